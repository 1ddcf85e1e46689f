# Figures of the study `margin`, from margin.tsv.
#
#   gnuplot -c plots/margin.gp plots/style.gp FOLDER OUTPUT FIGURE SCENE
#
# FOLDER holds margin.tsv, OUTPUT ends in .svg or .png, FIGURE is missed, trade, cost, bound, mean or filled
# (SCENE is none).
folder = ARG2
output = ARG3
figure = ARG4
scene = ARG5
load ARG1
data = folder . "/margin.tsv"

if (figure eq "filled") {
    set title "What two lights made for a bound lose of it"
    set xlabel "R_r, roughness: 1 is the roughest, 1000 nearly a mirror"
    set ylabel "loss over the bound"
    set logscale x
    set xtics (1, 3, 10, 30, 100, 300, 1000)
    made(loss) = strcol("series") eq "filled" && column("loss") == loss ? column("rr") : NaN
    losses = ""
    note(loss) = (strstrt(" " . losses, sprintf(" %g ", loss)) == 0 ? losses = losses . sprintf("%g ", loss) : losses, loss)
    stats data using (strcol("series") eq "filled" && column("filled") > 0 ? note(column("loss")) : NaN) nooutput
    stats data using (strcol("series") eq "filled" ? column("rr") : NaN) name "RR" nooutput
    if (!exists("RR_max") || words(losses) == 0) { exit status 3 }
    set xrange [RR_min / 1.5:RR_max * 1.5]
    set yrange [0:1.05]
    set bmargin 9.5
    set object 1 rectangle from graph 0, first 0.4 to graph 1, first 1 fillcolor rgb "#e3e6e9" fillstyle solid noborder behind
    plot for [i = 1:words(losses)] data using (made(real(word(losses, i)))):"due" with lines linetype i linewidth 1 dashtype 3 notitle, \
        for [i = 1:words(losses)] data using (made(real(word(losses, i)))):"filled" with points linetype i pointsize 1.1 title "bound " . word(losses, i), \
        keyentry with lines linetype -1 dashtype 3 title "as the proof asks", \
        1 with lines linestyle 90 title "the bound", \
        keyentry with boxes fillcolor rgb "#e3e6e9" fillstyle solid title "0.4 of it or more"
    exit
}

fixed(s, a) = strcol("scene") eq scene && s eq "margin" && a ne "off" && a ne "again" && a ne "huge" && a ne "auto"
is_auto(a) = strcol("scene") eq scene && a eq "auto" && column("spheres") > 0

# The values of R_r that were measured, ascending: the next larger one until there is none.
rr_list = ""
last = 0.0
while (1) {
    next = 1e99
    note_rr(x) = (x > last && x < next ? next = x : 0, x)
    stats data using (strcol("scene") eq scene && strcol("series") eq "margin" ? note_rr(column("rr")) : NaN) nooutput
    if (next == 1e99) { break }
    rr_list = rr_list . sprintf("%g ", next)
    last = next
}
if (words(rr_list) == 0) { exit status 3 }
# Six curves are as many as can be told apart: of more, every second one from the smooth end.
while (words(rr_list) > 6) {
    shorter = ""
    do for [i = 1:words(rr_list)] { if ((words(rr_list) - i) % 2 == 0) { shorter = shorter . word(rr_list, i) . " " } }
    rr_list = shorter
}
at(i) = column("rr") == word(rr_list, i)
stats data using (fixed(strcol("series"), strcol("arm")) && column("missed") > 0 ? column("missed") : NaN) name "MISSED" nooutput
if (!exists("MISSED_max")) { exit status 3 }
lowest = 1e-5

if (figure eq "missed") {
    set title "Highlight taken away by the bounding spheres: " . scene . ", random 4"
    set xlabel "margin: sphere radius over the light's, less 1"
    set ylabel "share of the highlight's energy missed"
    set logscale y
    set format y "10^{%L}"
    # Before ranges are set, since these hold for what is looked at too.
    stats data using ((fixed(strcol("series"), strcol("arm")) || is_auto(strcol("arm"))) ? column("margin") : NaN) name "M" nooutput
    set yrange [edge_of(lowest, 1):1]
    set xrange [-0.04 * M_max:1.1 * M_max]
    set label 1 "1 %" at graph 0.995, first 0.0118 right textcolor rgb "#6a7076" font ",12"
    shown(i) = fixed(strcol("series"), strcol("arm")) && at(i) ? column("margin") : NaN
    # What is missed nowhere would lie on one spot.
    beside(i) = shown(i) + (column("missed") <= edge ? 0.012 * M_max * (i - 0.5 * (words(rr_list) + 1)) : 0)
    chosen(i) = is_auto(strcol("arm")) && at(i) ? column("margin") : NaN
    plot for [i = 1:words(rr_list)] data using (shown(i)):(above(column("missed"))) with linespoints linetype i pointsize 0.9 title "R_r " . word(rr_list, i), \
        for [i = 1:words(rr_list)] data using (beside(i)):(standing(column("missed"))):(ended(column("missed_low"))):(ended(column("missed_high"))) \
            with yerrorbars linetype i dashtype 1 pointsize 0.9 notitle, \
        for [i = 1:words(rr_list)] data using (beside(i)):(sunk(column("missed"))):(0):(fall(0)) with vectors arrowstyle i notitle, \
        for [i = 1:words(rr_list)] data using (chosen(i)):(standing(column("missed"))):(ended(column("missed_low"))):(ended(column("missed_high"))) \
            with yerrorbars linetype i dashtype 1 pointtype 6 pointsize 2 title i == words(rr_list) ? "auto, with its R_r" : "", \
        for [i = 1:words(rr_list)] data using (chosen(i)):(sunk(column("missed"))):(0):(fall(0)) with vectors arrowstyle i notitle, \
        for [i = 1:words(rr_list)] data using (chosen(i)):(standing(column("missed"))):(word(rr_list, i)) \
            with labels offset 1.2, 0 left font ",12" notitle, \
        0.01 with lines linestyle 90 notitle
}

if (figure eq "trade") {
    set title "Time saved against highlight missed: " . scene . ", random 4"
    set xlabel "share of the highlight's energy missed"
    set ylabel "frame time over that without the pass"
    set logscale x
    set format x "10^{%L}"
    set xrange [edge_of(lowest, 1):1]
    stats data using (strcol("scene") eq scene && column("spheres") > 0 && column("time_to_off") > 0 ? column("time_to_off") : NaN) name "T" nooutput
    if (!exists("T_max")) { exit status 3 }
    set yrange [0:(T_max > 1.1 ? 1.1 * T_max : 1.2)]
    set label 1 "no time saved" at graph 0.005, first 1 left offset 0, 0.6 textcolor rgb "#6a7076" font ",12"
    shown(i, missed) = fixed(strcol("series"), strcol("arm")) && at(i) ? missed : NaN
    plot for [i = 1:words(rr_list)] data using (shown(i, above(column("missed")))):"time_to_off" with linespoints linetype i pointsize 0.9 title "R_r " . word(rr_list, i), \
        for [i = 1:words(rr_list)] data using (shown(i, standing(column("missed")))):"time_to_off":"time_to_off_low":"time_to_off_high" \
            with yerrorbars linetype i dashtype 1 pointsize 0.9 notitle, \
        for [i = 1:words(rr_list)] data using (fixed(strcol("series"), strcol("arm")) && at(i) ? sunk(column("missed")) : NaN):"time_to_off":(fall(0)):(0) with vectors arrowstyle i notitle, \
        for [i = 1:words(rr_list)] data using (is_auto(strcol("arm")) && at(i) ? standing(column("missed")) : NaN):"time_to_off" \
            with points linetype i pointtype 6 pointsize 2 title i == words(rr_list) ? "auto, with its R_r" : "", \
        for [i = 1:words(rr_list)] data using (is_auto(strcol("arm")) && at(i) ? sunk(column("missed")) : NaN):"time_to_off":(fall(0)):(0) with vectors arrowstyle i notitle, \
        for [i = 1:words(rr_list)] data using (is_auto(strcol("arm")) && at(i) ? standing(column("missed")) : NaN):"time_to_off":(word(rr_list, i)) \
            with labels offset 1.2, 0 left font ",12" notitle, \
        data using (fixed(strcol("series"), strcol("arm")) && at(words(rr_list)) && (column("margin") == 0 || column("margin") == 0.5 || column("margin") == 1) ? standing(column("missed")) : NaN):"time_to_off":(sprintf("%g", column("margin"))) \
            with labels left offset 0.6, -0.6 font ",11" notitle, \
        1 with lines linestyle 90 notitle
}

if (figure eq "cost") {
    set title "Frame time with the pass, by R_r: " . scene . ", random 4"
    set xlabel "R_r"
    set ylabel "frame time over that without the pass"
    set logscale x
    set xtics (1, 3, 10, 30, 100, 300, 1000)
    timed(a) = strcol("scene") eq scene && strcol("series") eq "margin" && strcol("arm") eq a && column("time_to_off") > 0
    stats data using (timed("huge") ? column("rr") : NaN) name "RR" nooutput
    if (!exists("RR_max")) { exit status 3 }
    set xrange [RR_min / 2:RR_max * 2]
    names = "huge auto again"
    titles = "'the pass alone' 'auto' 'without it again'"
    place(i) = timed(word(names, i)) && (i != 2 || column("spheres") > 0) ? column("rr") * 1.05 ** (i - 2) : NaN
    plot for [i = 1:3] data using (place(i)):"time_to_off":"time_to_off_low":"time_to_off_high" \
            with yerrorbars linetype i dashtype 1 pointsize 1.1 title word(titles, i), \
        1 with lines linestyle 90 dashtype 3 title "no time saved", \
        1.1 with lines linestyle 90 title "10 % more"
}

if (figure eq "bound" || figure eq "mean") {
    # The worst pixel of those skipped, or all of them in the mean.
    loss = figure eq "bound" ? "worst_exact" : "loss_exact"
    low = figure eq "bound" ? 1e-4 : 1e-6
    set title (figure eq "bound" ? "Worst pixel against the bound asked for: " : "Mean loss of skipped pixels against the bound asked for: ") . scene
    set xlabel "bound on a pixel's loss, over the light's radiance"
    set ylabel (figure eq "bound" ? "largest loss of a skipped pixel" : "mean loss of skipped pixels")
    set logscale xy
    set format x "%g"
    set format y "10^{%L}"
    set xtics (0.005, 0.01, 0.02, 0.05, 0.1, 0.2)
    has_bound(any) = strcol("scene") eq scene && column("spheres") > 0 && column("bound") > 0
    # Side by side where all lose the same.
    asked(i) = has_bound(0) && at(i) ? column("bound") * (1 + 0.03 * (i - words(rr_list) / 2.0)) : NaN
    stats data using (has_bound(0) ? column(loss) : NaN) name "W" nooutput
    if (!exists("W_max")) { exit status 3 }
    set xrange [0.003:0.4]
    set yrange [edge_of(low, 0.4):0.4]
    plot for [i = 1:words(rr_list)] data using (asked(i)):(standing(column(loss))):(ended(column(loss . "_low"))):(ended(column(loss . "_high"))) \
            with yerrorbars linetype i pointsize 1.1 title "R_r " . word(rr_list, i), \
        for [i = 1:words(rr_list)] data using (asked(i)):(sunk(column(loss))):(0):(fall(0)) with vectors arrowstyle i notitle, \
        x with lines linestyle 90 title "the bound"
}
