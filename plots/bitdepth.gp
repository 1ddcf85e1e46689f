# Figures of the study `bitdepth`, from bitdepth_normals.tsv, bitdepth_regular.tsv, bitdepth_environment.tsv, bitdepth_frame.tsv and bitdepth_time.tsv.
#
#   gnuplot -c plots/bitdepth.gp plots/style.gp FOLDER OUTPUT FIGURE SCENE
#
# FOLDER holds the tables, OUTPUT ends in .svg or .png, FIGURE is normals, regular, rounding, formats or time.
folder = ARG2
output = ARG3
figure = ARG4
scene = ARG5
load ARG1
normals = folder . "/bitdepth_normals.tsv"
regular = folder . "/bitdepth_regular.tsv"

step = 1.0 / 255.0
here(s) = s eq scene

# The largest N: bias is the same at each, but known best there.
stats normals using (here(strcol("scene")) ? column("samples") : NaN) name "N" nooutput
stats normals using (here(strcol("scene")) ? column("rr") : NaN) name "RR" nooutput
stats normals using (here(strcol("scene")) && column("change") > 0 ? column("change") : NaN) name "CHANGE" nooutput
# Exit status 3 says that there is nothing to draw: not measured, or a scene without a highlight.
if (figure ne "time" && !exists("CHANGE_max")) { exit status 3 }
bits(b) = here(strcol("scene")) && strcol("normal_bits") eq b && column("samples") == N_max

if (figure ne "time") {
    set logscale xy
    set format y "10^{%L}"
    set xlabel "R_r, roughness: 1 is the roughest, 1000 nearly a mirror"
    set xtics (1, 2, 5, 10, 20, 50, 100, 200, 500, 1000)
    set mxtics 1
    set xrange [RR_min / 1.3:RR_max * 1.3]
    set style line 91 linecolor rgb "#c9ced3" linewidth 5 dashtype 1
}

if (figure eq "normals") {
    set title "Bias from the bits of the normal map: " . scene
    set ylabel "RMS bias (full scale 1)"
    set yrange [edge_of(1e-4, 0.3):0.3]
    set key maxcols 4
    set bmargin 9
    names = "4 5 6 8 10 12 16 half"
    # Not all by colour: more curves than colours.
    type(i) = i <= 7 ? i : 1
    # Bars side by side, else they cover each other.
    at(i) = bits(word(names, i)) ? column("rr") * 1.045 ** (i - 4.5) : NaN
    plot normals using (bits("float") ? column("rr") : NaN):(0.1 * column("noise_4")) with lines linestyle 91 title "noise/10", \
        for [i = 1:words(names)] normals using (at(i)):(standing(column("bias"))):(ended(column("bias_low"))):(ended(column("bias_high"))) \
            with yerrorbars linetype type(i) dashtype 1 pointtype i + 3 pointsize 0.9 notitle, \
        for [i = 1:words(names)] normals using (at(i)):(sunk(column("bias"))):(0):(fall(0)) with vectors arrowstyle type(i) notitle, \
        for [i = 1:words(names)] normals using (column("bias_low") > edge ? at(i) : NaN):"bias" \
            with lines linetype type(i) dashtype i notitle, \
        for [i = 1:words(names)] keyentry with linespoints linetype type(i) dashtype i pointtype i + 3 pointsize 0.9 title word(names, i), \
        step with lines linestyle 90 title "1/255"
}

if (figure eq "regular") {
    set title "8 and 10 bits for random normals and for a pattern: " . scene
    set ylabel "RMS (full scale 1)"
    set yrange [edge_of(1e-4, 0.3):0.3]
    random(b, aside) = bits(b) ? column("rr") * aside : NaN
    pattern(b) = here(strcol("scene")) && strcol("normal_bits") eq b
    plot normals using (bits("float") ? column("rr") : NaN):(0.1 * column("noise_4")) with lines linestyle 91 title "noise/10", \
        regular using (pattern("8") ? column("rr") : NaN):(above(column("change"))) with linespoints linetype 2 dashtype 1 title "regular 13, 8 bits", \
        regular using (pattern("8") ? column("rr") : NaN):(sunk(column("change"))) with points linetype 2 notitle, \
        normals using (random("8", 0.98)):(above(column("bias"))) \
            with linespoints linetype 1 dashtype 1 title "random, 8 bits", \
        normals using (random("8", 0.98)):(standing(column("bias"))):(ended(column("bias_low"))):(ended(column("bias_high"))) \
            with yerrorbars linetype 1 dashtype 1 notitle, \
        normals using (random("8", 0.98)):(sunk(column("bias"))):(0):(fall(0)) with vectors arrowstyle 1 notitle, \
        regular using (pattern("10") ? column("rr") : NaN):(above(column("change"))) with linespoints linetype 6 dashtype 2 title "regular 13, 10 bits", \
        regular using (pattern("10") ? column("rr") : NaN):(sunk(column("change"))) with points linetype 6 notitle, \
        normals using (random("10", 1.02)):(above(column("bias"))) \
            with linespoints linetype 7 dashtype 2 title "random, 10 bits", \
        normals using (random("10", 1.02)):(standing(column("bias"))):(ended(column("bias_low"))):(ended(column("bias_high"))) \
            with yerrorbars linetype 7 dashtype 1 notitle, \
        normals using (random("10", 1.02)):(sunk(column("bias"))):(0):(fall(0)) with vectors arrowstyle 7 notitle, \
        step with lines linestyle 90 title "1/255"
}

if (figure eq "rounding") {
    stats normals using (here(strcol("scene")) ? note_central(column("rr")) : NaN) nooutput
    set title sprintf("Change of the picture by the bits of the normal map: %s, R_r %g, N = %g", scene, central, N_max)
    set xlabel "bits of the normal map"
    set ylabel "RMS change (full scale 1)"
    unset logscale x
    set xtics (4, 5, 6, 7, 8, 9, 10, 12, 16) nologscale
    set xrange [3.5:16.5]
    change(b) = here(strcol("scene")) && strcol("normal_bits") eq b && column("samples") == N_max && column("rr") == central ? column("change") : NaN
    stats normals using (change("6")) name "SIX" nooutput
    stats normals using (change("10")) name "TEN" nooutput
    stats normals using (change("4")) name "FOUR" nooutput
    if (!exists("SIX_max") || !exists("TEN_max") || !exists("FOUR_max")) { exit status 3 }
    set yrange [edge_of(1e-5, 3 * FOUR_max):3 * FOUR_max]
    # A straight line in log scale: at 8 bits the geometric mean of both its ends.
    mean(x) = x >= 6 && x <= 10 ? SIX_max * (TEN_max / SIX_max) ** ((x - 6) / 4.0) : NaN
    names = "4 5 6 8 10 12 16"
    set samples 1001
    plot for [i = 1:words(names)] normals using (change(word(names, i)) >= 0 ? real(word(names, i)) : NaN):(standing(column("change"))):(ended(column("change_low"))):(ended(column("change_high"))) \
            with yerrorbars linetype 1 dashtype 1 title (i == 1 ? "random, 95 % interval" : ""), \
        for [i = 1:words(names)] normals using (change(word(names, i)) >= 0 ? real(word(names, i)) : NaN):(sunk(column("change"))):(0):(fall(0)) with vectors arrowstyle 1 notitle, \
        mean(x) with lines linetype 2 dashtype 1 title "between 6 and 10 bits", \
        sqrt(2.0) * mean(x) with lines linetype 4 dashtype 2 title "√2 times that: the bound at 8 bits", \
        step with lines linestyle 90 title "1/255"
}

if (figure eq "formats") {
    set title "Formats of environment map and frame buffer: " . scene
    set ylabel "RMS change (full scale 1)"
    set yrange [edge_of(1e-7, 0.02):0.02]
    set bmargin 10.5
    names = "rgba8 rgb10a2 r11g11b10f rgba16 rgba16f"
    # Kept by hand: on a logarithmic axis `stats` sees no zero.
    largest_change = -1
    note_change(x) = (x > largest_change ? largest_change = x : 0, 1)
    stats folder . "/bitdepth_environment.tsv" using (here(strcol("scene")) ? note_change(column("change")) : NaN) nooutput
    if (largest_change == 0) { set label 1 "as texels of the environment map: exact in every format" at graph 0.5, 0.1 center font ",12" }
    # Side by side where several change nothing.
    one(f, i) = here(strcol("scene")) && f eq word(names, i) ? column("rr") * 1.02 ** (i - 3) : NaN
    plot normals using (bits("float") ? column("rr") : NaN):(0.1 * column("noise_4")) with lines linestyle 91 title "noise/10", \
        for [i = 1:words(names)] folder . "/bitdepth_environment.tsv" using (one(strcol("env_format"), i)):(above(column("change"))) \
            with linespoints linetype i dashtype 1 pointtype 2 * i + 3 pointsize 0.9 notitle, \
        for [i = 1:words(names)] folder . "/bitdepth_environment.tsv" using (one(strcol("env_format"), i)):(sunk(column("change"))) with points linetype i pointtype 2 * i + 3 pointsize 0.9 notitle, \
        for [i = 1:words(names)] folder . "/bitdepth_environment.tsv" using (one(strcol("env_format"), i)):(sunk(column("change"))):(0):(fall(0)) with vectors arrowstyle i notitle, \
        for [i = 1:words(names)] folder . "/bitdepth_frame.tsv" using (one(strcol("frame_format"), i)):(above(column("change"))) \
            with linespoints linetype i dashtype 2 pointtype 2 * i + 2 pointsize 0.9 notitle, \
        for [i = 1:words(names)] folder . "/bitdepth_frame.tsv" using (one(strcol("frame_format"), i)):(sunk(column("change"))) with points linetype i pointtype 2 * i + 2 pointsize 0.9 notitle, \
        for [i = 1:words(names)] folder . "/bitdepth_frame.tsv" using (one(strcol("frame_format"), i)):(sunk(column("change"))):(0):(fall(0)) with vectors arrowstyle i notitle, \
        for [i = 1:words(names)] keyentry with linespoints linetype i dashtype 1 pointtype 2 * i + 3 pointsize 0.9 title word(names, i), \
        keyentry with lines linetype 4 dashtype 2 title "dashed: frame buffer", \
        step with lines linestyle 90 title "1/255"
}

if (figure eq "time") {
    data = folder . "/bitdepth_time.tsv"
    set title "Frame time by the bits of the normal map, 4 random normals: " . scene
    set ylabel "frame time relative to 8 bits"
    set xlabel "bits of the normal map"
    set grid noxtics
    names = "8-again 4 10 16 half float"
    # The arms 8 and none (no highlight) have no place here: what is relative to 8 bits, and what has no normal map.
    before(arm) = strstrt(" " . names . " ", " " . arm . " ")
    place(arm) = here(strcol("scene")) && before(arm) > 0 ? words(substr(" " . names . " ", 1, before(arm))) : NaN
    stats data using (here(strcol("scene")) && strcol("arm") eq "8-again" ? column("time_to_8_low") : NaN) name "LOW" nooutput
    stats data using (here(strcol("scene")) && strcol("arm") eq "8-again" ? column("time_to_8_high") : NaN) name "HIGH" nooutput
    if (!exists("LOW_min")) { exit status 3 }
    set xrange [-0.6:5.6]
    set xtics ("8 again" 0, "4" 1, "10" 2, "16" 3, "half" 4, "float" 5)
    set object 1 rectangle from graph 0, first LOW_min to graph 1, first HIGH_max fillcolor rgb "#e3e6e9" fillstyle solid noborder behind
    plot data using (place(strcol("arm"))):"time_to_8":"time_to_8_low":"time_to_8_high" \
            with yerrorbars linetype 1 pointsize 1.1 linewidth 1.4 title "95 % interval, paired by round", \
        1 with lines linestyle 90 title "8 bits"
}
