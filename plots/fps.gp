# Figures of the study `fps`, from fps.tsv and frame_times.tsv.
#
#   gnuplot -c plots/fps.gp plots/style.gp FOLDER OUTPUT FIGURE SCENE
#
# FOLDER holds the tables, OUTPUT ends in .svg or .png, FIGURE is rate or frames.
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
    stats data using (strcol("scene") eq scene ? column("fps") : NaN) name "FPS" nooutput
    set yrange [(FPS_min < 20 ? FPS_min : 20) / 1.6:(FPS_max > 530 ? FPS_max : 530) * 2]
    set xrange [-0.6:5.6]
    set xtics ("no highlight" 0, "plain" 1, "regular 13" 2, "random 4" 3, "random 4\nagain" 4, "environment\npass" 5)
    place(arm) = arm eq "none" ? 0 : arm eq "plain" ? 1 : arm eq "regular-13" ? 2 : arm eq "random-4" ? 3 : arm eq "random-4-again" ? 4 : 5
    here(s) = s eq scene
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
    data = folder . "/frame_times.tsv"
    set title "Every frame in the order of rounds: " . scene
    set logscale y
    set xlabel "round"
    set ylabel "frame time in ms"
    arm(s, name) = strcol("study") eq "fps" && strcol("scene") eq scene && strstrt(s, "arm=" . name . " ") == 1
    names = "none plain regular-13 random-4 random-4-again environment"
    plot for [i = 1:words(names)] data using (arm(strcol("parameters"), word(names, i)) ? column("index") : NaN):"value" \
        with points linetype i pointsize 0.6 title word(names, i)
}
