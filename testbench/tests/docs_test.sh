#!/bin/bash
# The documents say what the code says: registers, example, profiles, measured errors, links.
set -u
: "${REPOUSSE_PROGRAM:?set by ctest: the repousse program}"
python3 testbench/tests/support/check_docs.py
