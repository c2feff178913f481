@drawing 560,350
set output name.".svg"
set title "A potato's three axes are found from its skin alone"
unset border
unset tics
unset grid
unset key
set size ratio -1
set xrange [-0.108:0.078]
set yrange [-0.066:0.05]
set margins 0, 0, 0, 2
is(kind) = strcol(1) eq kind ? column(2) : NaN
data = "potato.tsv"
plot data using (is("inside")):3:4:5 with vectors nohead linestyle 2 dashtype (3,3) linewidth 1.6, \
     data using (is("skin")):3 with filledcurves closed fillstyle transparent solid 0.22 border linestyle 6 dashtype solid linewidth 0.5, \
     data using (is("outside")):3:4:5 with vectors head filled linestyle 2 dashtype solid linewidth 2.5, \
     data using (is("centre")):3 with points linestyle 2 pointtype 7 pointsize 0.7, \
     data using (is("label")):3:6 with labels center textcolor linetype 2
