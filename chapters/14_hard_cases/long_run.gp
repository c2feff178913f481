@drawing 540,420
set title "Only the phase is lost"
set xlabel "time (s)"
set ylabel "off by (rad)"
set logscale xy
set format x "10^{%T}"
set format y "10^{%T}"
set xrange [10:*]
set yrange [1e-15:10]
set ytics 1e-15, 1e5
unset key
set label 1 "phase, in float and double" at 100, 0.8 center textcolor linetype 2
set label 2 "{/:Italic L}, float" at 200, 3e-4 center textcolor linetype 4
set label 3 "{/:Italic L}, double" at 250, 1e-12 center textcolor linetype 3
plot for [i=2:5] "long_run.tsv" using 1:i with lines linestyle i-1
