# One figure in all its forms: as SVG and PNG for the page and for print, and as a thumbnail.
#
#   gnuplot -c plots/figure.gp plots/style.gp plots/NAME.gp FOLDER STEM FIGURE SCENE
#
# Calls the study's script once for each of STEM.svg, STEM.png and STEM.small.png: to start gnuplot costs more than to draw.
style = ARG1
script = ARG2
tables = ARG3
stem = ARG4
name = ARG5
of_scene = ARG6
call script style tables (stem . ".svg") name of_scene
unset output
reset
call script style tables (stem . ".png") name of_scene
unset output
reset
call script style tables (stem . ".small.png") name of_scene
unset output
