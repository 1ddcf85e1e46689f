#!/bin/sh
# The studies margin, budget and environment from end to end on a scene each, quickly: their figures held against what they must
# obey. A margin asked from each point instead of from where the map was taken, a normal map of 5 bits, or a face of the cube
# drawn amiss is found here.
set -u
tmp=$(mktemp -d)
trap 'rm -rf "$tmp"' EXIT
rl=$ROUGHLIGHT
n=0

# check NAME TABLE AWK: the program sees the columns by name as c["name"], row by row, and calls bad("why"); it must see a row.
check() {
    n=$((n + 1))
    why=$(awk -F'\t' 'function bad(why) { if (!failed++) print "row " NR ": " why }
        NR == 1 { for (i = 1; i <= NF; i++) name[i] = $i; next }
        { for (i = 1; i <= NF; i++) c[name[i]] = $i }
        '"$3"'
        END { if (!seen) print "no row was looked at" }' "$2")
    [ -z "$why" ] && echo "ok - $1" || echo "not ok - $1: $why"
}

for run in "margin three-lights" "budget teapot-star" "environment sphere-quad"; do
    "$rl" study run "${run% *}" --scene "${run#* }" --quick --db "$tmp/r.db" 2>"$tmp/err" || cat "$tmp/err"
done
"$rl" study export --db "$tmp/r.db" -o "$tmp" >/dev/null 2>"$tmp/err" || cat "$tmp/err"

check "margin: no pixel loses more than the closed form was asked to keep" "$tmp/margin.tsv" '
    c["spheres"] == 1 && c["bound"] > 0 { seen = 1; if (c["worst_exact"] > c["bound"]) bad(c["worst_exact"] " of " c["bound"]) }'
check "margin: auto has a sphere where the surface is smooth, and none where it is rough" "$tmp/margin.tsv" '
    c["arm"] == "auto" { seen = 1; if (c["spheres"] != (c["rr"] > c["from_rr"])) bad("R_r " c["rr"] ", from " c["from_rr"]) }'
check "margin: a larger sphere skips fewer pixels and misses less" "$tmp/margin.tsv" '
    c["arm"] == "0" { skipped = c["skipped"]; missed = c["missed_exact"] }
    c["arm"] == "0.5" { seen = 1
      if (!(c["skipped"] < skipped && c["missed_exact"] < missed)) bad(c["skipped"] " of " skipped ", " c["missed_exact"] " of " missed) }'
check "margin: one that lets all through loses nothing" "$tmp/margin.tsv" '
    c["arm"] == "huge" { seen = 1; if (c["missed"] != 0 || c["worst"] != 0 || c["skipped"] > 0.01) bad("missed " c["missed"]) }'
check "margin: frames of 4 normals lose what the integral says" "$tmp/margin.tsv" '
    c["arm"] == "0" { seen = 1
      d = c["missed"] - c["missed_exact"]; if ((d < 0 ? -d : d) > 0.03 + 0.3 * c["missed_exact"]) bad(c["missed"] " and " c["missed_exact"]) }'
check "budget: the shares make one" "$tmp/budget.tsv" '
    c["share"] != "nan" { seen = 1; sum += c["share"] }
    END { if (sum < 1 - 1e-9 || sum > 1 + 1e-9) print "sum " sum }'
check "budget: the whole is the sum and the interaction" "$tmp/budget.tsv" '
    c["arm"] != "base" && c["arm"] != "all" { sum += c["mse"] }
    c["arm"] == "all" { whole = c["mse"]; rest = c["interaction"] }
    END { seen = 1; d = whole - sum - rest; if ((d < 0 ? -d : d) > 1e-9 * whole) print whole " is not " sum " + " rest }'
check "budget: rounding to 8 bits is a step evenly spread, 1/255 over the root of 12" "$tmp/budget.tsv" '
    c["arm"] == "bits" { seen = 1; if (c["rmse"] < 0.0008 || c["rmse"] > 0.0013) bad(c["rmse"]) }'
check "budget: what rests on references is as sure as they are, 1e-4" "$tmp/budget.tsv" '
    c["arm"] == "parallax" || c["arm"] == "bits" { seen = 1; t = c["arm"] == "bits" ? 1e-4 : 2e-4
      low = c["rmse"] - c["rmse_low"] - t; high = c["rmse_high"] - c["rmse"] - t
      if (low < -1e-7 || low > 1e-7 || high < -1e-7 || high > 1e-7) bad(c["arm"] " " c["rmse_low"] " to " c["rmse_high"])
      if (!(c["share_low"] < c["share"] && c["share"] < c["share_high"])) bad(c["arm"] " share " c["share_low"] " to " c["share_high"]) }'
check "budget: 8-bit normals are far below the noise of 4" "$tmp/budget.tsv" '
    c["arm"] == "normals" { seen = 1; if (!(c["share"] < 0.01 && c["mse"] > 0)) bad("share " c["share"]) }'
check "environment: the error falls as the map grows" "$tmp/environment.tsv" '
    c["series"] == "size" && c["base"] == 0 { if (seen && !(c["rmse_map"] < last)) bad(c["rmse_map"] " after " last); last = c["rmse_map"]; seen = 1 }'
check "environment: white light is exact in every format" "$tmp/environment.tsv" '
    c["series"] == "format" && c["base"] == 0 { seen = 1; if (c["rmse_map"] > 1e-7) bad(c["env_format"] " " c["rmse_map"]) }'
check "environment: a quarter of the size, a quarter of the parallax" "$tmp/environment.tsv" '
    c["series"] == "parallax" { if (seen) { r = last / c["parallax"]; if (r < 3 || r > 5) bad("ratio " r) } last = c["parallax"]; seen = 1 }'
check "environment: no place of the cube is far worse than another" "$tmp/environment.tsv" '
    c["series"] == "seam" && c["base"] == 0 { if (seen && (c["rmse_map"] > 1.5 * first || c["rmse_map"] < first / 2)) bad(c["place"] " " c["rmse_map"]); if (!seen) first = c["rmse_map"]; seen = 1 }'
check "every claim has a figure" "$tmp/claims.tsv" '{ seen = 1; if (c["value"] == "nan") bad(c["claim"]) }'
echo "1..$n"
