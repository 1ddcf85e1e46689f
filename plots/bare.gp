# Figures of the study `bare`, from bare.tsv.
#
#   gnuplot -c plots/bare.gp plots/style.gp FOLDER OUTPUT FIGURE SCENE
#
# FOLDER holds bare.tsv, OUTPUT ends in .svg or .png, FIGURE is ratio.
folder = ARG2
output = ARG3
figure = ARG4
scene = ARG5
load ARG1
data = folder . "/bare.tsv"

# The widest picture speaks.
stats data using (strcol("scene") eq scene ? column("width_px") : NaN) name "WIDTH" nooutput
if (!exists("WIDTH_max")) { exit status 3 }
here(x) = strcol("scene") eq scene && column("width_px") == WIDTH_max ? x : NaN
place(arm) = arm eq "plan" ? 0 : arm eq "uniforms" ? 1 : arm eq "again" ? 2 : 3
stats data using (here(strcol("arm") eq "plan" && column("time_to_literals") > column("time_to_uniforms") ? column("time_to_literals") : column("time_to_uniforms"))) name "T" nooutput
if (!exists("T_max")) { exit status 3 }

if (figure eq "ratio") {
    set title sprintf("Against a program in bare OpenGL: %s, %.0f pixels wide", scene, WIDTH_max)
    set xlabel "frame time over that of the bare program with uniforms (last: with literals)"
    set yrange [4.7:-0.7]
    set xrange [0:(T_max > 1.05 ? 1.2 * T_max : 1.3)]
    set ytics ("by its plan" 0, "bare, uniforms" 1, "uniforms again" 2, "bare, literals" 3, "plan over literals" 4)
    set grid noytics
    set lmargin 18
    set style fill solid 0.85
    set arrow 1 from 1.03, -0.7 to 1.03, 4.7 nohead linestyle 90
    set label 1 "1.03" at 1.04, -0.55 left textcolor rgb "#6a7076" font ",12"
    y(a) = here(place(a))
    baked(name) = strcol("arm") eq "plan" ? here(column(name)) : NaN
    plot data using (0):(y(strcol("arm"))):(0):(here(column("time_to_uniforms"))):(y(strcol("arm")) - 0.3):(y(strcol("arm")) + 0.3) \
            with boxxyerror linecolor rgb "#0072b2" title "median", \
        data using (here(column("time_to_uniforms"))):(y(strcol("arm"))):"time_to_uniforms_low":"time_to_uniforms_high" \
            with xerrorbars linetype 2 dashtype 1 pointsize 0.5 title "95 % interval", \
        data using (here(column("time_to_uniforms_low")) - 0.02):(y(strcol("arm"))):(sprintf("%.3f, %.2f ms", column("time_to_uniforms"), column("frame_ms"))) \
            with labels right textcolor rgb "#ffffff" notitle, \
        data using (0):(4 + baked("time_to_literals") * 0):(0):(baked("time_to_literals")):(3.7):(4.3) \
            with boxxyerror linecolor rgb "#0072b2" fill pattern 2 notitle, \
        data using (baked("time_to_literals")):(4 + baked("time_to_literals") * 0):(baked("time_to_literals_low")):(baked("time_to_literals_high")) \
            with xerrorbars linetype 2 dashtype 1 pointsize 0.5 notitle, \
        data using (baked("time_to_literals_high") + 0.02):(4 + baked("time_to_literals") * 0):(sprintf("%.3f", column("time_to_literals"))) \
            with labels left notitle
}
