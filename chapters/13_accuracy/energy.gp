@drawing 560,420
set title "The error of Runge–Kutta rules grows with time, and in the end passes splitting's"
set xlabel "time"
stats "energy.tsv" using 1 nooutput # before the axes are logarithmic
last = STATS_max
set ylabel "relative error of the energy"
set logscale xy
set format y "10^{%T}"
set xrange [1:50000]
set xtics ("1 s" 1, "10 s" 10, "1 min" 60, "10 min" 600, "1 h" 3600, "10 h" 36000)
set yrange [1e-9:1]
set ytics 1e-9, 1000
set rmargin 17
unset key
# Three lines end so near to one another that their names would touch: the upper one is raised, the lower one lowered.
rise(i) = i == 4 ? 7 : i == 5 ? 0.15 : 1
plot for [i=2:5] "energy.tsv" using 1:i with lines linestyle i-1, \
     for [i=2:5] "" using ($1 == last ? $1 : NaN):(column(i) * rise(i)):(columnhead(i)) with labels left offset 0.5,0 textcolor linetype i-1
