@drawing 560,400
set title "Some errors of the energy waver, others add up"
set xlabel "time (s)"
set ylabel "largest error of the energy so far"
set logscale xy
set format y "10^{%T}"
set xrange [1:600]
set yrange [1e-9:1]
set xtics ("1" 1, "10" 10, "100" 100, "600" 600)
set rmargin 21
set ytics 1e-9, 1e3
unset key
set label 1 "splitting" at 640, 1e-2 left textcolor linetype 1
set label 2 "Blanes–Moan 4" at 640, 8e-7 left textcolor linetype 3
set label 3 "eighth order" at 640, 4e-4 left textcolor linetype 5
set label 4 "eighth order, {/:Italic L} apart" at 640, 8e-6 left textcolor linetype 6
plot "adding_up.tsv" using 1:2 with lines linestyle 1, \
     "" using 1:3 with lines linestyle 3, \
     "" using 1:4 with lines linestyle 5, \
     "" using 1:5 with lines linestyle 6
