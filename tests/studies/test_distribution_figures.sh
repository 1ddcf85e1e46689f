#!/bin/sh
# Figures of the study `distribution`, drawn from tables that are made up so that it is known where every line and bar must be.
set -u
tmp=$(mktemp -d)
trap 'rm -rf "$tmp"' EXIT
n=0

# Nine formats at nine R_r. Nothing is turned by storing that chance would not: every bar ends at 0. Every bin has what is expected.
awk 'BEGIN { OFS = "\t"
    split("4 5 6 8 10 12 16 half float", format, " "); split("1 2 3 5 10 30 100 300 1000", rr, " ")
    print "rr", "normal_bits", "normal_size_px", "tilt_rad", "tilt_rad_low", "tilt_rad_high", "mean_tilt_rad", "d_median_rad"
    for (r = 1; r <= 9; r++) for (f = 1; f <= 9; f++) print rr[r], format[f], 512, 1e-5, 0, 1e-4, 1e-4, 0.5 / rr[r] }' >"$tmp/distribution.tsv"
awk 'BEGIN { OFS = "\t"
    split("8 float", format, " "); split("1 30 1000", rr, " ")
    print "study", "scene", "parameters", "series", "index", "value", "identity"
    for (r = 1; r <= 3; r++) for (f = 1; f <= 2; f++) for (i = 0; i < 64; i++)
        print "distribution", "none", "series=map rr=" rr[r] " normal_bits=" format[f] " normal_size=512 keep=1", "delta_bins", i, 1, "x" }' \
    >"$tmp/distribution_raw.tsv"

# draw FIGURE: its lines' segments on stdout, "x1 y1 x2 y2 colour"; the frame, the grid and grey lines are left out.
draw() {
    gnuplot -c plots/distribution.gp plots/style.gp "$tmp" "$tmp/$1.svg" "$1" none 2>"$tmp/err" || cat "$tmp/err" >&2
    tr '\n\t' '  ' <"$tmp/$1.svg" | sed 's/<path/\n<path/g' | sed -n "s/^<path stroke='rgb(\([^)]*\))'[^>]* d='\([^']*\)'.*/\1|\2/p" |
        awk -F'|' '{ gsub(/ /, "", $1); if ($1 ~ /^(87,|227,|240,|138,143)/) next
            m = split($2, word, " "); x = ""
            for (i = 1; i <= m; i++) { kind = substr(word[i], 1, 1); split(substr(word[i], 2), at, ",")
                if (kind == "L") print x, y, at[1], at[2], $1
                x = at[1]; y = at[2] } }'
}

# check NAME AWK: the program reads segments and prints what is wrong.
check() {
    n=$((n + 1))
    why=$(awk "$2" "$tmp/segments" 2>&1) || why="$why (awk)"
    [ -z "$why" ] && echo "ok - $1" || echo "not ok - $1: $why"
}

draw histogram >"$tmp/segments"
check "bins that all have what is expected are level lines, the last bin's too" '
    { seen++; if ($2 != $4) steep++ }
    END { if (!seen) print "no line was looked at"; if (steep) print steep " of " seen " pieces are not level" }'
check "they reach from the first bin to the end of the last" '
    $5 == "0,114,178" && $3 - $1 > 1 { if (!from || $1 < from) from = $1; if ($3 > to) to = $3; seen[$2] += $3 - $1 }
    END { for (y in seen) if (seen[y] > 0.99 * (to - from)) panels++
        if (panels < 3) print panels + 0 " of 3 panels have a whole line, from " from " to " to }'

draw tilt >"$tmp/segments"
check "no two bars are closer than 6 pixels where both are drawn" '
    $1 == $3 && ($2 - $4 > 30 || $4 - $2 > 30) { x[++bars] = $1; low[bars] = $2 < $4 ? $2 : $4; high[bars] = $2 < $4 ? $4 : $2 }
    END { for (i = 1; i <= bars; i++) for (k = 1; k < i; k++) {
            apart = x[i] - x[k]; if (apart < 0) apart = -apart
            if (apart < 6 && apart > 0.05 && low[i] < high[k] && low[k] < high[i]) pairs++ }
        if (bars < 72) print bars + 0 " bars"; if (pairs) print pairs " pairs of " bars " bars" }'
echo "1..$n"
