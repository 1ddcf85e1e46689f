# Figures of the study `interpolation`, from interpolation.tsv, interpolation_time.tsv and interpolation_raw.tsv (the lines).
#
#   gnuplot -c plots/interpolation.gp plots/style.gp FOLDER OUTPUT FIGURE
#
# FOLDER holds the tables, OUTPUT ends in .svg or .png, FIGURE is sphere, teapot, bands, teapot-bands or time.
folder = ARG2
output = ARG3
figure = ARG4
load ARG1
step = 1.0 / 255.0
modes = "constant gouraud phong"
names = "constant Gouraud Phong"

if (figure eq "sphere" || figure eq "teapot") {
    data = folder . "/interpolation.tsv"
    here(light, mode) = strcol("object") eq figure && strcol("light") eq light && strcol("interpolation") eq mode
    stats data using (here("eye", "phong") ? column("rmse") : NaN) name "LOW" nooutput
    if (!exists("LOW_min")) { exit status 3 }
    stats data using (strcol("object") eq figure ? column("rmse") : NaN) name "RMSE" nooutput
    stats data using (strcol("object") eq figure ? column("triangles") : NaN) name "N" nooutput
    set title "Error against the number of triangles: " . figure
    set logscale xy
    set xlabel "triangles"
    set ylabel "RMSE of radiance (full scale 1)"
    set format x "10^{%L}"
    set format y "10^{%L}"
    set xrange [N_min / 1.5:N_max * 1.5]
    set yrange [10 ** floor(log10(RMSE_min)):10 ** ceil(log10(RMSE_max))]
    set bmargin 11.5
    # Edges are as the root of the number of triangles: guides through the middle of the frame's left side.
    guide = 0.4 * RMSE_max
    plot for [i = 1:3] data using (here("eye", word(modes, i)) ? column("triangles") : NaN):"rmse" \
            with linespoints linetype i pointtype 2 * i + 3 pointsize 0.9 title word(names, i) . ", lit from the eye", \
        for [i = 1:3] data using (here("side", word(modes, i)) ? column("triangles") : NaN):"rmse" \
            with points linetype i pointtype 2 * i + 2 pointsize 1.1 title word(names, i) . ", from the side", \
        step with lines linestyle 90 title "1/255", \
        guide * (N_min / x) ** 0.5 with lines linestyle 90 dashtype 3 title "slope of h", \
        guide * (N_min / x) with lines linestyle 90 dashtype 4 title "slope of h²"
}

if (figure eq "bands" || figure eq "teapot-bands") {
    raw = folder . "/interpolation_raw.tsv"
    object = figure eq "bands" ? "sphere" : "teapot"
    line(series, surface, mode) = strcol("study") eq "interpolation" && strcol("series") eq series \
        && strstrt(strcol("parameters"), "series=bands object=" . object . " ") > 0 \
        && strstrt(strcol("parameters"), "surface=" . surface . " ") > 0 \
        && strstrt(strcol("parameters"), "interpolation=" . mode . " ") > 0
    stats raw using (line("bend", "mesh", "gouraud") ? column("value") : NaN) name "BEND" nooutput
    if (!exists("BEND_max")) { exit status 3 }
    stats raw using (line("bend", "mesh", "gouraud") ? column("index") : NaN) name "INDEX" nooutput
    # What is shown: the part in which changes of slope were looked for.
    first = INDEX_max
    last = 0.0
    extent(x) = (first = x < first ? x : first, last = x > last ? x : last, x)
    stats raw using (line("bend", "mesh", "constant") && abs(column("value")) > 1e-9 ? extent(column("index")) : NaN) nooutput
    stats raw using (line("bend", "exact", "phong") && abs(column("value")) > 0 ? extent(column("index")) : NaN) nooutput
    most = BEND_max > -BEND_min ? BEND_max : -BEND_min
    set multiplot
    set xrange [first / (INDEX_max + 1):last / (INDEX_max + 1)]
    at(x) = x / (INDEX_max + 1)
    set key off
    set lmargin at screen 0.12
    set rmargin at screen 0.97
    set tmargin at screen 0.91
    set bmargin at screen 0.6
    set title "Mach bands: " . object
    set ylabel "radiance"
    set format x ""
    plot for [i = 1:3] raw using (line("radiance", "mesh", word(modes, i)) ? at(column("index")) : NaN):"value" \
            with lines linetype i linewidth 1.2 notitle, \
        raw using (line("radiance", "exact", "phong") ? at(column("index")) : NaN):"value" with lines linetype 4 linewidth 1.2 notitle
    unset title
    set key at screen 0.5, 0.02 bottom center horizontal maxcols 2
    set tmargin at screen 0.56
    set bmargin at screen 0.24
    set format x "%g"
    set xlabel "along the line, its length being 1"
    set ylabel "change of slope"
    set yrange [-1.15 * most:1.15 * most]
    plot for [i = 1:3] raw using (line("bend", "mesh", word(modes, i)) ? at(column("index")) : NaN):"value" \
            with lines linetype i linewidth 1.2 title word(names, i), \
        raw using (line("bend", "exact", "phong") ? at(column("index")) : NaN):"value" with lines linetype 4 linewidth 1.2 title "the surface itself"
    unset multiplot
}

if (figure eq "time") {
    data = folder . "/interpolation_time.tsv"
    here(object, mode) = strcol("object") eq object && strcol("arm") eq "frame" && strcol("interpolation") eq mode
    stats data using (strcol("arm") eq "frame" ? column("frame_ms") : NaN) name "MS" nooutput
    if (!exists("MS_max")) { exit status 3 }
    stats data using (strcol("arm") eq "frame" ? column("triangles") : NaN) name "N" nooutput
    stats data using (strcol("arm") eq "frame" ? column("width_px") : NaN) name "WIDTH" nooutput
    stats data using (strcol("arm") eq "frame" ? column("height_px") : NaN) name "HEIGHT" nooutput
    set title sprintf("Time of a frame of %g × %g pixels", WIDTH_max, HEIGHT_max)
    set logscale xy
    set xlabel "triangles"
    set ylabel "median frame time in ms"
    # Few counts may have been timed, with no power of ten among them.
    set format "%g"
    set xtics (100, 200, 500, 1000, 2000, 5000, 10000, 20000, 50000, 100000, 200000, 500000, 1000000)
    set ytics (0.01, 0.02, 0.05, 0.1, 0.2, 0.5, 1, 2, 5, 10, 20, 50, 100, 200, 500, 1000)
    set xrange [N_min / 2:N_max * 2]
    set yrange [MS_min / 2:MS_max * 2]
    set bmargin 10.5
    plot for [i = 1:3] data using (here("sphere", word(modes, i)) ? column("triangles") : NaN):"frame_ms":"frame_ms_low":"frame_ms_high" \
            with yerrorlines linetype i pointtype 2 * i + 3 pointsize 0.9 title word(names, i) . ", sphere", \
        for [i = 1:3] data using (here("teapot", word(modes, i)) ? column("triangles") : NaN):"frame_ms":"frame_ms_low":"frame_ms_high" \
            with yerrorbars linetype i dashtype 1 pointtype 2 * i + 2 pointsize 1.1 title word(names, i) . ", teapot"
}
