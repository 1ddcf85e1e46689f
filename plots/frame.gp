# Figures of the study `frame`, from frame_lobe.tsv, frame_light.tsv, frame_scene.tsv and frame_raw.tsv (map and profiles).
#
#   gnuplot -c plots/frame.gp plots/style.gp FOLDER OUTPUT FIGURE SCENE
#
# FOLDER holds the tables, OUTPUT ends in .svg or .png, FIGURE is map, width or highlight, or of a scene, scene.
folder = ARG2
output = ARG3
figure = ARG4
scene = ARG5
load ARG1
raw = folder . "/frame_raw.tsv"
step = 1.0 / 255.0
of_frame(series) = strcol("study") eq "frame" && strcol("series") eq series

if (figure eq "map" || figure eq "width") {
    # The map is twice as wide as high; rows of latitude from -90 degrees up, columns of longitude from -180.
    stats raw using (of_frame("map") ? note_central(parameter("rr")) : NaN) nooutput
    on_map(any) = of_frame("map") && parameter("rr") == central
    stats raw using (on_map(0) ? column("index") : NaN) name "INDEX" nooutput
    if (!exists("INDEX_max")) { exit status 3 }
    columns = int(sqrt(2.0 * (INDEX_max + 1)) + 0.5)
    longitude(i) = 360.0 * ((int(i) % columns + 0.5) / columns - 0.5)
    latitude(i) = 360.0 * ((int(i) / columns + 0.5) / columns) - 90.0
    rad(x) = x * pi / 180.0
}

if (figure eq "map") {
    set title sprintf("Width of the lobe in the printed frame, R_r %g (1: as it should be)", central)
    set xlabel "longitude of N in degrees, 0 and ±180 being ±x"
    set ylabel "latitude of N in degrees"
    set xrange [-180:180]
    set yrange [-90:90]
    set xtics 45
    set ytics 30
    set cbrange [0:1]
    set cbtics 0.25
    # One hue from dark to light: reads the same in print.
    set palette defined (0 "#08306b", 0.5 "#4292c6", 1 "#f7fbff")
    set border 15
    set samples 2881
    # On the curve of width w of small angles |n_x| = sqrt(1 - w^2).
    # Beside its ends it is 0, so that the halves meet between two samples.
    cosine(x, w) = sqrt(1 - w * w) / abs(cos(rad(x)))
    curve(x, w) = cosine(x, w) <= 1 ? acos(cosine(x, w)) * 180.0 / pi : cosine(x, w) < 1.005 ? 0 : NaN
    set key maxcols 3
    plot raw using (on_map(0) ? longitude(column("index")) : NaN):(latitude(column("index"))):"value" with image notitle, \
        for [k = 1:3] curve(x, 1 - 0.25 * k) with lines linetype 2 dashtype k linewidth 1.4 title sprintf("width %g by the formula", 1 - 0.25 * k), \
        for [k = 1:3] -curve(x, 1 - 0.25 * k) with lines linetype 2 dashtype k linewidth 1.4 notitle
}

if (figure eq "width") {
    set title sprintf("Width of the lobe in the printed frame, R_r %g", central)
    set xlabel "|n_x|"
    set ylabel "median |delta|, printed over orthonormal"
    set xrange [0:1]
    set yrange [0:1.3]
    set samples 1001
    n_x(i) = abs(cos(rad(latitude(i))) * cos(rad(longitude(i))))
    plot raw using (on_map(0) ? n_x(column("index")) : NaN):"value" with points linetype 1 pointtype 7 pointsize 0.25 title "sampled normals", \
        sqrt(1 - x * x) with lines linetype 2 dashtype 1 linewidth 1.6 title "l = sqrt(n_y^2 + n_z^2)", \
        0.5 with lines linestyle 90 title "half the width"
}

if (figure eq "highlight") {
    stats raw using (of_frame("profile") ? note_central(parameter("rr")) : NaN) nooutput
    set title sprintf("A highlight of R_r %g in the printed frame, less the true one", central)
    set xlabel "|n_x|"
    set ylabel "difference of L_o (full scale 1)"
    set bmargin 10.5
    set xrange [0:1]
    places = "middle inside outside far"
    titles = "'mirror direction in the middle of the light' 'just inside its edge' 'just outside its edge' 'far outside'"
    chosen(place) = of_frame("profile") && strstrt(strcol("parameters"), "place=" . place . " ") > 0 && parameter("rr") == central
    # Pairs: |n_x|, then the difference there.
    before = NaN
    pair(place) = chosen(place) ? (int(column("index")) % 2 == 0 ? (before = column("value"), NaN) : before) : NaN
    stats raw using (chosen("middle") ? column("value") : NaN) name "PROFILE" nooutput
    if (!exists("PROFILE_max")) { exit status 3 }
    plot for [i = 1:words(places)] raw using (pair(word(places, i))):"value" with points linetype i pointtype 2 * i + 3 pointsize 0.5 title word(titles, i), \
        step with lines linestyle 90 title "±1/255", -step with lines linestyle 90 notitle
}

if (figure eq "scene") {
    data = folder . "/frame_scene.tsv"
    here(x) = strcol("scene") eq scene ? x : NaN
    set title "The whole picture in the printed frame: " . scene
    set logscale xy
    set xlabel "R_r"
    set ylabel "difference (full scale 1)"
    set bmargin 9.5
    set xrange [0.8:1300]
    set format y "10^{%L}"
    stats data using (here(column("max"))) name "MAX" nooutput
    if (!exists("MAX_max")) { exit status 3 }
    top = 10 ** ceil(log10(MAX_max > step ? MAX_max : step))
    set yrange [edge_of(1e-5, top):top]
    plot data using (here(column("rr"))):(above(column("rmse"))) with linespoints linetype 1 pointsize 1 title "RMSE", \
        data using (here(column("rr"))):(standing(column("rmse"))):(ended(column("rmse_low"))):(ended(column("rmse_high"))) \
            with yerrorbars linetype 1 dashtype 1 pointsize 1 notitle, \
        data using (here(column("rr"))):(sunk(column("rmse"))):(0):(fall(0)) with vectors arrowstyle 1 notitle, \
        data using (here(column("rr"))):(above(column("max"))) with linespoints linetype 2 pointsize 1 title "worst pixel", \
        data using (here(column("rr"))):(sunk(column("max"))) with points linetype 2 pointsize 1 notitle, \
        data using (here(column("rr"))):(sunk(column("max"))):(0):(fall(0)) with vectors arrowstyle 2 notitle, \
        data using (here(column("rr"))):(above(column("moved"))) with linespoints linetype 3 pointsize 1 title "share of pixels moved by more than 1/255", \
        data using (here(column("rr"))):(sunk(column("moved"))) with points linetype 3 pointsize 1 notitle, \
        data using (here(column("rr"))):(sunk(column("moved"))):(0):(fall(0)) with vectors arrowstyle 3 notitle, \
        step with lines linestyle 90 title "1/255"
}
