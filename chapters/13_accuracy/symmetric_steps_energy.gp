@drawing 565,420
set title "With steps that are chosen at their start, the energy drifts"
set xlabel "rounds"
set ylabel "relative error of the energy"
set logscale y
set format y "10^{%T}"
set xrange [0:100]
set yrange [1e-17:10]
set ytics 1e-16, 1e4
set rmargin 21
unset key
above_rounding(i) = column(i) > 1e-16 ? column(i) : 1e-16
# The lower two of three neighbours give way to the name above them.
rise(i) = i == 3 ? 2 : i == 2 ? 0.5 : i == 4 ? 0.3 : 1
plot for [i=2:5] "symmetric_steps_energy.tsv" using 1:(above_rounding(i)) with lines linestyle i-1, \
     for [i=2:5] "" using ($1 == 100 ? 100 : NaN):(column(i) * rise(i)):(columnhead(i)) with labels left offset 0.5,0 textcolor linetype i-1
