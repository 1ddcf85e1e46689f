#!/bin/sh
# Bad input, each a row: exit code 2 and one clear line on stderr, nothing on stdout, no file left behind.
set -u
tmp=$(mktemp -d)
trap 'rm -rf "$tmp"' EXIT
rl=$ROUGHLIGHT
scene=studies/scenes/sphere-quad.yaml
n=0

# bad NAME PATTERN ARGUMENTS...: the message must match the extended regular expression PATTERN
bad() {
    name=$1 pattern=$2
    shift 2
    n=$((n + 1))
    "$rl" "$@" >"$tmp/stdout" 2>"$tmp/stderr"
    code=$?
    why=
    [ $code -eq 2 ] || why="exit code $code, expected 2"
    [ "$(wc -l <"$tmp/stderr")" -eq 1 ] || why="$why; $(wc -l <"$tmp/stderr") lines on stderr, expected 1"
    grep -Eq -- "$pattern" "$tmp/stderr" || why="$why; no /$pattern/"
    [ -s "$tmp/stdout" ] && why="$why; something on stdout"
    if [ -z "$why" ]; then
        echo "ok - $name"
    else
        echo "not ok - $name ($why): $(cat "$tmp/stderr")"
    fi
}

# A good scene with one line replaced: edit NAME 's/sed/expression/' -> $tmp/NAME.yaml
edit() {
    sed -E "$2" "$tmp/good.yaml" >"$tmp/$1.yaml"
}

cat >"$tmp/good.yaml" <<'YAML'
film: {width: 32, height: 24}
camera: {position: [0, 0, 5], target: [0, 0, 0], field-of-view: 40}
materials:
  - name: shiny
    rr: 30
    highlight: random
objects:
  - shape: sphere
    material: shiny
    tessellation: 4
lights:
  - name: quad
    polygon: [[-1, 3, -1], [1, 3, -1], [1, 3, 1], [-1, 3, 1]]
    radiance: [1, 1, 1]
YAML
"$rl" render "$tmp/good.yaml" -o "$tmp/good.exr" 2>"$tmp/stderr" && echo "ok - the good scene renders" ||
    echo "not ok - the good scene renders: $(cat "$tmp/stderr")"
n=$((n + 1))

bad "no command" "command is missing"
bad "unknown command" "unknown command 'rendr'" rendr
bad "unknown option" "unknown option '--sample'; did you mean '--samples'" render $scene -o "$tmp/x.exr" --sample 3
bad "option without its argument" "--samples: an argument is missing" render $scene --samples
bad "missing scene file" "nowhere.yaml: .*No such file" render nowhere.yaml -o "$tmp/x.exr"
bad "scene is a directory" "studies" render studies -o "$tmp/x.exr"
bad "no output" "--output is missing" render $scene
bad "output of an unknown kind" "expected a file name ending in .exr or .png" render $scene -o "$tmp/x.jpg"
bad "output in a missing folder" "/no/such/x.exr: cannot write" render $scene -o "$tmp/no/such/x.exr"
bad "output is a folder" "expected a file name ending" render $scene -o "$tmp/"
mkdir "$tmp/dir.exr"
bad "output names a directory" "is a directory" render $scene -o "$tmp/dir.exr"
for samples in 0 100000 -1 4.5 four ''; do
    bad "samples '$samples'" "--samples: found '$samples', expected a whole number from 1 to 1024" \
        render $scene -o "$tmp/x.exr" --samples "$samples"
done
for rr in -1 nan 0 inf 1e13 x; do
    bad "option rr $rr" "--rr: found '$rr', expected" render $scene -o "$tmp/x.exr" --rr "$rr"
done
bad "unknown method" "--method: found 'magic', expected one of plain, regular, random" render $scene -o "$tmp/x.exr" --method magic
bad "size" "--size: found '0x5'" render $scene -o "$tmp/x.exr" --size 0x5
bad "size with a tail" "--size: found '5x5x'" render $scene -o "$tmp/x.exr" --size 5x5x
bad "normal bits" "--normal-bits: found '3'" render $scene -o "$tmp/x.exr" --normal-bits 3
bad "environment format" "--env-format: found 'rgb'" render $scene -o "$tmp/x.exr" --env-format rgb
bad "margin" "--margin: found '-1'" render $scene -o "$tmp/x.exr" --margin -1
bad "margin's bound" "--margin: found 'auto:1', expected a bound from 1e-6 to 0.999" plan $scene --margin auto:1
bad "interpolation" "--interpolation: found 'flat', expected phong, gouraud or constant" \
    render $scene -o "$tmp/x.exr" --interpolation flat
bad "backend" "'vulkan'" render $scene -o "$tmp/x.exr" --backend vulkan
bad "shadows" "--shadows: found 'yes', expected on or off" render $scene -o "$tmp/x.exr" --shadows yes
bad "shadows of a GPU method" "shadows are on, .*method random .*--method reference, or --shadows off" \
    render $scene -o "$tmp/x.exr" --method random --shadows on
bad "shadows of a method that does not integrate" "shadows are on, .*method plain " plan $scene --method plain --shadows on
bad "culling" "--culling: found 'front', expected on or off" plan $scene --culling front
bad "depth bits" "--depth-bits: found 20, expected 16, 24 or 32" plan $scene --depth-bits 20
bad "depth bits of no number" "--depth-bits: found 'deep', expected" plan $scene --depth-bits deep
bad "reversed depth" "--reversed-depth: found '1', expected on or off" plan $scene --reversed-depth 1
bad "16 bits of depth without a stencil" "16 bits, .*method random.*--depth-bits 24 or 32, .*--method plain" plan $scene --depth-bits 16
bad "budget" "--max-seconds: found '0', expected" render $scene -o "$tmp/x.exr" --method reference --max-seconds 0
bad "budget of a GPU method" "--max-seconds: .*GPU.*--method reference" render $scene -o "$tmp/x.exr" --method random --max-seconds 3
bad "errors of a GPU method" "--errors: .*GPU.*--method reference" render $scene -o "$tmp/x.exr" --method random --errors "$tmp/xe.exr"
bad "errors as PNG" "--errors: found '.*xe.png', expected .*\.exr" render $scene -o "$tmp/x.exr" --method reference --errors "$tmp/xe.png"
bad "errors over the image" "--errors: .*another file" render $scene -o "$tmp/x.exr" --method reference --errors "$tmp/x.exr"
bad "seed" "--seed: found '-3'" render $scene -o "$tmp/x.exr" --seed -3

# Options that the method has no use for: METHOD OPTION VALUE, and what has one. The same of plan, which says what render would do.
while read -r method option value others; do
    bad "$option of $method" "^roughlight render: $option has no effect with the method $method; it is for $others$" \
        render $scene -o "$tmp/x.exr" --method "$method" "$option" "$value"
    bad "$option of $method, planned" "^roughlight plan: $option has no effect" plan $scene --method "$method" "$option" "$value"
done <<'END'
plain --samples 14 regular, random
reference --samples 4 regular, random
regular --normal-bits 8 random
exhaustive --normal-size 256 random
regular --seed 3 random
reference --env-size 64 regular, random, exhaustive
exhaustive --env-format rgba8 regular, random
plain --margin 0.2 regular, random
plain --attenuation off regular, random, exhaustive, reference
plain --frame printed regular, random, exhaustive, reference
random --tolerance 1e-3 reference
exhaustive --light-from object reference
END
edit plain 's/highlight: random/highlight: plain/'
bad "-n of the scene's own method" "--samples has no effect with the method plain; it is for" render "$tmp/plain.yaml" -n 3 -o "$tmp/x.exr"
bad "samples where nothing is highlit" "--samples has no effect: no material of .*lamps.yaml has a highlight" \
    render studies/scenes/lamps.yaml -n 3 -o "$tmp/x.exr"
bad "errors of a method without" "--errors: found the method exhaustive, which states no error, expected --method reference" \
    render $scene -o "$tmp/x.exr" --method exhaustive --errors "$tmp/xe.exr"
bad "budget of a method without passes" "--max-seconds: found the method exhaustive" \
    render $scene -o "$tmp/x.exr" --method exhaustive --max-seconds 3
bad "a backend to plan on" "unknown option '--backend'" plan $scene --backend osmesa
for threads in 0 -1 1.5 99999 ''; do
    bad "threads '$threads'" "--threads: found '$threads', expected a whole number from 1 to 1024" \
        render $scene -o "$tmp/x.exr" --threads "$threads"
done
bad "normal size" "--normal-size: found 100, expected a power of two" render $scene -o "$tmp/x.exr" --normal-size 100
bad "environment size" "--env-size: found '7', expected a whole number from 8" render $scene -o "$tmp/x.exr" --env-size 7
bad "frame" "--frame: found 'foo', expected orthonormal or printed" render $scene -o "$tmp/x.exr" --frame foo
bad "light from" "--light-from: found 'here', expected point or object" render $scene -o "$tmp/x.exr" --method reference --light-from here
bad "drop" "--drop: found 'maybe', expected on or off" render $scene -o "$tmp/x.exr" --drop maybe
bad "a long option with one dash" "unknown option '-size'; did you mean '--size'" render $scene -o "$tmp/x.exr" -size 3x3
bad "two scenes" "unexpected argument '.*'; usage: roughlight render SCENE" render $scene $scene -o "$tmp/x.exr"
bad "a device as output" "--output: found '/dev/full'" render $scene -o /dev/full
bad "a device as scene" "/dev/full: not a regular file" render /dev/full -o "$tmp/x.exr"
bad "a folder to plan" "$tmp: not a regular file" plan "$tmp"
bad "rows of no kind" "--format: found 'csv', expected tsv or json" plan $scene --format csv
bad "a name with an end of line" "a\?b.yaml: cannot open" plan "$(printf 'a\nb.yaml')"

edit wrong-key 's/rr: 30/roughness: 30/'
bad "wrong key in a scene" "wrong-key.yaml:5: .*roughness" render "$tmp/wrong-key.yaml" -o "$tmp/x.exr"
for rr in -1 .nan nan 0 .inf 1e400; do
    edit rr "s/rr: 30/rr: $rr/"
    bad "scene with rr $rr" "rr.yaml:5: .*rr.*expected" render "$tmp/rr.yaml" -o "$tmp/x.exr"
done
edit two 's/polygon: .*/polygon: [[0, 3, 0], [1, 3, 0]]/'
bad "light with 2 vertices" "two.yaml:13: .*2 vertices.*3" render "$tmp/two.yaml" -o "$tmp/x.exr"
edit bent 's/\[1, 3, 1\]/[1, 4, 1]/'
bad "non-planar light" "bent.yaml:13: .*plan" render "$tmp/bent.yaml" -o "$tmp/x.exr"
edit flat 's/polygon: .*/polygon: [[0, 3, 0], [1, 3, 0], [2, 3, 0]]/'
bad "light without area" "flat.yaml:13: .*area" render "$tmp/flat.yaml" -o "$tmp/x.exr"
edit bow 's/polygon: .*/polygon: [[0, 3, 0], [1, 3, 1], [1, 3, 0], [0, 3, 1]]/'
bad "light that crosses itself" "bow.yaml:13: " render "$tmp/bow.yaml" -o "$tmp/x.exr"
edit method 's/highlight: random/highlight: magic/'
bad "unknown method in a scene" "method.yaml:6: .*magic.*expected.*random" render "$tmp/method.yaml" -o "$tmp/x.exr"
edit material 's/material: shiny/material: dull/'
bad "unknown material" "material.yaml:9: .*dull" render "$tmp/material.yaml" -o "$tmp/x.exr"
{ cat "$tmp/good.yaml" && printf 'render:\n  shadows: maybe\n'; } >"$tmp/shadows.yaml"
bad "shadows in a scene" "shadows.yaml:1[0-9]: .*maybe" render "$tmp/shadows.yaml" -o "$tmp/x.exr"
edit shape 's/shape: sphere/shape: cube/'
bad "unknown shape" "shape.yaml:8: .*cube" render "$tmp/shape.yaml" -o "$tmp/x.exr"
edit number 's/width: 32/width: wide/'
bad "text for a number" "number.yaml:1: .*width" render "$tmp/number.yaml" -o "$tmp/x.exr"
: >"$tmp/empty.yaml"
bad "empty scene" "empty.yaml" render "$tmp/empty.yaml" -o "$tmp/x.exr"
head -c 3000 /dev/urandom >"$tmp/junk.yaml"
bad "junk scene" "junk.yaml" render "$tmp/junk.yaml" -o "$tmp/x.exr"

# Meshes
edit mesh 's/shape: sphere/shape: mesh\n    file: m.ply/; /tessellation/d'
mesh_header='ply\nformat ascii 1.0\nelement vertex %d\nproperty float x\nproperty float y\nproperty float z\nelement face %d\nproperty list uchar int vertex_indices\nend_header\n'
bad "missing mesh" "m.ply" render "$tmp/mesh.yaml" -o "$tmp/x.exr"
# shellcheck disable=SC2059
printf "$mesh_header" 0 0 >"$tmp/m.ply"
bad "empty mesh" "m.ply" render "$tmp/mesh.yaml" -o "$tmp/x.exr"
# shellcheck disable=SC2059
{ printf "$mesh_header" 3 2 && printf '0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n'; } >"$tmp/m.ply"
bad "truncated PLY" "m.ply" render "$tmp/mesh.yaml" -o "$tmp/x.exr"

# compare
"$rl" render "$tmp/good.yaml" -o "$tmp/small.exr" --size 16x12 2>"$tmp/stderr" || cat "$tmp/stderr"
bad "images of different size" "32.?x.?24.*16.?x.?12" compare "$tmp/good.exr" "$tmp/small.exr"
bad "missing image" "none.exr" compare "$tmp/good.exr" "$tmp/none.exr"
head -c 100 "$tmp/good.exr" >"$tmp/cut.exr"
bad "truncated image" "cut.exr" compare "$tmp/good.exr" "$tmp/cut.exr"
bad "not an image" "junk.yaml" compare "$tmp/good.exr" "$tmp/junk.yaml"
bad "one image" "argument is missing" compare "$tmp/good.exr"
bad "three images" "unexpected argument 'x'; usage: roughlight compare IMAGE REFERENCE" compare "$tmp/good.exr" "$tmp/good.exr" x
bad "a folder as image" "$tmp: not a regular file, an image expected" compare "$tmp/good.exr" "$tmp"
for limit in nan -1 x ''; do
    bad "compare: at most '$limit'" "^roughlight compare: --max-rmse: found '$limit', expected a number from 0" \
        compare "$tmp/good.exr" "$tmp/good.exr" --max-rmse "$limit"
done
bad "compare: mismatched" "--max-mismatched: found '1.5', expected a whole number" compare "$tmp/good.exr" "$tmp/good.exr" --max-mismatched 1.5
bad "compare: errors in a missing folder" "/no/x.exr: cannot write: No such file" compare "$tmp/good.exr" "$tmp/good.exr" -o "$tmp/no/x.exr"
bad "compare: errors as PNG" "--error-image: found '.*x.png', expected .*\.exr" compare "$tmp/good.exr" "$tmp/good.exr" -o "$tmp/x.png"
bad "compare: errors over an image" "--error-image: found '.*/./good.exr', expected another file" \
    compare "$tmp/good.exr" "$tmp/small.exr" -o "$tmp/./good.exr"

# illuminance
bad "illuminance without a point" "--at is missing, expected x,y,z" illuminance $scene --normal 0,1,0
bad "illuminance without a normal" "--normal is missing, expected x,y,z" illuminance $scene --at 0,0,0
bad "illuminance without a scene" "argument is missing" illuminance --at 0,0,0 --normal 0,1,0
bad "a point of two numbers" "--at: found '0,0', expected three finite numbers x,y,z" illuminance $scene --at 0,0 --normal 0,1,0
bad "a normal of no length" "--normal: found the zero vector '0,0,0', expected a direction" illuminance $scene --at 0,0,0 --normal 0,0,0
bad "a point at a light" "--at: found the place of the light lamp, expected a point away" illuminance studies/scenes/office.yaml \
    --at -0.55,1.2,-0.45 --normal 0,1,0
edit unit 's/radiance: .*/flux: 800 cd/'
bad "wrong unit" "unit.yaml:14: lights\[0\].flux: found '800 cd', expected a luminous flux .* in lm.*cd is the unit of luminous-intensity" \
    illuminance "$tmp/unit.yaml" --at 0,0,0 --normal 0,1,0
{ cat "$tmp/good.yaml" && printf '  - {name: bulb, position: [0, 9, 0], flux: 800 lm}\n'; } >"$tmp/mixed.yaml"
bad "radiometric and photometric lights" "mixed.yaml:15: .*photometric flux of bulb, and in line 14 the radiometric radiance of quad" \
    render "$tmp/mixed.yaml" -o "$tmp/x.exr"

# integrate
light='-1,-1,2 1,-1,2 1,1,2 -1,1,2'
bad "integrate without a light" "--light is missing" integrate --view 0,0,1 --rr 3
bad "integrate: light with 2 vertices" "--light 1: .*2 vertices" integrate --view 0,0,1 --rr 3 --light '0,0,1 1,0,1'
bad "integrate: vertex" "--light 1: vertex 2 .*expected three" integrate --view 0,0,1 --rr 3 --light '0,0,1 1,0 1,1,1'
bad "integrate: vertex too far" "^roughlight integrate: --light 1: vertex 1: found 1e.300, expected coordinates from -1e.09 to 1e.09$" \
    integrate --view 0,0,1 --rr 3 --light "1e300,0,1 1,0,1 1,1,1"
bad "integrate: position too far" "--position: found -2e.09, expected coordinates from -1e.09 to 1e.09" \
    integrate --view 0,0,1 --position 0,0,-2e9 --rr 3 --light "$light"
bad "integrate: zero normal" "--normal: found the zero vector" integrate --view 0,0,1 --normal 0,0,0 --rr 3 --light "$light"
bad "integrate: rr" "--rr: found 'nan'" integrate --view 0,0,1 --rr nan --light "$light"
bad "integrate without a view" "--view is missing" integrate --rr 3 --light "$light"
bad "integrate: method" "--method: found 'guess', expected one of reference, .*montecarlo.*cubature.*vegas" \
    integrate --view 0,0,1 --rr 3 --light "$light" --method guess
bad_option() { # METHOD OPTION VALUE PATTERN
    bad "integrate: --method $1 $2 '$3'" "$4" integrate --view 0,0,1 --rr 3 --light "$light" --method "$1" "$2" "$3"
}
bad_option reference --seed 3 "--seed has no effect with --method reference; it is for .*montecarlo"
bad_option cubature --confidence 0.9 "--confidence has no effect with --method cubature; it is for .*montecarlo"
bad_option montecarlo --env-size 64 "--env-size has no effect with --method montecarlo"
for seed in -1 1.5 x '' 99999999999999999999; do
    bad_option montecarlo --seed "$seed" "--seed: found '$seed', expected a whole number from 0"
done
for confidence in 0 1 99 nan; do
    bad_option vegas --confidence $confidence "--confidence: found '$confidence', expected a number from 0.5"
done
for most in 0 -5 1e6; do
    bad_option cubature --max-evaluations $most "--max-evaluations: found '$most', expected a whole number from 1"
done
for tolerance in 0 -1e-3 1 inf; do
    bad_option vegas --tolerance $tolerance "--tolerance: found '$tolerance', expected a number from 1e-14 to 0.1"
done
bad_option reference --repeat 0 "--repeat: found '0', expected a whole number from 1"
bad "integrate: the printed frame has no density" "cubature: the printed frame has collapsed" \
    integrate --view 1,0,1 --normal 1,0,0 --rr 3 --light "$light" --method cubature --frame printed

# study: every verb, and the options of the others
bad "study without a verb" "^roughlight study: found nothing, expected list, run, status, export, merge, report or check$" study
bad "an unknown verb" "^roughlight study: found 'runs', expected list, run" study runs
bad "help of an unknown verb" "^roughlight study: found 'runs', expected list, run" study runs --help
# VERB OPTION [VALUE]: those it belongs to
while read -r verb option value verbs; do
    [ "$value" = - ] && value=
    # shellcheck disable=SC2086
    bad "study $verb $option" "^roughlight study $verb: $option belongs to study $verbs$" study $verb $option $value
done <<'END'
list --shard 1/2 run
list --output x export, report
list --db x run, status, export, report
status --quick - run
status --output x export, report
export --retry - run
export --backend osmesa run, report, check
report --scene foo run, check
report --format json list, run, status, export, check
merge --axis foo=bar run
merge --db x run, status, export, report
run --study samples merge
run --write x check
check --full - run
check --axis rr=3 run
check --allow-mixed - merge
END
bad "before the verb too" "^roughlight study list: --shard belongs to study run$" study --shard 1/2 list
bad "study run: no study" "^roughlight study run: found no study, expected at least one; 'roughlight study list'" study run
bad "study run: an unknown study" "^roughlight study run: there is no study 'sample'; 'roughlight study list'" study run samples sample
bad "study run: an unknown option" "unknown option '--quik'; did you mean '--quick'" study run samples --quik
bad "study list: an unknown option" "unknown option '--quik'; 'roughlight study list --help' lists them" study list --quik
bad "study list: a name too many" "unexpected argument 'samples'; usage: roughlight study list " study list samples
bad "study merge: one file" "an argument is missing; usage: roughlight study merge INTO FROM" study merge "$tmp/x.db"
bad "study run: quick and full" "--quick and --full: found both" study run samples --quick --full
bad "study run: rows of no dry run" "--format has no effect without --dry-run" study run samples --format json
bad "study status: an empty name" "^roughlight study status: --db: found an empty name, which is none" study status --db ''
bad "study export: an empty folder name" "--output: found an empty name, which is none" study export --output=
bad "an empty positional" "found an empty argument, expected a name; usage: roughlight compare IMAGE" compare '' "$tmp/good.exr"

bad "study status: a folder" "$tmp: not a regular file, a results database" study status --db "$tmp"
bad "study status: a device" "/dev/null: not a regular file, a results database" study status --db /dev/null
bad "study run: a device" "/dev/full: not a regular file" study run samples --quick --db /dev/full
bad "study run: point lights only" "lamps.yaml: found no shaped light \(and 2 without a shape\), expected a polygon or mesh light" \
    study run samples --quick --scene studies/scenes/lamps.yaml --db "$tmp/x.db"
bad "study run: an axis twice" "--axis rr: given twice" study run samples --axis rr=1 --axis rr=2 --db "$tmp/x.db"
bad "study export: a file as folder" "good.exr: exists and is not a folder|not an SQLite" study export --db "$tmp/good.exr" -o "$tmp/good.exr"

# info and probe
bad "info: a name too many" "unexpected argument 'extra'" info extra
bad "info: unknown format" "--format: found 'yaml', expected tsv or json" info --format yaml
bad "probe: no function" "an argument is missing; usage: roughlight probe FUNCTION" probe
bad "probe: unknown function" "function 'nosuch': expected one of ellipsoid-pdf" probe nosuch
bad "probe: backend" "backend 'vulkan': expected auto" probe frame --backend vulkan

# A disk without room for what is printed, help as well
full() {
    n=$((n + 1))
    "$rl" "$@" >/dev/full 2>"$tmp/stderr"
    code=$?
    if [ $code -eq 2 ] && [ "$(wc -l <"$tmp/stderr")" -eq 1 ] && grep -q "standard output: cannot write: No space" "$tmp/stderr"; then
        echo "ok - $1 onto a full disk"
    else
        echo "not ok - $1 onto a full disk (exit code $code): $(cat "$tmp/stderr")"
    fi
}
for words in --help --version "info --help" "study run --help" "study list" "plan $scene" "study run samples --quick --dry-run --db $tmp/x.db"; do
    # shellcheck disable=SC2086
    full $words
done
full compare "$tmp/good.exr" "$tmp/good.exr"
full integrate --view 0,0,1 --rr 3 --light "$light"

# make faults: a name that is none, before anything is built
for run in "make --no-print-directory faults F=nosuch" "tests/faults/run.sh nosuch"; do
    n=$((n + 1))
    # shellcheck disable=SC2086
    env -u MAKEFLAGS -u MAKELEVEL SETUP=check $run >"$tmp/stdout" 2>"$tmp/stderr"
    code=$?
    if [ $code -eq 2 ] && [ ! -s "$tmp/stdout" ] && [ "$(wc -l <"$tmp/stderr")" -eq 1 ] &&
        grep -q "no fault is called 'nosuch'; there are: .*d-value" "$tmp/stderr"; then
        echo "ok - $run"
    else
        echo "not ok - $run (exit code $code): $(cat "$tmp/stdout" "$tmp/stderr")"
    fi
done

# The instruction set
for simd in SSE AVX512 best; do
    export ROUGHLIGHT_SIMD=$simd
    bad "ROUGHLIGHT_SIMD=$simd" "ROUGHLIGHT_SIMD: found '$simd', expected plain, avx2 or avx512" info
done
unset ROUGHLIGHT_SIMD

n=$((n + 1))
left=$(find "$tmp" -name '*x.*' ! -name '*.yaml' | head -3)
[ -z "$left" ] && echo "ok - no output file is left behind" || echo "not ok - left behind: $left"
echo "1..$n"
