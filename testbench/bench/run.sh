#!/usr/bin/env bash
# Runs every benchmark in a folder and writes the tables that they end with to a Markdown file.
#   run.sh FOLDER FILE
set -euo pipefail
folder=${1:?the folder with the benchmark programs}
file=${2:?the Markdown file to write}
{
    echo '# Benchmarks'
    echo
    echo 'Written by `make bench`. Figures of one table are from one run with interleaved rounds:'
    echo 'trust the ratios, not the nanoseconds.'
} > "$file.part"
for program in "$folder"/*_bench; do
    name=$(basename "$program")
    echo "== $name"
    log=$(mktemp)
    "$program" | tee "$log"
    { echo; echo "## $name"; echo; grep -h '^scenes/' "$log" || true; } >> "$file.part"
    sed -n '/^Best of/,$p' "$log" | sed '1a\\' >> "$file.part"
    rm -f "$log"
done
mv "$file.part" "$file"
echo "The tables are in $file"
