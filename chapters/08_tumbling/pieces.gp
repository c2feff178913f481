set title "A step is three turns, about axes 2, 3 and 2 again, and ends beside the loop"
set size ratio -1
unset border
unset tics
unset grid
unset key
set xrange [-1.15:1.15]
set yrange [-1.15:1.15]
set label 1 "about 3" at -0.3, 0.47 left textcolor linetype 3
set label 3 "loop" at 0.36, 0.13 left textcolor linetype 7
set label 4 "after each step" at 0.36, -1.06 left textcolor linetype 1
set arrow 4 from 0.42, -0.98 to 0.17, -0.77 nohead linecolor rgb "#555555"
set label 2 "about 2" at -0.3, 0.14 right textcolor linetype 2
plot "sphere.tsv" using 1:2 with lines linecolor rgb "#555555" linewidth 1, \
     "polhode_through.tsv" using 1:2 with lines linestyle 7, \
     "pieces_half.tsv" using 1:2 with lines linetype 2 dashtype solid, \
     "pieces_whole.tsv" using 1:2 with lines linetype 3 dashtype solid, \
     "steps.tsv" using 1:2 with points linetype 1 pointtype 7 pointsize 0.7, \
     "pieces_arrows.tsv" using ($1 - $3 / 2):($2 - $4 / 2):3:4 with vectors head size 0.09,25 filled linecolor rgb "#22303a" dashtype solid linewidth 1.5, \
     "axes.tsv" using 1:2 with points pointtype 7 pointsize 0.6 linecolor rgb "#22303a", \
     "axes.tsv" using 1:2:3 with labels offset 1.1,0 textcolor rgb "#22303a"
