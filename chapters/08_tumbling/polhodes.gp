set title "Seen from the body, L runs along a curve of constant energy"
set size ratio -1
unset border
unset tics
unset grid
unset key
set xrange [-1.15:1.15]
set yrange [-1.15:1.15]
set label 1 "separatrix" at 0.93, 0.62 left textcolor linetype 2
set label 2 "○ stepped" at -0.66, -0.9 right textcolor linetype 1
set label 3 "one energy" at -0.88, 0.58 right textcolor linetype 3
plot "sphere.tsv" using 1:2 with lines linecolor rgb "#555555" linewidth 1, \
     "polhodes.tsv" using 3:4 with lines linecolor rgb "#b9c2c9" linewidth 1 dashtype solid, \
     "separatrix.tsv" using 3:4 with lines linecolor rgb "#b9c2c9" linewidth 1.6 dashtype (8,4), \
     "polhodes.tsv" using 1:2 with lines linetype 6 linewidth 1 dashtype solid, \
     "separatrix.tsv" using 1:2 with lines linestyle 2 linewidth 2, \
     "polhode_through.tsv" using 1:2 with lines linetype 3 dashtype solid linewidth 3.5, \
     "polhode_stepped.tsv" using 1:2 with points pointtype 7 pointsize 0.85 linecolor rgb "#fffffe", \
     "polhode_stepped.tsv" using 1:2 with points linetype 1 pointtype 6 pointsize 0.85, \
     "axes.tsv" using 1:2 with points pointtype 7 pointsize 0.6 linecolor rgb "#22303a", \
     "axes.tsv" using 1:2:3 with labels offset 1.1,0 textcolor rgb "#22303a"
