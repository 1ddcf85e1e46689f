#!/bin/sh
# Values that pictures of light should not have, at the command line: counted on stderr, never silent; and what a PNG clips.
set -u
tmp=$(mktemp -d)
trap 'rm -rf "$tmp"' EXIT
rl=$ROUGHLIGHT

# check NAME CONDITION...: the condition is a command
check() {
    name=$1
    shift
    if "$@"; then echo "ok - $name"; else echo "not ok - $name: $(cat "$tmp/err")"; fi
}

# picture FILE BYTES: a PFM of 2 x 1 pixels, six little-endian floats as octal escapes
picture() {
    printf 'PF\n2 1\n-1.0\n' >"$1"
    # shellcheck disable=SC2059
    printf "$2" >>"$1"
}
half='\000\000\000\077' zero='\000\000\000\000' huge='\312\362\111\161' negative='\157\022\203\273' cent='\012\327\043\274'
nan='\000\000\300\177' inf='\000\000\200\177'
picture "$tmp/plain.pfm" "$half$half$half$half$half$zero"
picture "$tmp/hdr.pfm" "$huge$negative$half$cent$half$half"
picture "$tmp/broken.pfm" "$nan$inf$half$half$negative$half"

"$rl" compare "$tmp/plain.pfm" "$tmp/plain.pfm" >"$tmp/out" 2>"$tmp/err"
check "of an ordinary picture nothing is said" [ $? -eq 0 -a ! -s "$tmp/err" ]
"$rl" compare "$tmp/plain.pfm" "$tmp/hdr.pfm" >"$tmp/out" 2>"$tmp/err"
check "values of 1e30 and negative ones are compared" [ $? -eq 0 ]
check "and counted" [ "$(cat "$tmp/err")" = \
    "compare: $tmp/hdr.pfm: of 6 values 0 are NaN or infinite, 2 negative (least -0.01), 1 above 65504, the largest half (most 1e+30)" ]
check "every figure is finite, the relative error too" sh -c "tail -n 1 '$tmp/out' | awk '{ exit !(\$5 < 2000 && \$7 == 0 && !/nan|inf/) }'"
"$rl" compare "$tmp/broken.pfm" "$tmp/plain.pfm" >"$tmp/out" 2>"$tmp/err"
check "NaN and infinity fail" [ $? -eq 1 ]
check "and are counted on both streams" [ "$(head -n 1 "$tmp/err")" = \
    "compare: $tmp/broken.pfm: of 6 values 2 are NaN or infinite, 1 negative (least -0.004), 0 above 65504, the largest half (most 0.5)" -a \
    "$(tail -n 1 "$tmp/out" | cut -f 7)" = 2 ]

# A light a hundred times as bright.
sed 's/radiance: \[[^]]*\]/radiance: [100, 100, 0.5]/' studies/scenes/sphere-quad.yaml >"$tmp/bright.yaml"
"$rl" render "$tmp/bright.yaml" --size 48x36 --method plain -o "$tmp/bright.exr" 2>"$tmp/err"
check "an EXR loses nothing" sh -c "! grep -q clipped '$tmp/err'"
"$rl" render "$tmp/bright.yaml" --size 48x36 --method plain -o "$tmp/bright.png" 2>"$tmp/err"
check "a PNG of a bright light is written" [ -s "$tmp/bright.png" ]
clipped=$(sed -n 's/^render: warning: \([0-9]*\) values outside \[0, 1\] were clipped in .*: \1 above 1, 0 below 0, 0 without coverage; .exr keeps them$/\1/p' "$tmp/err")
check "with one line that says how many values it clipped (${clipped:-none})" [ "${clipped:-0}" -gt 100 ]
"$rl" compare "$tmp/bright.png" "$tmp/bright.exr" >"$tmp/out" 2>"$tmp/err"
check "the file itself says so, and compare tells" [ "$(grep -c "^compare: $tmp/bright.png: $clipped of its values were clipped when it was written$" "$tmp/err")" -eq 1 ]
sed 's/radiance: \[[^]]*\]/radiance: [0.1, 0.1, 0.1]/' studies/scenes/sphere-quad.yaml >"$tmp/dim.yaml"
"$rl" render "$tmp/dim.yaml" --size 48x36 --method plain -o "$tmp/dim.png" 2>"$tmp/err"
check "one that fits says nothing" sh -c "! grep -q clipped '$tmp/err'"
