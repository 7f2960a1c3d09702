#!/bin/bash
# What `repousse sim` writes: report.json obeys its schema, the same inputs give the same bytes, and
# units that the scene does not call for change nothing.
set -u
program=${REPOUSSE_PROGRAM:?set by ctest: the repousse program}
scene=scenes/donut_small.toml
support=testbench/tests/support
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
failures=0

fail() {
    echo "FAILED: $1"
    failures=$((failures + 1))
}

# sim NAME OPTIONS...: a run into a folder of that name; of the scene SCENE, if it is set.
sim() {
    local name=$1
    shift
    "$program" sim "${SCENE:-$scene}" -o "$folder/$name" --quiet "$@" > "$folder/log" 2>&1 && return
    cat "$folder/log"
    fail "sim $* ends with status 0"
}

valid() { # NAME: its report obeys the schema
    python3 $support/check_schema.py docs/report.schema.json "$folder/$1/report.json" ||
        fail "the report of the run '$1' is valid"
}

# refused NAME EXPRESSION: the report, spoilt by a Python statement on `r`, violates the schema.
refused() {
    python3 - "$folder/first/report.json" "$folder/spoilt.json" "$2" <<'PYTHON'
import json, sys
with open(sys.argv[1]) as file:
    r = json.load(file)
exec(sys.argv[3])
with open(sys.argv[2], "w") as file:
    json.dump(r, file)
PYTHON
    if python3 $support/check_schema.py docs/report.schema.json "$folder/spoilt.json" \
        > "$folder/log" 2>&1; then
        fail "a report with $1 is refused"
    fi
}

sim first
sim second
sim everything --everything
sim ref --level ref
sim ref_everything --level ref --everything
sim unchecked --no-check --profile narrow
SCENE=scenes/tilt_small.toml sim swept
SCENE=scenes/tilt_small.toml sim swept_everything --everything
SCENE=scenes/tilt_small.toml sim swept_ref --level ref
SCENE=scenes/head_lit_small.toml sim lit
SCENE=scenes/head_lit_small.toml sim lit_everything --everything
SCENE=scenes/head_lit_small.toml sim lit_ref --level ref
for name in first everything ref ref_everything unchecked swept swept_everything swept_ref \
    lit lit_everything lit_ref; do
    valid $name
done

refused "an unknown field" 'r["surprise"] = 1'
refused "an unknown field in an object" 'r["objects"][0]["surprise"] = 1'
refused "an unknown counter" 'r["units"]["elaborated"][0]["counters"]["surprise"] = 1'
refused "another unit's counter" 'r["units"]["elaborated"][0]["counters"] = {"known_unsplit": 1}'
refused "an unknown unit" 'r["units"]["elaborated"][0]["unit"] = "surprise"'
refused "an unknown profile entry" 'r["profile"]["entries"]["surprise"] = "s1.2"'
refused "a missing field" 'del r["table_bytes"]'
refused "a missing profile entry" 'del r["profile"]["entries"]["uv"]'
refused "a negative count" 'r["objects"][0]["triangles"] = -1'
refused "a count that is text" 'r["objects"][0]["triangles"] = "1"'
refused "no time at level lt" 'del r["time"]'
refused "a time at level ref" 'r["level"] = "ref"'
refused "a grid in an adaptive object" 'r["objects"][0]["coarseness_px"] = 1'
refused "another method's invariants" 'r["objects"][0]["method"] = "sweep"'
refused "an object without its map" 'del r["objects"][0]["map"]'

for file in frame.png mesh.ply report.json; do
    cmp "$folder/first/$file" "$folder/second/$file" || fail "two runs give the same $file"
done
for file in frame.png mesh.ply; do
    cmp "$folder/first/$file" "$folder/everything/$file" || fail "--everything gives the same $file"
    cmp "$folder/swept/$file" "$folder/swept_everything/$file" ||
        fail "--everything gives the same $file of a swept object"
    cmp "$folder/lit/$file" "$folder/lit_everything/$file" ||
        fail "--everything gives the same $file of coloured objects"
done
for name in first everything ref unchecked; do
    for file in frame.png mesh.ply report.json timing.json; do
        [[ -s $folder/$name/$file ]] || fail "the run '$name' writes $file"
    done
done

# The units that two runs have both elaborated count the same.
python3 - "$folder" <<'PYTHON' || fail "the reports agree"
import json, sys

def read(name):
    with open(f"{sys.argv[1]}/{name}/report.json") as file:
        return json.load(file)

def counters(report):
    return {u["unit"]: u["counters"] for u in report["units"]["elaborated"]}

def omitted(report):
    return [u["unit"] for u in report["units"]["omitted"]]

first, everything, ref = read("first"), read("everything"), read("ref")
needed, built = counters(first), counters(everything)
sweep = ["grid_transform", "view_clip", "triangle_setup", "sweep_line", "perspective", "normalise"]
ends = ["strip", "triangle_buffer"]
assert omitted(first) == [
    "controller", "view_test", "vertex_transform", *sweep, "footprint", "shade", *ends], first
assert omitted(everything) == [] and len(built) == len(needed) + len(omitted(first))
for unit in needed:
    assert needed[unit] == built[unit], unit
assert built["view_test"] == {"items": 0, "tests": 0, "positives": 0}
assert first["time"] == everything["time"] and first["objects"] == everything["objects"]
assert first["objects"][0]["triangles"] > 1000
assert first["objects"][0]["invariants"] == {"open_edges": 0, "flipped": 0, "zero_area": 0}
assert "invariants" not in read("unchecked")["objects"][0]
swept, swept_everything = read("swept"), read("swept_everything")
assert [unit for unit in counters(swept)] == [
    "controller", "vertex_transform", *sweep, "displace", *ends], swept
assert set(counters(swept)) == set(counters(read("swept_ref")))
for unit, row in counters(swept).items():
    assert row == counters(swept_everything)[unit], unit
assert swept["objects"] == swept_everything["objects"]
assert swept["objects"][0]["method"] == "sweep" and swept["objects"][0]["coarseness_px"] == 6
assert swept["objects"][0]["triangles"] == counters(swept)["strip"]["triangles"] > 100
assert set(swept["objects"][0]["invariants"].values()) == {0}, swept
lit, lit_everything = counters(read("lit")), counters(read("lit_everything"))
vertices = sum(o["vertices"] for o in read("lit")["objects"])
assert lit["shade"]["items"] >= vertices > 1000 and lit["shade"]["degenerate"] == 0, lit
assert lit["shade"] == lit_everything["shade"] and lit.keys() == counters(read("lit_ref")).keys()
with open(f"{sys.argv[1]}/lit/mesh.ply", "rb") as file:
    header = file.read(1000).split(b"end_header")[0].decode()
assert "property uchar red\nproperty uchar green\nproperty uchar blue\n" in header, header
assert set(counters(ref)) == set(needed) and ref["objects"][0]["triangles"] > 1000
PYTHON

# timing.json is for people and differs from run to run; its fields do not.
python3 - "$folder/first/timing.json" <<'PYTHON' || fail "timing.json has its fields"
import json, sys
with open(sys.argv[1]) as file:
    timing = json.load(file)
assert list(timing) == ["schema", "wall_s", "tessellation_s", "triangles_per_s", "machine"], timing
assert timing["schema"] == "repousse-timing/1"
assert list(timing["machine"]) == ["processor", "threads", "compiler"]
assert all(seconds >= 0 for seconds in timing["wall_s"].values())
PYTHON

echo "$failures failures"
[[ $failures -eq 0 ]]
