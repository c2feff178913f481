set terminal svg size 480,470 font "sans-serif,15"
set output name.".svg"
set title "A kick and a drift shear a patch of starts and keep its area"
set xlabel "place x (m)"
set ylabel "velocity v (m/s)"
set size ratio -1
set xrange [0.2:1.6]
set xtics 0.4
set yrange [-1.05:0.35]
of(kind) = strcol(1) eq kind ? column(2) : NaN
plot "patch.tsv" using (of("start")):3 with filledcurves closed fillstyle transparent solid 0.25 border linestyle 7 title "start", \
     "patch.tsv" using (of("kicked")):3 with filledcurves closed fillstyle transparent solid 0.25 border linestyle 3 title "after the kick", \
     "patch.tsv" using (of("stepped")):3 with filledcurves closed fillstyle transparent solid 0.35 border linestyle 1 title "after the drift", \
     "patch.tsv" using (of("explicit")):3 with filledcurves closed fillstyle transparent solid 0.08 border linestyle 2 title "explicit step"
