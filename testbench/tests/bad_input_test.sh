#!/usr/bin/env bash
# What a user can get wrong: every case ends with the right exit status and a message that says
# where and what, and leaves the results of an earlier run as they were.
set -u
program=${REPOUSSE_PROGRAM:?set by ctest: the repousse program}
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
failures=0
cases=0

# A scene with one key of each kind, to be spoilt by sed.
cat > "$folder/good.toml" <<'SCENE'
title = "good"
[viewport]
width_px = 64
height_px = 64
[camera]
eye = [0.5, -1.0, 0.8]
target = [0.5, 0.5, 0.0]
[[light]]
direction = [0.0, 0.0, 1.0]
[[object]]
name = "thing"
method = "adaptive"
[object.mesh]
kind = "grid"
quads = [2, 2]
[object.map]
kind = "donut"
size_texels = [32, 32]
range = 0.1
[object.adaptive]
normal_threshold = 0.3
SCENE

fail() {
    echo "FAILED: $1"
    failures=$((failures + 1))
}

# A result that must survive everything that follows.
if ! "$program" sim "$folder/good.toml" -o "$folder/out" > "$folder/log" 2>&1; then
    cat "$folder/log"
    fail "the good scene runs"
fi
before=$(cd "$folder/out" && sha256sum ./*)

# expect NAME STATUS PATTERN ARGUMENTS...
expect() {
    local name=$1 status=$2 pattern=$3
    shift 3
    cases=$((cases + 1))
    "$program" "$@" > "$folder/log" 2>&1
    local found=$?
    if [[ $found -ne $status ]]; then
        fail "$name: status $found instead of $status"
    elif ! grep -qE "$pattern" "$folder/log"; then
        fail "$name: the message does not match /$pattern/"
    else
        return
    fi
    sed 's/^/    /' "$folder/log"
}

# scene NAME PATTERN SED: the good scene with one line spoilt; the message names file:line:column.
scene() {
    sed -E "$3" "$folder/good.toml" > "$folder/$1.toml"
    expect "$1" 2 "$1\.toml:[0-9]+:[0-9]+: .*$2" sim "$folder/$1.toml" -o "$folder/out"
}

scene zero_viewport 'width_px' 's/^width_px = 64/width_px = 0/'
scene threshold_range 'normal_threshold' 's/^normal_threshold = 0.3/normal_threshold = 7.5/'
scene unknown_key 'nromal_threshold' 's/^normal_threshold/nromal_threshold/'
scene wrong_type 'title' 's/^title = "good"/title = 3/'
scene not_toml '' 's/^quads = .*/quads = [2, /'
scene method_not_built 'not built yet' 's/"adaptive"/"patches"/'
scene method_unknown 'method' 's/"adaptive"/"magic"/'
scene missing_map 'nowhere\.png' 's/^kind = "donut"/file = "nowhere.png"/; /^size_texels/d'
scene missing_mesh 'nowhere\.obj' 's/^kind = "grid"/file = "nowhere.obj"/; /^quads/d'
scene eye_on_target 'eye' 's/^eye = .*/eye = [0.5, 0.5, 0.0]/'
scene position_too_large 'does not fit' 's/^quads = .*/quads = [2, 2]\nsize = [90000.0, 1.0]/'

# mesh NAME EXTENSION PATTERN: the file is there already.
mesh() {
    sed -E "s/^kind = \"grid\"/file = \"$1.$2\"/; /^quads/d" "$folder/good.toml" > "$folder/$1.toml"
    expect "$1" 2 "$3" sim "$folder/$1.toml" -o "$folder/out"
}
printf 'v 0 0 0\nv 1 nan 0\nv 0 1 0\nvt 0 0\nf 1/1 2/1 3/1\n' > "$folder/nan_vertex.obj"
mesh nan_vertex obj 'nan_vertex\.obj:2:[0-9]+: '
printf 'OFF\n3 1 0\n0 0 0\n1 0 0\n' > "$folder/truncated.off"
mesh truncated off 'truncated\.off:[0-9]+:[0-9]+: '
printf 'v 0 0 0\nf 1 2 9\n' > "$folder/bad_index.obj"
mesh bad_index obj 'bad_index\.obj:2:[0-9]+: '
printf 'ply\nformat binary_little_endian 1.0\nelement vertex 99999999\nproperty double x\nproperty double y\nproperty double z\nend_header\n' > "$folder/claims.ply"
mesh claims ply 'claims\.ply: offset [0-9]+: '

# image NAME PATTERN: likewise for a map.
image() {
    sed -E "s/^kind = \"donut\"/file = \"$1.png\"/; /^size_texels/d" "$folder/good.toml" \
        > "$folder/$1.toml"
    expect "$1" 2 "$2" sim "$folder/$1.toml" -o "$folder/out"
}
: > "$folder/empty.png"
image empty 'empty\.png'
# Signature and IHDR of a 100000 x 100000 16-bit grey image, with its checksum, and nothing else.
printf '\x89PNG\r\n\x1a\n\0\0\0\rIHDR\0\x01\x86\xa0\0\x01\x86\xa0\x10\0\0\0\0' > "$folder/huge.png"
python3 - "$folder/huge.png" <<'PYTHON'
import struct, sys, zlib
with open(sys.argv[1], "r+b") as file:
    data = file.read()
    file.write(struct.pack(">I", zlib.crc32(data[12:29])))
    file.write(struct.pack(">I", 0) + b"IDAT" + struct.pack(">I", zlib.crc32(b"IDAT")))
PYTHON
image huge '(100000|16384)'

# elevations NAME EXTENSION PATTERN: likewise for other map files.
elevations() {
    sed -E "s/^kind = \"donut\"/file = \"$1.$2\"/; /^size_texels/d" "$folder/good.toml" \
        > "$folder/$1.toml"
    expect "$1" 2 "$3" sim "$folder/$1.toml" -o "$folder/out"
}
printf '{"width": 2,\n "height": 1, "values": [1 2]}' > "$folder/comma.json"
elevations comma json 'comma\.json:2:[0-9]+: '
printf '{"width": 2, "height": 1, "values": [1, null]}' > "$folder/hole.json"
elevations hole json 'hole\.json: texel \(1, 0\) is not finite.*fill_voids'
printf 'CDF\x01\0\0\0\0\0\0\0\n' > "$folder/truncated.nc"
elevations truncated nc 'truncated\.nc: offset [0-9]+: '

# Lights that the unit `shade` has no registers for.
{
    cat "$folder/good.toml"
    printf '[object.shade]\n[[light]]\ndirection = [1, 0, 0]\n[[light]]\ndirection = [0, 1, 0]\n'
} > "$folder/lights.toml"
expect too_many_lights 2 'lights\.toml:[0-9]+:[0-9]+: object "thing": the scene has 3 lights' \
    sim "$folder/lights.toml" --profile narrow -o "$folder/out"
sed -E 's/^direction.*/&\ncolour = [16, 0, 0]/' "$folder/lights.toml" > "$folder/bright.toml"
expect too_bright 2 'bright\.toml:[0-9]+:[0-9]+: .*light 1 times the diffuse colour.*u2\.10' \
    sim "$folder/bright.toml" -o "$folder/out"

expect no_scene 2 'nowhere\.toml' sim "$folder/nowhere.toml" -o "$folder/out"
expect no_command 2 'subcommand' --bogus
expect level_not_built 2 'not built yet' sim "$folder/good.toml" --level at -o "$folder/out"
expect level_unknown 2 'not a level' sim "$folder/good.toml" --level fast -o "$folder/out"
expect no_profile 2 'default, narrow' sim "$folder/good.toml" --profile nowhere -o "$folder/out"
printf 'uv = "s14.8"\nwidth = 3\n' > "$folder/profile.toml"
expect profile_key 2 'profile\.toml:2:' sim "$folder/good.toml" --profile "$folder/profile.toml" \
    -o "$folder/out"
: > "$folder/file"
expect folder_is_a_file 3 'cannot be created' sim "$folder/good.toml" -o "$folder/file/out"

if [[ $(cd "$folder/out" && sha256sum ./*) != "$before" ]]; then
    fail "an earlier result was touched by a run that failed"
fi
echo "$cases cases, $failures failures"
[[ $failures -eq 0 ]]
