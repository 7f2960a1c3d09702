#!/bin/sh
# fetch.sh [--force]: the elevation data that scenes/jacksboro.toml shows, into inputs/.
#
# The file is part of a Debian package, fetched by name through the machine's own package sources,
# checked by SHA-256, and never installed; no root is needed. Where it cannot be had, that is said
# and the status is 0: the scene falls back on a procedural map.
set -u
cd "$(dirname "$0")/.." || exit 3

package=python-matplotlib-data
member=usr/share/matplotlib/mpl-data/sample_data/jacksboro_fault_dem.npz
target=inputs/jacksboro_fault_dem.npz
# Of the whole .npz. The 277,264 bytes of elevation in it (344 rows of 403 int16, little-endian)
# have the SHA-256 0c7e9f894eb7c8d444ca4475e64249e060d96c90ab63fdf439a0381c590ed502.
sha=d493f50a33e82a4420494c54d1fca1539d177bdc27ab190bc5fe6e92f62fb637

matches() { echo "$sha  $1" | sha256sum -c --status 2>/dev/null; }

if [ "${1:-}" != --force ] && matches "$target"; then exit 0; fi
give_up() {
    echo "The Jacksboro elevation data could not be fetched: $1." >&2
    echo "The scene's procedural fallback will be used; try again with scenes/fetch.sh." >&2
    exit 0
}
command -v apt-get >/dev/null && command -v dpkg-deb >/dev/null ||
    give_up "it is in the Debian package $package, and this machine has no apt-get"

work=$(mktemp -d) || exit 3
trap 'rm -rf "$work"' EXIT
trap 'exit 1' HUP INT TERM
apt() {
    (cd "$work" && apt-get -q -o Acquire::Retries=1 -o Acquire::http::Timeout=20 \
        -o APT::Sandbox::User= "$@") >>"$work/log" 2>&1
}
echo "Fetching the Jacksboro elevation data (2.7 MB, package $package)" >&2
if ! apt download "$package"; then
    # The machine's package lists may be absent or stale: read them anew, in a private folder.
    mkdir -p "$work/lists/partial" "$work/cache/archives/partial"
    private="-o Dir::State::Lists=$work/lists -o Dir::Cache=$work/cache"
    apt $private update
    apt $private download "$package" || give_up "$(sed -n 's/^[EW]: *//p' "$work/log" | head -n 1)"
fi
dpkg-deb -x "$work"/$package*.deb "$work/package" || give_up "the package cannot be unpacked"
matches "$work/package/$member" ||
    give_up "$member in $(basename "$work"/$package*.deb) has not the SHA-256 $sha"
mkdir -p inputs
cp "$work/package/$member" "$target.part" && mv "$target.part" "$target" || exit 3
