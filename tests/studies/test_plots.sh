#!/bin/sh
# Figures of tables made by hand: lengths and lines say what the numbers say. The drawing is read from the SVG.
set -u
tmp=$(mktemp -d)
trap 'rm -rf "$tmp"' EXIT
n=0

# draw STUDY FIGURE: of the scene `made`; $tmp/words has what it says, $tmp/elements its elements, one a line.
draw() {
    gnuplot -c "plots/$1.gp" plots/style.gp "$tmp" "$tmp/$1.svg" "$2" made 2>"$tmp/err" || cat "$tmp/err"
    svg=$tmp/$1.svg
    tr -s ' \n\t' '   ' <"$svg" | sed 's/</\n</g' | tr -s ' ' >"$tmp/elements" # one a line
    sed 's/<[^>]*>/ /g;s/&lt;/</g' "$tmp/elements" | tr -s ' \n' '  ' >"$tmp/words"
}

# ok NAME COMMAND...: the command succeeds.
ok() {
    n=$((n + 1))
    name=$1
    shift
    if "$@"; then echo "ok - $name"; else echo "not ok - $name: $(cat "$tmp/words")"; fi
}
says() { grep -qF -- "$1" "$tmp/words"; }
silent() { ! grep -qF -- "$1" "$tmp/words"; }

# level RGB: the length of the longest level line of that colour, in SVG units.
level() {
    grep -F "<path stroke='rgb($1)'" "$tmp/elements" | sed "s/.* d='//;s/'.*//;s/\([ML]\)/ \1 /g;s/,/ /g" | awk '
        { x = y = 0
          for (i = 1; i + 2 <= NF; i += 3) {
              if ($i == "L" && $(i + 2) == y && ($(i + 1) - x) ^ 2 > most ^ 2) { most = $(i + 1) - x; if (most < 0) most = -most }
              x = $(i + 1); y = $(i + 2) } }
        END { printf "%d\n", most }'
}

# ---- budget: squared errors 60, 30, 1, ... and 100 of all together; the interaction is -2 ---------------------------

{
    printf 'scene\tarm\trr\tmse\tmse_low\tmse_high\trmse\trmse_low\trmse_high\tinteraction_share\tinteraction_share_low\tinteraction_share_high\n'
    for rr in 30 300; do
        while read -r arm mse rmse; do
            share='nan\tnan\tnan'
            [ "$arm" = all ] && share='-0.02\t-0.03\t-0.01'
            printf "made\t$arm\t$rr\t$mse\t$mse\t$mse\t$rmse\t$rmse\t$rmse\t$share\n"
        done <<'ARMS'
base 0.0001 0.01
sampling 0.006 0.0775
parallax 0.003 0.0548
frame 0.0011 0.0332
normals 0.0001 0.01
map 0.00000049 0.0007
sphere 0 0
format 0.00000001 0.0001
bits 0.00000001 0.0001
all 0.01 0.1
ARMS
    done
} >"$tmp/budget.tsv"
draw budget sources
ok "budget: the interaction left over is shown, with its sign" says "-2 %"
ok "budget: parts are of all together" says "60 % (RMSE 0.077)"
ok "budget: a part too small to see says so" says "< 0.01 % (RMSE 0.0007)"
ok "budget: the axis is linear" silent "10 -"
draw budget smoother
ok "budget over R_r: ticks where there are measurements" silent " 100 "
ok "budget over R_r: both of them" says " 300 "
colours=$(grep -o "stroke='rgb([^)]*)'" "$svg" | sort -u | wc -l)
ok "budget over R_r: as many colours as curves ($colours)" [ "$colours" -ge 11 ] # nine, the frame and the grid

# ---- samples: the same intervals of time for both methods ----------------------------------------------------------

{
    printf 'scene\tseries\tsetting\tmethod\tsamples\trr\trmse\trmse_low\trmse_high\tnoise\tframe_ms\tframe_ms_low\tframe_ms_high\n'
    for k in 1 4 13; do
        printf "made\tmethods\tpaper\trandom\t$k\t30\t0.0$k\t0.0$k\t0.0$k\t0.0$k\t10\t9.9\t10.1\n"
        printf "made\tmethods\tpaper\tregular\t$k\t30\t0.0$k\t0.0$k\t0.0$k\t0\t10\t2\t50\n"
    done
} >"$tmp/samples.tsv"
draw samples time
ok "samples: the time of regular has its interval" [ "$(level '213, 94, 0')" -ge 400 ]
ok "samples: far from 1/255 the axis leaves it out" silent "1/255"

# ---- margin: 0 missed at the widest margin ---------------------------------------------------------------------------

{
    printf 'scene\tseries\tarm\trr\tmargin\tspheres\tmissed\tmissed_low\tmissed_high\n'
    for rr in 30 100; do
        printf "made\tmargin\t0\t$rr\t0\t1\t0.1\t0.09\t0.11\nmade\tmargin\t0.5\t$rr\t0.5\t1\t0.05\t0.04\t0.06\nmade\tmargin\t1\t$rr\t1\t1\t0\t0\t0\n"
    done
} >"$tmp/margin.tsv"
draw margin missed
# The first curve: its sample in the key, and as many corners as there are margins that miss something.
curve=$(sed -n '/gnuplot_plot_1"/,/gnuplot_plot_2"/p' "$tmp/elements" | grep "<path" | sed "s/.* d='//;s/'.*//" | tr -cd ML)
ok "margin: no line to what is not missed ($curve)" [ "$curve" = MLML ]

# ---- environment: a light that every format holds exactly ------------------------------------------------------------

formats() {
    printf 'scene\tseries\trr\tbase\tenv_size_px\tenv_format\trmse_map\trmse_map_low\trmse_map_high\n'
    for f in rgba16f rgba16 r11g11b10f rgb10a2 rgba8; do printf "made\tformat\t30\t0\t256\t$f\t$1\t$1\t$1\n"; done
}
formats 0 >"$tmp/environment.tsv"
draw environment format
ok "formats: without any error the figure says so" says "exact in every format"
formats 0.0002 >"$tmp/environment.tsv"
draw environment format
ok "formats: with one it does not" silent "exact in every format"
ok "formats: but the error" says "0.0002"
echo "1..$n"
