#!/bin/sh
# hard as a script sees it: a row for each function and backend, exit 1 and a line on stderr for each row beyond its bound.
set -u
tmp=$(mktemp -d)
trap 'rm -rf "$tmp"' EXIT
rl=$ROUGHLIGHT
# shellcheck source=tests/support/check.sh
. tests/support/check.sh

header='n_h\tn_v\tn_l\tv_h\tg\tg_bound\tg_single\tg_single_bound\twhy'
file=$tmp/attenuation.tsv
columns=$(printf 'function\tbackend\trows\tfailed\tworst_ulp\tworst_share\tresult\terror\tbound\tline\twhy')

good() {
    printf "$header\n1\t0.25\t0.5\t1\t0.5\t1e-15\t0.5\t1e-6\tplain\n" >"$file"
    "$rl" hard "$file" >"$tmp/out" 2>"$tmp/err" && [ ! -s "$tmp/err" ] &&
        [ "$(cat "$tmp/out")" = "$(printf "$columns\nattenuation\tcpu\t1\t0\t0\t0\tg\t0\t1e-15\t2\tplain\nattenuation\tgpu\t1\t0\t0\t0\tg\t0\t1e-06\t2\tplain")" ]
}
check "both backends" good

one() {
    [ "$("$rl" hard "$file" --backend cpu | wc -l)" -eq 2 ] && "$rl" hard "$file" --backend gpu --format json |
        grep -q '"backend": "gpu", "rows": 1, "failed": 0'
}
check "one backend" one

bad() {
    printf "$header\n1\t0.25\t0.5\t1\t0.5\t1e-15\t0.5\t1e-6\tright\n1\t0.25\t0.5\t1\t0.75\t1e-15\t0.5\t1e-6\tdoctored\n" >"$file"
    "$rl" hard "$file" >"$tmp/out" 2>"$tmp/err"
    [ $? -eq 1 ] && [ "$(cut -f 2,4 "$tmp/out" | tail -n 2)" = "$(printf 'cpu\t1\ngpu\t0')" ] &&
        grep -q '^roughlight hard: 1 rows beyond their bounds$' "$tmp/err" &&
        grep -q "^$file:3: cpu, g: found 0.5, expected 0.75 within 1e-15, 0.25 away (2.25e+15 ulp): doctored$" "$tmp/err"
}
check "a row that fails" bad

unreadable() {
    printf "$header\n1\t0.25\n" >"$file"
    "$rl" hard "$file" >"$tmp/out" 2>"$tmp/err"
    [ $? -eq 2 ] && [ ! -s "$tmp/out" ] && grep -q "^roughlight hard: $file:2: found 2 columns, expected 9" "$tmp/err"
}
check "a file that is wrong" unreadable

# refuses MESSAGE FILE...: exit 2, one line, nothing on stdout
refuses() {
    want="roughlight hard: $1"
    shift
    "$rl" hard "$@" >"$tmp/out" 2>"$tmp/err"
    [ $? -eq 2 ] && [ ! -s "$tmp/out" ] && [ "$(cat "$tmp/err")" = "$want" ] || { cat "$tmp/err"; return 1; }
}
check "no such file" refuses "$tmp/nope.tsv: cannot open: No such file or directory" "$tmp/nope.tsv"
check "a folder" refuses ".: not a regular file" .
check "a second file that is wrong" refuses "$tmp/nope.tsv: cannot open: No such file or directory" tests/hard/frame.tsv "$tmp/nope.tsv"

catalogue() {
    "$rl" hard --backend cpu >"$tmp/out" && [ "$(tail -n +2 "$tmp/out" | wc -l)" -eq "$(ls tests/hard/*.tsv | wc -l)" ]
}
check "the whole catalogue, in C" catalogue

summary
