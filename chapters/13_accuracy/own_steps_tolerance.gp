@drawing 545,400
set title "The pair 8(5,3) needs the fewest steps for a small tolerance"
set xlabel "tolerance (m/s and m/s²)"
set ylabel "steps along the orbit"
set logscale xy
set xrange [1.3e-2:1e-10] reverse
set xtics ("10^{-2}" 1e-2, "10^{-4}" 1e-4, "10^{-6}" 1e-6, "10^{-8}" 1e-8, "10^{-10}" 1e-10)
set yrange [20:3000]
set ytics (20, 50, 100, 200, 500, 1000, 2000)
set rmargin 15
unset key
last(i) = $1 < 2e-10 ? column(i) : NaN
plot for [i=2:4] "own_steps_tolerance.tsv" using 1:i with linespoints linestyle i-1, \
     for [i=2:4] "" using 1:(last(i)):(columnhead(i)) with labels left offset 0.8,0 textcolor linetype i-1
