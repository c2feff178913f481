set title "How far the weight can swing grows with the step, up to the limit"
set xlabel "{/:Italic ωh}"
set ylabel "largest |{/:Italic x}| (m)"
set logscale y
set xrange [0:2.1]
set xtics 0.5
set yrange [0.7:40]
set ytics (1, 2, 5, 10, 20)
set samples 2001
set label 3 "limit" at 1.98, 28 right textcolor rgb "#555555"
set arrow from 2, graph 0 to 2, graph 1 nohead linecolor rgb "#555555"
set label 1 "1/√(1 − {/:Italic ω}²{/:Italic h}²/4)" at 1.6, 4 right textcolor linetype 7
set arrow from 1.62, 3.6 to 1.83, 2.6 nohead linecolor rgb "#555555"
set label 4 "{/:Italic ωh} = 1: six steps a swing" at 1.93, 0.83 right textcolor linetype 1
set arrow from 1.03, 0.88 to 1.005, 0.97 nohead linecolor rgb "#555555"
set label 2 "2000 steps" at 0.98, 1.5 right textcolor linetype 1
plot sample [0:1.9985] 1/sqrt(1 - x*x/4) with lines linestyle 7 notitle, \
     "amplitude.tsv" using 1:2 with points linestyle 1 notitle
