# Figures of the study `distribution`, from distribution.tsv, generators.tsv and distribution_raw.tsv (histograms and pictures).
#
#   gnuplot -c plots/distribution.gp plots/style.gp FOLDER OUTPUT FIGURE SCENE
#
# FOLDER holds the tables, OUTPUT ends in .svg or .png, FIGURE is fit, misfit, histogram, width, tilt, generators or pictures.
folder = ARG2
output = ARG3
figure = ARG4
load ARG1
data = folder . "/distribution.tsv"
raw = folder . "/distribution_raw.tsv"

# The size of which all R_r and formats were measured: the largest at the smallest R_r.
stats data using "rr" name "RR" nooutput
if (!exists("RR_min")) { exit status 3 }
stats data using (column("rr") == RR_min ? column("normal_size_px") : NaN) name "SIZE" nooutput
if (!exists("SIZE_max")) { exit status 3 }
formats = ""
note(s) = (strstrt(" " . formats, " " . s . " ") == 0 ? formats = formats . s . " " : formats, 1)
stats data using (column("normal_size_px") == SIZE_max ? note(strcol("normal_bits")) : NaN) nooutput
name(s) = s eq "half" || s eq "float" ? s : s . " bits"
at(format) = column("normal_size_px") == SIZE_max && strcol("normal_bits") eq format ? column("rr") : NaN
map = sprintf(", maps of %g × %g", SIZE_max, SIZE_max)

# More formats than the style has line types.
set linetype 8 linecolor rgb "#8b4513" dashtype 1 pointtype 8
set linetype 9 linecolor rgb "#6a3d9a" dashtype 1 pointtype 2
set linetype cycle 9
stored = "" # floats are turned by less than a frame shows
do for [i = 1:words(formats)] { if (word(formats, i) ne "float") { stored = stored . word(formats, i) . " " } }
# Bars side by side, else they cover each other.
aside(i, x) = x * 1.03 ** (i - 4.5)

set xlabel "R_r"
set bmargin 9.5
if (words(formats) > 5) {
    set key maxcols 5
}

if (figure eq "fit") {
    set title "Distance of the stored normals' cdf from D's" . map
    set logscale xy
    set xrange [0.8:1300]
    set yrange [1e-3:1]
    set ylabel "Kolmogorov distance in U"
    chance = sqrt(log(40.0) / 2.0) / SIZE_max
    plot for [i = 1:words(formats)] data using (at(word(formats, i))):"kolmogorov" \
            with linespoints linetype i pointsize 0.9 title name(word(formats, i)), \
        chance with lines linestyle 90 title "chance, 95 %"
}

if (figure eq "width") {
    set title "Width of the stored lobe" . map
    set logscale xy
    set xrange [0.8:1300]
    set ylabel "median |delta| over that of D"
    plot for [i = 1:words(formats)] data using (at(word(formats, i))):"width" \
            with linespoints linetype i pointsize 0.9 title name(word(formats, i)), \
        1 with lines linestyle 90 title "D itself"
}

if (figure eq "misfit") {
    set title "Misfit of 64 bins of delta or theta, the worse" . map
    set logscale xy
    set format y "10^{%L}"
    set xrange [0.8:1300]
    set yrange [edge_of(1e-3, 10):10]
    set ylabel "root mean square of observed/expected − 1"
    worse(end) = column("misfit_delta" . end) > column("misfit_theta" . end) ? column("misfit_delta" . end) : column("misfit_theta" . end)
    plot for [i = 1:words(formats)] data using (aside(i, at(word(formats, i)))):(standing(worse(""))):(ended(worse("_low"))):(ended(worse("_high"))) \
            with yerrorlines linetype i pointsize 0.9 title name(word(formats, i)), \
        for [i = 1:words(formats)] data using (aside(i, at(word(formats, i)))):(sunk(worse(""))):(0):(fall(0)) with vectors arrowstyle i notitle, \
        0.02 with lines linestyle 90 title "2 %"
}

if (figure eq "tilt") {
    # A panel for each format: their bars, which mostly end at 0, would cover each other in one.
    panels = words(stored)
    if (panels == 0) { exit status 3 }
    columns = panels > 6 ? 4 : panels > 4 ? 3 : panels > 2 ? 2 : panels
    rows = (panels + columns - 1) / columns
    set bmargin
    unset key
    set multiplot layout rows, columns title "How far storing turns the mean normal, in radians" . map margins 0.09, 0.97, 0.26, 0.87 spacing 0.025, 0.1
    set logscale xy
    set xrange [0.6:1700]
    set xtics (1, 10, 100, 1000)
    set yrange [edge_of(1e-9, 1e-2):1e-2]
    set ytics (1e-8, 1e-6, 1e-4, 1e-2)
    set tics font ",12"
    allowed(format) = format eq "8" ? 0.2 / 255.0 : format eq "half" ? 0.01 * column("d_median_rad") : NaN
    do for [p = 1:panels] {
        format = word(stored, p)
        set title name(format) offset 0, -0.6
        set format x (p + columns > panels ? "%g" : "")
        set format y ((p - 1) % columns == 0 ? "10^{%L}" : "")
        set xlabel (p + columns > panels ? "R_r" : "") offset 0, 0.6
        if (p == panels) { set key at screen 0.5, 0.015 bottom center vertical maxcols 1 }
        plot data using (at("float")):"mean_tilt_rad" with linespoints linestyle 90 pointtype 7 pointsize 0.2 title "chance of the numbers", \
            data using (at(format)):(allowed(format)) with linespoints linetype 2 pointtype 7 pointsize 0.2 title "at most, by the claims of 8 bits and half", \
            data using (at(format)):(standing(column("tilt_rad"))):(ended(column("tilt_rad_low"))):(ended(column("tilt_rad_high"))) \
                with yerrorbars linetype 1 pointsize 0.7 title "turned by storing, 95 % interval", \
            data using (at(format)):(sunk(column("tilt_rad"))):(0):(fall(0)) with vectors arrowstyle 1 notitle
    }
    unset multiplot
}

if (figure eq "histogram") {
    # Panels of the smallest, the central and the largest R_r share one key and are drawn from 64 points each.
    stats data using (column("normal_size_px") == SIZE_max ? note_central(column("rr")) : NaN) nooutput
    rr_list = sprintf("%g%s%s", RR_min, central > RR_min && central < RR_max ? sprintf(" %g", central) : "", RR_max > RR_min ? sprintf(" %g", RR_max) : "")
    panels = words(rr_list)
    chosen(r, format) = strcol("study") eq "distribution" && strcol("series") eq "delta_bins" \
        && strstrt(strcol("parameters"), sprintf("rr=%s normal_bits=%s normal_size=%g ", r, format, SIZE_max)) > 0
    set bmargin
    unset key
    set multiplot layout panels, 1 title "Observed over expected counts in 64 bins of equal probability" . map margins 0.1, 0.97, 0.17, 0.91 spacing 0.07
    set xrange [0:64]
    set xtics 8
    set grid noxtics
    chance = 1.96 * sqrt(64.0) / SIZE_max
    do for [p = 1:panels] {
        r = word(rr_list, p)
        set label 1 "R_r " . r at graph -0.075, 0.5 center rotate
        set xlabel (p == panels ? "bin along delta, from −90° to 90°" : "")
        if (p == panels) { set key at screen 0.5, 0.01 bottom center horizontal maxcols 3 }
        set yrange [*:*]
        stats raw using (chosen(r, "8") ? column("value") : NaN) name "RATIO" nooutput
        if (!exists("RATIO_max")) { exit status 3 }
        # Where all is near 1, closer to; and steps from bin to bin: histeps would fall to 0 behind the last.
        near = RATIO_min > 0.8 && RATIO_max < 1.2
        set yrange [(near ? 0.8 : 0):(near ? 1.2 : RATIO_max > 2 ? RATIO_max * 1.1 : 2)]
        if (near) { set ytics 0.1 } else { set ytics autofreq }
        last(r, format) = chosen(r, format) && column("index") == 63 ? 63 : NaN
        plot 1 + chance with lines linestyle 90 notitle, 1 - chance with lines linestyle 90 notitle, \
            raw using (chosen(r, "float") ? column("index") : NaN):"value" with steps linetype 1 linewidth 2 title "float", \
            raw using (last(r, "float")):"value":(1):(0) with vectors nohead linetype 1 linewidth 2 notitle, \
            raw using (chosen(r, "8") ? column("index") : NaN):"value" with steps linetype 2 dashtype 1 title "8 bits", \
            raw using (last(r, "8")):"value":(1):(0) with vectors nohead linetype 2 dashtype 1 notitle
    }
    unset multiplot
}

if (figure eq "generators") {
    data = folder . "/generators.tsv"
    set title "One point at a highlight's edge: bias and noise of N normals"
    set logscale xy
    set xlabel "N, microfacet normals a pixel"
    set ylabel "bias and noise (full scale 1)"
    stats data using "samples" name "N" nooutput
    set xrange [0.8:1.5 * N_max]
    set xtics (1, 4, 16, 64, 256)
    set mxtics 1
    set yrange [edge_of(1e-4, 1):1]
    set format y "10^{%L}"
    set key maxcols 3
    here(generator, bits) = strcol("generator") eq generator && strcol("normal_bits") eq bits ? column("samples") : NaN
    arms = "lcg:float baked:8 baked:float hash:float"
    titles = "'restarted generator' 'map, 8 bits' 'map, float' 'hash'"
    generator(i) = word(arms, i)[:strstrt(word(arms, i), ":") - 1]
    bits(i) = word(arms, i)[strstrt(word(arms, i), ":") + 1:]
    plot for [i = 1:4] data using (aside(2 * i, here(generator(i), bits(i)))):(standing(column("floor"))):(ended(column("floor_low"))):(ended(column("floor_high"))) \
            with yerrorbars linetype i dashtype 1 pointtype 2 * i + 3 pointsize 1.1 title "bias, " . word(titles, i), \
        for [i = 1:4] data using (aside(2 * i, here(generator(i), bits(i)))):(sunk(column("floor"))):(0):(fall(0)) with vectors arrowstyle i notitle, \
        for [i = 2:4] data using (aside(2 * i, here(generator(i), bits(i)))):(standing(column("noise"))) \
            with linespoints linetype i dashtype 2 pointtype 2 * i + 2 pointsize 1.1 title "noise, " . word(titles, i), \
        1.0 / 255.0 with lines linestyle 90 title "1/255"
}

if (figure eq "pictures") {
    chosen(g) = strcol("study") eq "distribution" && strcol("series") eq "picture" && strstrt(strcol("parameters"), "series=patch generator=" . g . " ") > 0
    stats raw using (chosen("reference") ? column("index") : NaN) name "INDEX" nooutput
    if (!exists("INDEX_max")) { exit status 3 }
    stats raw using (chosen("reference") ? parameter("rr") : NaN) name "R" nooutput
    stats raw using (chosen("baked") ? parameter("samples") : NaN) name "N" nooutput
    if (!exists("N_max")) { exit status 3 }
    width = int(sqrt(INDEX_max + 1))
    set bmargin
    unset key
    set multiplot layout 2, 2 title sprintf("A highlight on a plane, %g normals a pixel, R_r %g", N_max, R_max) margins 0.02, 0.86, 0.03, 0.86 spacing 0.04, 0.09
    unset tics
    unset grid
    unset xlabel
    set border 15
    set size ratio -1
    set palette gray
    set cbrange [0:1]
    set xrange [-0.5:width - 0.5]
    set yrange [-0.5:width - 0.5]
    generators = "reference lcg baked hash"
    titles = "'the reference' 'generator restarted at every pixel' 'numbers baked into a map' 'hash of each pixel'"
    do for [p = 1:4] {
        if (p == 2) { set colorbox user origin 0.9, 0.15 size 0.02, 0.6; set cbtics 0.25 } else { unset colorbox }
        set title word(titles, p)
        plot raw using (chosen(word(generators, p)) ? int(column("index")) % width : NaN):(int(column("index")) / width):"value" with image
    }
    unset multiplot
}
