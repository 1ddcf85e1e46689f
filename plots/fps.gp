# Figures of the study `fps`, from fps.tsv, fps_models.tsv and fps_raw.tsv.
#
#   gnuplot -c plots/fps.gp plots/style.gp FOLDER OUTPUT FIGURE SCENE
#
# FOLDER holds the tables, OUTPUT ends in .svg or .png, FIGURE is rate, frames, scaling,
# environment, objects, roughness, maps or exhaustive.
folder = ARG2
output = ARG3
figure = ARG4
scene = ARG5
load ARG1

if (figure eq "rate") {
    data = folder . "/fps.tsv"
    set title "Frames a second: " . scene
    set logscale y
    set ylabel "frames a second"
    set grid noxtics
    set ytics (1, 2, 5, 10, 20, 50, 100, 200, 500, 1000, 2000, 5000, 10000)
    stats data using (strcol("scene") eq scene && strcol("series") eq "table1" ? column("fps") : NaN) name "FPS" nooutput
    stats data using (strcol("scene") eq scene && strcol("series") eq "table1" ? column("fps_high") : NaN) name "HIGH" nooutput
    set yrange [(FPS_min < 20 ? FPS_min : 20) / 1.6:(HIGH_max > 530 ? HIGH_max : 530) * 2]
    set xrange [-0.6:5.6]
    set xtics ("no highlight" 0, "plain" 1, "regular 13" 2, "random 4" 3, "random 4\nagain" 4, "environment\npass" 5)
    place(arm) = arm eq "none" ? 0 : arm eq "plain" ? 1 : arm eq "regular-13" ? 2 : arm eq "random-4" ? 3 : arm eq "random-4-again" ? 4 : 5
    here(s) = s eq scene && strcol("series") eq "table1"
    set bmargin 9
    plot data using (here(strcol("scene")) ? place(strcol("arm")) - 0.08 : NaN):"fps":"fps_low":"fps_high" \
            with yerrorbars linetype 1 pointsize 1.1 linewidth 1.4 title "measured here, 95 % interval", \
        data using (here(strcol("scene")) && column("paper_fps") > 0 ? place(strcol("arm")) + 0.08 : NaN):"paper_fps" \
            with points linetype 2 pointsize 1.2 title "Kimura and Tokoi, Table 1 (GeForce FX 5200)", \
        data using (here(strcol("scene")) ? place(strcol("arm")) - 0.08 : NaN):"fps":(column("fps") < 100 ? sprintf("%.3g", column("fps")) : sprintf("%.0f", column("fps"))) \
            with labels offset -2.6, 0 font ",13" textcolor rgb "#0072b2" notitle, \
        data using (here(strcol("scene")) && column("paper_fps") > 0 ? place(strcol("arm")) + 0.08 : NaN):"paper_fps":(sprintf("%g", column("paper_fps"))) \
            with labels offset 2.4, 0 font ",13" textcolor rgb "#b34a00" notitle, \
        24 with lines linestyle 90 title "24 and 30 frames/s", 30 with lines linestyle 90 notitle
}

if (figure eq "frames") {
    data = folder . "/fps_raw.tsv"
    set title "Every frame in the order of rounds: " . scene
    set logscale y
    set xlabel "round"
    set ylabel "frame time in ms"
    arm(s, name) = strcol("study") eq "fps" && strcol("scene") eq scene && strstrt(s, "arm=" . name . " series=table1 ") == 1
    names = "none plain regular-13 random-4 random-4-again environment"
    plot for [i = 1:words(names)] data using (arm(strcol("parameters"), word(names, i)) ? column("index") : NaN):"value" \
        with points linetype i pointsize 0.6 title word(names, i)
}

# ---- What things cost: marks are cases, lines the models fitted to them ----------------------------------------------

rows = folder . "/fps.tsv"
models = folder . "/fps_models.tsv"
is(series, arm) = strcol("scene") eq scene && strcol("series") eq series && strcol("arm") eq arm
is_method(series, method) = strcol("scene") eq scene && strcol("series") eq series && strcol("method") eq method
is_model(name) = strcol("scene") eq scene && strcol("model") eq name

# A model that could not be fitted has no line: its coefficients stay NaN.
array A[2] = [NaN, NaN]
array B[2] = [NaN, NaN]
names = figure eq "scaling" ? "random regular" : figure eq "environment" ? "environment-pass" : \
        figure eq "objects" ? "objects-none objects-pass" : figure eq "roughness" ? "roughness-frame roughness-margin" : figure
slope = figure eq "scaling" ? "per_sample_ns" : figure eq "environment" ? "per_texel_ns" : \
        figure eq "exhaustive" ? "per_texel_normal_ns" : figure eq "objects" ? "per_object_us" : "per_roughness_us"
unit = slope[strlen(slope) - 1:] eq "ns" ? 1e-6 : 1e-3
if (figure ne "rate" && figure ne "frames") {
    do for [i = 1:words(names)] {
        stats models using (is_model(word(names, i)) ? column("constant_ms") : NaN) name "A" . i nooutput
        stats models using (is_model(word(names, i)) ? column(slope) : NaN) name "B" . i nooutput
        if (exists(sprintf("A%d_mean", i)) && exists(sprintf("B%d_mean", i))) {
            A[i] = value(sprintf("A%d_mean", i))
            B[i] = unit * value(sprintf("B%d_mean", i))
        }
    }
}
line(i, x) = A[i] + B[i] * x

if (figure eq "scaling") {
    set title "Time above the frame without highlight: " . scene
    set logscale xy
    set xlabel "pixels drawn x normals, in millions"
    set ylabel "ms above the frame without highlight"
    work(n) = 1e-6 * column("drawn_px") * column("samples")
    stats rows using (is_method("size", "random") || is_method("size", "regular") ? work(0) : NaN) name "X" nooutput
    if (!exists("X_max")) { exit status 3 }
    set xrange [X_min / 1.6:X_max * 1.6]
    above(metric) = (is_method("size", "random") || is_method("size", "regular")) && column(metric) > 0 ? column(metric) : NaN
    stats rows using (above("above_baseline_ms")) name "LOW" nooutput
    stats rows using (above("above_baseline_ms_high")) name "HIGH" nooutput
    if (!exists("LOW_min")) { exit status 3 }
    set yrange [edge_of(10 ** floor(log10(LOW_min)), 10 ** ceil(log10(HIGH_max))):10 ** ceil(log10(HIGH_max))]
    place(method, aside) = is_method("size", method) ? aside * work(0) : NaN
    plot rows using (place("random", 1 / 1.04)):(standing(column("above_baseline_ms"))):(ended(column("above_baseline_ms_low"))):(ended(column("above_baseline_ms_high"))) \
            with yerrorbars linetype 1 pointsize 1.1 title "random, 95 % interval", \
        rows using (place("random", 1 / 1.04)):(sunk(column("above_baseline_ms"))):(0):(fall(0)) with vectors arrowstyle 1 notitle, \
        line(1, 1e6 * x) with lines linetype 1 title "random, fitted", \
        rows using (place("regular", 1.04)):(standing(column("above_baseline_ms"))):(ended(column("above_baseline_ms_low"))):(ended(column("above_baseline_ms_high"))) \
            with yerrorbars linetype 2 pointsize 1.1 title "regular, 95 % interval", \
        rows using (place("regular", 1.04)):(sunk(column("above_baseline_ms"))):(0):(fall(0)) with vectors arrowstyle 2 notitle, \
        line(2, 1e6 * x) with lines linetype 2 title "regular, fitted"
}

if (figure eq "environment") {
    set title "The environment map's size: " . scene
    set logscale xy
    set xlabel "texels along an edge of a face"
    set ylabel "ms"
    stats rows using (is("environment", "environment") ? column("env_size_px") : NaN) name "X" nooutput
    if (!exists("X_max")) { exit status 3 }
    set xrange [X_min / 1.2:X_max * 1.2]
    set xtics (16, 32, 64, 128, 256, 512, 1024, 2048, 4096)
    plot rows using (is("environment", "random-4") ? column("env_size_px") : NaN):"frame_ms":"frame_ms_low":"frame_ms_high" \
            with yerrorbars linetype 1 pointsize 1.1 title "frame of random 4", \
        rows using (is("environment", "environment") ? column("env_size_px") : NaN):"frame_ms":"frame_ms_low":"frame_ms_high" \
            with yerrorbars linetype 2 pointsize 1.1 title "drawing the map", \
        line(1, 6 * x * x) with lines linetype 2 title "fitted: a + b x texels"
}

if (figure eq "objects") {
    set title "Objects, of as many pixels together: " . scene
    set xlabel "objects"
    set ylabel "ms"
    stats rows using (is("objects", "none") ? column("objects") : NaN) name "X" nooutput
    stats rows using (is("objects", "random-4") ? column("drawn_px") * column("samples") : NaN) name "W" nooutput
    stats models using (is_model("objects-frame") ? 1e-6 * column("per_sample_ns") : NaN) name "S" nooutput
    stats models using (is_model("objects-frame") ? 1e-3 * column("per_object_us") : NaN) name "O" nooutput
    if (!exists("X_max")) { exit status 3 }
    if (!exists("S_mean") || !exists("W_mean") || !exists("O_mean")) { S_mean = NaN; W_mean = NaN; O_mean = NaN }
    set bmargin 9
    set xrange [0:X_max + 1]
    set yrange [0:*]
    plot rows using (is("objects", "random-4") ? column("objects") + 0.06 : NaN):"above_baseline_ms":"above_baseline_ms_low":"above_baseline_ms_high" \
            with yerrorbars linetype 1 pointsize 1.1 title "random 4 adds", \
        S_mean * W_mean + O_mean * x with lines linetype 1 title "random 4, fitted", \
        rows using (is("objects", "none") ? column("objects") - 0.06 : NaN):"frame_ms":"frame_ms_low":"frame_ms_high" \
            with yerrorbars linetype 4 pointsize 1.1 title "frame without highlight", \
        line(1, x) with lines linetype 4 title "without highlight, fitted", \
        rows using (is("objects", "environment") ? column("objects") : NaN):"frame_ms":"frame_ms_low":"frame_ms_high" \
            with yerrorbars linetype 2 pointsize 1.1 title "drawing the environment maps", \
        line(2, x) with lines linetype 2 title "environment maps, fitted"
}

if (figure eq "roughness" || figure eq "maps") {
    stats rows using (strcol("scene") eq scene && strcol("series") eq figure ? column("roughnesses") : NaN) name "X" nooutput
    if (!exists("X_max")) { exit status 3 }
    set xlabel "roughnesses, as many normal maps"
    set xrange [0.5:X_max + 0.5]
    set yrange [0:*]
    set xtics 1
}

if (figure eq "roughness") {
    set title "What random 4 adds, by roughnesses among four objects: " . scene
    set ylabel "ms above the frame without highlight"
    plot rows using (is("roughness", "random-4") ? column("roughnesses") - 0.03 : NaN):"above_baseline_ms":"above_baseline_ms_low":"above_baseline_ms_high" \
            with yerrorbars linetype 1 pointsize 1.1 title "random 4", \
        line(1, x) with lines linetype 1 title "random 4, fitted", \
        rows using (is("roughness", "random-4-margin") ? column("roughnesses") + 0.03 : NaN):"above_baseline_ms":"above_baseline_ms_low":"above_baseline_ms_high" \
            with yerrorbars linetype 2 pointsize 1.1 title "with bounding spheres", \
        line(2, x) with lines linetype 2 title "with spheres, fitted"
}

if (figure eq "maps") {
    set title "Making the normal maps, once: " . scene
    set ylabel "ms"
    plot rows using (is("maps", "normal-maps") ? column("roughnesses") : NaN):"frame_ms":"frame_ms_low":"frame_ms_high" \
            with yerrorbars linetype 1 pointsize 1.1 title "baked and uploaded, 95 % interval", \
        line(1, x) with lines linetype 1 title "fitted"
}

if (figure eq "exhaustive") {
    set title "Every texel at every pixel, on the CPU: " . scene
    set xlabel "texel-normals, in millions"
    set ylabel "ms a frame"
    set logscale xy
    set ytics (1, 2, 5, 10, 20, 50, 100, 200, 500, 1000, 2000, 5000, 10000)
    set bmargin 9
    stats rows using (is("exhaustive", "exhaustive") ? 1e-6 * column("texel_normals") : NaN) name "X" nooutput
    stats rows using (is("exhaustive", "exhaustive") ? column("drawn_px") : NaN) name "P" nooutput
    stats rows using (is("exhaustive", "exhaustive") ? column("frame_ms") : NaN) name "Y" nooutput
    stats models using (is_model("exhaustive") ? 1e-6 * column("per_drawn_pixel_ns") : NaN) name "C" nooutput
    if (!exists("X_max")) { exit status 3 }
    if (!exists("C_mean")) { C_mean = NaN }
    of_size(pixels) = is("exhaustive", "exhaustive") && column("drawn_px") == pixels ? 1e-6 * column("texel_normals") : NaN
    set xrange [X_min / 1.6:X_max * 2]
    set yrange [(Y_min < 30 ? Y_min : 30) / 1.3:Y_max * 2]
    plot rows using (of_size(P_min)):"frame_ms":"frame_ms_low":"frame_ms_high" \
            with yerrorbars linetype 1 pointsize 1.1 title sprintf("%.0f pixels", P_min), \
        line(1, 1e6 * x) + C_mean * P_min with lines linetype 1 title sprintf("fitted, %.0f pixels", P_min), \
        rows using (of_size(P_max)):"frame_ms":"frame_ms_low":"frame_ms_high" \
            with yerrorbars linetype 2 pointsize 1.1 title sprintf("%.0f pixels", P_max), \
        rows using (is("exhaustive", "exhaustive") && column("drawn_px") > P_min && column("drawn_px") < P_max ? 1e-6 * column("texel_normals") : NaN):"frame_ms":"frame_ms_low":"frame_ms_high" \
            with yerrorbars linetype 3 pointsize 1.1 notitle, \
        line(1, 1e6 * x) + C_mean * P_max with lines linetype 2 title sprintf("fitted, %.0f pixels", P_max), \
        1000.0 / 24.0 with lines linestyle 90 title "1/24 s"
}
