@drawing 545,420
set title "A needle's energy: wrong by a hundredfold, by hundredths, or by millionths"
set xlabel "time (s)"
set ylabel "relative error of the energy"
set logscale y
set format y "10^{%T}"
set xrange [0:5]
set yrange [1e-8:1e4]
set ytics 1e-8, 1e2
set rmargin 17
unset key
off(x) = abs(x - 1) > 1e-8 ? abs(x - 1) : 1e-8
set label 1 "by axes" at 5.1, 1e-4 left textcolor linetype 5
set label 2 "ours" at 5.1, 1.5e-6 left textcolor linetype 1
plot for [i=2:5] "needle.tsv" using 1:(off(column(i))) with lines linestyle i, \
     "" using 1:(off($6)) with lines linestyle 1, \
     "" using ($1 == 5 ? 5 : NaN):(off($2)):("restored, linear") with labels left offset 0.5,0 textcolor linetype 2, \
     "" using ($1 == 5 ? 5 : NaN):(off($4)):(columnhead(4)) with labels left offset 0.5,0 textcolor linetype 4
