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
# An interval's end of zero has no place on a logarithmic axis: it is drawn to below the frame.
above_zero(x) = x > 1e-12 ? x : 1e-12

# The values of R_r that were measured, in the file's order.
rr_list = ""
note_rr(x) = (x == x && strstrt(" " . rr_list, sprintf(" %g ", x)) == 0 ? rr_list = rr_list . sprintf("%g ", x) : rr_list, x)
stats data using (strcol("scene") eq scene && strcol("series") eq "methods" ? note_rr(column("rr")) : NaN) nooutput
# And the settings, paper alone or paper and fine.
settings = ""
note_setting(s) = (strstrt(" " . settings, " " . s . " ") == 0 ? settings = settings . s . " " : settings, 1)
stats data using (strcol("scene") eq scene && strcol("series") eq "methods" && column("rr") == 30 ? note_setting(strcol("setting")) : NaN) nooutput

stats data using (strcol("scene") eq scene && column("rmse") > 0 ? column("rmse") : NaN) name "RMSE" nooutput
decade_low = 10 ** floor(log10(RMSE_min))
decade_high = 10 ** ceil(log10(RMSE_max))
step = 1.0 / 255.0

name(s) = s eq "paper" ? "paper's settings" : "fine settings"

set logscale xy
set format y "10^{%L}"
set xtics (1, 2, 4, 8, 16, 32, 64, 128, 256, 512, 1024)
set mxtics 1
set xlabel "N, microfacet normals a pixel"

if (figure eq "error") {
    set title "Error against the number of normals, the paper's settings: " . scene
    set ylabel "RMSE of linear radiance (full scale 1)"
    set xrange [0.8:1300]
    set yrange [decade_low:decade_high]
    set label 1 "1/255" at 0.85, step * 1.12 left textcolor rgb "#6a7076" font ",12"
    # The guide of slope -1/2 starts from random at the second R_r's first point, or the first's.
    guide_rr = words(rr_list) > 1 ? word(rr_list, 2) : word(rr_list, 1)
    stats data using (row("methods", "paper", "random") && column("rr") == guide_rr ? column("rmse") * sqrt(column("samples")) : NaN) name "GUIDE" nooutput
    plot for [i = 1:words(rr_list)] data using (row("methods", "paper", "regular") && column("rr") == word(rr_list, i) ? column("samples") : NaN):"rmse" \
            with linespoints linetype i dashtype 2 pointtype 2 * i + 2 pointsize 0.8 title "regular, R_r " . word(rr_list, i), \
        for [i = 1:words(rr_list)] data using (row("methods", "paper", "random") && column("rr") == word(rr_list, i) ? column("samples") : NaN):"rmse":(above_zero(column("rmse_low"))):"rmse_high" \
            with yerrorlines linetype i dashtype 1 pointtype 2 * i + 3 pointsize 0.8 title "random, R_r " . word(rr_list, i), \
        step with lines linestyle 90 notitle, \
        GUIDE_max / sqrt(x) with lines linestyle 90 title "slope −1/2"
}

if (figure eq "split") {
    set title "Random normals taken apart: " . scene . ", R_r 30"
    set ylabel "noise and floor (full scale 1)"
    set xrange [0.8:1300]
    set yrange [decade_low / 10:decade_high]
    stats data using (row("methods", "paper", "random") && column("rr") == 30 ? column("noise") * sqrt(column("samples")) : NaN) name "GUIDE" nooutput
    plot for [i = 1:words(settings)] data using (row("methods", word(settings, i), "random") && column("rr") == 30 ? column("samples") : NaN):"noise":(above_zero(column("noise_low"))):"noise_high" \
            with yerrorlines linetype i dashtype 1 pointtype 2 * i + 3 pointsize 0.9 title "noise: " . name(word(settings, i)), \
        for [i = 1:words(settings)] data using (row("methods", word(settings, i), "random") && column("rr") == 30 && column("floor") > 0 ? column("samples") : NaN):"floor":(above_zero(column("floor_low"))):"floor_high" \
            with yerrorbars linetype i dashtype 1 pointtype 2 * i + 2 pointsize 0.9 notitle, \
        for [i = 1:words(settings)] data using (row("methods", word(settings, i), "random") && column("rr") == 30 && column("floor") > 0 ? column("samples") : NaN):"floor" \
            with linespoints linetype i dashtype 2 pointtype 2 * i + 2 pointsize 0.9 title "floor: " . name(word(settings, i)), \
        step with lines linestyle 90 title "1/255", \
        GUIDE_max / sqrt(x) with lines linestyle 90 dashtype 3 title "slope −1/2"
}

if (figure eq "floor") {
    set title "What samples cannot remove: " . scene . ", R_r 30, float normals"
    set xlabel "environment map, texels along an edge of a face"
    set ylabel "error of the mean over seeds (full scale 1)"
    set xtics (8, 16, 32, 64, 128, 256, 512, 1024, 2048, 4096)
    here(x) = strcol("scene") eq scene && strcol("series") eq "floor" ? x : NaN
    stats data using (here(column("env_size_px"))) name "SIZE" nooutput
    stats data using (here(column("floor") > 0 ? column("floor") : NaN)) name "FLOOR" nooutput
    stats data using (here(column("texel_error") > 0 ? column("texel_error") : NaN)) name "TEXEL" nooutput
    set xrange [SIZE_min / 1.3:SIZE_max * 1.3]
    low = TEXEL_min < step ? TEXEL_min : step
    high = FLOOR_max > TEXEL_max ? FLOOR_max : TEXEL_max
    set yrange [10 ** floor(log10(low)):10 ** ceil(log10(high))]
    plot data using (here(column("env_size_px"))):"floor":(above_zero(column("floor_low"))):"floor_high" \
            with yerrorlines linetype 1 pointsize 1 title "floor: error against the reference", \
        data using (here(column("texel_error") > 0 ? column("env_size_px") : NaN)):"texel_error":(above_zero(column("texel_error_low"))):"texel_error_high" \
            with yerrorlines linetype 2 dashtype 1 pointsize 1 title "texel error: against the largest map", \
        step with lines linestyle 90 title "1/255", \
        TEXEL_max * SIZE_min / x with lines linestyle 90 dashtype 3 title "slope −1"
}

if (figure eq "time") {
    set title "Error against time: " . scene . ", R_r 30"
    set xlabel "median frame time in ms"
    set ylabel "RMSE of linear radiance (full scale 1)"
    set xtics auto
    set format x "%g"
    stats data using (strcol("scene") eq scene && column("frame_ms") > 0 ? column("frame_ms") : NaN) name "MS" nooutput
    set xrange [MS_min / 1.5:MS_max * 1.8]
    set yrange [decade_low:decade_high]
    timed(setting, method) = row("methods", setting, method) && column("frame_ms") > 0
    label(n) = n == 1 || n == 4 || n == 13 || n == 64 || n == 1024
    plot for [i = 1:words(settings)] data using (timed(word(settings, i), "regular") ? column("frame_ms") : NaN):"rmse" \
            with linespoints linetype i dashtype 2 pointtype 2 * i + 2 pointsize 0.9 title "regular: " . name(word(settings, i)), \
        for [i = 1:words(settings)] data using (timed(word(settings, i), "random") ? column("frame_ms") : NaN):"rmse":"frame_ms_low":"frame_ms_high":(above_zero(column("rmse_low"))):"rmse_high" \
            with xyerrorlines linetype i dashtype 1 pointtype 2 * i + 3 pointsize 0.9 title "random: " . name(word(settings, i)), \
        data using (timed("paper", "random") && label(column("samples")) ? column("frame_ms") : NaN):"rmse":(sprintf("%g", column("samples"))) \
            with labels offset 0.9, 0.7 font ",12" textcolor rgb "#0072b2" notitle, \
        data using (timed("paper", "regular") && label(column("samples")) ? column("frame_ms") : NaN):"rmse":(sprintf("%g", column("samples"))) \
            with labels offset -0.9, -0.7 font ",12" textcolor rgb "#0072b2" notitle, \
        step with lines linestyle 90 title "1/255"
}
