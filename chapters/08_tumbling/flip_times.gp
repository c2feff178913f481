set title "Each tenfold cut in the wobble delays the flip by the same amount"
set xlabel "wobble / spin"
set ylabel "from flip to flip (s)"
set logscale x
set xrange [1:1e-8] reverse
set format x "10^{%T}"
set yrange [0:12]
set label 1 "2 ln(1/wobble)/{/:Italic κ}" at 1e-4, 4.2 left textcolor linetype 4
set label 2 "exact, elliptic" at 0.4, 7.3 left textcolor linetype 7
set label 4 "rounding" at 1.2e-8, 6 right textcolor rgb "#555555"
set arrow 4 from 1.6e-8, 6.6 to 1.08e-8, 8.8 nohead linecolor rgb "#555555"
set label 3 "• stepped" at 0.4, 8.5 left textcolor linetype 1
plot "flip_times.tsv" using 1:4 with lines linestyle 4 notitle, \
     "flip_times.tsv" using 1:2 with lines linestyle 7 notitle, \
     "flip_times.tsv" using 1:3 with points linestyle 1 notitle
