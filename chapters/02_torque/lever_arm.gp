unset border
unset tics
unset key
set size ratio -1
set xrange [-2.9:2.9]
set yrange [-1.5:2.4]
set title "The torque is the force times d, the distance of the force's line from the centre"
data = "lever_arm.tsv"
x_of(kind) = strcol(1) eq kind ? column(2) : NaN
plot data using (x_of("body")):3 with filledcurves closed fillstyle transparent solid 0.15 border linestyle 6 dashtype solid, \
     data using (x_of("line")):3:4:5 with vectors nohead linestyle 7, \
     data using (x_of("square")):3:4:5 with vectors nohead linetype 7 dashtype solid linewidth 1, \
     data using (x_of("distance")):3:4:5 with vectors heads size 0.17,20 filled linestyle 3 dashtype solid, \
     data using (x_of("arm")):3:4:5 with vectors head size 0.2,20 filled linestyle 1, \
     data using (x_of("force")):3:4:5 with vectors head size 0.2,20 filled linestyle 2 dashtype solid linewidth 3, \
     data using (x_of("dot")):3 with points linestyle 6 pointtype 7 pointsize 1, \
     data using (x_of("label")):3:(formula(strcol(6))) with labels
