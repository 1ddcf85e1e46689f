#!/bin/sh
# The answers in the catalogue of hard lights are of the inputs beside them, and those of a sample come out again, in 20 digits, with fewer
# bits and a smaller rule. A wrong answer and a changed input are seen.
set -u
tmp=$(mktemp -d)
trap 'rm -rf "$tmp"' EXIT
exact=$BUILD/tests/hard/exact_lines
good=tests/hard/lights/lights.tsv

# says STATUS NAME FILE
says() {
    "$exact" --check "$3" >"$tmp/out" 2>&1
    status=$?
    if [ $status = "$1" ]; then
        echo "ok - $2"
    else
        echo "not ok - $2: exit status $status, expected $1"
        cat "$tmp/out"
    fi
}

says 0 "answers of a sample come out again" $good
# The first line of a file is in the sample.
row=$(grep -m 1 "one ulp above" $good)
echo "$row" >"$tmp/right.tsv"
says 0 "a row alone" "$tmp/right.tsv"
echo "$row" | awk -F'\t' -v OFS='\t' '{ $8 = substr($8, 1, 18) (substr($8, 19, 1) + 1) % 10 substr($8, 20); print }' >"$tmp/answer.tsv"
says 1 "an answer whose 18th digit is another is seen" "$tmp/answer.tsv"
echo "$row" | awk -F'\t' -v OFS='\t' '{ $5 = $5 "1"; print }' >"$tmp/input.tsv"
says 1 "an answer of other inputs is seen" "$tmp/input.tsv"
echo "a row" >"$tmp/bad.tsv"
says 2 "a row of another number of columns is refused" "$tmp/bad.tsv"
