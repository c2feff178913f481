set title "The kicks lead L round a circle"
set xlabel "{/:Italic L}, eastward (g m²/s)"
set ylabel "{/:Italic L}, northward (g m²/s)"
set size ratio -1
set xrange [-14:14]
set yrange [-14:14]
set xtics 5
set ytics 5
unset key
set label 1 "{/:Italic L}" at 5.6,-1.9 center textcolor linetype 6
set label 2 "kicks" at 10.2,7.6 left textcolor linetype 2
plot "kicks.tsv" using (0):(0):1:2 with vectors head size 0.6,18 linestyle 6 linewidth 1.3 dashtype solid, \
     "kicks.tsv" using 1:2:3:4 with vectors head size 0.8,20 linestyle 2 linewidth 2 dashtype solid
