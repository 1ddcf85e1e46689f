# Figures of the study `environment`, from environment.tsv.
#
#   gnuplot -c plots/environment.gp plots/style.gp FOLDER OUTPUT FIGURE SCENE
#
# FOLDER holds environment.tsv, OUTPUT ends in .svg or .png, FIGURE is size, format, parallax or seam.
folder = ARG2
output = ARG3
figure = ARG4
scene = ARG5
load ARG1
data = folder . "/environment.tsv"

stats data using (strcol("scene") eq scene && strcol("series") eq figure ? note_central(column("rr")) : NaN) nooutput
at = sprintf("%s, R_r %g", scene, central)
row(s) = strcol("scene") eq scene && strcol("series") eq s && column("rr") == central
step = 1.0 / 255.0

if (figure eq "size") {
    set bmargin 10.5
    set title "Error by the environment map's texels: " . at
    stats data using (row("size") ? column("env_size_px") : NaN) name "SIZE" nooutput
    stats data using (row("size") && column("rmse_map") > 0 ? column("rmse_map") : NaN) name "RMSE" nooutput
    if (!exists("RMSE_max")) { exit status 3 }
    set xlabel "texels along an edge of a face"
    set ylabel "error of linear radiance (full scale 1)"
    set logscale xy
    set format y "10^{%L}"
    set xtics (8, 16, 32, 64, 128, 256, 512, 1024, 2048)
    set xrange [SIZE_min / 1.3:SIZE_max * 1.3]
    set yrange [edge_of(1e-4, 3 * RMSE_max):3 * RMSE_max]
    set label 1 "1/255" at graph 0.01, first step * 1.15 left textcolor rgb "#6a7076" font ",12"
    sized(aside) = row("size") ? column("env_size_px") * aside : NaN
    plot data using (sized(1)):(above(column("rmse_map"))) with linespoints linetype 1 pointsize 0.9 title "against the largest map", \
        data using (sized(1)):(standing(column("rmse_map"))):(ended(column("rmse_map_low"))):(ended(column("rmse_map_high"))) \
            with yerrorbars linetype 1 dashtype 1 pointsize 0.9 notitle, \
        data using (sized(1 / 1.06)):(above(column("floor_map"))) with linespoints linetype 2 pointsize 0.9 title "noise taken out", \
        data using (sized(1 / 1.06)):(standing(column("floor_map"))):(ended(column("floor_map_low"))):(ended(column("floor_map_high"))) \
            with yerrorbars linetype 2 dashtype 1 pointsize 0.9 notitle, \
        data using (sized(1 / 1.06)):(sunk(column("floor_map"))):(0):(fall(0)) with vectors arrowstyle 2 notitle, \
        data using (sized(1.06)):(standing(column("floor_centre"))):(ended(column("floor_centre_low"))):(ended(column("floor_centre_high"))) \
            with yerrorbars linetype 3 pointsize 0.9 title "against the reference", \
        data using (sized(1.06)):(sunk(column("floor_centre"))):(0):(fall(0)) with vectors arrowstyle 3 notitle, \
        RMSE_max * SIZE_min / x with lines linestyle 90 dashtype 3 title "slope −1", \
        step with lines linestyle 90 notitle
}

if (figure eq "format") {
    stats data using (row("format") && column("base") == 0 ? column("env_size_px") : NaN) name "SIZE" nooutput
    if (!exists("SIZE_max")) { exit status 3 }
    set title sprintf("Error by the texels' format: %s, %g texels a face edge", at, SIZE_max)
    stats data using (row("format") && column("base") == 0 ? column("rmse_map") : NaN) name "RMSE" nooutput
    if (!exists("RMSE_max")) { exit status 3 }
    set yrange [-0.7:4.9]
    set lmargin 16
    set rmargin 6
    set grid noytics
    place(f) = f eq "rgba16f" ? 0 : f eq "rgba16" ? 1 : f eq "r11g11b10f" ? 2 : f eq "rgb10a2" ? 3 : 4
    set ytics ("rgba16f" 0, "rgba16" 1, "r11g11b10f" 2, "rgb10a2" 3, "rgba8" 4)
    set xlabel "RMSE of linear radiance against 32-bit floats (full scale 1)"
    here(f) = row("format") && column("base") == 0 ? place(f) : NaN
    if (RMSE_max == 0) {
        # No scale, where there is nothing to be read from it.
        unset grid
        set xtics ("0" 0)
        set xrange [-1:1]
        set label 2 "exact in every format: not one pixel changes" at 0, -0.35 center
        plot data using (0):(here(strcol("env_format"))) with points linetype 1 pointtype 7 pointsize 1.3 title "RMSE"
        exit
    }
    set logscale x
    set format x "10^{%L}"
    low = edge_of(1e-8, 1e-2)
    set xrange [low:1e-2]
    set label 2 "1/255" at step, 4.8 center textcolor rgb "#6a7076" font ",12"
    set arrow 1 from step, -0.7 to step, 4.6 nohead linestyle 90
    # Marks: on a logarithmic axis a bar would have no foot to stand on, and its length no meaning.
    plot data using (standing(column("rmse_map"))):(here(strcol("env_format"))):(ended(column("rmse_map_low"))):(ended(column("rmse_map_high"))) \
            with xerrorbars linetype 1 dashtype 1 pointsize 1.3 title "RMSE, 95 % interval over seeds", \
        data using (sunk(column("rmse_map"))):(here(strcol("env_format"))):(fall(0)):(0) with vectors arrowstyle 1 notitle, \
        data using (standing(column("rmse_map_high"))):(here(strcol("env_format"))):(column("rmse_map") > low ? sprintf("%.2g", column("rmse_map")) : column("rmse_map") > 0 ? "< 1e-8" : "0") \
            with labels left offset 1.3, 0 font ",12" notitle
}

if (figure eq "parallax") {
    set title "Error by the map's single position: " . at
    stats data using (row("parallax") ? column("size") : NaN) name "SIZE" nooutput
    stats data using (row("parallax") ? column("parallax") : NaN) name "P" nooutput
    if (!exists("P_max")) { exit status 3 }
    # Through the smallest object: in proportion, as a picture that is shifted by little changes.
    set xlabel "object's radius over the light's distance"
    set ylabel "RMSE of linear radiance (full scale 1)"
    set logscale xy
    set format y "10^{%L}"
    set xtics (0.005, 0.01, 0.02, 0.05, 0.1, 0.2, 0.5, 1)
    set xrange [SIZE_min / 1.4:SIZE_max * 1.4]
    set yrange [edge_of(P_min / 3, P_max * 3):P_max * 3]
    set label 1 "1/255" at graph 0.01, first step * 1.1 left textcolor rgb "#6a7076" font ",12"
    plot data using (row("parallax") ? column("size") : NaN):(standing(column("parallax"))):(ended(column("parallax_low"))):(ended(column("parallax_high"))) \
            with yerrorlines linetype 1 pointsize 1 title "reference from the centre against from each point", \
        P_min * x / SIZE_min with lines linestyle 90 dashtype 3 title "slope 1", \
        step with lines linestyle 90 notitle
}

if (figure eq "seam") {
    set title "A light in a face's middle, across an edge, across a corner: " . at
    stats data using (row("seam") && column("base") == 0 ? column("rmse_map") : NaN) name "RMSE" nooutput
    stats data using (row("seam") && column("base") == 0 ? column("env_size_px") : NaN) name "SIZE" nooutput
    if (!exists("RMSE_max")) { exit status 3 }
    set ylabel "error of linear radiance (full scale 1)"
    set xrange [-0.5:2.5]
    set yrange [0:1.2 * RMSE_max]
    set xtics ("middle of a face" 0, "edge" 1, "corner" 2)
    set grid noxtics
    place(p) = p eq "middle" ? 0 : p eq "edge" ? 1 : 2
    here(p, size, shift) = row("seam") && column("base") == 0 && column("env_size_px") == size ? place(p) + shift : NaN
    plot data using (here(strcol("place"), SIZE_min, -0.12)):"rmse_map":"rmse_map_low":"rmse_map_high" \
            with yerrorbars linetype 1 pointsize 1 title sprintf("%g texels: RMSE", SIZE_min), \
        data using (here(strcol("place"), SIZE_min, -0.04)):"floor_map":"floor_map_low":"floor_map_high" \
            with yerrorbars linetype 2 pointsize 1 title sprintf("%g texels: noise taken out", SIZE_min), \
        data using (here(strcol("place"), SIZE_max, 0.04)):(SIZE_max > SIZE_min ? column("rmse_map") : NaN):"rmse_map_low":"rmse_map_high" \
            with yerrorbars linetype 3 pointsize 1 title sprintf("%g texels: RMSE", SIZE_max), \
        data using (here(strcol("place"), SIZE_max, 0.12)):(SIZE_max > SIZE_min ? column("floor_map") : NaN):"floor_map_low":"floor_map_high" \
            with yerrorbars linetype 4 pointsize 1 title sprintf("%g texels: noise taken out", SIZE_max)
}
