@drawing 500,345
set output name.".svg"
unset border
unset tics
unset grid
unset key
set size ratio -1
set xrange [-0.04:0.68]
set yrange [-0.05:0.40]
set margins 0, 0, 0, 2
set title "One hammer, three sets of axes"
data = "frames.tsv"
of(kind) = strcol(1) eq kind ? column(2) : NaN
plot data using (of("body")):3 with filledcurves closed fillstyle transparent solid 0.12 border linestyle 7 dashtype solid linetype 6, \
     data using (of("to the offset")):3:4:5 with vectors nohead linetype 7, \
     data using (of("offset")):3:4:5 with vectors heads size 0.012,20 filled linetype 4 dashtype solid, \
     data using (of("world")):3:4:5 with vectors head size 0.016,20 filled linetype 1 linewidth 3, \
     data using (of("model")):3:4:5 with vectors head size 0.016,20 filled linetype 3 dashtype solid linewidth 3, \
     data using (of("principal")):3:4:5 with vectors head size 0.016,20 filled linetype 2 dashtype solid linewidth 3, \
     data using (of("world name")):3:(strlen(strcol(6)) == 1 ? formula(strcol(6)) : strcol(6)) with labels textcolor linetype 1, \
     data using (of("model name")):3:(strlen(strcol(6)) == 1 ? formula(strcol(6)) : strcol(6)) with labels textcolor linetype 3, \
     data using (of("principal name")):3:6 with labels textcolor linetype 2, \
     data using (of("offset name")):3:6 with labels left textcolor linetype 4
