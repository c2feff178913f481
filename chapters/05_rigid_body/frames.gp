unset border
unset tics
unset key
set size ratio -1
set xrange [-0.08:0.72]
set yrange [-0.09:0.42]
set title "One hammer, three sets of axes"
data = "frames.tsv"
x_of(kind) = strcol(1) eq kind ? column(2) : NaN
plot data using (x_of("body")):3 with filledcurves closed fillstyle transparent solid 0.15 border linestyle 6 dashtype solid, \
     data using (x_of("offset")):3:4:5 with vectors nohead linestyle 7, \
     data using (x_of("world")):3:4:5 with vectors head linestyle 1, \
     data using (x_of("model")):3:4:5 with vectors head linestyle 3 dashtype solid, \
     data using (x_of("principal")):3:4:5 with vectors head linestyle 2 dashtype solid linewidth 3, \
     data using (x_of("dot")):3 with points linestyle 6 pointtype 7 pointsize 0.8, \
     data using (x_of("label")):3:6 with labels
