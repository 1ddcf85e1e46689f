# Figures of the study `accuracy`, from accuracy_points.tsv, accuracy_images.tsv and accuracy_kernel.tsv.
#
#   gnuplot -c plots/accuracy.gp plots/style.gp FOLDER OUTPUT FIGURE SCENE
#
# FOLDER holds the tables, OUTPUT ends in .svg or .png, FIGURE is quad, star, bounded, kernel (SCENE is none) or seconds.
folder = ARG2
output = ARG3
figure = ARG4
scene = ARG5
load ARG1

if (figure eq "quad" || figure eq "star") {
    data = folder . "/accuracy_points.tsv"
    names = "reference cubature montecarlo vegas cubature-uv"
    title_of(name) = name eq "cubature-uv" ? "cubature over (U, V)" : name eq "cubature" ? "cubature over area" : name eq "vegas" ? "VEGAS (GSL)" : name
    row(name) = strcol("light") eq figure && strcol("integrator") eq name
    stats data using (strcol("light") eq figure ? column("time_us_high") : NaN) name "HIGH" nooutput
    stats data using (strcol("light") eq figure ? column("time_us_low") : NaN) name "LOW" nooutput
    if (!exists("HIGH_max")) { exit status 3 }
    set title "Error against time: one " . (figure eq "quad" ? "quad light" : "star of ten edges")
    set logscale xy
    set xlabel "time of a point in microseconds, one core"
    set ylabel "true error that 9 points in 10 stay below"
    set format xy "10^{%L}"
    set xrange [10 ** floor(log10(LOW_min)):10 ** ceil(log10(HIGH_max))]
    # Below the edge, double precision has nothing to say.
    set yrange [edge_of(1e-16, 3):3]
    set ytics 100
    if (figure eq "quad") {
        set arrow 1 from 20, edge to 20, 3 nohead linestyle 90
        set label 1 "20 us, the bar at a tolerance of 10^{-6}" at 22, 4e-15 left textcolor rgb "#6a7076" font ",12"
    }
    # Tolerances beside the marks, where those are apart.
    labelled(name) = row(name) && (name eq "cubature" && column("tolerance") < 5e-5 || name eq "montecarlo" && column("tolerance") < 0.02)
    took(name) = row(name) ? column("time_us") : NaN
    plot for [i = 1:words(names)] data using (took(word(names, i))):(standing(column("error_p90"))):"time_us_low":"time_us_high":(ended(column("true_error"))):(ended(column("error_max"))) \
            with xyerrorbars linetype i dashtype 1 linewidth 0.5 pointsize 0.01 notitle, \
        for [i = 1:words(names)] data using (took(word(names, i))):(sunk(column("error_p90"))):(0):(fall(0)) with vectors arrowstyle i notitle, \
        for [i = 1:words(names)] data using (took(word(names, i))):(above(column("error_p90"))) \
            with linespoints linetype i pointsize 1 title title_of(word(names, i)), \
        for [i = 1:words(names)] data using (took(word(names, i))):(sunk(column("error_p90"))) with points linetype i pointsize 1 notitle, \
        for [i = 1:words(names)] data using (labelled(word(names, i)) ? column("time_us") : NaN):(standing(column("error_p90"))):(sprintf("%g", column("tolerance"))) \
            with labels offset 0.8, 0.8 left font ",11" textcolor rgb "#57606a" notitle
}

if (figure eq "bounded") {
    data = folder . "/accuracy_points.tsv"
    stats data using "bounded" name "B" nooutput
    if (!exists("B_max")) { exit status 3 }
    set title "Does the stated error bound the true one?"
    set ylabel "share of points"
    set yrange [-0.05:1.08]
    set xrange [0.4:6.6]
    set grid noxtics
    set xtics ("reference,\nwithin tolerance" 1, "reference" 2, "cubature\nover area" 3, "Monte Carlo" 4, "VEGAS" 5, "cubature\nover (U, V)" 6)
    set bmargin 9.5
    names = "reference reference cubature montecarlo vegas cubature-uv"
    share(i) = i == 1 ? column("within") : column("bounded")
    # Within an integrator's place from left to right: tolerances from 1e-1 to 1e-12.
    at(i, light, aside) = strcol("integrator") eq word(names, i) && strcol("light") eq light ? i - 0.36 + 0.72 * (-log10(column("tolerance")) - 0.5) / 11.5 + aside : NaN
    # Of all cases of an integrator together, which the claims are about.
    do for [i = 1:6] {
        k = 0.0
        n = 0.0
        note(share, points) = (k = k + share * points, n = n + points, share)
        stats data using (strcol("integrator") eq word(names, i) ? note(share(i), column("points")) : NaN) nooutput
        if (n > 0) { set arrow i from i - 0.4, k / n to i + 0.4, k / n nohead linetype 4 dashtype 1 linewidth 1.6 }
    }
    set object 1 rectangle from 3.6, 0.97 to 5.4, 1.01 fillcolor rgb "#e3e6e9" fillstyle solid noborder behind
    set arrow 7 from 5.6, 0.9 to 6.4, 0.9 nohead linestyle 90
    set label 1 "9 in 10" at 6.42, 0.9 left textcolor rgb "#6a7076" font ",12"
    plot for [i = 1:6] data using (at(i, "quad", -0.01)):(share(i)) with points linetype 1 pointtype 7 pointsize 0.9 title (i == 1 ? "one quad, a mark a tolerance" : ""), \
        for [i = 1:6] data using (at(i, "star", 0.01)):(share(i)) with points linetype 2 pointtype 4 pointsize 1.3 title (i == 1 ? "a star, a mark a tolerance" : ""), \
        keyentry with lines linetype 4 dashtype 1 linewidth 1.6 title "all cases together", \
        keyentry with boxes fillcolor rgb "#e3e6e9" fillstyle solid title "99 % to within 2 %"
}

if (figure eq "kernel") {
    data = folder . "/accuracy_kernel.tsv"
    stats data using "texel_normals_low" name "RATE" nooutput
    if (!exists("RATE_max")) { exit status 3 }
    stats data using "texel_normals_high" name "HIGH" nooutput
    sets = "plain avx2 avx512"
    place(s) = s eq "plain" ? 1 : s eq "avx2" ? 2 : 3
    label(s) = s eq "plain" ? "plain C" : s eq "avx2" ? "AVX2" : "AVX-512"
    set title "Exhaustive's inner loop"
    set logscale y
    set format y "10^{%L}"
    set mytics 10
    set ylabel "texel-normals per second"
    set grid noxtics
    set xrange [0.5:3.5]
    set yrange [10 ** floor(log10(RATE_min)):2 * (HIGH_max > 1e9 ? HIGH_max : 1e9)]
    set xtics ("plain C" 1, "AVX2" 2, "AVX-512" 3)
    on(t) = column("threads") == t ? place(strcol("simd")) + (t - 1.5) * 0.12 : NaN
    plot for [t = 1:2] data using (on(t)):"texel_normals":"texel_normals_low":"texel_normals_high" \
            with yerrorbars linetype t dashtype 1 pointsize 1.2 linewidth 1.4 title (t == 1 ? "1 thread" : "2 threads"), \
        for [t = 1:2] data using (on(t)):"texel_normals":(sprintf("%.3g", column("texel_normals"))) \
            with labels offset (t == 1 ? -4.2 : 4.2), 0 font ",13" notitle, \
        1e9 with lines linestyle 90 title "10^9"
}

if (figure eq "seconds") {
    data = folder . "/accuracy_images.tsv"
    # Threads are compared on smaller images.
    here(t) = strcol("scene") eq scene && strcol("method") eq "reference" && column("threads") == t && column("width_px") == W_max ? column("tolerance") : NaN
    stats data using (strcol("scene") eq scene ? column("seconds_high") : NaN) name "S" nooutput
    if (!exists("S_max")) { exit status 3 }
    stats data using (strcol("scene") eq scene ? column("width_px") : NaN) name "W" nooutput
    stats data using (strcol("scene") eq scene ? column("height_px") : NaN) name "H" nooutput
    stats data using (strcol("scene") eq scene && strcol("method") eq "reference" ? column("threads") : NaN) name "T" nooutput
    bar = scene eq "sphere-quad" ? 2 : scene eq "teapot-star" ? 5 : NaN
    shown = W_max == 640 && H_max == 480 && bar > 0
    set title sprintf("Seconds an image: %s, %d x %d", scene, W_max, H_max)
    set logscale x
    set format x "10^{%L}"
    set xlabel "tolerance"
    set ylabel "seconds"
    set xrange [1e-2:1e-11] reverse
    set mxtics 1
    set yrange [0:1.2 * (shown && bar > S_max ? bar : S_max)]
    plot for [t = 1:T_max] data using (here(t)):"seconds":"seconds_low":"seconds_high" with yerrorbars linetype t dashtype 1 pointsize 0.01 notitle, \
        for [t = 1:T_max] data using (here(t)):"seconds" smooth unique with linespoints linetype t pointsize 1.2 title sprintf("%d thread%s", t, t > 1 ? "s" : ""), \
        (shown ? bar : NaN) with lines linestyle 90 title (shown ? sprintf("%g s, at 10^{-6} on two cores", bar) : "")
}
