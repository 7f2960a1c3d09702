#!/bin/sh
# format.sh [--check]: clang-format over our C++; --check changes nothing and fails on a difference.
set -eu
cd "$(dirname "$0")/.."
case ${1:-} in
    --check) set -- --dry-run -Werror ;;
    *) set -- -i ;;
esac
find datapath tlm testbench \( -name '*.h' -o -name '*.cpp' \) -print0 |
    xargs -0 -r clang-format --style=file "$@"
