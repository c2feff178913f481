@drawing 560,290
set output name.".svg"
unset border
unset tics
unset key
unset grid
set size ratio -1
set xrange [-1.05:1.9]
set yrange [-0.34:0.72]
set margins 0, 0, 0, 2
set title "A long box is easy to turn only about its length"
data = "hardest_axis.tsv"
is(kind) = strcol(1) eq kind ? column(2) : NaN
plot data using (is("axis behind")):3:4:5 with vectors head filled linestyle 2 dashtype solid linewidth 2.5, \
     data using (is("front")):3 with filledcurves closed fillstyle transparent solid 0.45 border linestyle 6 dashtype solid linewidth 1.2, \
     data using (is("top")):3 with filledcurves closed fillstyle transparent solid 0.15 border linestyle 6 dashtype solid linewidth 1.2, \
     data using (is("side")):3 with filledcurves closed fillstyle transparent solid 0.3 border linestyle 6 dashtype solid linewidth 1.2, \
     data using (is("axis")):3:4:5 with vectors head filled linestyle 2 dashtype solid linewidth 2.5, \
     data using (is("label")):3:(formula(strcol(6)[1:1]).strcol(6)[2:*]) with labels left textcolor rgb "#22303a"
