#!/bin/sh
# `study check`: passes on the tree as it is, fails where a baseline was better, and refuses baselines that are none.
set -u
tmp=$(mktemp -d)
trap 'rm -rf "$tmp"' EXIT
rl=$ROUGHLIGHT
tab=$(printf '\t')

ok() { echo "ok - $1"; }
not_ok() { echo "not ok - $1"; }
check() {
    name=$1
    shift
    if "$@"; then ok "$name"; else not_ok "$name"; fi
}

# exits CODE NAME ARGUMENTS...: of study check; leaves stdout and stderr
exits() {
    expected=$1 name=$2
    shift 2
    "$rl" study check "$@" >"$tmp/stdout" 2>"$tmp/stderr"
    code=$?
    if [ $code -eq "$expected" ]; then ok "$name"; else not_ok "$name: exit code $code: $(cat "$tmp/stderr")"; fi
}

# refused NAME PATTERN ARGUMENTS...: exit code 2, one line, nothing on stdout
refused() {
    name=$1 pattern=$2
    shift 2
    "$rl" study check "$@" >"$tmp/stdout" 2>"$tmp/stderr"
    code=$?
    if [ $code -eq 2 ] && [ ! -s "$tmp/stdout" ] && [ "$(wc -l <"$tmp/stderr")" -eq 1 ] && grep -Eq -- "$pattern" "$tmp/stderr"; then
        ok "$name"
    else
        not_ok "$name: exit code $code: $(cat "$tmp/stderr")"
    fi
}

# verdict METRIC: of the one row with that metric, from the last check
verdict() { awk -F "$tab" -v metric="$1" '$3 == metric { print $6 }' "$tmp/stdout"; }

base=tests/baseline.tsv
two="--scene two-roughness"

# ---- The tree as it is -------------------------------------------------------------------------------------------

# shellcheck disable=SC2086
exits 0 "one scene against the baseline" $two
check "finds all its metrics the same" [ "$(cut -f 6 "$tmp/stdout" | sort | uniq -c | tr -s ' ' | tr '\n' ,)" = " 5 same, 1 verdict," ]
check "with the seconds of the case" awk -F "$tab" 'NR > 1 && !($15 > 0 && $15 < 300) { exit 1 }' "$tmp/stdout"
cp "$tmp/stdout" "$tmp/first"
# shellcheck disable=SC2086
exits 0 "the same seeds once more" $two --format json
check "give the same figures, in JSON" python3 -c "
import json, sys
rows = json.load(open('$tmp/stdout'))
first = [line.rstrip('\n').split('\t') for line in open('$tmp/first')]
assert len(rows) == 5
for row, text in zip(rows, first[1:]):
    for name, value in zip(first[0], text):
        if name != 'case_seconds':
            assert str(row[name]) == value or float(value) == row[name], (name, value, row[name])
"
exits 0 "cases without a scene" --scene none --seeds 8
check "are compared" [ "$(grep -c same "$tmp/stdout")" -gt 80 ]

# ---- A baseline that was better, or worse ------------------------------------------------------------------------

# doctored METRIC COLUMN EXPRESSION: the baseline with that column of those rows so changed
doctored() {
    awk -F "$tab" -v OFS="$tab" -v CONVFMT=%.17g -v OFMT=%.17g -v metric="$1" -v column="$2" \
        '$3 == metric && ($1 == "two-roughness" || $1 == "none") { x = $column; $column = '"$3"' } { print }' "$base" >"$tmp/doctored.tsv"
}
doctored rmse 7 'x * 0.8'
# shellcheck disable=SC2086
exits 1 "an error that was lower is worse now" $two --baseline "$tmp/doctored.tsv"
check "its row says so" [ "$(verdict rmse)" = worse ]
check "and a line on stderr" grep -q "^worse: rmse of two-roughness method=random" "$tmp/stderr"
doctored rmse 7 'x * 1.3'
# shellcheck disable=SC2086
exits 0 "an error that was higher" $two --baseline "$tmp/doctored.tsv"
check "is better now" [ "$(verdict rmse)" = better ]
doctored rmse 11 'x * 1e-6'
# shellcheck disable=SC2086
exits 0 "a change that four pairs cannot see, but matters" $two --seeds 8 --baseline "$tmp/doctored.tsv"
check "is inconclusive" [ "$(verdict rmse)" = inconclusive ]
doctored masked 7 'x + 1e-14'
exits 1 "a fixed value in the 14th place" --scene none --seeds 4 --baseline "$tmp/doctored.tsv"
check "is worse" [ "$(verdict masked)" = worse ]

# ---- What cannot be compared -------------------------------------------------------------------------------------

doctored rmse 3 '"rms"'
# shellcheck disable=SC2086
exits 0 "a metric under another name" $two --baseline "$tmp/doctored.tsv"
check "is incomparable" [ "$(verdict rmse)$(verdict rms)" = incomparableincomparable ]
sed "s/${tab}method=random/${tab}method=chance/" "$base" >"$tmp/doctored.tsv"
# shellcheck disable=SC2086
exits 2 "nothing in common" $two --baseline "$tmp/doctored.tsv"
check "is told" grep -q "doctored.tsv: found no metric that can be compared" "$tmp/stderr"
refused "no such file" "/none.tsv" --baseline "$tmp/none.tsv"
head -n 3 "$base" | sed 's/^scene/scenery/' >"$tmp/wrong.tsv"
refused "wrong columns" "wrong.tsv:3: column 1: found 'scenery', expected 'scene'" --baseline "$tmp/wrong.tsv"
{ head -n 4 "$base" && printf 'a\tb\n'; } >"$tmp/broken.tsv"
refused "a broken row" "broken.tsv:5: found 2 columns, expected 15" --baseline "$tmp/broken.tsv"
refused "an unknown scene" "'nowhere', expected one of none, sphere-quad" --scene nowhere
refused "an odd number of seeds" "--seeds: found 5" --seeds 5
refused "two purposes" "--write: found it beside --baseline" --write "$tmp/x" --baseline "$base"
refused "rows of a new baseline" "--format has no effect with --write" --write "$tmp/x" --format json
refused "a new baseline in no folder, before it is measured" "/no/such/folder.tsv: cannot write: No such file" --write "$tmp/no/such/folder.tsv"
refused "a new baseline onto a folder" "is a directory" --write "$tmp"
refused "a new baseline onto a device" "/dev/full: is a device" --write /dev/full
refused "a new baseline without a name" "--write: found an empty name" --write ''
check "none of this leaves a file" [ -z "$(find "$tmp" -name '.*' -o -name x)" ]
refused "a name too many" "unexpected argument 'samples'" samples

# ---- New baselines and reruns ------------------------------------------------------------------------------------

# shellcheck disable=SC2086
exits 0 "a baseline written" $two --write "$tmp/new.tsv" --seeds 32
# shellcheck disable=SC2086
exits 0 "and checked" $two --baseline "$tmp/new.tsv"
check "is comparable" [ "$(grep -c incomparable "$tmp/stdout")" -eq 0 ]
# shellcheck disable=SC2086
exits 0 "three runs" $two --runs 3 --seeds 4
check "are three p values a metric" [ "$(cut -f 4 "$tmp/stdout" | tr '\n' ,)" = "runs,3,3,3,3,3," ]

# A command in the background does not hear SIGINT: SIGTERM does the same.
"$rl" study check >"$tmp/stdout" 2>"$tmp/stderr" &
pid=$!
sleep 1
kill -TERM $pid
wait $pid
code=$?
check "interrupted: 130, no rows: exit code $code" [ "$code" -eq 130 -a ! -s "$tmp/stdout" ]
