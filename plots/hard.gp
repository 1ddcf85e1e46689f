# Figures of the study `hard`, from hard_rows.tsv and hard_raw.tsv (points of the maps).
#
#   gnuplot -c plots/hard.gp plots/style.gp FOLDER OUTPUT FIGURE SCENE
#
# FOLDER holds the tables, OUTPUT ends in .svg or .png, FIGURE is rows, or the name of a map.
folder = ARG2
output = ARG3
figure = ARG4
load ARG1
thumbnail = strstrt(output, ".small.png") > 0
small = thumbnail ? ",15" : ",11"


if (figure eq "rows") {
    data = folder . "/hard_rows.tsv"
    set title "Hard cases: the worst row of each function"
    set xlabel "error, as a share of the bound"
    # Functions from top to bottom as they come.
    names = " "
    row(name) = words(names[1:strstrt(names, " " . name . " ")]) + 1
    note(name) = (strstrt(names, " " . name . " ") > 0 ? 0 : (names = names . name . " ", 0))
    top = 10.0
    note_top(x) = (x > top && x < 1e30 ? (top = 10 ** ceil(log10(x))) : 0, 0)
    stats data using (note(strcol("function")) + note_top(column("worst_share"))) nooutput
    if (words(names) == 0) { exit status 3 }
    set logscale x
    set format x "10^{%L}"
    set xrange [edge_of(1e-3, top):top]
    set yrange [words(names) + 0.6:0.4]
    tic_font = words(names) > 30 ? ",8" : ",11"
    set ytics () font tic_font
    do for [i = 1:words(names)] { set ytics add (word(names, i) i) }
    if (!thumbnail) { set lmargin 24 }
    set bmargin 7
    set key maxcols 3 font ",13"
    set arrow 1 from 1, graph 0 to 1, graph 1 nohead linestyle 90
    # What is not finite is at the right edge.
    place(x) = x < top ? standing(x) : top
    only(backend, x) = strcol("backend") eq backend ? x : NaN
    plot data using (only("cpu", place(column("worst_share")))):(row(strcol("function")) - 0.16) with points linetype 1 pointsize 0.8 title "in C, double precision", \
        data using (only("cpu", sunk(column("worst_share")))):(row(strcol("function")) - 0.16):(fall(0)):(0) with vectors arrowstyle 1 notitle, \
        data using (only("gpu", place(column("worst_share")))):(row(strcol("function")) + 0.16) with points linetype 2 pointsize 0.8 title "in GLSL, single precision", \
        data using (only("gpu", sunk(column("worst_share")))):(row(strcol("function")) + 0.16):(fall(0)):(0) with vectors arrowstyle 2 notitle, \
        NaN with lines linestyle 90 title "the bound"
    exit
}

# ---- Maps ----

# The rows of this map, once for all: 0 in C or 1 in GLSL, which series, index, value. To look for them is what takes time.
raw = folder . "/hard_raw.tsv"
here(any) = strcol("study") eq "hard" && strstrt(strcol("parameters"), " map=" . figure . " ") > 0
in_glsl(any) = strstrt(strcol("parameters"), " backend=gpu ") > 0
series(any) = strstrt("ulp         across      up          beyond      conditioned ", strcol("series") . " ") / 12
set table $POINTS separator tab
plot raw using (in_glsl(0)):(series(0)):(column("index")):(sprintf("%.12g", column("value"))) with table if (here(0))
unset table
set datafile nocolumnheaders
if (|$POINTS| == 0) { exit status 3 }
ULP = 0; ACROSS = 1; UP = 2; BEYOND = 3; CONDITIONED = 4
of(backend, which) = $1 == backend && $2 == which
panels = 1
columns = 0
lines = 0
count(any) = (panels = $1 == 1 ? 2 : panels, columns = of(0, ACROSS) && $3 >= columns ? int($3) + 1 : columns, \
              lines = of(0, UP) && $3 >= lines ? int($3) + 1 : lines, 0)
stats $POINTS using (count(0)) nooutput
array across[columns]
array up[lines]
keep(any) = (of(0, ACROSS) ? (across[int($3) + 1] = $4) : 0, of(0, UP) ? (up[int($3) + 1] = $4) : 0, 0)
stats $POINTS using (keep(0)) nooutput

# Points stand side by side, whatever their values are; an axis has tics at the points nearest to round values.
near(x, value) = abs(x - value) / (abs(x) + abs(value) + 1e-300)
nearest_across(value) = (best = 1, sum [i = 1:|across|] (near(across[i], value) < near(across[best], value) ? (best = i, 0) : 0), best - 1)
nearest_up(value) = (best = 1, sum [i = 1:|up|] (near(up[i], value) < near(up[best], value) ? (best = i, 0) : 0), best - 1)
# Value and label in turn; gnuplot reads no text "1e-6" as a number, but "1.0e-6".
of_rr = "1.0e-6 10^{-6} 1.0e-3 10^{-3} 0.5 1/2 0.999 .999 1 1 1.001 1.001 2 2 1.0e3 10^3 1.0e6 10^6 1.0e9 10^9 1.0e12 10^{12}"
of_delta = "-1.57079625 -π/2+10^{-7} -1.5698 -π/2+10^{-3} -1 -1 -0.1 -0.1 -1.0e-3 -10^{-3} -1.0e-7 -10^{-7} 1.0e-30 10^{-30} " \
    . "1.0e-7 10^{-7} 1.0e-3 10^{-3} 0.1 0.1 1 1 1.5698 π/2-10^{-3} 1.57079625 π/2-10^{-7}"
of_u = "0 0 1.0e-37 10^{-37} 1.0e-9 10^{-9} 1.0e-5 10^{-5} 0.01 0.01 0.25 1/4 0.5 1/2 0.75 3/4 0.99 0.99 0.99999 1-10^{-5} 1 1"
of_cosine = "1.0e-30 10^{-30} 1.0e-20 10^{-20} 1.0e-10 10^{-10} 1.0e-5 10^{-5} 0.01 0.01 0.25 1/4 0.5 1/2 0.75 3/4 1 1"
of_longitude = "-179.999994 -180 -145 -145 -90 -90 -34.4 -34.4 -0.57 -0.57 1.0e-6 0 0.57 0.57 34.4 34.4 90 90 145 145 180 180"
of_latitude = "-90 -90 -89.43 -89.4 -84.3 -84.3 -60 -60 -30 -30 -0.0573 -.06 0.0573 .06 30 30 60 60 84.3 84.3 89.43 89.4 90 90"
tics_across = of_rr
tics_up = of_delta
name_across = "R_r"
name_up = "delta"
what = "D(delta)"
if (figure eq "ellipsoid-cdf") { what = "U(delta)" }
if (figure eq "ellipsoid-inverse") { what = "delta(U) and its cosine"; name_up = "U"; tics_up = of_u }
if (figure eq "attenuation" || figure eq "cook-torrance") {
    what = figure eq "attenuation" ? "G" : "Cook-Torrance"
    name_across = "N.V"
    name_up = "N.L"
    tics_across = of_cosine
    tics_up = of_cosine
}
if (figure eq "frame" || figure eq "frame-printed") {
    what = figure eq "frame" ? "The frame" : "The printed frame"
    name_across = "longitude of N in degrees, 0 and ±180 being ±x"
    name_up = "latitude of N in degrees, -90 being -z"
    tics_across = of_longitude
    tics_up = of_latitude
}

# One hue from light to dark: reads the same in print. Zero and what is below the scale stay white.
least = 1.0 / 16
scaled(x) = x < least ? -5 : log(x < 1024 ? x : 1024) / log(2)
set palette defined (-5 "#ffffff", -4 "#ffffff", -4 "#dbe9f6", 3 "#4a90c4", 10 "#08306b")
set cbrange [-5:10]
unset colorbox
unset key
unset grid
set border 15
set xrange [-0.5:columns - 0.5]
set yrange [-0.5:|up| - 0.5]
set xtics () rotate by 90 right font small offset 0, 0.3
set ytics () font small
do for [i = 1:words(tics_across) / 2] { set xtics add (word(tics_across, 2 * i) nearest_across(word(tics_across, 2 * i - 1) + 0.0)) }
do for [i = 1:words(tics_up) / 2] { set ytics add (word(tics_up, 2 * i) nearest_up(word(tics_up, 2 * i - 1) + 0.0)) }
at_column(i) = int(i) % columns
at_line(i) = int(i) / columns
set multiplot
set label 1 what . ": errors in units in the last place" . (figure[1:5] eq "frame" ? " of 1" : "") at screen 0.5, 0.965 center
set label 2 name_across at screen 0.5, 0.13 center
# The two marks, each on a piece of the scale.
set object 1 rectangle from screen 0.14, 0.025 to screen 0.165, 0.06 fillcolor rgb "#08306b" fillstyle solid noborder
set label 3 "" at screen 0.1525, 0.0425 point pointtype 7 pointsize 0.35 linecolor rgb "#ffffff"
set label 4 "above the plain bound, by what rounding the arguments does" at screen 0.175, 0.0425 left font ",12"
set object 2 rectangle from screen 0.70, 0.025 to screen 0.725, 0.06 fillcolor rgb "#d55e00" fillstyle solid noborder
set label 5 "beyond the bound" at screen 0.735, 0.0425 left font ",12"
set tmargin at screen 0.88
set bmargin at screen 0.26
do for [k = 1:panels] {
    set lmargin at screen k == 1 ? 0.135 : 0.52
    set rmargin at screen k == 1 ? 0.485 : 0.87
    set title k == 1 ? "in C, double precision" : "in GLSL, single precision" offset 0, -0.6
    if (k == 1) { set ylabel name_up } else {
        unset ylabel
        set format y ""
        set ytics ()
        set colorbox user origin screen 0.89, 0.26 size screen 0.02, 0.62
        set cbtics ("0" -5, "1/16" -4, "1/4" -2, "1" 0, "2" 1, "4" 2, "8 (C)" 3, "16" 4, "32" 5, "84 (GLSL)" 6.4, "256" 8, "1024" 10) font ",10"
    }
    plot $POINTS using (of(k - 1, ULP) ? at_column($3) : NaN):(at_line($3)):(scaled($4)) with image pixels notitle, \
        $POINTS using (of(k - 1, CONDITIONED) ? at_column($4) : NaN):(at_line($4)) with points pointtype 7 pointsize 0.22 linecolor rgb "#ffffff" notitle, \
        $POINTS using (of(k - 1, BEYOND) ? at_column($4) : NaN):(at_line($4)):(0.5):(0.5) with boxxyerror fillstyle solid noborder linecolor rgb "#d55e00" notitle
    unset label
    unset object
}
unset multiplot
