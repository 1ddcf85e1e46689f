# What all figures share. Scripts set `output` to the file's name and load this file; its ending decides the terminal: .svg, .png, or
# .small.png for a thumbnail, which is too small for words: they shrink to dots, and the curves get the room.
#
# Colours: the podo sequence of Okabe and Ito without its yellow, which is lost on white paper. Dashes and points differ too, so
# that curves can be told apart in print and by readers who see colours differently.

if (strlen(output) > 4 && output[strlen(output) - 3:] eq ".svg") {
    set terminal svg size 900, 620 dynamic font "DejaVu Sans,15" background "#ffffff" linewidth 1.4
} else { if (strstrt(output, ".small.png") > 0) {
    set terminal pngcairo size 320, 220 font "DejaVu Sans,15" background "#ffffff" linewidth 2 fontscale 0.1 pointscale 0.8
} else {
    set terminal pngcairo size 1800, 1240 font "DejaVu Sans,15" background "#ffffff" linewidth 3 fontscale 1.8 pointscale 1.8
} }
set output output

set colorsequence podo
set linetype 1 linecolor rgb "#0072b2" dashtype 1 pointtype 7
set linetype 2 linecolor rgb "#d55e00" dashtype 2 pointtype 5
set linetype 3 linecolor rgb "#009e73" dashtype 4 pointtype 9
set linetype 4 linecolor rgb "#000000" dashtype 3 pointtype 13
set linetype 5 linecolor rgb "#cc79a7" dashtype 5 pointtype 11
set linetype 6 linecolor rgb "#e69f00" dashtype 6 pointtype 4
set linetype 7 linecolor rgb "#56b4e9" dashtype (12, 4) pointtype 6
set linetype cycle 7
set style line 90 linecolor rgb "#8a8f94" dashtype (8, 5) linewidth 1

set border 3 linecolor rgb "#57606a"
set tics nomirror
set grid linecolor rgb "#e3e6e9" linewidth 0.7, linecolor rgb "#f0f2f4" linewidth 0.5
set key at screen 0.5, 0.02 bottom center horizontal maxcols 2 samplen 3 spacing 1.15 width 1
set bmargin 8.2
if (strstrt(output, ".small.png") > 0) { set key at screen 0.5, -1 }
set datafile separator tab
set datafile columnheaders
set datafile missing NaN

# Zero and less have no place on a logarithmic axis. What is at or below its lower end is drawn one way in all figures: bars end at the
# frame, and marks stand just above it, with an arrow from the mark down to the frame. edge_of() is told the ends of the axis' range
# and gives the lower one. Plots draw the mark at standing(x), its bar's ends at ended(x), and then
# using ...:(sunk(x)):(0):(fall(0)) with vectors arrowstyle i, i being the line type; on an axis across (sunk(x)):...:(fall(0)):(0).
# Lines are drawn through above(x), which leaves such points out: how steeply a curve comes down to nothing was not measured.
edge_of(low, high) = (edge = low, foot = low * (high / low) ** 0.045, low)
standing(x) = x <= edge ? foot : x
ended(x) = x <= edge ? edge : x
above(x) = x <= edge ? 1 / 0 : x
sunk(x) = x <= edge ? foot : NaN
fall(any) = edge - foot
do for [i = 1:9] { set style arrow i head filled size screen 0.008, 25 linetype i dashtype 1 linewidth 1 }

# Where single figures are taken: at the R_r nearest to 30, in ratio, of those that `stats ... using (note_central(...))` is shown.
# Titles name it, since `study run --axis rr=...` may have measured any other.
central = NaN
central_off = 1e99
note_central(x) = (abs(log(x / 30.0)) < central_off ? (central_off = abs(log(x / 30.0)), central = x) : 0, x)
# The number after " NAME=" in a case's parameters; NaN if it has none.
parameter(name) = strstrt(strcol("parameters"), " " . name . "=") > 0 ? \
    real(strcol("parameters")[strstrt(strcol("parameters"), " " . name . "=") + strlen(name) + 2:]) : NaN
