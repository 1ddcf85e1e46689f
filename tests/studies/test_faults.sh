#!/bin/sh
# Proofs that a fault is seen: `study check` sees some that are planted (`make faults` plants them all), and neither a harmless change nor
# other seeds alarm it; and a study's verdict changes where the fault is about its claim.
set -u
build=${BUILD:-build}
scratch=$(mktemp -d) || exit 2
trap 'rm -rf "$scratch"' EXIT
trap 'exit 130' INT TERM HUP
tree=$scratch/tree
faults=tests/faults
# shellcheck source=tests/faults/tree.sh
. $faults/tree.sh
tab=$(printf '\t')

case $build in
*sanitize*)
    echo "ok - faults # SKIP they are built thrice; what the check sees is the same without sanitizers"
    exit 0
    ;;
esac

ok() { echo "ok - $1"; }
not_ok() { echo "not ok - $1"; }

# ---- The patches ---------------------------------------------------------------------------------------------------

# Sources move on, and a patch that no longer fits plants nothing: this says so long before `make faults` is run again.
unfit=$(for patch in $faults/*.patch; do
    patch -p1 --dry-run -s -f <"$patch" >/dev/null 2>&1 || echo "$patch"
done)
if [ -z "$unfit" ]; then ok "every patch fits its source"; else not_ok "patches that do not fit: $unfit"; fi

# ---- The check ---------------------------------------------------------------------------------------------------

# Few sources are built again for each of these, and cases without a scene see them.
$faults/run.sh --scene none --seeds 8 bits-16 hash-same harmless-theta >"$scratch/faults" 2>"$scratch/err" || cat "$scratch/err"
for expected in "(none) passed" "bits-16 caught" "hash-same caught" "harmless-theta passed"; do
    found=$(awk -F "$tab" -v fault="${expected% *}" '$1 == fault { print $2 }' "$scratch/faults")
    if [ "$found" = "${expected#* }" ]; then ok "check: $expected"; else not_ok "check: $expected: found '$found'"; fi
done
# Every depth that is not 8 or 10, twice.
found=$(awk -F "$tab" '$1 == "bits-16" { print $3 }' "$scratch/faults")
if [ "$found" = 10 ]; then ok "check: five depths have a bit too few"; else not_ok "check: $found metrics worse of 10"; fi
if $faults/run.sh no-such-fault >"$scratch/out" 2>"$scratch/err" || [ -s "$scratch/out" ]; then
    not_ok "an unknown fault is refused"
else
    ok "an unknown fault is refused"
fi

"$ROUGHLIGHT" study check --runs 5 --seeds 4 --scene none --scene two-roughness >"$scratch/runs" 2>"$scratch/err" || cat "$scratch/err"
found=$(awk -F "$tab" 'NR > 1 { runs += $4; alarms += $5 } END { print (runs >= 5 * 50 ? alarms : "too few runs") }' "$scratch/runs")
if [ "$found" = 0 ]; then ok "check: five runs with other seeds, no alarm"; else not_ok "check: five runs: $found alarms"; fi

# ---- A claim -----------------------------------------------------------------------------------------------------

# verdict PROGRAM FILE: the study in a second, its claims left in FILE; prints the named one's
claim="ours: in an orthonormal frame a highlight that turns with the normal is the same everywhere"
verdict() {
    rm -rf "$scratch/db" "$scratch/tables"
    "$1" study run frame --quick --scene sphere-quad --axis rr=30 --db "$scratch/db/r.db" 2>"$scratch/err" || cat "$scratch/err" >&2
    "$1" study export --db "$scratch/db/r.db" -o "$scratch/tables" 2>"$scratch/err" || cat "$scratch/err" >&2
    mv "$scratch/tables/claims.tsv" "$2"
    awk -F "$tab" -v claim="$claim" 'index($1, claim) == 1 { print $2 }' "$2"
}
found=$(verdict "$ROUGHLIGHT" "$scratch/sound")
if [ "$found" = holds ]; then ok "frame: $claim"; else not_ok "frame: $claim: found '$found'"; fi
if copy_tree && plant $faults/frame-model.patch && make_tree; then
    found=$(verdict "$tree/$build/roughlight" "$scratch/faulty")
    if [ "$found" = fails ]; then ok "frame: it fails with the sign of a tangent wrong"; else not_ok "frame: with a fault planted: found '$found'"; fi
    awk -F "$tab" 'NR == FNR { sound[$1] = $2; next } $2 != sound[$1] { print "# " $1 ": " sound[$1] " -> " $2 }' "$scratch/sound" "$scratch/faulty"
    if [ "$(cut -f 1 "$scratch/sound")" = "$(cut -f 1 "$scratch/faulty")" ]; then ok "frame: and is among the same claims"; else not_ok "frame: other claims"; fi
else
    cat "$scratch/patch" "$scratch/make"
    not_ok "a fault planted and built"
fi
