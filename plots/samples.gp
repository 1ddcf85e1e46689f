# Figures of the study `samples`, from samples.tsv.
#
#   gnuplot -c plots/samples.gp plots/style.gp FOLDER OUTPUT FIGURE SCENE
#
# FOLDER holds samples.tsv, OUTPUT ends in .svg or .png, FIGURE is error, split, floor or time.
folder = ARG2
output = ARG3
figure = ARG4
scene = ARG5
load ARG1
data = folder . "/samples.tsv"

row(series, setting, method) = strcol("scene") eq scene && strcol("series") eq series && strcol("setting") eq setting \
    && strcol("method") eq method

# The values of R_r that were measured, ascending: the next larger one until there is none.
rr_list = ""
last = 0.0
while (1) {
    next = 1e99
    note_rr(x) = (x > last && x < next ? next = x : 0, x)
    stats data using (strcol("scene") eq scene && strcol("series") eq "methods" ? note_rr(column("rr")) : NaN) nooutput
    if (next == 1e99) { break }
    rr_list = rr_list . sprintf("%g ", next)
    last = next
}
stats data using (strcol("scene") eq scene && strcol("series") eq "methods" ? note_central(column("rr")) : NaN) nooutput
at = sprintf(", R_r %g", central)
# And the settings, paper alone or paper and fine; and those of them that were timed.
settings = ""
note_setting(s) = (strstrt(" " . settings, " " . s . " ") == 0 ? settings = settings . s . " " : settings, 1)
stats data using (strcol("scene") eq scene && strcol("series") eq "methods" && column("rr") == central ? note_setting(strcol("setting")) : NaN) nooutput
timed_settings = ""
note_timed(s) = (strstrt(" " . timed_settings, " " . s . " ") == 0 ? timed_settings = timed_settings . s . " " : timed_settings, 1)
stats data using (strcol("scene") eq scene && column("rr") == central && column("frame_ms") > 0 ? note_timed(strcol("setting")) : NaN) nooutput

step = 1.0 / 255.0
stats data using (strcol("scene") eq scene && column("rmse") > 0 ? column("rmse") : NaN) name "RMSE" nooutput
# A scene without a highlight has no error. Exit status 3 says that there is nothing to draw.
if (!exists("RMSE_min")) { exit status 3 }
decade_low = 10 ** floor(log10(RMSE_min < step ? RMSE_min : step))
decade_high = 10 ** ceil(log10(RMSE_max))
# The guide of slope -1/2 is the noise of one random normal at that R_r, divided by the root of N.
stats data using (row("methods", "paper", "random") && column("rr") == central && column("samples") == 1 ? column("noise") : NaN) name "GUIDE" nooutput
if (!exists("GUIDE_max")) { GUIDE_max = NaN }

name(s) = s eq "paper" ? "paper's" : s

set logscale xy
set format y "10^{%L}"
set xtics (1, 2, 4, 8, 16, 32, 64, 128, 256, 512, 1024)
set mxtics 1
set xlabel "N, microfacet normals a pixel"

if (figure eq "error") {
    set title "Error against the number of normals, the paper's settings: " . scene
    set ylabel "RMSE of linear radiance (full scale 1)"
    set xrange [0.8:1300]
    set yrange [edge_of(decade_low, decade_high):decade_high]
    set label 1 "1/255" at 0.85, step * 1.12 left textcolor rgb "#6a7076" font ",12"
    plot for [i = 1:words(rr_list)] data using (row("methods", "paper", "regular") && column("rr") == word(rr_list, i) ? column("samples") : NaN):"rmse" \
            with linespoints linetype i dashtype 2 pointtype 2 * i + 2 pointsize 0.8 title "regular, R_r " . word(rr_list, i), \
        for [i = 1:words(rr_list)] data using (row("methods", "paper", "random") && column("rr") == word(rr_list, i) ? column("samples") : NaN):"rmse":(ended(column("rmse_low"))):"rmse_high" \
            with yerrorlines linetype i dashtype 1 pointtype 2 * i + 3 pointsize 0.8 title "random, R_r " . word(rr_list, i), \
        step with lines linestyle 90 notitle, \
        GUIDE_max / sqrt(x) with lines linestyle 90 title "slope −1/2"
}

if (figure eq "split") {
    set title "Random normals taken apart: " . scene . at
    set ylabel "noise and floor (full scale 1)"
    set xrange [0.8:1300]
    set yrange [edge_of(1e-4, decade_high):decade_high]
    set bmargin 10.5
    part(s) = row("methods", s, "random") && column("rr") == central ? column("samples") : NaN
    # Bars of both settings side by side, else they cover each other.
    beside(i) = part(word(settings, i)) * 1.08 ** (i - 1)
    plot for [i = 1:words(settings)] data using (part(word(settings, i))):(above(column("noise"))) \
            with linespoints linetype i dashtype 1 pointtype 2 * i + 3 pointsize 0.9 title "noise, " . name(word(settings, i)), \
        for [i = 1:words(settings)] data using (part(word(settings, i))):(standing(column("noise"))):(ended(column("noise_low"))):(ended(column("noise_high"))) \
            with yerrorbars linetype i dashtype 1 pointtype 2 * i + 3 pointsize 0.9 notitle, \
        for [i = 1:words(settings)] data using (part(word(settings, i))):(standing(column("floor"))):(ended(column("floor_low"))):(ended(column("floor_high"))) \
            with yerrorbars linetype i dashtype 1 pointtype 2 * i + 2 pointsize 0.9 notitle, \
        for [i = 1:words(settings)] data using (part(word(settings, i))):(sunk(column("floor"))):(0):(fall(0)) with vectors arrowstyle i notitle, \
        for [i = 1:words(settings)] data using (part(word(settings, i))):(above(column("floor"))) \
            with linespoints linetype i dashtype 2 pointtype 2 * i + 2 pointsize 0.9 title "floor, " . name(word(settings, i)), \
        for [i = 1:words(settings)] data using (beside(i)):(standing(column("floor_centre"))):(ended(column("floor_centre_low"))):(ended(column("floor_centre_high"))) \
            with yerrorbars linetype i + 2 dashtype 1 pointtype 2 * i + 6 pointsize 0.9 title "floor − parallax, " . name(word(settings, i)), \
        for [i = 1:words(settings)] data using (beside(i)):(sunk(column("floor_centre"))):(0):(fall(0)) with vectors arrowstyle i + 2 notitle, \
        step with lines linestyle 90 title "1/255", \
        GUIDE_max / sqrt(x) with lines linestyle 90 dashtype 3 title "slope −1/2"
}

if (figure eq "floor") {
    central_off = 1e99
    stats data using (strcol("scene") eq scene && strcol("series") eq "floor" ? note_central(column("rr")) : NaN) nooutput
    set title sprintf("What samples cannot remove: %s, R_r %g, float normals", scene, central)
    set xlabel "environment map, texels along an edge of a face"
    set ylabel "floor: root of bias² (full scale 1)"
    set xtics (8, 16, 32, 64, 128, 256, 512, 1024, 2048, 4096)
    here(x) = strcol("scene") eq scene && strcol("series") eq "floor" && column("rr") == central ? x : NaN
    positive(x) = x > 0 ? x : NaN
    stats data using (here(column("env_size_px"))) name "SIZE" nooutput
    stats data using (here(positive(column("floor")))) name "FLOOR" nooutput
    stats data using (here(positive(column("floor_centre")))) name "CENTRE" nooutput
    stats data using (here(column("parallax"))) name "PARALLAX" nooutput
    if (!exists("FLOOR_max") || !exists("CENTRE_min")) { exit status 3 }
    set xrange [SIZE_min / 1.3:SIZE_max * 1.3]
    low = CENTRE_min < step ? CENTRE_min : step
    top = 10 ** ceil(log10(FLOOR_max > PARALLAX_max ? FLOOR_max : PARALLAX_max))
    set yrange [edge_of(10 ** floor(log10(low)), top):top]
    plot data using (here(column("env_size_px"))):(above(column("floor"))) with linespoints linetype 1 pointsize 1 title "against the reference", \
        data using (here(column("env_size_px"))):(standing(column("floor"))):(ended(column("floor_low"))):(ended(column("floor_high"))) \
            with yerrorbars linetype 1 dashtype 1 pointsize 1 notitle, \
        data using (here(column("env_size_px"))):(sunk(column("floor"))):(0):(fall(0)) with vectors arrowstyle 1 notitle, \
        data using (here(column("env_size_px"))):(above(column("floor_centre"))) with linespoints linetype 2 dashtype 1 pointsize 1 title "seen from the object's centre", \
        data using (here(column("env_size_px"))):(standing(column("floor_centre"))):(ended(column("floor_centre_low"))):(ended(column("floor_centre_high"))) \
            with yerrorbars linetype 2 dashtype 1 pointsize 1 notitle, \
        data using (here(column("env_size_px"))):(sunk(column("floor_centre"))):(0):(fall(0)) with vectors arrowstyle 2 notitle, \
        PARALLAX_max with lines linetype 3 dashtype 4 title "parallax alone", \
        step with lines linestyle 90 title "1/255", \
        CENTRE_max * SIZE_min / x with lines linestyle 90 dashtype 3 title "slope −1"
}

if (figure eq "time") {
    set title "Error against time: " . scene . at
    set xlabel "median frame time in ms"
    set bmargin 9
    set ylabel "RMSE of linear radiance (full scale 1)"
    set xtics (1, 2, 5, 10, 20, 50, 100, 200, 500, 1000, 2000, 5000, 10000)
    set format x "%g"
    timed(setting, method) = row("methods", setting, method) && column("rr") == central && column("frame_ms") > 0
    shown(x) = timed("paper", "random") || timed("paper", "regular") || timed("fine", "random") || timed("fine", "regular") ? x : NaN
    stats data using (shown(column("frame_ms_low"))) name "LEFT" nooutput
    stats data using (shown(column("frame_ms_high"))) name "RIGHT" nooutput
    stats data using (shown(column("rmse"))) name "E" nooutput
    if (!exists("E_min")) { exit status 3 }
    set xrange [LEFT_min / 1.2:RIGHT_max * 1.2]
    # Within a decade there are few powers of ten; 1/255 is shown where the errors come near it.
    low = (E_min < 2.5 * step && E_min > step ? step : E_min) / 1.2
    set yrange [edge_of(low, E_max * 1.25):E_max * 1.25]
    if (E_max / low < 100) {
        set format y "%g"
        set ytics (0.0001, 0.0002, 0.0005, 0.001, 0.002, 0.003, 0.005, 0.007, 0.01, 0.02, 0.03, 0.05, 0.07, 0.1, 0.2, 0.3, 0.5, 1)
        if (E_max / low < 6) { set ytics add (0.004, 0.006, 0.008, 0.009, 0.015, 0.025, 0.04, 0.06, 0.08, 0.09, 0.12, 0.15, 0.25, 0.4) }
    }
    settings_of(s) = s eq "paper" ? "the paper's settings" : s . " settings"
    # Line types of regular and random, setting by setting; numbers of the first setting, in the colours of both curves.
    type(i, random) = 2 * i - 1 + (random ? 0 : 1)
    # A number stands only where the one before it is far enough off, in parts of the frame.
    named(n) = n == 1 || n == 4 || n == 13 || n == 64 || n == 256 || n == 1024
    last_ms = NaN
    last_rmse = NaN
    off(ms, rmse) = abs(log(ms / last_ms)) / log(RIGHT_max / LEFT_min) + abs(log(rmse / last_rmse)) / log(E_max * 1.5 / low)
    note_label(ms, rmse) = off(ms, rmse) < 0.04 ? NaN : (last_ms = ms, last_rmse = rmse, ms)
    labelled(method) = timed("paper", method) && named(column("samples")) ? note_label(column("frame_ms"), column("rmse")) : NaN
    # Bars are thinner than the curves that they belong to, since those of neighbours overlap on a machine that is not quiet.
    plot for [i = 1:words(timed_settings)] for [k = 0:1] data using (timed(word(timed_settings, i), k ? "random" : "regular") ? column("frame_ms") : NaN):(standing(column("rmse"))):"frame_ms_low":"frame_ms_high":(ended(column("rmse_low"))):(ended(column("rmse_high"))) \
            with xyerrorbars linetype type(i, k) dashtype 1 linewidth 0.5 pointtype 2 * i + 2 + k pointsize 0.9 notitle, \
        for [i = 1:words(timed_settings)] for [k = 0:1] data using (timed(word(timed_settings, i), k ? "random" : "regular") ? column("frame_ms") : NaN):(above(column("rmse"))) \
            with linespoints linetype type(i, k) dashtype 2 - k pointtype 2 * i + 2 + k pointsize 0.9 title (k ? "random, " : "regular, ") . settings_of(word(timed_settings, i)), \
        data using (labelled("random")):"rmse":(sprintf("%g", column("samples"))) \
            with labels center offset 0, 0.75 font ",12" textcolor rgb "#0072b2" notitle, \
        data using (labelled("regular")):"rmse":(sprintf("%g", column("samples"))) \
            with labels center offset 0, -0.75 font ",12" textcolor rgb "#b34a00" notitle, \
        (low <= step ? step : 1 / 0) with lines linestyle 90 title low <= step ? "1/255" : ""
}
