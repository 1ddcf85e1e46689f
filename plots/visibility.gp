# Figures of the study `visibility`, from visibility_depth.tsv, visibility_culling.tsv and visibility_raw.tsv (the map).
#
#   gnuplot -c plots/visibility.gp plots/style.gp FOLDER OUTPUT FIGURE SCENE
#
# FOLDER holds the tables, OUTPUT ends in .svg or .png, FIGURE is wrong, worst, map or culling.
folder = ARG2
output = ARG3
figure = ARG4
scene = ARG5
load ARG1

# The depth buffers: bits, reversed, name.
n_buffers = 4
bits = "16 24 32 32"
reversed = "off off off on"
array name[4] = ["16 bits", "24 bits", "32 bits (float)", "32 bits reversed"]
is_buffer(i) = strcol("scene") eq scene && column("depth_bits") == word(bits, i) && strcol("reversed_depth") eq word(reversed, i)
# Side by side, so that marks at one place can be told apart.
beside(i) = 1.12 ** (i - 2.5)

if (figure eq "wrong" || figure eq "worst") {
    data = folder . "/visibility_depth.tsv"
    stats data using (strcol("scene") eq scene ? column("ratio") : NaN) name "R" nooutput
    if (!exists("R_max")) { exit status 3 }
    set logscale x
    set format x "10^{%L}"
    set xlabel "distance of the far plane over that of the near one"
    set xrange [R_min / 2:R_max * 2]
}

if (figure eq "wrong") {
    lowest = 1e-4
    positive(x) = x > lowest ? x : lowest
    set title "Pixels that show the wrong surface: " . scene
    set ylabel "share of the pixels"
    set logscale y
    set format y "10^{%L}"
    set yrange [lowest / 1.5:1.5]
    plot for [i = 1:n_buffers] data using (is_buffer(i) ? column("ratio") * beside(i) : NaN):(positive(column("wrong"))):(positive(column("wrong_low"))):(positive(column("wrong_high"))) \
            with yerrorbars linetype i dashtype 1 pointsize 1 title name[i], \
        for [i = 1:n_buffers] data using (is_buffer(i) && column("ideal") > 0 ? column("ratio") * beside(i) : NaN):(positive(column("ideal"))) \
            with lines linetype i title i == n_buffers ? "lines: ideal" : "", \
        0.001 with lines linestyle 90 title "1 pixel in 1000"
}

if (figure eq "worst") {
    stats data using (strcol("scene") eq scene && column("worst") > 0 ? column("worst") : NaN) name "W" nooutput
    if (!exists("W_max")) { exit status 3 }
    set title "The farthest surface that shows through a nearer one: " . scene
    set ylabel "steps of the depth buffer behind the right one"
    set yrange [0:(W_max > 1.2 ? 1.1 * W_max : 1.3)]
    plot for [i = 1:n_buffers] data using (is_buffer(i) && column("worst") > 0 ? column("ratio") * beside(i) : NaN):"worst" \
            with points linetype i pointsize 1.2 title name[i], \
        1 with lines linestyle 90 title "one step"
}

if (figure eq "map") {
    raw = folder . "/visibility_raw.tsv"
    of_map(any) = strcol("study") eq "visibility" && strcol("scene") eq scene && strcol("series") eq "map" && strstrt(strcol("parameters"), "depth_bits=16") > 0
    # Its first value is the picture's width. Of several ratios the first in the table.
    chosen = ""
    of_chosen(any) = of_map(0) && (chosen eq "" ? (chosen = strcol("parameters"), 1) : strcol("parameters") eq chosen)
    width = 0
    stats raw using (of_chosen(0) ? (column("index") == 0 ? (width = int(column("value"))) : 0, column("index")) : NaN) name "I" nooutput
    if (!exists("I_max") || width == 0) { exit status 3 }
    height = int(I_max) / width
    set title "Pixels that show the wrong surface, 16 bits: " . scene
    set xrange [-0.5:width - 0.5]
    set yrange [height - 0.5:-0.5]
    set size ratio -1
    unset xtics
    unset ytics
    unset grid
    unset colorbox
    set border 15
    set palette maxcolors 4
    set palette defined (0 "#ffffff", 1 "#9ecae1", 2 "#a63603", 3 "#bdbdbd")
    set cbrange [-0.5:3.5]
    plot raw using (of_chosen(0) && column("index") > 0 ? (int(column("index")) - 1) % width : NaN):((int(column("index")) - 1) / width):"value" with image notitle, \
        NaN with boxes fillstyle solid 1 border linecolor rgb "#9ecae1" title "right", \
        NaN with boxes fillstyle solid 1 border linecolor rgb "#a63603" title "wrong", \
        NaN with boxes fillstyle solid 1 border linecolor rgb "#bdbdbd" title "not judged"
}

if (figure eq "culling") {
    data = folder . "/visibility_culling.tsv"
    timed(m, a) = strcol("scene") eq scene && strcol("method") eq m && strcol("arm") eq a && column("time_to_on") > 0
    stats data using (timed("none", "off") ? column("time_to_on_high") : NaN) name "T" nooutput
    if (!exists("T_max")) { exit status 3 }
    stats data using (timed("random", "off") ? column("time_to_on_high") : NaN) name "U" nooutput
    top = exists("U_max") && U_max > T_max ? U_max : T_max
    set title "Frame time over that with back faces culled: " . scene
    set ylabel "times"
    set xrange [0.5:2.5]
    set yrange [0:(top > 1.2 ? 1.15 * top : 1.4)]
    set xtics ("surfaces alone" 1, "4 random normals" 2)
    methods = "none random"
    plot for [k = 1:2] data using (timed(word(methods, k), "off") ? k - 0.08 : NaN):"time_to_on":"time_to_on_low":"time_to_on_high" \
            with yerrorbars linetype 1 pointsize 1.4 title k == 1 ? "back faces drawn" : "", \
        for [k = 1:2] data using (timed(word(methods, k), "again") ? k + 0.08 : NaN):"time_to_on":"time_to_on_low":"time_to_on_high" \
            with yerrorbars linetype 2 dashtype 1 pointsize 1.4 title k == 1 ? "culled once more (A/A)" : "", \
        1 with lines linestyle 90 title "culled"
}
