#!/bin/sh
# fetch_systemc.sh FILE: SystemC 2.3.4's upstream tarball out of Debian's source package, to FILE.
#
# The machine's own package sources are used, read as deb-src in a private folder: nothing in
# /etc/apt or /var/lib/apt is touched, and no root is needed. The caller checks the SHA-256.
set -u
target=$1
command -v apt-get >/dev/null || { echo "this machine has no apt-get"; exit 1; }

work=$(mktemp -d) || exit 1
trap 'rm -rf "$work"' EXIT
trap 'exit 1' HUP INT TERM
mkdir -p "$work/lists/partial" "$work/sources" "$work/cache/archives/partial"

for file in /etc/apt/sources.list /etc/apt/sources.list.d/*.list; do
    [ -r "$file" ] && sed -n 's/^deb[ \t]/deb-src /p' "$file" >>"$work/sources/machine.list"
done
for file in /etc/apt/sources.list.d/*.sources; do
    [ -r "$file" ] && sed 's/^Types:.*/Types: deb-src/' "$file" \
        >"$work/sources/$(basename "$file")"
done

apt() {
    apt-get -q -o Dir::Etc::SourceList=/dev/null -o Dir::Etc::SourceParts="$work/sources" \
        -o Dir::State::Lists="$work/lists" -o Dir::Cache="$work/cache" \
        -o Acquire::Retries=2 -o Acquire::http::Timeout=30 -o APT::Sandbox::User= "$@"
}
cd "$work" || exit 1
# A third party's source without deb-src makes `update` fail; what counts is the next step.
apt update >update.log 2>&1
if ! apt source --download-only systemc >source.log 2>&1; then
    cat update.log source.log | sed -n 's/^[EW]: //p' | head -n 3  # the first is the cause
    exit 1
fi
if [ ! -e systemc_2.3.4.orig.tar.gz ]; then
    echo "the package sources offer $(ls systemc_*.orig.tar.*), not systemc_2.3.4.orig.tar.gz"
    exit 1
fi
mv systemc_2.3.4.orig.tar.gz "$target"
