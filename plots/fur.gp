# Figures of the study `fur`, from fur_profile.tsv, fur_vertex.tsv, fur_time.tsv and fur_raw.tsv (panels, profiles, forms).
#
#   gnuplot -c plots/fur.gp plots/style.gp FOLDER OUTPUT FIGURE SCENE
#
# FOLDER holds the tables, OUTPUT ends in .svg or .png, FIGURE is sheet, causes, kajiya, goldman, glow, vertex, time or time-many; of a scene
# sheet, error or time.
folder = ARG2
output = ARG3
figure = ARG4
scene = ARG5 eq "" ? "none" : ARG5
load ARG1
raw = folder . "/fur_raw.tsv"
step = 1.0 / 255.0
small = strstrt(output, ".small.png") > 0
of_raw(series) = strcol("series") eq series && strcol("scene") eq scene
# The word after " NAME=" in a case's parameters; every NAME asked for is followed by another.
word_of(name) = (at = strstrt(strcol("parameters"), " " . name . "="), at > 0 ? \
    (tail = strcol("parameters")[at + strlen(name) + 2:], end = strstrt(tail, " "), end > 0 ? tail[:end - 1] : tail) : "")
models = "kajiya-printed kajiya goldman-printed goldman lengyel"
title_of(effect) = effect eq "lambert" ? "Lambert" : effect eq "phong" ? "Phong, cos^4" : effect eq "lengyel" ? "Lengyel" \
    : effect eq "kajiya" ? "Kajiya" : effect eq "kajiya-printed" ? "Kajiya as printed" \
    : effect eq "goldman" ? "Goldman" : effect eq "goldman-printed" ? "Goldman as printed" : effect
degrees(x) = x * 180.0 / pi
radians(x) = x * pi / 180.0

# ---- Closed forms of the ball's radiance (studies/fur.h), N at angle n from the eye and the light at b, degrees ----
irradiance = 2.0
k_d = 0.1
k_s = 0.15
c = 0.5
psi(n, b) = acos(cos(radians(b - n)))
theta(n) = abs(radians(n))
listed_lobe(n, b, p) = abs(cos(psi(n, b) - theta(n))) ** p
right_cosine(n, b) = -cos(psi(n, b) + theta(n))
right_lobe(n, b, p) = right_cosine(n, b) > 0 ? right_cosine(n, b) ** p : 0
fur(n, b, lobe) = irradiance * (k_d * sin(psi(n, b)) + k_s * lobe)
facing(n, b) = 2 * cos(radians(b - n)) + 1
clamped(x) = x < 0 ? 0 : x > 1 ? 1 : x
f_dir(n, b) = 0.5 * (1 + c * sgn(sin(radians(b - n)) * sin(radians(-n))))
kajiya(n, b, p, listed) = fur(n, b, listed ? listed_lobe(n, b, p) : right_lobe(n, b, p))
goldman(n, b, p, listed) = f_dir(n, b) * (listed ? facing(n, b) : clamped(facing(n, b))) * kajiya(n, b, p, listed)

if (figure eq "sheet") {
    # Panels come one after another, each with its parameters in every row. Values hold a pixel of the panel's upper half and one of its
    # lower half: either half is a picture.
    panels = 0
    array titles[64]
    begin(any) = (panels = panels + 1, panel_width = int(parameter("width")), panel_height = int(parameter("height")), \
        titles[panels] = title_of(word_of("effect")) . (word_of("monochrome") eq "on" ? " in grey" : "") . (parameter("beta") > 90 ? "\nback-lit" : ""), 0)
    stats raw using (of_raw("pixels") && column("index") == 0 ? begin(0) : NaN) nooutput
    if (panels == 0) { exit status 3 }
    half = (panel_height + 1) / 2
    values = panel_width * half
    columns = 4
    gap = panel_width / 16
    label = panel_height * 3 / 10
    left(k) = (k % columns) * (panel_width + gap)
    top(k) = (k / columns) * (panel_height + label)
    # Channel by channel: a table keeps six digits.
    byte(n) = int(column("value") / 256.0 ** n) & 255
    set table $packed
    plot raw using (of_raw("pixels") ? column("index") : NaN):(byte(2)):(byte(1)):(byte(0)):(byte(5)):(byte(4)):(byte(3)) with table if (of_raw("pixels"))
    unset table
    set title "Models of fur in one light and one exposure" . (scene eq "none" ? "" : ": " . scene) offset 0, -0.6
    set lmargin 1
    set rmargin 1
    set bmargin 1
    set tmargin 2
    set xrange [-0.5:columns * (panel_width + gap) - gap - 0.5]
    set yrange [((panels - 1) / columns + 1) * (panel_height + label) - 0.5:-0.5]
    set size ratio -1
    unset border
    unset xtics
    unset ytics
    unset grid
    unset key
    do for [k = 0:panels - 1] {
        set label k + 1 titles[k + 1] at left(k) + panel_width / 2.0, top(k) + panel_height + 0.07 * panel_height center font ",13"
    }
    unset datafile columnheaders
    set datafile separator whitespace
    across(i) = int(i) % panel_width
    down(i) = int(i) / panel_width
    plot for [k = 0:panels - 1] $packed every ::k * values::(k + 1) * values - 1 \
            using (left(k) + across($1)):(top(k) + down($1)):2:3:4 with rgbimage notitle, \
        for [k = 0:panels - 1] $packed every ::k * values::(k + 1) * values - 1 \
            using (left(k) + across($1)):(top(k) + half + down($1)):5:6:7 with rgbimage notitle
}

if (figure eq "causes") {
    kinds = "'sines=minus sign=lost' 'sines=plus sign=lost' 'sines=minus sign=kept' 'sines=plus sign=kept'"
    names = "'as printed: both faults' 'sines right, sign lost' 'sines wrong, sign kept' 'corrected: neither'"
    here(b, kind) = of_raw("lobe") && parameter("beta") == b && strstrt(strcol("parameters"), kind) > 0
    stats raw using (here(0, "sines=minus sign=lost") ? column("value") : NaN) name "LOBE" nooutput
    if (!exists("LOBE_max")) { exit status 3 }
    set multiplot layout 1, 2 title "The highlight alone, without k_s"
    set xrange [-90:90]
    set yrange [-0.04:1.08]
    set xtics 45
    set xlabel "angle between fibre and eye in degrees"
    set bmargin 10.5
    set key maxcols 1 spacing 1.05
    do for [k = 1:2] {
        b = k == 1 ? 0 : 30
        set title k == 1 ? "lit from the eye" : "lit from 30 degrees above the eye"
        if (k == 2) { set key off }
        plot for [i = 1:4] raw using (here(b, word(kinds, i)) ? column("index") - 90 : NaN):"value" \
            with linespoints linetype i pointsize 0.6 pointinterval 15 linewidth 1.4 title word(names, i)
    }
    unset multiplot
}

if (figure eq "kajiya" || figure eq "goldman") {
    # Pairs: angle, then radiance there.
    before = NaN
    here(b, effect) = of_raw("profile") && parameter("beta") == b && word_of("effect") eq effect
    pair(b, effect) = here(b, effect) ? (int(column("index")) % 2 == 0 ? (before = column("value"), NaN) : before) : NaN
    effects = figure . "-printed " . figure
    angles = figure eq "kajiya" ? "0 30" : "0 150"
    p = NaN
    stats raw using (here(0, figure) ? (p = parameter("exponent"), column("value")) : NaN) name "P" nooutput
    if (!exists("P_max")) { exit status 3 }
    model(n, b, listed) = figure eq "kajiya" ? kajiya(n, b, p, listed) : goldman(n, b, p, listed)
    set multiplot layout 1, 2 title (figure eq "kajiya" ? "Kajiya's fur" : "Goldman's fur, c = 0.5") . " along the middle column of the ball"
    set xrange [-90:90]
    set xtics 45
    set samples 360
    set xlabel "angle between fibre and eye in degrees"
    set ylabel "radiance (full scale 1)"
    set yrange [figure eq "kajiya" ? 0 : -0.25:figure eq "kajiya" ? 0.6 : 1]
    set bmargin 9
    set key maxcols 2
    do for [k = 1:2] {
        b = real(word(angles, k))
        set title b == 0 ? "lit from the eye" : b < 90 ? "lit from 30 degrees above the eye" : "back-lit, from 150 degrees"
        if (k == 2) { set key off; unset ylabel }
        plot for [i = 1:2] raw using (pair(b, word(effects, i))):"value" with points linetype i pointtype i == 1 ? 7 : 4 pointsize 0.45 \
                title i == 1 ? "as printed" : "corrected", \
            for [i = 1:2] model(x, b, i == 1) with lines linetype i linewidth 1 title (i == 1 ? "as printed" : "corrected") . ", closed form"
    }
    unset multiplot
}

if (figure eq "glow") {
    data = folder . "/fur_profile.tsv"
    here(effect) = strcol("effect") eq effect
    p = NaN
    stats data using (here("kajiya") ? (p = column("exponent"), column("middle")) : NaN) name "M" nooutput
    if (!exists("M_max")) { exit status 3 }
    set title "Radiance in the middle of the ball"
    set xlabel "beta: angle between light and eye in degrees"
    set ylabel "radiance (full scale 1)"
    set xrange [-4:184]
    set xtics 30
    set yrange [0:0.55]
    set samples 361
    set bmargin 11.5
    inside(x) = x >= 0 && x <= 180 ? x : NaN
    shown = "kajiya-printed kajiya lengyel"
    shape = "7 4 9"
    plot for [i = 1:3] data using (here(word(shown, i)) && column("exponent") == p ? column("beta_degrees") : NaN):"middle":"middle_low":"middle_high" \
            with yerrorbars linetype i dashtype 1 pointtype int(word(shape, i)) pointsize 1 title title_of(word(shown, i)), \
        kajiya(0, inside(x), p, 1) with lines linetype 1 title "E (k_d sin β + k_s |cos β|^p)", \
        kajiya(0, inside(x), p, 0) with lines linetype 2 title "E (k_d sin β + k_s max(0, −cos β)^p)", \
        fur(0, inside(x), (0.5 * sin(radians(x))) ** p) with lines linetype 3 title "E (k_d sin β + k_s (½ sin β)^p)"
}

if (figure eq "vertex") {
    data = folder . "/fur_vertex.tsv"
    here(effect) = strcol("scene") eq "none" && strcol("effect") eq effect
    stats data using (strcol("scene") eq "none" && column("rmse") > 0 ? column("rmse") : NaN) name "E" nooutput
    stats data using (strcol("scene") eq "none" ? column("triangles") : NaN) name "N" nooutput
    if (!exists("E_max")) { exit status 3 }
    set title "Fur at the vertices against fur at each pixel"
    set logscale xy
    set format x "10^{%L}"
    set format y "10^{%L}"
    set xlabel "triangles"
    set ylabel "RMSE of radiance (full scale 1)"
    set xrange [N_min / 1.5:N_max * 1.5]
    set yrange [10 ** floor(log10(E_min)):10 ** ceil(log10(E_max))]
    set bmargin 11.5
    guide = E_max
    plot for [i = 1:5] data using (here(word(models, i)) ? column("triangles") : NaN):"rmse" with linespoints linetype i pointsize 0.9 title title_of(word(models, i)), \
        step with lines linestyle 90 title "1/255", \
        guide * (N_min / x) ** 0.5 with lines linestyle 90 dashtype 3 title "slope of h", \
        guide * (N_min / x) with lines linestyle 90 dashtype 4 title "slope of h²"
}

if (figure eq "error") {
    data = folder . "/fur_vertex.tsv"
    stats data using (strcol("scene") eq scene ? column("max") : NaN) name "E" nooutput
    if (!exists("E_max")) { exit status 3 }
    stats data using (strcol("scene") eq scene && column("rmse") > 0 ? column("rmse") : NaN) name "R" nooutput
    top = 10 ** ceil(log10(E_max > step ? E_max : step))
    low = edge_of(10 ** floor(log10(exists("R_min") && R_min < step ? R_min : step)), top)
    set title "Fur at the vertices against fur at each pixel: " . scene
    set logscale y
    set format y "10^{%L}"
    set yrange [low:top]
    set ylabel "difference of radiance (full scale 1)"
    set xrange [0.5:5.5]
    set xtics ()
    do for [i = 1:5] { set xtics add (title_of(word(models, i)) i) }
    set xtics font ",12"
    if (small) { set xtics font ",1" }
    at(i) = strcol("scene") eq scene && strcol("effect") eq word(models, i) ? i : NaN
    plot for [i = 1:5] data using (at(i)):(standing(column("rmse"))) with points linetype 1 pointsize 1.4 title i == 1 ? "RMSE" : "", \
        for [i = 1:5] data using (at(i)):(sunk(column("rmse"))):(0):(fall(0)) with vectors arrowstyle 1 notitle, \
        for [i = 1:5] data using (at(i)):(standing(column("max"))) with points linetype 2 pointsize 1.4 title i == 1 ? "worst pixel" : "", \
        step with lines linestyle 90 title "1/255"
}

if (figure eq "time" || figure eq "time-many") {
    data = folder . "/fur_time.tsv"
    all = "lambert phong " . models
    # Of the meshes one, as large a picture as there is.
    of_scene(x) = strcol("scene") eq scene ? x : NaN
    stats data using (of_scene(column("triangles"))) name "N" nooutput
    if (!exists("N_min")) { exit status 3 }
    stats data using (of_scene(column("width_px"))) name "WIDTH" nooutput
    triangles = figure eq "time" ? N_min : N_max
    here(x) = strcol("scene") eq scene && column("triangles") == triangles && column("width_px") == WIDTH_max ? x : NaN
    arm(effect, mode) = strcol("effect") eq effect && strcol("interpolation") eq mode && strcol("arm") eq "frame" && strcol("monochrome") eq "off"
    floor_of(again) = strcol("arm") eq "again" ? column("frame_ms") * (column("time_to_pixel_high") - 1 > 1 - column("time_to_pixel_low") ? column("time_to_pixel_high") - 1 : 1 - column("time_to_pixel_low")) : NaN
    stats data using (here(floor_of(0))) name "FLOOR" nooutput
    stats data using (here(column("above_baseline_ms_high"))) name "MS" nooutput
    stats data using (here(column("above_baseline_ms_low"))) name "LOW" nooutput
    stats data using (here(strcol("effect") eq "none" ? column("frame_ms") : NaN)) name "BARE" nooutput
    set title sprintf("Time above a frame in ambient light (%.2f ms): %s", BARE_mean, scene eq "none" ? "the ball" : scene)
    set xlabel sprintf("ms of a frame; %.0f triangles, %.0f pixels wide", triangles, WIDTH_max)
    set yrange [6.6:-0.6]
    set xrange [(LOW_min < -FLOOR_max ? LOW_min : -FLOOR_max) * 1.1:(MS_max > FLOOR_max ? MS_max : FLOOR_max) * 1.1]
    set grid noytics
    set ytics ()
    do for [i = 1:words(all)] { set ytics add (title_of(word(all, i)) i - 1) }
    set lmargin at screen small ? 0.04 : 0.22
    set bmargin 9.5
    set object 1 rectangle from -FLOOR_max, -0.6 to FLOOR_max, 6.6 fillcolor rgb "#d0d4d8" fillstyle solid 0.6 noborder behind
    set arrow 1 from 0, -0.6 to 0, 6.6 nohead linecolor rgb "#57606a" linewidth 0.7
    set style fill solid 0.85
    modes = "phong gouraud"
    set style line 11 linecolor rgb "#0072b2"
    set style line 12 linecolor rgb "#e69f00"
    off(m) = m == 1 ? -0.19 : 0.19
    row(i, m) = here(arm(word(all, i), word(modes, m)) ? i - 1 + off(m) : NaN)
    plot for [i = 1:7] data using (0):(row(i, 1)):(0):"above_baseline_ms":(row(i, 1) - 0.17):(row(i, 1) + 0.17) with boxxyerror linestyle 11 title i == 1 ? "at each pixel" : "", \
        for [i = 1:7] data using (0):(row(i, 2)):(0):"above_baseline_ms":(row(i, 2) - 0.17):(row(i, 2) + 0.17) with boxxyerror linestyle 12 fillstyle pattern 4 title i == 1 ? "at the vertices" : "", \
        for [i = 1:7] for [m = 1:2] data using "above_baseline_ms":(row(i, m)):"above_baseline_ms_low":"above_baseline_ms_high" \
            with xerrorbars linecolor rgb "#000000" dashtype 1 pointtype 7 pointsize 0.2 title i == 1 && m == 1 ? "95 % interval" : "", \
        NaN with lines linecolor rgb "#d0d4d8" linewidth 8 title "two arms of the same work differ by as much"
}
