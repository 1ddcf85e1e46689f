# Figures of the study `budget`, from budget.tsv.
#
#   gnuplot -c plots/budget.gp plots/style.gp FOLDER OUTPUT FIGURE SCENE
#
# FOLDER holds budget.tsv, OUTPUT ends in .svg or .png, FIGURE is sources or smoother.
folder = ARG2
output = ARG3
figure = ARG4
scene = ARG5
load ARG1
data = folder . "/budget.tsv"

names = "base bits format sphere map normals frame parallax sampling all"
place(arm) = arm eq "base" ? 0 : arm eq "bits" ? 1 : arm eq "format" ? 2 : arm eq "sphere" ? 3 : arm eq "map" ? 4 \
    : arm eq "normals" ? 5 : arm eq "frame" ? 6 : arm eq "parallax" ? 7 : arm eq "sampling" ? 8 : 10
step = 1.0 / 255.0
lowest = 1e-6
stats data using (strcol("scene") eq scene && column("rmse") > 0 ? column("rmse") : NaN) name "RMSE" nooutput
if (!exists("RMSE_max")) { exit status 3 }
stats data using (strcol("scene") eq scene ? note_central(column("rr")) : NaN) nooutput
rr = central

if (figure eq "sources") {
    set title sprintf("Where the error comes from: %s, R_r %g", scene, rr)
    set xlabel "RMSE of linear radiance (full scale 1)"
    set logscale x
    set format x "10^{%L}"
    set xrange [edge_of(lowest, 2 * RMSE_max):2 * RMSE_max]
    set yrange [-0.7:10.7]
    set lmargin 20
    set rmargin 10
    set grid noytics
    set ytics ("base" 0, "8-bit frame buffer" 1, "8-bit texels" 2, "sphere, auto" 3, "map of 256" 4, "8-bit normals" 5, \
        "frame as printed" 6, "parallax" 7, "4 normals" 8, "root of the sum" 9, "all together" 10)
    here(a) = strcol("scene") eq scene && column("rr") == rr ? place(a) : NaN
    # What the squares of the single errors add up to.
    total = 0.0
    note(x) = (total = total + x, x)
    stats data using (strcol("scene") eq scene && column("rr") == rr && strcol("arm") ne "base" && strcol("arm") ne "all" ? note(column("mse")) : NaN) nooutput
    set label 1 sprintf("%.2g", sqrt(total)) at sqrt(total) * 1.15, 9 left font ",12"
    set style fill solid 0.85
    set label 2 "1/255" at step, 10.6 center textcolor rgb "#6a7076" font ",12"
    set arrow 1 from step, -0.7 to step, 10.3 nohead linestyle 90
    set object 1 rectangle from lowest, 8.7 to sqrt(total), 9.3 fillcolor rgb "#9aa0a6" fillstyle solid 0.85 noborder
    plot data using (lowest):(here(strcol("arm"))):(lowest):(ended(column("rmse"))):(here(strcol("arm")) - 0.3):(here(strcol("arm")) + 0.3) \
            with boxxyerror linecolor rgb "#0072b2" title "RMSE alone", \
        data using (standing(column("rmse"))):(here(strcol("arm"))):(ended(column("rmse_low"))):(ended(column("rmse_high"))) \
            with xerrorbars linetype 2 dashtype 1 pointsize 0.4 title "95 % interval over seeds", \
        data using (sunk(column("rmse"))):(here(strcol("arm"))):(fall(0)):(0) with vectors arrowstyle 2 notitle, \
        data using (standing(column("rmse_high")) * 1.15):(here(strcol("arm"))):(sprintf(column("rmse") > lowest ? "%.2g" : "< 1e-6", column("rmse"))) \
            with labels left font ",12" notitle
}

if (figure eq "smoother") {
    stats data using (strcol("scene") eq scene ? column("rr") : NaN) name "RR" nooutput
    set title "Where the error comes from, over R_r: " . scene
    set xlabel "R_r (right: smoother)"
    set xtics (1, 3, 10, 30, 100, 300, 1000)
    set ylabel "RMSE of linear radiance (full scale 1)"
    set logscale xy
    set format y "10^{%L}"
    set key maxcols 4
    set yrange [edge_of(lowest, 2 * RMSE_max):2 * RMSE_max]
    set xrange [RR_min / 1.5:RR_max * 1.5]
    of(s, a, i) = s eq scene && a eq word(names, i) ? column("rr") : NaN
    plot for [i = 2:words(names)] data using (of(strcol("scene"), strcol("arm"), i)):(standing(column("rmse"))):(ended(column("rmse_low"))):(ended(column("rmse_high"))) \
            with yerrorlines linetype i - 1 pointtype i + 3 pointsize 0.9 title word(names, i), \
        for [i = 2:words(names)] data using (of(strcol("scene"), strcol("arm"), i)):(sunk(column("rmse"))):(0):(fall(0)) with vectors arrowstyle i - 1 notitle, \
        step with lines linestyle 90 title "1/255"
}
