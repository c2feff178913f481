@drawing 560,400
set title "All but the classical Runge–Kutta rule keep the angular momentum"
set xlabel "time (s)"
set ylabel "relative error of {/:Italic L} in the world"
set logscale y
set format y "10^{%T}"
set xrange [0:600]
set yrange [1e-17:10]
set ytics 1e-16, 1e4
set rmargin 17
unset key
above_rounding(i) = column(i) > 1e-16 ? column(i) : 1e-16
plot for [i=2:6] "momentum.tsv" using 1:(above_rounding(i)) with lines linestyle int(word("5 2 3 1 6", i - 1)), \
     "" using ($1 == 600 ? 600 : NaN):3:(columnhead(3)) with labels left offset 0.5,0 textcolor linetype 2, \
     "" using ($1 == 600 ? 600 : NaN):2:("the other four") with labels left offset 0.5,0 textcolor linetype 7
