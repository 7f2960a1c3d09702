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
    if [ -f rtl/tops/"$unit".sv ]; then # made of units
        case $unit in
        sweep_chain) files=(rtl/units/{sweep_line,perspective,strip}*.sv) ;;
        tessellation_tests) files=(rtl/units/{texcoord,view,normal,height}_test*.sv) ;;
        esac
        files=(rtl/common/*.sv "${files[@]}" rtl/tops/"$unit".sv)
    fi
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

lint normal_test
lint normal_test DISPLACED_NORMAL_WIDTH=11 DISPLACED_NORMAL_FRAC=9 MAP_NORMAL_WIDTH=9 \
    MAP_NORMAL_FRAC=7 NORMAL_WIDTH=13 NORMAL_FRAC=11
lint normal_test DISPLACED_NORMAL_WIDTH=3 DISPLACED_NORMAL_FRAC=1 MAP_NORMAL_WIDTH=16 \
    MAP_NORMAL_FRAC=14 NORMAL_WIDTH=20 NORMAL_FRAC=18

lint edge_iter

lint split
lint split POSITION_WIDTH=24 DIAGONAL_WIDTH=14 DIAGONAL_FRAC=12
lint split POSITION_WIDTH=3 POSITION_FRAC=1 DIAGONAL_WIDTH=2 DIAGONAL_FRAC=0
lint split POSITION_WIDTH=20 POSITION_FRAC=8 DIAGONAL_WIDTH=30 DIAGONAL_FRAC=16

lint displace
lint displace UV_WIDTH=16 UV_FRAC=4 HEIGHT_WIDTH=12 HEIGHT_FRAC=12 FILTERED_HEIGHT_WIDTH=16 \
    FILTERED_HEIGHT_FRAC=16 DISPLACEMENT_WIDTH=22 DISPLACEMENT_FRAC=16 POSITION_WIDTH=24 \
    NORMAL_WIDTH=13 NORMAL_FRAC=11
lint displace UV_WIDTH=5 UV_FRAC=2 HEIGHT_WIDTH=2 HEIGHT_FRAC=2 FILTERED_HEIGHT_WIDTH=4 \
    FILTERED_HEIGHT_FRAC=4 DISPLACEMENT_WIDTH=5 DISPLACEMENT_FRAC=2 POSITION_WIDTH=5 \
    POSITION_FRAC=2 NORMAL_WIDTH=3 NORMAL_FRAC=1
lint displace UV_WIDTH=31 UV_FRAC=0
lint displace UV_WIDTH=31 UV_FRAC=16

lint footprint
lint footprint UV_WIDTH=16 UV_FRAC=4 POSITION_WIDTH=24 NORMAL_WIDTH=13 NORMAL_FRAC=11 \
    SWEEP_DATA_WIDTH=20 SWEEP_DATA_FRAC=12 INVERSE_W_WIDTH=22 INVERSE_W_FRAC=20 \
    RECIPROCAL_INDEX_BITS=9 RECIPROCAL_NEWTON_STEPS=1 RECIPROCAL_BITS=16
lint footprint UV_WIDTH=5 UV_FRAC=2 POSITION_WIDTH=4 POSITION_FRAC=1 NORMAL_WIDTH=3 NORMAL_FRAC=1 \
    SWEEP_DATA_WIDTH=6 SWEEP_DATA_FRAC=2 INVERSE_W_WIDTH=6 INVERSE_W_FRAC=4
lint footprint UV_WIDTH=31 UV_FRAC=16
lint footprint UV_WIDTH=31 UV_FRAC=0

lint mid_vertex
lint mid_vertex NORMALISE_KIND=1
lint mid_vertex UV_WIDTH=16 UV_FRAC=4 POSITION_WIDTH=24 NORMAL_WIDTH=13 NORMAL_FRAC=11 \
    UNNORMALISED_WIDTH=15 UNNORMALISED_FRAC=12
lint mid_vertex UV_WIDTH=4 UV_FRAC=1 POSITION_WIDTH=4 POSITION_FRAC=1 NORMAL_WIDTH=4 NORMAL_FRAC=2 \
    UNNORMALISED_WIDTH=4 UNNORMALISED_FRAC=1

tiny="UV_WIDTH=5 UV_FRAC=1 HEIGHT_WIDTH=2 HEIGHT_FRAC=2 MAP_NORMAL_WIDTH=2 MAP_NORMAL_FRAC=1
    NORMAL_WIDTH=3 NORMAL_FRAC=1 UNNORMALISED_WIDTH=4 UNNORMALISED_FRAC=1 DISPLACED_NORMAL_WIDTH=4
    DISPLACED_NORMAL_FRAC=2 SLOPE_WIDTH=4 SLOPE_FRAC=1 ANGLE_WIDTH=3 ANGLE_FRAC=2 SINE_INDEX_BITS=2"
for kind in 0 1 2; do
    lint bump BUMP_KIND=$kind
    lint bump BUMP_KIND=$kind $tiny
    lint bump BUMP_KIND=$kind NORMALISE_KIND=1 UV_WIDTH=31 UV_FRAC=0 NORMAL_WIDTH=20 NORMAL_FRAC=18 \
        MAP_NORMAL_WIDTH=16 MAP_NORMAL_FRAC=14 UNNORMALISED_WIDTH=24 SLOPE_WIDTH=24 SLOPE_FRAC=20 \
        ANGLE_WIDTH=16 ANGLE_FRAC=1 SINE_INDEX_BITS=10
done

lint height_test
lint height_test UV_WIDTH=4 UV_FRAC=1 SAT_WIDTH=8 HEIGHT_WIDTH=2
lint height_test UV_WIDTH=31 UV_FRAC=16 SAT_WIDTH=39 HEIGHT_WIDTH=16
lint height_test UV_WIDTH=31 UV_FRAC=0 SAT_WIDTH=32 HEIGHT_WIDTH=16
lint height_test UV_WIDTH=16 UV_FRAC=4 SAT_WIDTH=28 HEIGHT_WIDTH=12
lint height_test UV_WIDTH=14 UV_FRAC=0 SAT_WIDTH=13 HEIGHT_WIDTH=1

lint grid_transform
lint grid_transform Z_TABLE_KIND=2 Z_TABLE_INDEX_BITS=3
lint grid_transform Z_TABLE_KIND=0 Z_TABLE_INDEX_BITS=8
lint grid_transform Z_TABLE_KIND=1 Z_TABLE_INDEX_BITS=1 RECIPROCAL_INDEX_BITS=2 \
    RECIPROCAL_NEWTON_STEPS=0 RECIPROCAL_BITS=8
lint grid_transform Z_TABLE_KIND=2 Z_TABLE_INDEX_BITS=5 RECIPROCAL_INDEX_BITS=12 RECIPROCAL_BITS=30
lint grid_transform POSITION_WIDTH=24 CLIP_WIDTH=22 CLIP_FRAC=14 NDC_WIDTH=21 NDC_FRAC=16 \
    FOCAL_WIDTH=17 FOCAL_FRAC=4 SWEEP_DATA_WIDTH=20 SWEEP_DATA_FRAC=12 INVERSE_W_WIDTH=22 \
    INVERSE_W_FRAC=20 STEPS_PER_OCTAVE_WIDTH=20 STEPS_PER_OCTAVE_FRAC=9 Z_TABLE_KIND=2 \
    Z_TABLE_INDEX_BITS=3 RECIPROCAL_INDEX_BITS=9 RECIPROCAL_NEWTON_STEPS=1 RECIPROCAL_BITS=16
lint grid_transform POSITION_WIDTH=4 POSITION_FRAC=0 CLIP_WIDTH=4 CLIP_FRAC=1 NDC_WIDTH=9 \
    NDC_FRAC=5 FOCAL_WIDTH=8 FOCAL_FRAC=2 SWEEP_DATA_WIDTH=6 SWEEP_DATA_FRAC=2 \
    INVERSE_W_WIDTH=8 INVERSE_W_FRAC=6 STEPS_PER_OCTAVE_WIDTH=8 STEPS_PER_OCTAVE_FRAC=2 \
    Z_TABLE_KIND=0 Z_TABLE_INDEX_BITS=2

lint view_clip
lint view_clip CLIP_WIDTH=22 CLIP_FRAC=14 VIEW_ROW_WIDTH=16 VIEW_ROW_FRAC=14 DISPLACEMENT_WIDTH=22 \
    DISPLACEMENT_FRAC=16
lint view_clip CLIP_WIDTH=4 CLIP_FRAC=1 VIEW_ROW_WIDTH=4 VIEW_ROW_FRAC=2 DISPLACEMENT_WIDTH=4 \
    DISPLACEMENT_FRAC=2
lint view_clip CLIP_WIDTH=24 CLIP_FRAC=14 VIEW_ROW_WIDTH=20 VIEW_ROW_FRAC=18 \
    DISPLACEMENT_WIDTH=16 DISPLACEMENT_FRAC=8

lint perspective
lint perspective COMPONENTS=9
lint perspective COMPONENTS=9 SWEEP_DATA_WIDTH=20 SWEEP_DATA_FRAC=12 INVERSE_W_WIDTH=22 \
    INVERSE_W_FRAC=20 POSITION_WIDTH=24 POSITION_FRAC=16 UNNORMALISED_WIDTH=15 \
    UNNORMALISED_FRAC=12 UV_WIDTH=16 UV_FRAC=4 RECIPROCAL_INDEX_BITS=9 \
    RECIPROCAL_NEWTON_STEPS=1 RECIPROCAL_BITS=16
lint perspective SWEEP_DATA_WIDTH=9 SWEEP_DATA_FRAC=7 INVERSE_W_WIDTH=16 INVERSE_W_FRAC=14 \
    POSITION_WIDTH=14 POSITION_FRAC=8 UNNORMALISED_WIDTH=10 UNNORMALISED_FRAC=7 UV_WIDTH=12 \
    UV_FRAC=4

lint normalise
lint normalise NORMALISE_KIND=1
lint normalise NORMAL_WIDTH=13 NORMAL_FRAC=11 UNNORMALISED_WIDTH=15 UNNORMALISED_FRAC=12 \
    INVERSE_SQRT_INDEX_BITS=8 INVERSE_SQRT_NEWTON_STEPS=1 INVERSE_SQRT_BITS=14
lint normalise NORMAL_WIDTH=20 NORMAL_FRAC=18 UNNORMALISED_WIDTH=24 INVERSE_SQRT_INDEX_BITS=10 \
    INVERSE_SQRT_BITS=29
lint normalise NORMAL_WIDTH=20 NORMAL_FRAC=18 UNNORMALISED_WIDTH=24 NORMALISE_KIND=1
lint normalise NORMAL_WIDTH=3 NORMAL_FRAC=1 UNNORMALISED_WIDTH=4 INVERSE_SQRT_INDEX_BITS=2 \
    INVERSE_SQRT_NEWTON_STEPS=0 INVERSE_SQRT_BITS=8
lint normalise NORMAL_WIDTH=3 NORMAL_FRAC=1 UNNORMALISED_WIDTH=4 NORMALISE_KIND=1

lint shade
lint shade NORMALISE_KIND=1
lint shade LIGHTS=1 POWER_LOG_INDEX_BITS=1 POWER_EXP_INDEX_BITS=1 NORMAL_WIDTH=3 NORMAL_FRAC=1 \
    COSINE_WIDTH=4 COSINE_FRAC=1 LIGHT_WIDTH=2 LIGHT_FRAC=1 COLOUR_WIDTH=1 COLOUR_FRAC=1 \
    POSITION_WIDTH=4 POSITION_FRAC=0 UNNORMALISED_WIDTH=24 INVERSE_SQRT_BITS=29
lint shade LIGHTS=2 POWER_LOG_INDEX_BITS=4 POWER_EXP_INDEX_BITS=8 NORMAL_WIDTH=20 NORMAL_FRAC=17 \
    COSINE_WIDTH=22 COSINE_FRAC=20 LIGHT_WIDTH=20 LIGHT_FRAC=10 COLOUR_WIDTH=20 COLOUR_FRAC=20 \
    UNNORMALISED_WIDTH=4 NORMALISE_KIND=1

lint texel_cache
lint texel_cache CACHE_LINE_BITS=0 CACHE_SET_BITS=0 CACHE_WAYS=1
lint texel_cache CACHE_LINE_BITS=0 CACHE_SET_BITS=0 CACHE_WAYS=1 CACHE_REPLACEMENT=0 HEIGHT_WIDTH=1
lint texel_cache CACHE_LINE_BITS=2 CACHE_SET_BITS=5 CACHE_WAYS=2 CACHE_REPLACEMENT=0
lint texel_cache CACHE_LINE_BITS=5 CACHE_SET_BITS=3 CACHE_WAYS=8 HEIGHT_WIDTH=39
lint texel_cache CACHE_LINE_BITS=1 CACHE_SET_BITS=12 CACHE_WAYS=3 HEIGHT_WIDTH=38

lint strip
lint strip COLUMN_DEPTH=0
lint strip COLUMN_DEPTH=1 VERTEX_WIDTH=1
lint strip COLUMN_DEPTH=5 VERTEX_WIDTH=270

lint sweep_chain
lint sweep_chain COMPONENTS=9 COLUMN_DEPTH=3 SWEEP_DATA_WIDTH=20 SWEEP_DATA_FRAC=12 \
    INVERSE_W_WIDTH=22 INVERSE_W_FRAC=20 POSITION_WIDTH=24 POSITION_FRAC=16

lint tessellation_tests
lint tessellation_tests UV_WIDTH=16 UV_FRAC=4 SCREEN_WIDTH=14 SCREEN_FRAC=2 \
    DISPLACED_NORMAL_WIDTH=11 DISPLACED_NORMAL_FRAC=9 MAP_NORMAL_WIDTH=9 MAP_NORMAL_FRAC=7 \
    NORMAL_WIDTH=13 NORMAL_FRAC=11 SAT_WIDTH=28 HEIGHT_WIDTH=12
lint tessellation_tests UV_WIDTH=3 UV_FRAC=1 SCREEN_WIDTH=3 SCREEN_FRAC=0 \
    DISPLACED_NORMAL_WIDTH=3 DISPLACED_NORMAL_FRAC=1 MAP_NORMAL_WIDTH=3 MAP_NORMAL_FRAC=0 \
    NORMAL_WIDTH=3 NORMAL_FRAC=2 SAT_WIDTH=8 HEIGHT_WIDTH=2

lint sweep_line
lint sweep_line COLUMN_DEPTH=0
lint sweep_line COLUMN_DEPTH=1 COMPONENTS=1 ADDER_KIND=0 GUARD_BITS=5
lint sweep_line COLUMN_DEPTH=0 COMPONENTS=2 ADDER_KIND=1 GUARD_BITS=13
lint sweep_line COLUMN_DEPTH=3 COMPONENTS=9 SWEEP_DATA_WIDTH=20 SWEEP_DATA_FRAC=12 \
    INVERSE_W_WIDTH=22 INVERSE_W_FRAC=20

# Every file keeps undeclared names from becoming wires.
for file in rtl/common/*.sv rtl/units/*.sv rtl/tops/*.sv; do
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
