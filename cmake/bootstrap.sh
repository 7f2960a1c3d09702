#!/bin/sh
# bootstrap.sh GROUP...: sees to it that the Debian packages of these groups are here.
#
# Groups: run (the program), test (its tests; includes bench), bench, format, tidy.
# What is missing is installed as root or through sudo. Otherwise, or with NO_INSTALL=1, the exact
# command is printed and the status is 3 (the environment). When all is here nothing is printed.
set -eu

# A package, or package=program where a program of that name, from wherever, will do.
run="g++=g++ cmake=cmake ninja-build=ninja make=make ccache=ccache
     libglm-dev libcli11-dev nlohmann-json3-dev libtomlplusplus-dev libfmt-dev zlib1g-dev
     libopenimageio-dev openimageio-tools"
bench="libbenchmark-dev"
format="clang-format=clang-format"
tidy="clang-tidy=clang-tidy"
test="libgtest-dev libgmock-dev librapidcheck-dev $bench $format
      verilator=verilator iverilog=iverilog yosys=yosys z3=z3 python3=python3"

wanted=
for group in "$@"; do
    case $group in
        run) wanted="$wanted $run" ;;
        test) wanted="$wanted $test" ;;
        bench) wanted="$wanted $bench" ;;
        format) wanted="$wanted $format" ;;
        tidy) wanted="$wanted $tidy" ;;
        *) echo "bootstrap.sh: unknown group $group, expected run, test, bench, format or tidy" >&2
           exit 2 ;;
    esac
done

if ! command -v dpkg-query >/dev/null || ! command -v apt-get >/dev/null; then
    echo "This is no Debian machine: CMake looks for the libraries by itself. Needed are:" >&2
    for entry in $wanted; do printf ' %s' "${entry%%=*}" >&2; done
    echo >&2
    exit 0
fi

# One question for all of them: starting dpkg-query is what takes the time.
names=
for entry in $wanted; do names="$names ${entry%%=*}"; done
installed=$(dpkg-query -W -f '${db:Status-Status} ${Package}\n' $names 2>/dev/null |
            sed -n 's/^installed //p') || true
installed=" $(echo $installed) "
missing=
for entry in $wanted; do
    name=${entry%%=*}
    case $installed in *" $name "*) continue ;; esac
    case $entry in *=*) command -v "${entry#*=}" >/dev/null && continue ;; esac
    missing="$missing $name"
done
[ -n "$missing" ] || exit 0

command="apt-get install -y --no-install-recommends$missing"
sudo=
if [ "$(id -u)" != 0 ]; then
    # Without a terminal sudo could only hang or fail at its password prompt.
    if [ -t 0 ]; then ask=; else ask=-n; fi
    if command -v sudo >/dev/null && { [ -t 0 ] || sudo -n true 2>/dev/null; }; then
        sudo="sudo $ask"
    else
        NO_INSTALL=1
    fi
fi
if [ "${NO_INSTALL:-0}" != 0 ]; then
    echo "Debian packages are missing. Install them with (as root)" >&2
    echo "    apt-get update && $command" >&2
    echo "and start again." >&2
    exit 3
fi
echo "Installing the Debian packages that are missing:$missing"
$sudo apt-get update -q
$sudo env DEBIAN_FRONTEND=noninteractive $command </dev/null || {
    echo "The packages could not be installed; the command was: $command" >&2
    exit 3
}
