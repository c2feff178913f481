@drawing 565,420
set title "With steps that are chosen at their start, the energy drifts"
set xlabel "rounds"
set ylabel "relative error of the energy"
set logscale xy
set format y "10^{%T}"
set xrange [1:100]
set xtics ("1" 1, "10" 10, "100" 100)
set yrange [1e-7:0.1]
set ytics 1e-7, 10
set rmargin 21
set label "transformed time: far below, at rounding" at 1.15, 2.5e-7 textcolor linetype 4
unset key
rise(i) = i == 3 ? 1.25 : i == 2 ? 0.8 : 1
plot for [i=2:4] "symmetric_steps_energy.tsv" using 1:i with lines linestyle i-1, \
     for [i=2:4] "" using ($1 == 100 ? 100 : NaN):(column(i) * rise(i)):(columnhead(i)) with labels left offset 0.5,0 textcolor linetype i-1
