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
array buffer[4] = ["16 bits", "24 bits", "32 bits (float)", "32 bits reversed"]
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
    set title "Pixels that show the wrong surface: " . scene
    set ylabel "share of the pixels"
    set logscale y
    set format y "10^{%L}"
    top = 1.5
    set yrange [edge_of(1e-4, top):top]
    plot for [i = 1:n_buffers] data using (is_buffer(i) ? column("ratio") * beside(i) : NaN):(standing(column("wrong"))):(ended(column("wrong_low"))):(ended(column("wrong_high"))) \
            with yerrorbars linetype i dashtype 1 pointsize 1 title buffer[i], \
        for [i = 1:n_buffers] data using (is_buffer(i) ? column("ratio") * beside(i) : NaN):(sunk(column("wrong"))):(0):(fall(0)) with vectors arrowstyle i notitle, \
        for [i = 1:n_buffers] data using (is_buffer(i) && column("ideal") > 0 ? column("ratio") * beside(i) : NaN):(ended(column("ideal"))) \
            with lines linetype i notitle, \
        NaN with lines linetype 2 title "lines: ideal", \
        0.001 with lines linestyle 90 title "1 pixel in 1000"
}

if (figure eq "worst") {
    stats data using (strcol("scene") eq scene && column("worst") > 0 ? column("worst") : NaN) name "W" nooutput
    if (!exists("W_max")) { exit status 3 }
    set title "The farthest surface that shows through a nearer one: " . scene
    set ylabel "steps of the depth buffer behind the right one"
    set yrange [0:(W_max > 1.2 ? 1.1 * W_max : 1.3)]
    plot for [i = 1:n_buffers] data using (is_buffer(i) && column("worst") > 0 ? column("ratio") * beside(i) : NaN):"worst" \
            with points linetype i pointsize 1.2 title buffer[i], \
        1 with lines linestyle 90 title "one step"
}

if (figure eq "map") {
    raw = folder . "/visibility_raw.tsv"
    of_map(bits) = strcol("study") eq "visibility" && strcol("scene") eq scene && strcol("series") eq "map" && strstrt(strcol("parameters"), "depth_bits=" . bits . " ") > 0
    # Of several ratios the first in the table. A map's first value is the picture's width.
    ratio = NaN
    first_ratio(x) = ratio == ratio ? ratio == x : (ratio = x, 1)
    on_map(bits) = of_map(bits) && first_ratio(parameter("ratio"))
    # A map's first values are the picture's width and height; then 24 pixels are one value, each of them two bits.
    stats raw using (on_map("16") ? column("index") : NaN) name "I" nooutput
    if (!exists("I_max")) { exit status 3 }
    array packed[int(I_max) + 1]
    set print $map
    do for [k = 1:2] {
        stats raw using (on_map(word("16 24", k)) ? (packed[int(column("index")) + 1] = column("value"), 0) : NaN) nooutput
        width = int(packed[1])
        height = int(packed[2])
        do for [i = 0:width * height - 1] {
            print sprintf("%d\t%d\t%d\t%d", k, i % width, i / width, int(packed[3 + i / 24] / 4.0 ** (i % 24)) % 4)
        }
    }
    set print
    right = 1.04 * width
    set title sprintf("Pixels that show the wrong surface, far/near %g: %s", ratio, scene)
    set xrange [-0.5:right + width - 0.5]
    set yrange [height - 0.5:-0.5]
    set size ratio -1
    set format x ""
    unset ytics
    unset grid
    unset colorbox
    set border 0
    set xtics scale 0 ("16 bits" 0.5 * width, "24 bits" right + 0.5 * width)
    # As far apart in grey as in colour.
    set palette maxcolors 4
    set palette defined (0 "#ffffff", 1 "#c6dbef", 2 "#7f2704", 3 "#8a8a8a")
    set cbrange [-0.5:3.5]
    set key maxcols 3
    unset datafile columnheaders
    plot for [k = 1:2] $map using ($1 == k ? (k - 1) * right + $2 : NaN):3:4 with image notitle, \
        NaN with points pointtype 5 pointsize 2 linecolor rgb "#c6dbef" title "right", \
        NaN with points pointtype 5 pointsize 2 linecolor rgb "#7f2704" title "wrong", \
        NaN with points pointtype 5 pointsize 2 linecolor rgb "#8a8a8a" title "not judged"
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
