#!/bin/bash
# `repousse cosim` and `repousse vectors` as a user meets them: output, exit status, messages.
set -u
program=${REPOUSSE_PROGRAM:?}
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
failures=0

# Runs the program; checks its status and that what it prints contains every given text.
expect() { # status, command..., -- texts...
    local status=$1 command=() output got text
    shift
    while [ $# -gt 0 ] && [ "$1" != -- ]; do
        command+=("$1")
        shift
    done
    shift
    output=$("${command[@]}" 2>&1)
    got=$?
    if [ "$got" != "$status" ]; then
        echo "${command[*]}: status $got, expected $status"
        echo "$output"
        failures=$((failures + 1))
    fi
    for text in "$@"; do
        if [[ $output != *"$text"* ]]; then
            echo "${command[*]}: \"$text\" is not in:"
            echo "$output"
            failures=$((failures + 1))
        fi
    done
}

expect 0 "$program" cosim --help -- --vectors --icarus --exhaustive --stalls --seed --profile
expect 0 "$program" cosim --vectors 200000 --icarus 5000 -- \
    texcoord_test view_test height_test Verilator Icarus vectors/s
expect 0 "$program" cosim view_test --vectors 20000 --icarus 0 --profile narrow --seed 7 -- view_test
expect 0 "$program" cosim tessellation_tests --vectors 2000 --icarus 0 \
    --scene scenes/donut_small.toml --scene scenes/jacksboro_small.toml -- \
    "donut_small, " "jacksboro_small, " " distinct"
expect 2 "$program" cosim view_test --scene scenes/donut_small.toml -- "scenes are for"
expect 2 "$program" cosim --scene "$work/none.toml" -- none.toml
expect 2 "$program" cosim no_such_unit -- no_such_unit
expect 2 "$program" cosim --stalls 101 -- stalls
expect 2 "$program" cosim --profile "$work/none.toml" -- none.toml
expect 3 env PATH=/nonexistent "$program" cosim view_test -- "apt-get install"
expect 3 env REPOUSSE_SOURCE_DIR="$work" "$program" cosim view_test --profile narrow -- \
    REPOUSSE_SOURCE_DIR

expect 0 "$program" vectors check -- texcoord_test view_test height_test ", 0 mismatches"
expect 0 "$program" vectors generate --folder "$work" -- transactions
for unit in texcoord_test view_test height_test; do
    cmp "$work/$unit/hard.vec" "vectors/$unit/hard.vec" || failures=$((failures + 1))
done
# One output bit turned over.
sed -i '$ y/02468ace13579bdf/13579bdf02468ace/' "$work/view_test/hard.vec"
expect 1 "$program" vectors check view_test --folder "$work" -- "field vt: engine 0x" "LSB"
sed -i 's/^\/\/ unit .*/\/\/ unit other/' "$work/texcoord_test/hard.vec"
expect 2 "$program" vectors check texcoord_test --folder "$work" -- "hard.vec:2:1: "

[ "$failures" = 0 ]
