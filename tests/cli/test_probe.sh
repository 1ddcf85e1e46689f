#!/bin/sh
# probe as a script sees it: rows, headers, backends, and what is said of a wrong row.
set -u
tmp=$(mktemp -d)
trap 'rm -rf "$tmp"' EXIT
rl=$ROUGHLIGHT
# shellcheck source=tests/support/check.sh
. tests/support/check.sh

# gives ROWS RESULT ARGUMENTS...: rows on stdin give just these rows on stdout
gives() {
    rows=$1
    want=$2
    shift 2
    got=$(printf "$rows" | "$rl" probe "$@") || return 1
    [ "$got" = "$(printf "$want")" ] || { echo "got $got"; return 1; }
}

# refuses ROWS MESSAGE ARGUMENTS...: exit 2, one line, nothing on stdout
refuses() {
    rows=$1
    want="roughlight probe: $2"
    shift 2
    printf "$rows" | "$rl" probe "$@" >"$tmp/out" 2>"$tmp/err"
    code=$?
    [ $code -eq 2 ] && [ ! -s "$tmp/out" ] && [ "$(cat "$tmp/err")" = "$want" ] || {
        echo "exit $code, got $(cat "$tmp/err")"
        return 1
    }
}

check "a row" gives '1 0\n' 'pdf\n0.5\n' ellipsoid-pdf
check "tabs, a header, empty lines, no line end" gives 'rr\tdelta\n\n1\t0\n \n1\t0' 'pdf\n0.5\n0.5\n' ellipsoid-pdf
check "no rows" gives '' 'pdf\n' ellipsoid-pdf
check "several columns" gives '0 0 7\n' 'tx\tty\ttz\tbx\tby\tbz\n1\t-0\t-0\t-0\t1\t-0\n' frame
check "the shader says the same" gives '1 0.25 0.5 1\n' 'g\n0.5\n' attenuation --backend gpu
check "JSON" gives '1 0.25 0.5 1\n' '[\n  {"g": 0.5}\n]\n' attenuation --format json
check "a word" refuses 'rr delta\n1 0\n1 x\n' "standard input:3: delta: found 'x', expected a finite number" ellipsoid-pdf
check "not finite" refuses '1 nan\n' "standard input:1: delta: found 'nan', expected a finite number" ellipsoid-pdf
check "a header too late" refuses '1 0\nrr delta\n' "standard input:2: rr: found 'rr', expected a finite number" ellipsoid-pdf
check "too few columns" refuses '1\n' "standard input:1: found 1 columns, expected 2" ellipsoid-pdf
check "too many columns" refuses '1 0 0\n' "standard input:1: found 3 columns, expected 2" ellipsoid-pdf
check "out of range" refuses '1 0\n\n1 2\n' "standard input:3: delta: found 2, expected -1.5708 to 1.5708" ellipsoid-pdf
check "no direction" refuses '0 0 0\n' "standard input:1: nx, ny, nz: found the zero vector, expected a direction" frame
check "cpu only" refuses '0 0 1 0 0 1 0 0 1\n' "fur-half: no shader has this function, expected the backend cpu" fur-half --backend gpu
eye='0 0 1 0 0 1 0 0 1'
check "a colour in part" refuses "$eye 0.5 - - - - - - - - 0.1 0\n" \
    "standard input:1: reflectance_g: found -, expected a number, as for reflectance_r: a colour has three channels or none" cook-torrance
check "a colour but for its last channel" refuses "$eye - - - 1.5 1.5 - 0 0 0\n" \
    "standard input:1: n_b: found -, expected a number, as for n_g: a colour has three channels or none" fresnel
check "a colour without its first channel" refuses "$eye - - - 1.5 1.5 1.5 - 0 0\n" \
    "standard input:1: k_g: found a number, expected -, as for k_r: a colour has three channels or none" fresnel
unknown() { "$rl" probe nothing </dev/null 2>&1 | grep -q "^roughlight probe: function 'nothing': expected one of ellipsoid-pdf, "; }
check "an unknown function" unknown
listed() { "$rl" probe --help | grep -q '^    n_h n_v n_l v_h -> g$'; }
check "--help lists columns" listed

summary
