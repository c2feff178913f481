@drawing 560,420
set title "The error of Runge–Kutta rules grows with time, and in the end passes that of splitting"
set xlabel "time"
stats "energy.tsv" using 1 nooutput # before the axes are logarithmic
last = STATS_max
set ylabel "largest relative error of the energy so far"
set logscale xy
set format y "10^{%T}"
set xrange [1:50000]
set xtics ("1 s" 1, "10 s" 10, "1 min" 60, "10 min" 600, "1 h" 3600, "10 h" 36000)
set yrange [1e-8:3]
set ytics 1e-8, 100
set rmargin 17
unset key
colour(i) = int(word("5 2 3 1", i - 1)) # as where else these rules are drawn
# Three lines end near to one another: the upper name is raised, and splitting's stands on its line.
rise(i) = i == 4 ? 2.2 : 1
set label 1 "splitting" at 120, 4.5e-4 textcolor linetype 1
plot for [i=2:5] "energy.tsv" using 1:i with lines linestyle colour(i), \
     for [i=2:4] "" using ($1 == last ? $1 : NaN):(column(i) * rise(i)):(columnhead(i)) with labels left offset 0.5,0 textcolor linetype colour(i)
