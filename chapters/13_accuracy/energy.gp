@drawing 560,420
set title "Splitting keeps the energy within a band; Runge–Kutta rules let it drift"
set xlabel "time (s)"
set ylabel "relative error of the energy"
set logscale y
set format y "10^{%T}"
set xrange [0:600]
set yrange [1e-17:10]
set ytics 1e-16, 1e4
set rmargin 17
unset key
above_rounding(i) = column(i) > 1e-16 ? column(i) : 1e-16
# Three lines end so near to one another that their names would touch: the upper one is raised, the lower one lowered.
rise(i) = i == 5 ? 3 : i == 3 ? 0.2 : 1
plot for [i=2:6] "energy.tsv" using 1:(above_rounding(i)) with lines linestyle i-1, \
     for [i=2:6] "" using ($1 == 600 ? 600 : NaN):(column(i) * rise(i)):(columnhead(i)) with labels left offset 0.5,0 textcolor linetype i-1
