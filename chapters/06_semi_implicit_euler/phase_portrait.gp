@drawing 480,470
set output name.".svg"
set title "Drift with the old velocity, and every swing is wider than the last"
set xlabel "{/:Italic ωx} (m/s)"
set ylabel "{/:Italic v} (m/s)"
set size ratio -1
set xrange [-2.8:3.2]
set yrange [-3.1:2.5]
set trange [0:2*pi]
set parametric
set label 1 "explicit Euler" at 1.5, 2.1 left textcolor linetype 2
set label 2 "kick, drift;" at 0, 0.17 center textcolor linetype 1
set label 3 "exact" at 0, -0.17 center textcolor linetype 7
plot cos(t), sin(t) with lines linestyle 7 notitle, \
     "phase_portrait.tsv" using 2:3 with linespoints linestyle 2 notitle, \
     "phase_portrait.tsv" using 4:5 with linespoints linestyle 1 notitle
