# An error image: signed error of every pixel, blue below the reference, orange above, with its scale.
#
#   gnuplot -c plots/error.gp plots/style.gp MATRIX OUTPUT WIDTH HEIGHT SCALE
#
# MATRIX: WIDTH x HEIGHT floats of 32 bits in this machine's order, top row first. Colours end at +-SCALE.
matrix = ARG2
output = ARG3
width = int(ARG4)
height = int(ARG5)
scale = real(ARG6)
load ARG1

# As wide as the rendered pictures beside it on the page, with the scale below; small ones are enlarged by whole pixels.
zoom = ceil(640.0 / width)
full_height = zoom * height + 110.0
set terminal pngcairo size zoom * width, full_height font "DejaVu Sans,13" background "#ffffff" fontscale 1.6
set output output
set datafile nocolumnheaders
set lmargin at screen 0
set rmargin at screen 1
set tmargin at screen 1
set bmargin at screen 110.0 / full_height
unset key
unset border
unset xtics
unset ytics
unset grid
set xrange [-0.5:width - 0.5]
set yrange [-0.5:height - 0.5]
set cbrange [-scale:scale]
set palette defined (-1 "#08306b", -0.5 "#4292c6", -0.12 "#c6dbef", 0 "#ffffff", 0.12 "#fdd0a2", 0.5 "#e6550d", 1 "#7f2704")
set colorbox horizontal user origin 0.1, 60.0 / full_height size 0.8, 30.0 / full_height
set cbtics (sprintf("−%.3g", scale) -scale, "0" 0, sprintf("+%.3g", scale) scale)
plot matrix binary array=(width, height) format="%float32" flipy with image
