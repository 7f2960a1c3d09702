#!/bin/bash
# check_includes.sh [ROOT]: who may include whom, and other rules that a reader can grep.
#
#   1. Our own headers are included from the repository's root, in quotes.
#   2. datapath: the standard library and datapath/; no floating point but in the Real policy.
#   3. tlm: also tlm/ and SystemC; toml++ in tlm/config alone, SystemC everywhere but there.
#   4. testbench/reference: neither datapath/ nor tlm/, or it would judge the device by itself.
#   5. OpenImageIO in testbench/host/image alone (and the tests of it): it slows every start.
#   6. rtl: includes nothing outside rtl/.
# Prints FILE:LINE: RULE for each violation. --self-test plants one of each kind in a copy of
# nothing and demands that every one is found, so that a green check means something.
set -u

# Lines "FILE:LINE:TEXT" of the folder's sources that match the pattern.
lines() { # folder pattern [grep options]
    local folder=$1 pattern=$2
    shift 2
    [ -d "$folder" ] && grep -rnE "$@" --include='*.h' --include='*.cpp' -e "$pattern" "$folder"
}

report() { # rule, then violations on stdin
    local rule=$1 line
    while IFS= read -r line; do
        echo "$(cut -d: -f1-2 <<<"$line"): $rule: $(cut -d: -f3- <<<"$line")"
    done
}

# Comments and strings blanked, lines kept, so that "double" in prose is no violation.
code_only() {
    sed -E 's/"([^"\\]|\\.)*"/""/g; s://.*$::; s:/\*.*\*/::g' "$1"
}

check() {
    local include='^[[:space:]]*#[[:space:]]*include[[:space:]]*'
    local standard='<[a-z_]+>' kernel='<(systemc|tlm)>'

    for folder in datapath tlm testbench; do
        lines $folder "$include\"" | grep -vE "include[[:space:]]*\"(datapath|tlm|testbench)/" |
            report "includes are written from the repository's root"
    done

    lines datapath "$include[<\"]" | grep -E "$kernel|\"(tlm|testbench)/|<[^>]*[^a-z_>]" |
        report "datapath includes the standard library and datapath/ only"
    [ -d datapath ] && find datapath \( -name '*.h' -o -name '*.cpp' \) \
        ! -path datapath/numbers/policy.h | sort | while read -r file; do
        code_only "$file" | grep -nwE 'double|float' | sed "s|^|$file:|" |
            report "floating point in datapath belongs to numbers/policy.h"
    done

    lines tlm "$include\"testbench/" | report "tlm does not include testbench/"
    lines tlm "$include<" | grep -vE "<[a-z_]+>|<tlm_utils/|<sysc/|<toml\+\+/" |
        report "tlm includes the standard library, SystemC and toml++ only"
    lines tlm "$include<toml" | grep -v '^tlm/config/' | report "toml++ belongs to tlm/config"
    lines tlm/config "$include($kernel|<tlm_utils/|<sysc/)" | report "tlm/config needs no SystemC"

    lines testbench/reference "$include\"(datapath|tlm)/" |
        report "the reference shares no code with the device"
    for folder in datapath tlm testbench; do lines $folder "$include<OpenImageIO/"; done |
        grep -vE '^testbench/(host/image/|tests/[a-z0-9_]*_image_test\.cpp)' |
        report "OpenImageIO belongs to testbench/host/image"

    [ -d rtl ] && grep -rnE '^[[:space:]]*`include' rtl | grep -vE '`include[[:space:]]+"rtl/' |
        report "rtl includes rtl/ only, from the repository's root"
}

self_test() {
    local work found expected=0
    work=$(mktemp -d)
    trap 'rm -rf "$work"' EXIT
    cd "$work" || exit 3
    plant() { # file, line
        mkdir -p "$(dirname "$1")"
        printf '// double in a comment is prose\n%s\n' "$2" >"$1"
        expected=$((expected + 1))
    }
    plant datapath/units/a.h '#include "a.h"'
    plant datapath/units/b.h '#include <systemc>'
    plant datapath/units/c.h '#include "testbench/host/mesh/mesh.h"'
    plant datapath/units/d.h '#include <glm/glm.hpp>'
    plant datapath/units/e.cpp 'static double half = 0.5;'
    plant datapath/units/f.cpp '#include <math.h>'
    plant tlm/units/a.h '#include "testbench/host/mesh/mesh.h"'
    plant tlm/units/b.cpp '#include <toml++/toml.h>'
    plant tlm/units/c.cpp '#include <glm/glm.hpp>'
    plant tlm/config/a.cpp '#include <systemc>'
    plant testbench/reference/a.cpp '#include "datapath/numbers/format.h"'
    plant testbench/host/a.cpp '  #  include "../b.h"'
    plant testbench/app/a.cpp '#include <OpenImageIO/imageio.h>'
    plant rtl/units/a.sv '`include "../datapath/a.svh"'
    found=$(check | cut -d: -f1 | sort -u | wc -l)
    if [ "$found" != "$expected" ]; then
        echo "self-test: $expected violations planted, $found found:"
        check
        exit 1
    fi
    rm -r ./*
    # What is allowed must pass.
    plant datapath/numbers/policy.h 'using Value = double;'
    plant datapath/numbers/a.cpp '#include "datapath/numbers/format.h"'
    plant datapath/numbers/b.cpp 'const char* kText = "double";  // a double'
    plant tlm/units/a.h '#include <tlm_utils/simple_target_socket.h>'
    plant tlm/config/a.cpp '#include <toml++/toml.h>'
    plant testbench/host/image/a.cpp '#include <OpenImageIO/imageio.h>'
    plant rtl/units/a.sv '`include "rtl/common/pipe.svh"'
    if [ -n "$(check)" ]; then
        echo "self-test: allowed code is refused:"
        check
        exit 1
    fi
    echo "self-test: all $expected planted violations and permissions are as they should be"
    exit 0
}

[ "${1:-}" = --self-test ] && self_test
cd "${1:-$(dirname "$0")/..}" || exit 3
violations=$(check)
[ -z "$violations" ] && exit 0
echo "$violations"
exit 1
