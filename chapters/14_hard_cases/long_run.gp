@drawing 540,420
set title "The phase is lost in either precision; L drifts by its roundings alone"
set xlabel "time (s)"
set ylabel "off so far by (rad)"
set logscale xy
set format x "10^{%T}"
set format y "10^{%T}"
set xrange [10:2e4]
set yrange [1e-15:10]
set ytics 1e-15, 1e5
unset key
set label 1 "phase, float" at 13, 1 left textcolor linetype 2
set label 4 "phase, double" at 13, 0.05 left textcolor linetype 1
set label 2 "direction of {/:Italic L}, float" at 2e4, 2e-6 right textcolor linetype 4
set label 3 "direction of {/:Italic L}, double" at 13, 1e-12 left textcolor linetype 3
plot for [i=2:5] "long_run.tsv" using 1:i with lines linestyle i-1
