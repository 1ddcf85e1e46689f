#!/bin/sh
# `study run` killed with SIGKILL at 50 random moments and more, from before its database is there until its last case: whenever
# one of the runs gets to its end, everything but times is what an undisturbed run gives; and no file half-written is in the way.
set -u
tmp=$(mktemp -d)
trap 'rm -rf "$tmp"' EXIT
rl=$ROUGHLIGHT
tab=$(printf '\t')
seed=20260131 wanted=52
echo "# seed $seed"

small="samples --quick --scene sphere-quad --axis rr=3,30 --axis rounds=0,1 --axis seeds=2 --axis width=32 --axis height=24
    --axis env_size=64 --axis samples=1,4"

# results DATABASE FILE: every measured case with all that is not a time
results() {
    "$rl" study export --db "$1" -o "$tmp/tables" 2>/dev/null &&
        awk -F "$tab" 'NR == 1 { for (i = 1; i <= NF; i++) time[i] = $i ~ /_ms|^time_|^frames$/ }
            { for (i = 1; i <= NF; i++) if (!time[i]) printf "%s\t", $i; print "" }' "$tmp/tables/samples.tsv" >"$2"
}

measured() { # cases, or nothing if the file cannot be read
    "$rl" study status --db "$1" 2>"$tmp/stderr" | awk -F "$tab" '$1 == "samples" { print $5 }'
}

calm() {
    # shellcheck disable=SC2086
    "$rl" study run $small "$@" --db "$tmp/calm/r.db" 2>"$tmp/stderr" || echo "not ok - an undisturbed run: $(cat "$tmp/stderr")"
}
calm
start=$(date +%s.%N)
calm --again # with its references at hand, as most of those that are killed
longest=$(awk -v a="$start" -v b="$(date +%s.%N)" 'BEGIN { t = b - a; print t < 1 ? t : 1 }')
results "$tmp/calm/r.db" "$tmp/expected.tsv"
cases=$(measured "$tmp/calm/r.db")
[ "$cases" -ge 10 ] && echo "ok - an undisturbed run: $cases cases" || echo "not ok - an undisturbed run: $cases cases"

# finish: to the end, and what comes of it. Times alone may differ.
finished=0 wrong=0
finish() {
    # shellcheck disable=SC2086
    "$rl" study run $small --db "$tmp/r/r.db" 2>"$tmp/stderr" || { echo "# $(cat "$tmp/stderr")" && wrong=$((wrong + 1)); }
    results "$tmp/r/r.db" "$tmp/found.tsv"
    cmp "$tmp/expected.tsv" "$tmp/found.tsv" || wrong=$((wrong + 1))
    finished=$((finished + 1))
    rm -rf "$tmp/r"
}

# Until a moment from 0 to 1 of the run: every second time by the clock, which hits any line of it, else by the number of cases
# done, however busy the machine is and however long the run then takes to get there.
turn=0
wait_for() {
    turn=$((1 - turn))
    if [ $turn -eq 1 ]; then
        sleep "$(awk -v longest="$longest" -v moment="$1" 'BEGIN { printf "%.3f", longest * moment }')"
        return
    fi
    wait_cases=$(awk -v cases="$cases" -v moment="$1" 'BEGIN { print 1 + int((cases - 1) * moment) }')
    while kill -0 $pid 2>/dev/null; do
        wait_done=$(measured "$tmp/r/r.db")
        [ "${wait_done:-0}" -lt "$wait_cases" ] || break
    done
}

# Random moments alone let few runs get to their end: after so many kills one is left in peace, from wherever it is.
each=6
kills=0 middle=0 unreadable=0 lost=0 before=0 since=0
for moment in $(awk -v seed=$seed 'BEGIN { srand(seed); for (i = 0; i < 200; i++) printf "%.6f ", rand() }'); do
    [ $kills -lt $wanted ] || [ $middle -lt 5 ] || break
    # shellcheck disable=SC2086
    "$rl" study run $small --db "$tmp/r/r.db" 2>/dev/null &
    pid=$!
    wait_for "$moment"
    kill -KILL $pid 2>/dev/null
    wait $pid 2>/dev/null
    [ $? -eq 137 ] && kills=$((kills + 1))
    n=0
    if [ -s "$tmp/r/r.db" ]; then
        n=$(measured "$tmp/r/r.db")
        # Killed while the tables were made, the file is an empty one to SQLite.
        [ -n "$n" ] || { n=0 && grep -q "holds no results yet" "$tmp/stderr" || unreadable=$((unreadable + 1)); }
    fi
    [ "$n" -ge "$before" ] || lost=$((lost + 1))
    before=$n
    [ "$n" -gt 0 ] && [ "$n" -lt "$cases" ] && middle=$((middle + 1))
    since=$((since + 1))
    [ "$n" -lt "$cases" ] && [ $since -lt $each ] || { finish && before=0 since=0; }
done
finish

report() { # NAME CONDITION...
    name=$1
    shift
    if "$@"; then echo "ok - $name"; else echo "not ok - $name"; fi
}
report "$kills kills, $middle of them with some cases done and some not, $finished runs to the end" [ $kills -ge 50 -a $middle -ge 5 ]
report "the database could be read after each ($unreadable could not)" [ $unreadable -eq 0 ]
report "no case measured was lost ($lost times)" [ $lost -eq 0 ]
report "each of these $finished runs gave what an undisturbed one gives ($wrong did not)" [ $wrong -eq 0 -a $finished -ge 8 ]
echo "1..5"
