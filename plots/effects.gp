# Figures of the study `effects`, from effects.tsv.
#
#   gnuplot -c plots/effects.gp plots/style.gp FOLDER OUTPUT FIGURE SCENE
#
# FOLDER holds effects.tsv, OUTPUT ends in .svg or .png, FIGURE is price.
folder = ARG2
output = ARG3
figure = ARG4
scene = ARG5
load ARG1
data = folder . "/effects.tsv"

# The widest picture speaks.
stats data using (strcol("scene") eq scene ? column("width_px") : NaN) name "WIDTH" nooutput
if (!exists("WIDTH_max")) { exit status 3 }
here(x) = strcol("scene") eq scene && column("width_px") == WIDTH_max ? x : NaN
base(x) = strcol("kind") eq "base" ? here(x) : NaN
row(x) = strcol("kind") eq "base" ? NaN : here(x)
stats data using (row(column("row"))) name "ROW" nooutput
stats data using (base(column("floor_ms"))) name "FLOOR" nooutput
stats data using (base(column("full_ms"))) name "FULL" nooutput
stats data using (row(column("rmse") > 0 ? column("rmse") : NaN)) name "RMSE" nooutput
stats data using (row(column("max"))) name "MAX" nooutput
if (!exists("ROW_max") || !exists("FLOOR_max") || !exists("RMSE_max")) { exit status 3 }
small = strstrt(output, ".small.png") > 0

if (figure eq "price") {
    stats data using (row(column("added_ms_high") > column("removed_ms_high") ? column("added_ms_high") : column("removed_ms_high"))) name "MS" nooutput
    stats data using (row(column("added_ms_low") < column("removed_ms_low") ? column("added_ms_low") : column("removed_ms_low"))) name "LOW" nooutput
    set multiplot layout 1, 2 title sprintf("Price and benefit: %s, %.0f pixels wide, full frame %.2f ms", scene, WIDTH_max, FULL_mean)
    set yrange [ROW_max + 0.7:-0.7]
    set grid noytics
    # The names, in the order of their rows.
    names = ""
    note_name(x) = (x == x ? names = names . strcol("feature") . " " : 0, x)
    stats data using (note_name(row(column("row")))) nooutput
    set ytics ()
    do for [i = 1:words(names)] { set ytics add (word(names, i) i - 1) }
    set style fill solid 0.85
    set tics font ",12"
    if (small) { set tics font ",1" }

    set lmargin at screen (small ? 0.05 : 0.19)
    set rmargin at screen 0.59
    set xlabel "price: ms of a frame"
    set xrange [(LOW_min < 0 ? 1.1 * LOW_min : 0):1.05 * MS_max]
    set key at screen 0.36, 0.02 bottom center maxcols 2
    if (small) { set key off }
    set object 1 rectangle from -FLOOR_max, -0.7 to FLOOR_max, ROW_max + 0.7 fillcolor rgb "#d0d4d8" fillstyle solid 0.6 noborder behind
    set arrow 1 from 0, -0.7 to 0, ROW_max + 0.7 nohead linecolor rgb "#57606a" linewidth 0.7
    bar(off) = row(column("row")) + off
    plot data using (0):(bar(-0.2)):(0):(row(column("added_ms"))):(bar(-0.38)):(bar(-0.02)) with boxxyerror linecolor rgb "#0072b2" title "added to the bare scene", \
        data using (0):(bar(0.2)):(0):(row(column("removed_ms"))):(bar(0.02)):(bar(0.38)) with boxxyerror linecolor rgb "#e69f00" fillstyle pattern 4 title "saved by its removal", \
        data using (row(column("added_ms"))):(bar(-0.2)):"added_ms_low":"added_ms_high" with xerrorbars linecolor rgb "#000000" dashtype 1 pointtype 7 pointsize 0.2 title "95 % interval", \
        data using (row(column("removed_ms"))):(bar(0.2)):"removed_ms_low":"removed_ms_high" with xerrorbars linecolor rgb "#000000" dashtype 1 pointtype 7 pointsize 0.2 notitle

    unset object 1
    unset arrow 1
    set lmargin at screen 0.63
    set rmargin at screen 0.97
    set xlabel "benefit: error without it"
    set logscale x
    set format x "10^{%L}"
    lowest = 1e-5
    at_least(x) = x > lowest ? x : lowest
    set xrange [lowest:2 * MAX_max]
    # Lines that lead back to the names.
    set ytics 0, 1, ROW_max scale 0 format ""
    set grid ytics
    set key at screen 0.81, 0.02 bottom center maxcols 2
    if (small) { set key off }
    set arrow 2 from 1.0 / 255.0, -0.7 to 1.0 / 255.0, ROW_max + 0.7 nohead linestyle 90
    # Marks: a bar on a logarithmic axis would have no foot to stand on.
    plot data using (row(column("rmse") > 0 ? at_least(column("rmse")) : NaN)):(bar(0)) with points linetype 3 pointtype 7 pointsize 1 title "RMSE", \
        data using (row(column("max") > 0 ? at_least(column("max")) : NaN)):(bar(0)) with points linetype 4 pointtype 8 pointsize 1 title "worst pixel", \
        data using (row(column("max") == 0 ? 1.5 * lowest : NaN)):(bar(0)):(small ? "" : "no pixel changes") with labels left font ",11" textcolor rgb "#6a7076" notitle, \
        NaN with lines linestyle 90 title "1/255"
    unset multiplot
}
