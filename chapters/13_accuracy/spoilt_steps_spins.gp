@drawing 560,400
set title "With a tolerance for each step a faster top errs by more"
set xlabel "times as fast"
set ylabel "error after a second (rad)"
set logscale xy
set format y "10^{%T}"
set xrange [1:1000]
set yrange [1e-10:1]
set xtics ("1" 1, "10" 10, "100" 100, "1000" 1000)
set ytics 1e-10, 100
set rmargin 15
unset key
set arrow from 1, 1e-6 to 1000, 1e-6 nohead linecolor rgb "#555555"
set label "allowed" at 1.2, 3e-6 textcolor rgb "#555555"
last(i) = $1 > 999 ? column(i) : NaN
plot for [i=2:3] "spoilt_steps_spins.tsv" using 1:(column(i)) with linespoints linestyle i-1, \
     for [i=2:3] "" using 1:(last(i)):("for ".columnhead(i)) with labels left offset 0.8,0 textcolor linetype i-1
