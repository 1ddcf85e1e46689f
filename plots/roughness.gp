# Figures of the study `roughness`, from roughness.tsv and roughness_needed.tsv.
#
#   gnuplot -c plots/roughness.gp plots/style.gp FOLDER OUTPUT FIGURE SCENE
#
# FOLDER holds the tables, OUTPUT ends in .svg or .png, FIGURE is error, centre, split or needed.
folder = ARG2
output = ARG3
figure = ARG4
scene = ARG5
load ARG1
data = folder . "/roughness.tsv"

step = 1.0 / 255.0
here(s) = s eq scene

# The numbers of normals that were measured with the paper's settings, ascending: the next larger one until there is none.
next = 0.0
last = 0.0
note(x) = (x > last && x < next ? next = x : 0, x)
regular = ""
random = ""
while (1) {
    next = 1e99
    stats data using (here(strcol("scene")) && strcol("setting") eq "paper" && strcol("method") eq "regular" ? note(column("samples")) : NaN) nooutput
    if (next == 1e99) { break }
    regular = regular . sprintf("%g ", next)
    last = next
}
last = 0.0
while (1) {
    next = 1e99
    stats data using (here(strcol("scene")) && strcol("setting") eq "paper" && strcol("method") eq "random" ? note(column("samples")) : NaN) nooutput
    if (next == 1e99) { break }
    random = random . sprintf("%g ", next)
    last = next
}
row(setting, method, samples) = here(strcol("scene")) && strcol("setting") eq setting && strcol("method") eq method && column("samples") == samples

stats data using (here(strcol("scene")) && column("rmse") > 0 ? column("rmse") : NaN) name "RMSE" nooutput
stats data using (here(strcol("scene")) ? column("rr") : NaN) name "RR" nooutput
# A scene without a highlight has no error. Exit status 3 says that there is nothing to draw.
if (!exists("RMSE_min") || words(random) == 0) { exit status 3 }
largest = word(random, words(random))
decade_low = 10 ** floor(log10(RMSE_min < step ? RMSE_min : step))
decade_high = 10 ** ceil(log10(RMSE_max))

set logscale xy
set format y "10^{%L}"
set xlabel "R_r, roughness: 1 is the roughest, 1000 nearly a mirror"
set xtics (1, 2, 5, 10, 20, 50, 100, 200, 500, 1000)
set mxtics 1
set xrange [RR_min / 1.15:RR_max * 1.15]

if (figure eq "error" || figure eq "centre") {
    # Against the reference, or against one that sees the lights from the object's centre as the environment map does.
    metric = figure eq "error" ? "rmse" : "rmse_centre"
    set title (figure eq "error" ? "Error of every method over roughness, the paper's settings: " : "Error of every method but for parallax, the paper's settings: ") . scene
    set ylabel (figure eq "error" ? "RMSE of linear radiance (full scale 1)" : "RMSE but for parallax (full scale 1)")
    stats data using (here(strcol("scene")) && strcol("setting") eq "paper" && column(metric) > 0 ? column(metric) : NaN) name "E" nooutput
    if (!exists("E_min")) { exit status 3 }
    low = 10 ** floor(log10(E_min < step ? E_min : step))
    top = 10 ** ceil(log10(E_max))
    set yrange [edge_of(low, top):top]
    set key maxcols 3
    plot data using (row("paper", "plain", 0) ? column("rr") : NaN):(above(column(metric))) with linespoints linetype 4 pointsize 0.9 title "plain", \
        data using (row("paper", "plain", 0) ? column("rr") : NaN):(sunk(column(metric))) with points linetype 4 pointsize 0.9 notitle, \
        data using (row("paper", "exhaustive", 0) ? column("rr") : NaN):(above(column(metric))) with linespoints linetype 5 dashtype 1 pointtype 10 pointsize 1.1 title "exhaustive", \
        data using (row("paper", "exhaustive", 0) ? column("rr") : NaN):(sunk(column(metric))) with points linetype 5 pointtype 10 pointsize 1.1 notitle, \
        for [i = 1:words(regular)] data using (row("paper", "regular", word(regular, i) + 0) ? column("rr") : NaN):(above(column(metric))) \
            with linespoints linetype i dashtype 2 pointtype 2 * i + 2 pointsize 0.9 title "regular " . word(regular, i), \
        for [i = 1:words(regular)] data using (row("paper", "regular", word(regular, i) + 0) ? column("rr") : NaN):(sunk(column(metric))) with points linetype i pointtype 2 * i + 2 pointsize 0.9 notitle, \
        for [i = 1:words(random)] data using (row("paper", "random", word(random, i) + 0) ? column("rr") : NaN):(above(column(metric))) \
            with linespoints linetype i dashtype 1 pointtype 2 * i + 3 pointsize 0.9 title "random " . word(random, i), \
        for [i = 1:words(random)] data using (row("paper", "random", word(random, i) + 0) ? column("rr") : NaN):(standing(column(metric))):(ended(column(metric . "_low"))):(ended(column(metric . "_high"))) \
            with yerrorbars linetype i dashtype 1 pointtype 2 * i + 3 pointsize 0.9 notitle, \
        step with lines linestyle 90 title "1/255"
}

if (figure eq "split") {
    set title "What the error of random normals is made of: " . scene
    set ylabel "noise and floors (full scale 1)"
    set yrange [edge_of(1e-4, decade_high):decade_high]
    set bmargin 10.5
    fine = 0
    stats data using (here(strcol("scene")) && strcol("setting") eq "fine" && column("samples") > fine ? fine = column("samples") : NaN) nooutput
    part(setting, samples) = row(setting, "random", samples) ? column("rr") : NaN
    plot data using (part("paper", 4)):(above(column("noise"))) \
            with linespoints linetype 1 dashtype 1 pointsize 0.9 title "noise, 4 normals", \
        data using (part("paper", 4)):(standing(column("noise"))):(ended(column("noise_low"))):(ended(column("noise_high"))) \
            with yerrorbars linetype 1 dashtype 1 pointsize 0.9 notitle, \
        data using (part("paper", largest + 0)):(above(column("noise"))) \
            with linespoints linetype 7 dashtype 1 pointtype 6 pointsize 0.9 title "noise, " . largest . " normals", \
        data using (part("paper", largest + 0)):(standing(column("noise"))):(ended(column("noise_low"))):(ended(column("noise_high"))) \
            with yerrorbars linetype 7 dashtype 1 pointtype 6 pointsize 0.9 notitle, \
        data using (part("paper", largest + 0)):(above(column("floor"))) \
            with linespoints linetype 2 dashtype 1 pointsize 0.9 title "floor", \
        data using (part("paper", largest + 0)):(standing(column("floor"))):(ended(column("floor_low"))):(ended(column("floor_high"))) \
            with yerrorbars linetype 2 dashtype 1 pointsize 0.9 notitle, \
        data using (part("paper", largest + 0)):(sunk(column("floor"))):(0):(fall(0)) with vectors arrowstyle 2 notitle, \
        data using (part("paper", largest + 0)):"parallax" \
            with lines linetype 4 dashtype 3 title "parallax alone", \
        data using (part("paper", largest + 0)):(standing(column("floor_centre"))):(ended(column("floor_centre_low"))):(ended(column("floor_centre_high"))) \
            with yerrorbars linetype 3 dashtype 1 pointsize 1 title "floor − parallax, paper's", \
        data using (part("paper", largest + 0)):(sunk(column("floor_centre"))):(0):(fall(0)) with vectors arrowstyle 3 notitle, \
        data using (part("fine", fine) * 1.06):(standing(column("floor_centre"))):(ended(column("floor_centre_low"))):(ended(column("floor_centre_high"))) \
            with yerrorbars linetype 5 dashtype 1 pointsize 1 title "floor − parallax, fine", \
        data using (part("fine", fine) * 1.06):(sunk(column("floor_centre"))):(0):(fall(0)) with vectors arrowstyle 5 notitle, \
        step with lines linestyle 90 title "1/255"
}

if (figure eq "needed") {
    data = folder . "/roughness_needed.tsv"
    set title "Random normals a pixel for an RMSE of 1/255: " . scene
    set ylabel "normals a pixel"
    top = 1e5
    set yrange [1:top]
    set format y "%g"
    # Infinite: at the upper edge.
    finite(x) = x < top ? x : NaN
    edge(x) = x < top ? x : top
    none(x) = x < top ? NaN : top / 1.25
    one(setting) = here(strcol("scene")) && strcol("setting") eq setting
    # Side by side where the three agree.
    x(i) = column("rr") * 1.04 ** i
    plot data using (one("paper") ? x(-1) : NaN):(finite(column("needed"))):(edge(column("needed_low"))):(edge(column("needed_high"))) \
            with yerrorlines linetype 1 dashtype 1 pointsize 1 notitle, \
        data using (one("paper") ? x(-1) : NaN):(none(column("needed"))) with points linetype 1 pointtype 6 pointsize 1.3 notitle, \
        data using (one("paper") ? x(0) : NaN):(finite(column("needed_centre"))):(edge(column("needed_centre_low"))):(edge(column("needed_centre_high"))) \
            with yerrorlines linetype 2 dashtype 1 pointsize 1 notitle, \
        data using (one("paper") ? x(0) : NaN):(none(column("needed_centre"))) with points linetype 2 pointtype 4 pointsize 1.3 notitle, \
        data using (one("fine") ? x(1) : NaN):(finite(column("needed_centre"))):(edge(column("needed_centre_low"))):(edge(column("needed_centre_high"))) \
            with yerrorlines linetype 3 dashtype 1 pointsize 1 notitle, \
        data using (one("fine") ? x(1) : NaN):(none(column("needed_centre"))) with points linetype 3 pointtype 8 pointsize 1.3 notitle, \
        keyentry with linespoints linetype 1 dashtype 1 pointsize 1 title "the paper's settings", \
        keyentry with linespoints linetype 2 dashtype 1 pointsize 1 title "the paper's − parallax", \
        keyentry with linespoints linetype 3 dashtype 1 pointsize 1 title "fine − parallax", \
        4 with lines linestyle 90 title "4 and 1024", 1024 with lines linestyle 90 notitle
}
