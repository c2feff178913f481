@drawing 480,470
set output name.".svg"
set title "A kick and a drift shear a patch of starts and keep its area"
set xlabel "position x (m)"
set ylabel "velocity v (m/s)"
set size ratio -1
set xrange [0.2:1.6]
set xtics 0.4
set yrange [-1.05:0.35]
set label 1 "start" at 1.02, 0 center textcolor rgb "#22303a"
set label 2 "after the kick" at 1.23, -0.8 left textcolor linetype 3
set label 3 "after the drift" at 0.35, -0.9 center textcolor rgb "#0b6aa2"
set label 4 "explicit step" at 1.28, -0.42 left textcolor linetype 2
of(kind) = strcol(1) eq kind ? column(2) : NaN
plot "patch.tsv" using (of("start")):3 with filledcurves closed fillstyle transparent solid 0.25 border linestyle 7 notitle, \
     "patch.tsv" using (of("kicked")):3 with filledcurves closed fillstyle transparent solid 0.25 border linestyle 3 notitle, \
     "patch.tsv" using (of("stepped")):3 with filledcurves closed fillstyle transparent solid 0.35 border linestyle 1 notitle, \
     "patch.tsv" using (of("explicit")):3 with filledcurves closed fillstyle transparent solid 0.08 border linestyle 2 notitle
