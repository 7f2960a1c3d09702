#!/bin/bash
# The RTL without a warning in Verilator -Wall, Icarus and Yosys (no latches, no undriven nets), at
# the default parameters and at the ends of what profiles may ask for.
set -u
failures=0

need() { # program, package
    command -v "$1" >/dev/null && return
    echo "$1: not found; install it with: apt-get install $2"
    exit 3
}
need verilator verilator
need iverilog iverilog
need yosys yosys

# Runs a tool; any output or a bad status is a failure. (Icarus checks with -t null: as root,
# -o /dev/null would change the device's mode.)
clean() { # what, command...
    local what=$1 output
    shift
    if ! output=$("$@" 2>&1) || [ -n "$output" ]; then
        echo "$what:"
        echo "$output"
        failures=$((failures + 1))
    fi
}

# Lints one unit with parameters NAME=VALUE...
lint() { # unit, parameters...
    local unit=$1 p
    local files=(rtl/common/*.sv rtl/units/"$unit"*.sv)
    shift
    local verilator=() icarus=() yosys=""
    for p in "$@"; do
        verilator+=("-G$p")
        icarus+=("-P$unit.$p")
        yosys+="chparam -set ${p/=/ } $unit; "
    done
    clean "$unit $*: verilator" verilator --lint-only -Wall -I. ${verilator[@]+"${verilator[@]}"} \
        --top-module "$unit" "${files[@]}"
    clean "$unit $*: iverilog" iverilog -g2012 -Wall -t null -I. ${icarus[@]+"${icarus[@]}"} \
        -s "$unit" "${files[@]}"
    clean "$unit $*: yosys" yosys -q -p "read_verilog -sv -I. ${files[*]}; $yosys
        hierarchy -check -top $unit; proc; check -assert; select -assert-none t:\$dlatch"
}

lint texcoord_test
lint texcoord_test UV_WIDTH=4 UV_FRAC=0
lint texcoord_test UV_WIDTH=31 UV_FRAC=16

lint view_test
lint view_test SCREEN_WIDTH=3 SCREEN_FRAC=0
lint view_test SCREEN_WIDTH=30 SCREEN_FRAC=8

lint height_test
lint height_test UV_WIDTH=4 UV_FRAC=1 SAT_WIDTH=8 HEIGHT_WIDTH=2
lint height_test UV_WIDTH=31 UV_FRAC=16 SAT_WIDTH=39 HEIGHT_WIDTH=16
lint height_test UV_WIDTH=31 UV_FRAC=0 SAT_WIDTH=32 HEIGHT_WIDTH=16
lint height_test UV_WIDTH=16 UV_FRAC=4 SAT_WIDTH=28 HEIGHT_WIDTH=12
lint height_test UV_WIDTH=14 UV_FRAC=0 SAT_WIDTH=13 HEIGHT_WIDTH=1

# Every file keeps undeclared names from becoming wires.
for file in rtl/common/*.sv rtl/units/*.sv; do
    if ! head -1 "$file" | grep -q '^`default_nettype none$'; then
        echo "$file: does not begin with \`default_nettype none"
        failures=$((failures + 1))
    fi
done

# And the lint itself sees a mistake.
broken=$(mktemp -d)
trap 'rm -rf "$broken"' EXIT
sed 's/assign vt = .*/assign vt = long_edge \& ~skiped;/' rtl/units/view_test.sv >"$broken/view_test.sv"
for tool in "verilator --lint-only -Wall" "iverilog -g2012 -t null"; do
    if $tool -I. rtl/common/*.sv "$broken/view_test.sv" >/dev/null 2>&1; then
        echo "$tool: a misspelt name was not seen"
        failures=$((failures + 1))
    fi
done

[ "$failures" = 0 ]
