#!/bin/sh
# The subcommands as a script sees them: help, rows, exit codes, what is loaded, what an interruption leaves.
set -u
tmp=$(mktemp -d)
trap 'rm -rf "$tmp"' EXIT
rl=$ROUGHLIGHT
scene=studies/scenes/sphere-quad.yaml
n=0

# check NAME COMMAND...: passes if the command does
check() {
    name=$1
    shift
    n=$((n + 1))
    if "$@" >"$tmp/out" 2>&1; then
        echo "ok - $name"
    else
        echo "not ok - $name: $(head -c 400 "$tmp/out" | tr '\n' ' ')"
    fi
}

# exits CODE COMMAND...
exits() {
    want=$1
    shift
    "$@"
    code=$?
    [ $code -eq "$want" ] || { echo "exit code $code, expected $want"; return 1; }
}

help_teaches() {
    # shellcheck disable=SC2086
    "$rl" $1 --help >"$tmp/help" && grep -q "^usage: roughlight $1" "$tmp/help" && grep -q '^options:' "$tmp/help" &&
        grep -q "  roughlight $1 " "$tmp/help"
}

check "help lists the commands" sh -c "'$rl' --help | grep -q integrate"
check "version" sh -c "'$rl' --version | grep -Eq '^roughlight [0-9]+\.[0-9]+\.[0-9]+ '"
for command in info plan render integrate probe compare illuminance; do
    check "$command --help has usage, options and an example" help_teaches $command
done
verbs="list run status export merge report check"
overview() { for verb in $verbs; do "$rl" study --help | grep -q "^  $verb  *[a-z]" || return 1; done; }
check "study --help lists its verbs" overview
for verb in $verbs; do
    check "study $verb --help has usage, options and an example" help_teaches "study $verb"
done
short() { for verb in list status merge report check; do [ "$("$rl" study $verb --help | wc -l)" -le 30 ] || return 1; done; }
own() { for verb in $verbs; do "$rl" study $verb --help | grep -q -e '--shard I' && echo $verb; done; }
check "an option is in the help of its verbs alone" sh -c "[ \"$(own)\" = run ]"
check "they are short where there are no tables" short

# What a plan leaves out
drops() {
    { cat studies/scenes/lamps.yaml; echo '  - {name: out, position: [0, 9, 0], intensity: [0, 0, 0]}'; } >"$tmp/dark.yaml"
    "$rl" plan "$tmp/dark.yaml" | grep -q "^dropped	light out	its strength is 0$" &&
        ! "$rl" plan "$tmp/dark.yaml" --drop off | grep -q '^dropped' && ! "$rl" plan studies/scenes/lamps.yaml | grep -q '^dropped'
}
check "plan says what it drops, and why" drops

# Where effects are evaluated
interpolates() {
    "$rl" plan studies/scenes/facets.yaml | grep -q "^effect	phong	material gouraud, gouraud: at each vertex$" &&
        "$rl" plan studies/scenes/facets.yaml | grep -q "^module	passes/gouraud_vertex	program [0-9]*, vertex shader$" &&
        "$rl" plan studies/scenes/lamps.yaml --interpolation constant --format json | grep -q "constant: once a triangle" &&
        ! "$rl" plan studies/scenes/lamps.yaml | grep -Eq "gouraud|once a triangle|radiance_|interpolated"
}
check "plan says where effects are interpolated, and scenes without that have nothing of it" interpolates

spheres() {
    "$rl" plan studies/scenes/sphere-quad.yaml --rr 300 --margin auto:0.05 |
        grep -q "^sphere	material .*	margin [0-9.]*; auto: no pixel loses more than 0.05 of the brightest" &&
        "$rl" plan studies/scenes/sphere-quad.yaml --rr 300 --margin auto | grep -q "^sphere	.* more than 0.02 of" &&
        "$rl" plan studies/scenes/sphere-quad.yaml --margin 0.25 | grep -q "^sphere	material [a-z]*	margin 0.25$" &&
        ! "$rl" plan studies/scenes/sphere-quad.yaml | grep -q "^sphere"
}
shares() {
    "$rl" plan studies/scenes/three-lights.yaml | grep -q "^texture	environment map 0	.*; shared by ball: one centre$" &&
        "$rl" plan studies/scenes/two-roughness.yaml | grep -q "^buffer	mesh of right	.*; shared: triangles of left, normals of left,"
}
check "plan says what objects share, and why" shares
check "plan says how large the bounding spheres are, and what they keep" spheres

# Rows
light='-1,-1,2 1,-1,2 1,1,2 -1,1,2'
integrate() { "$rl" integrate --view 0.3,0,1 --rr 30 --light "$light" "$@"; }
one_row() { integrate | awk -F'\t' 'NR == 1 { ok = $0 == "value\terror\tevaluations\tseconds" }
    NR == 2 { ok = ok && NF == 4 && $1 > 0.5 && $1 < 1 && $2 < 1e-9 } END { exit !(ok && NR == 2) }'; }
check "integrate prints a header and a row" one_row
check "integrate prints JSON" sh -c "'$rl' integrate --view 0,0,1 --rr 3 --light '$light' --format json | tr -d '\n ' |
    grep -Eq '^\[\{\"value\":[0-9.e-]+,\"error\":[0-9.e-]+,\"evaluations\":[0-9]+,\"seconds\":[0-9.e-]+\}\]$'"
same_value() { [ "$(integrate | cut -f1 | tail -1)" = "$(integrate --format=tsv --normal 0,0,7 | cut -f1 | tail -1)" ]; }
check "vectors need not be unit length" same_value
# Every method against the reference, within the errors of both: the interval of a random one at five sigma.
agrees() {
    integrate --method "$@" >"$tmp/row" && cat "$tmp/row" && integrate | tail -1 | cat - "$tmp/row" | awk -F'\t' '
        NR == 1 { truth = $1; ok = $2 <= 1e-12 }
        NR == 2 { ok = ok && $0 == "value\terror\tevaluations\tseconds" }
        NR == 3 { off = $1 - truth; ok = ok && off <= $2 + 1e-12 && -off <= $2 + 1e-12 && $2 < 0.01 && $3 > 0 }
        END { exit !(ok && NR == 3) }'
}
check "montecarlo agrees" agrees montecarlo --confidence 0.999999
check "vegas agrees" agrees vegas --confidence 0.999999
check "cubature agrees" agrees cubature
check "cubature-uv agrees" agrees cubature-uv
value_of() { integrate "$@" | cut -f1 | tail -1; }
same_seed() { [ "$(value_of --method montecarlo --seed 5)" = "$(value_of --method montecarlo --seed 5)" ]; }
other_seed() { [ "$(value_of --method montecarlo --seed 5)" != "$(value_of --method montecarlo --seed 6)" ]; }
check "the same seed gives the same value" same_seed
check "another seed gives another" other_seed
wider() { integrate --method montecarlo --max-evaluations 1000 --tolerance 1e-9 "$@" 2>"$tmp/err" | cut -f2 | tail -1; }
level() { awk -v a="$(wider --confidence 0.999)" -v b="$(wider --confidence 0.9)" 'BEGIN { exit !(a > 1.5 * b) }'; }
check "a higher confidence is a wider interval" level
stopped() {
    exits 1 integrate --method montecarlo --max-evaluations 1000 --tolerance 1e-9 >"$tmp/row" 2>"$tmp/err" &&
        [ "$(wc -l <"$tmp/row")" -eq 2 ] && [ "$(cut -f3 "$tmp/row" | tail -1)" -eq 1000 ] &&
        grep -q 'after 1000 samples, the tolerance is 1e-09' "$tmp/err"
}
check "a tolerance out of reach: a row, and exit code 1" stopped
repeated() { [ "$(value_of --repeat 20)" = "$(value_of)" ]; }
check "repeating changes no value" repeated
methods_in_help() { for m in reference montecarlo cubature cubature-uv vegas; do
    "$rl" integrate --help | grep -q "^  $m  " || return 1
done; }
check "integrate --help describes every method" methods_in_help
check "info names every backend" sh -c "'$rl' info | cut -f1 | grep -c '^backend ' | grep -q 3"
check "a full standard output is an error" sh -c "'$rl' info >/dev/full; [ \$? -eq 2 ]"
check "plan prints passes" sh -c "'$rl' plan $scene | grep -q highlight"
check "plan lists meshes and what holds lights" sh -c "test \$('$rl' plan studies/scenes/lamps.yaml | grep -c '^buffer.*\(mesh\|of [0-9]* light\)') = 2"
check "plan prints JSON" sh -c "'$rl' plan $scene --format json | head -c 1 | grep -q '\['"

# Illuminance
office=studies/scenes/office.yaml
lux() { "$rl" illuminance $office --at 0,0.75,0 --normal 0,2,0 "$@"; }
sums_up() { lux | awk -F'\t' 'NR == 1 { ok = $0 == "light\tkind\tred\tgreen\tblue\tvalue\tunit" }
    NR > 1 && $1 != "total" { sum += $6 } NR > 1 { y = 0.2126 * $3 + 0.7152 * $4 + 0.0722 * $5 - $6; ok = ok && NF == 7 && y * y < 1e-18 && $7 == "lx" }
    $1 == "total" { ok = ok && $6 > 500 && $6 < 600 && (sum - $6) ^ 2 < 1e-18; rows = NR } END { exit !(ok && rows == 6 && NR == 6) }'; }
check "illuminance: lights and their sum in lx" sums_up
check "illuminance prints JSON" sh -c "'$rl' illuminance $office --at 0,0.75,0 --normal 0,1,0 --format json | tr -d '\n ' |
    grep -Eq '^\[(\{\"light\":\"[a-z-]+\",\"kind\":\"[a-z]+\",\"red\":[0-9.]+,\"green\":[0-9.]+,\"blue\":[0-9.]+,\"value\":[0-9.]+,\"unit\":\"lx\"\},?){5}\]$'"
check "a radiometric scene: irradiance" sh -c "'$rl' illuminance $scene --at 0,0,0 --normal 0,1,0 | tail -1 | grep -q 'W/m2$'"
open_meshes() {
    polygon='\[\[-1, 2, -1\], \[1, 2, -1\], \[1, 2, 1\], \[-1, 2, 1\]\]'
    printf 'v -1 2 -1\nv 1 2 -1\nv 1 2 1\nv -1 2 1\nf 1 2 3 4\n' >"$tmp/sheet.obj"
    printf 'v -1 2 -1\nv 1 2 -1\nv 1 2 1\nf 1 2 3\n' >"$tmp/one.obj"
    printf 'v -1 2 -1\nv 1 2 -1\nv 1 2 1\nv -1 3 1\nf 1 2 3\nf 1 3 4\n' >"$tmp/bent.obj"
    sed "s/polygon: .*/polygon: $polygon/" studies/scenes/window.yaml >"$tmp/polygon.yaml"
    for of in polygon sheet one bent; do
        [ $of = polygon ] || sed "s/polygon: .*/mesh: $of.obj/" studies/scenes/window.yaml >"$tmp/$of.yaml"
        "$rl" illuminance "$tmp/$of.yaml" --at 0,0,0 --normal 0,1,0 2>"$tmp/$of.err" >"$tmp/$of.rows" || return 1
    done
    sed 's/\tpolygon\t/\tmesh\t/' "$tmp/polygon.rows" | cmp - "$tmp/sheet.rows" && ! cmp -s "$tmp/polygon.rows" "$tmp/sheet.rows" &&
        grep -q '	mesh	' "$tmp/one.rows" && [ ! -s "$tmp/sheet.err" ] && [ ! -s "$tmp/one.err" ] &&
        grep -q "warning: the light .* is an open mesh that is not flat" "$tmp/bent.err"
}
check "open meshes: as their polygon, and a warning where they bend" open_meshes
whites() {
    sed 's/white: 200/white: 100/' $office >"$tmp/white.yaml"
    "$rl" render $office --size 64x48 -o "$tmp/200.exr" && "$rl" render "$tmp/white.yaml" --size 64x48 -o "$tmp/100.exr" &&
        "$rl" compare "$tmp/200.exr" "$tmp/200.exr" && exits 2 "$rl" compare "$tmp/100.exr" "$tmp/200.exr" 2>"$tmp/err" &&
        grep -q "found 1 to be 100 and 200 cd/m2 (whiteLuminance), expected one white" "$tmp/err"
}
check "pictures of two whites do not compare" whites

# Render and compare
check "random 4" "$rl" render $scene --size 64x48 --method random --samples 4 -o "$tmp/a.exr"
check "the same again, by the environment's backend" env ROUGHLIGHT_BACKEND=osmesa "$rl" render $scene --size 64x48 --method random --samples 4 -o "$tmp/b.exr"
check "reference" "$rl" render $scene --size 64x48 --method reference -o "$tmp/r.exr"
ball=studies/scenes/ball-shadow.yaml
check "shadows by a scene's wish" "$rl" render $ball --size 64x48 -o "$tmp/shadow.exr"
check "shadows off" "$rl" render $ball --size 64x48 --shadows off -o "$tmp/open.exr"
check "shadows only darken" sh -c "'$rl' compare '$tmp/shadow.exr' '$tmp/open.exr' |
    awk -F'\t' 'NR == 2 { ok = \$3 > 0.1 && \$4 < -0.005 } END { exit !ok }'"
check "plan shows shadows" sh -c "'$rl' plan $ball | grep -q '^effect.shadows'"
check "plan shows depth, stencil and back faces" sh -c "'$rl' plan $scene >'$tmp/plan.tsv' && grep -q '^buffer.depth.24 bits' '$tmp/plan.tsv' &&
    grep -q '^buffer.stencil' '$tmp/plan.tsv' && grep -q '^culling.back faces' '$tmp/plan.tsv'"
check "no stencil with point lights alone" sh -c "! '$rl' plan studies/scenes/lamps.yaml | grep -q stencil"
check "plan lists render buffers by size and format" sh -c "'$rl' plan $scene --size 64x48 --env-size 32 >'$tmp/plan.tsv' &&
    grep -q '^buffer.colour.64x48 rgba32f' '$tmp/plan.tsv' && grep -q '^buffer.depth.24 bits, 64x48' '$tmp/plan.tsv' &&
    grep -q '^buffer.environment depth.32 bits, float, 32x32' '$tmp/plan.tsv'"
check "none of environment maps where there is no map" sh -c "'$rl' plan studies/scenes/lamps.yaml >'$tmp/plan.tsv' &&
    grep -q '^buffer.colour' '$tmp/plan.tsv' && ! grep -q 'environment' '$tmp/plan.tsv'"
check "no render buffer on the CPU" sh -c "! '$rl' plan $scene --method reference | grep -q '^buffer.\(colour\|depth\|environment\)'"
check "no stencil, 16 bits, backs" sh -c "'$rl' plan $scene --method plain --depth-bits 16 --culling off >'$tmp/plan.tsv' &&
    grep -q '^buffer.depth.16 bits' '$tmp/plan.tsv' && ! grep -q 'stencil\|^culling' '$tmp/plan.tsv'"
check "without a highlight shadows take the scene to the CPU" sh -c "'$rl' plan studies/scenes/window.yaml --shadows on |
    awk -F '\t' '\$1 == \"effect\" && \$2 == \"shadows\" || \$1 == \"pass\" && \$2 == \"cpu\" { n++ } END { exit n != 2 }'"
check "plan shows none when they are off" sh -c "! '$rl' plan $ball --shadows off | grep -q shadows"
budget() {
    "$rl" render $scene --size 64x48 --method reference --max-seconds "$1" --errors "$tmp/errors.exr" -o "$tmp/budget.exr" 2>&1
}
too_little() { budget 0.001 | tee "$tmp/said" && grep -q "of 0.001 s: 1 of 3 passes completed" "$tmp/said" &&
    grep -q "first pass, which is always completed" "$tmp/said"; }
check "a budget too small is a success that says so" too_little
check "a budget that is enough" sh -c "'$rl' render $scene --size 64x48 --method reference --max-seconds 100 -o '$tmp/budget.exr'"
check "gives the image of no budget" sh -c "'$rl' compare '$tmp/budget.exr' '$tmp/r.exr' | tail -1 | cut -f4 | grep -qx 0"
check "the errors are an image" sh -c "'$rl' compare '$tmp/errors.exr' '$tmp/r.exr'"
check "PNG" "$rl" render $scene --size 64x48 -o "$tmp/a.png"
check "equal images compare as equal" sh -c "'$rl' compare '$tmp/a.exr' '$tmp/b.exr' | tail -1 | cut -f1 | grep -qx 0"
check "random 4 against the reference is finite" sh -c "'$rl' compare '$tmp/a.exr' '$tmp/r.exr' |
    awk -F'\t' 'NR == 2 { ok = \$1 > 0 && \$1 < 1 && \$7 == 0 && \$8 > 100 } END { exit !ok }'"
check "a limit that is kept" exits 0 "$rl" compare "$tmp/a.exr" "$tmp/r.exr" --max-rmse 1
# 0.9 and 1.1 times the RMSE, which is not the MAE
rmse=$("$rl" compare "$tmp/a.exr" "$tmp/r.exr" | tail -1 | cut -f1)
scaled() { awk -v x="$rmse" -v f="$1" 'BEGIN { printf "%.9g", x * f }'; }
check "a limit just above the RMSE" exits 0 "$rl" compare "$tmp/a.exr" "$tmp/r.exr" --max-rmse "$(scaled 1.1)"
check "a limit just below the RMSE" exits 1 "$rl" compare "$tmp/a.exr" "$tmp/r.exr" --max-rmse "$(scaled 0.9)"
check "a limit that is not" exits 1 "$rl" compare "$tmp/a.exr" "$tmp/r.exr" --max-rmse 1e-9

# Start-up: what takes long to load is loaded when first used only.
loads_no() { ! ldd "$rl" | grep -Ei "$1"; }
check "OpenImageIO is not linked" loads_no openimageio
check "no OpenGL library is linked" loads_no 'OSMesa|libEGL|libGL'

# Interruption: nothing half-written, code 130.
interrupted() {
    "$rl" render studies/scenes/teapot-star.yaml --method reference --size 2000x1500 --tolerance 1e-9 -o "$tmp/long.exr" 2>"$tmp/err" &
    pid=$!
    sleep 1
    kill -INT $pid
    wait $pid
    code=$?
    [ $code -eq 130 ] && [ -z "$(ls "$tmp" | grep long)" ]
}
check "an interrupted render leaves nothing" interrupted
echo "1..$n"
