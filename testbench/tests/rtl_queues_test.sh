#!/bin/bash
# rp_scatter and rp_gather: data, and the cycle of every transfer against their recurrences, with
# the depths of the sweep chain, the least ones, and odd ones. And a wrong recurrence is seen.
set -u
if ! command -v verilator >/dev/null; then
    echo "verilator: not found; install it with: apt-get install verilator"
    exit 3
fi
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
here=testbench/tests/rtl_queues

run() { # scatter, steps, gather, stages, depth that the recurrence has for gather
    local defines="-DSCATTER=$1 -DSTEPS=$2 -DGATHER=$5 -DSTAGES=$4"
    verilator --cc --exe --build -Wall -O3 --top-module rtl_queues --Mdir "$work/$1-$2-$3-$5" \
        -GSCATTER="$1" -GSTEPS="$2" -GGATHER="$3" -GSTAGES="$4" \
        -CFLAGS "-std=c++17 -O1 $defines" \
        rtl/common/rp_{banks,fifo,gather,pipe,scatter}.sv "$here/rtl_queues.sv" \
        "$PWD/$here/rtl_queues.cpp" >"$work/log" 2>&1 || { cat "$work/log"; exit 1; }
    "$work/$1-$2-$3-$5/Vrtl_queues"
}

failures=0
run 32 64 8 10 8 || failures=1
run 4 2 4 1 4 || failures=1
run 7 5 5 3 5 || failures=1
run 7 5 5 3 6 && failures=1 # one place more than there is
exit $failures
