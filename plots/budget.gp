# Figures of the study `budget`, from budget.tsv.
#
#   gnuplot -c plots/budget.gp plots/style.gp FOLDER OUTPUT FIGURE SCENE
#
# FOLDER holds budget.tsv, OUTPUT ends in .svg or .png, FIGURE is sources or smoother.
folder = ARG2
output = ARG3
figure = ARG4
scene = ARG5
load ARG1
data = folder . "/budget.tsv"

names = "all sampling parallax frame normals map sphere format bits"
words_of(i) = word("'all together' '4 normals' 'parallax' 'frame as printed' '8-bit normals' 'map of 256' 'sphere, auto' '8-bit texels' '8-bit frame buffer'", i)
here(a) = strcol("scene") eq scene && strcol("arm") eq a
stats data using (strcol("scene") eq scene && column("rmse") > 0 ? column("rmse") : NaN) name "RMSE" nooutput
if (!exists("RMSE_max")) { exit status 3 }
stats data using (strcol("scene") eq scene ? note_central(column("rr")) : NaN) nooutput
rr = central

if (figure eq "sources") {
    # Squared errors, for they add up, in parts of that of all together; on a linear axis, where lengths compare.
    whole = NaN
    stats data using (here("all") && column("rr") == rr ? (whole = column("mse")) : NaN) nooutput
    stats data using (here("all") && column("rr") == rr ? column("interaction_share_low") : NaN) name "LOW" nooutput
    stats data using (strcol("scene") eq scene && column("rr") == rr ? column("mse_high") : NaN) name "HIGH" nooutput
    if (!(whole > 0)) { exit status 3 }
    percent(mse) = 100 * mse / whole
    set title sprintf("Where the squared error comes from: %s, R_r %g", scene, rr)
    set xlabel "squared error, in % of that of all together"
    left_end = exists("LOW_min") && LOW_min < 0 ? 110 * LOW_min - 3 : 0
    set xrange [left_end:1.45 * percent(HIGH_max)]
    set xtics -100, 20, 100
    set yrange [-1.7:9.7]
    set lmargin 20
    set grid noytics
    # From the top: all together, what the single ones leave of it, these, and the base, which is no part of it.
    row(a) = a eq "sampling" ? 7 : a eq "parallax" ? 6 : a eq "frame" ? 5 : a eq "normals" ? 4 : a eq "map" ? 3 : a eq "sphere" ? 2 : a eq "format" ? 1 : a eq "bits" ? 0 : a eq "all" ? 9 : -1.3
    set ytics ("all together" 9, "interaction" 8)
    do for [i = 2:words(names)] { set ytics add (words_of(i) row(word(names, i))) }
    set ytics add ("base (no part)" -1.3)
    placed(a) = strcol("scene") eq scene && column("rr") == rr ? row(a) : NaN
    left_over(x) = here("all") && column("rr") == rr ? x : NaN
    part(x) = x == 0 ? "0" : abs(x) < 0.01 ? "< 0.01 %" : abs(x) < 9.5 ? sprintf("%.2g %%", x) : sprintf("%.0f %%", x)
    set style fill solid 0.85
    set arrow 1 from 0, -1.7 to 0, 9.7 nohead linecolor rgb "#57606a"
    set arrow 2 from graph 0, first -0.65 to graph 1, first -0.65 nohead linestyle 90
    plot data using (0):(placed(strcol("arm"))):(0):(percent(column("mse"))):(placed(strcol("arm")) - 0.3):(placed(strcol("arm")) + 0.3) \
            with boxxyerror linecolor rgb "#56b4e9" title "single and all together", \
        data using (0):(left_over(8)):(0):(left_over(100 * column("interaction_share"))):(left_over(7.7)):(left_over(8.3)) \
            with boxxyerror linecolor rgb "#9aa0a6" fillstyle pattern 4 title "all together less the sum", \
        data using (percent(column("mse"))):(placed(strcol("arm"))):(percent(column("mse_low"))):(percent(column("mse_high"))) \
            with xerrorbars linetype 4 dashtype 1 pointtype 7 pointsize 0.3 title "95 % interval", \
        data using (left_over(100 * column("interaction_share"))):(left_over(8)):(100 * column("interaction_share_low")):(100 * column("interaction_share_high")) \
            with xerrorbars linetype 4 dashtype 1 pointtype 7 pointsize 0.3 notitle, \
        data using (percent(column("mse_high"))):(placed(strcol("arm"))):(part(percent(column("mse"))) . sprintf("  (RMSE %.2g)", column("rmse"))) \
            with labels left offset 1, 0 font ",12" notitle, \
        data using (left_over(column("interaction_share_high") > 0 ? 100 * column("interaction_share_high") : 0)):(left_over(8)):(part(100 * column("interaction_share"))) \
            with labels left offset 1, 0 font ",12" notitle
}

if (figure eq "smoother") {
    # As many colours and marks as there are curves.
    set linetype 6 linecolor rgb "#e69f00" dashtype 6 pointtype 4
    set linetype 7 linecolor rgb "#56b4e9" dashtype (12, 4) pointtype 6
    set linetype 8 linecolor rgb "#7a4a1e" dashtype (2, 3) pointtype 12
    set linetype 9 linecolor rgb "#8a8f94" dashtype (18, 4, 2, 4) pointtype 8
    set linetype cycle 9
    do for [i = 1:9] { set style arrow i head filled size screen 0.008, 25 linetype i dashtype 1 linewidth 1 }
    stats data using (here("all") ? column("rr") : NaN) name "RR" nooutput
    set title "Where the error comes from, over R_r: " . scene
    set xlabel "R_r (right: smoother)"
    set ylabel "RMSE of linear radiance (full scale 1)"
    set logscale xy
    set format y "10^{%L}"
    # Ticks where there are measurements.
    set xtics () nomirror
    rr_list = ""
    note_tick(rr) = (strstrt(" " . rr_list, sprintf(" %g ", rr)) == 0 ? rr_list = rr_list . sprintf("%g ", rr) : rr_list, rr)
    stats data using (here("all") ? note_tick(column("rr")) : NaN) nooutput
    do for [i = 1:words(rr_list)] { set xtics add (word(rr_list, i) real(word(rr_list, i))) }
    set mxtics 1
    set key maxcols 3
    set bmargin 9.8
    least = 10 ** floor(log10(RMSE_min))
    set yrange [edge_of(least < 1e-7 ? 1e-7 : least, 2 * RMSE_max):2 * RMSE_max]
    set xrange [RR_min / 1.5:RR_max * 1.5]
    # Side by side; a line from one R_r to the next only where more than two tell of a course.
    aside(i) = 1.035 ** (i - 5)
    of(i) = here(word(names, i)) ? column("rr") * aside(i) : NaN
    plot for [i = 1:(words(rr_list) > 2 ? words(names) : 0)] data using (of(i)):(above(column("rmse"))) with lines linetype i linewidth 0.7 notitle, \
        for [i = 1:words(names)] data using (of(i)):(standing(column("rmse"))):(ended(column("rmse_low"))):(ended(column("rmse_high"))) \
            with yerrorbars linetype i dashtype 1 pointsize 1.1 title words_of(i), \
        for [i = 1:words(names)] data using (of(i)):(sunk(column("rmse"))):(0):(fall(0)) with vectors arrowstyle i notitle, \
        1.0 / 255.0 with lines linestyle 90 title "1/255"
}
