#!/bin/sh
# The catalogue's answers and bounds are those that the MPFR program writes, and it sees one that is not.
set -u
tmp=$(mktemp -d)
trap 'rm -rf "$tmp"' EXIT
exact=$BUILD/tests/hard/exact
# shellcheck source=tests/support/check.sh
. tests/support/check.sh

for file in tests/hard/*.tsv; do
    check "$file is current" "$exact" --check "$file"
done

check "the maps are current" "$exact" --check --maps tests/hard/maps

# An answer of a map is another.
doctored_map() {
    mkdir -p "$tmp/maps" && cp tests/hard/maps/*.tsv "$tmp/maps" &&
        sed -i '$ s/[0-8]\t/9\t/' "$tmp/maps/ellipsoid-pdf.tsv" &&
        ! cmp -s tests/hard/maps/ellipsoid-pdf.tsv "$tmp/maps/ellipsoid-pdf.tsv" &&
        ! "$exact" --check --maps "$tmp/maps" 2>"$tmp/err" && [ "$(wc -l <"$tmp/err")" -eq 1 ] &&
        grep -q "^$tmp/maps/ellipsoid-pdf.tsv: its answers are not what" "$tmp/err"
}
check "another digit of a map is seen" doctored_map

# One digit of the first answer is another.
doctored() {
    awk -F '\t' -v OFS='\t' '/^[^#]/ && seen++ == 1 { sub(/[0-8]e/, "9e", $3) } { print }' \
        tests/hard/ellipsoid-pdf.tsv >"$tmp/ellipsoid-pdf.tsv"
    ! cmp -s tests/hard/ellipsoid-pdf.tsv "$tmp/ellipsoid-pdf.tsv" && ! "$exact" --check "$tmp/ellipsoid-pdf.tsv"
}
check "another digit is seen" doctored

# refuses LINE MESSAGE: exit 2, the file as it was
refuses() {
    printf 'rr\tdelta\twhy\n%b\n' "$1" >"$tmp/ellipsoid-pdf.tsv"
    cp "$tmp/ellipsoid-pdf.tsv" "$tmp/before"
    "$exact" "$tmp/ellipsoid-pdf.tsv" 2>"$tmp/err"
    [ $? -eq 2 ] && cmp "$tmp/before" "$tmp/ellipsoid-pdf.tsv" && [ "$(cat "$tmp/err")" = "$tmp/ellipsoid-pdf.tsv:2: $2" ] || {
        cat "$tmp/err"
        return 1
    }
}
check "a word for a number" refuses '1\tx\thard' 'found x, expected a finite number, or - for an argument that is left out'
check "no reason" refuses '1\t0.5\t' 'found nothing, expected why the row is hard'
check "too few columns" refuses '1\t0.5' \
    'found another number of columns, expected the arguments and why, or these and the answers between them'

summary
