#!/bin/sh
# Random rows of every function, made by the MPFR program of the catalogue's, are within the bounds that it computes for them by the catalogue's
# rule, in C and in GLSL; and other answers are seen.
set -u
tmp=$(mktemp -d)
trap 'rm -rf "$tmp"' EXIT
exact=$BUILD/tests/hard/exact
rows=300
seed=20261126
# shellcheck source=tests/support/check.sh
. tests/support/check.sh

within() {
    "$exact" --random "$1" $rows $seed >"$tmp/${1##*/}" && "$ROUGHLIGHT" hard "$tmp/${1##*/}"
}
for file in tests/hard/*.tsv; do
    # A line and an edge that are drawn by themselves seldom meet.
    [ "${file##*/}" != crossing.tsv ] || continue
    check "$rows rows of ${file##*/}, seed $seed" within "$file"
done

# The second digit of every answer is another; some rows' bounds are wider than that.
doctored() {
    awk -F '\t' -v OFS='\t' 'NR > 1 { d = substr($3, 3, 1); $3 = substr($3, 1, 2) (d + 5) % 10 substr($3, 4) } { print }' \
        "$tmp/ellipsoid-pdf.tsv" >"$tmp/doctored.tsv"
    ! cmp -s "$tmp/doctored.tsv" "$tmp/ellipsoid-pdf.tsv" && mv "$tmp/doctored.tsv" "$tmp/ellipsoid-pdf.tsv" &&
        "$ROUGHLIGHT" hard "$tmp/ellipsoid-pdf.tsv"
    [ $? -eq 1 ]
}
check "another digit is seen" doctored

same() {
    "$exact" --random tests/hard/frame.tsv 5 1 >"$tmp/a" && "$exact" --random tests/hard/frame.tsv 5 1 >"$tmp/b" &&
        "$exact" --random tests/hard/frame.tsv 5 2 >"$tmp/c" && cmp "$tmp/a" "$tmp/b" && ! cmp "$tmp/a" "$tmp/c"
}
check "a seed's rows are always the same, another's are others" same

summary
