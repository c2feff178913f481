set title "Seen from the body, L runs along a curve of constant energy"
set size ratio -1
unset border
unset tics
unset grid
set xrange [-1.15:1.15]
set yrange [-1.15:1.15]
set lmargin at screen 0.01
set rmargin at screen 0.68
set bmargin at screen 0.02
set tmargin at screen 0.88
set key at screen 0.99,0.58 right top vertical maxcols 1 Left reverse samplen 1.6
plot "sphere.tsv" using 1:2 with lines linecolor rgb "#555555" linewidth 1 notitle, \
     "polhodes.tsv" using 3:4 with lines linecolor rgb "#b9c2c9" linewidth 1 notitle, \
     "separatrix.tsv" using 3:4 with lines linecolor rgb "#b9c2c9" linewidth 1.6 notitle, \
     "polhodes.tsv" using 1:2 with lines linetype 6 linewidth 1.3 dashtype solid title "energies", \
     "separatrix.tsv" using 1:2 with lines linestyle 2 linewidth 2.2 title "separatrix", \
     "polhode_through.tsv" using 1:2 with lines linestyle 3 dashtype solid linewidth 1.3 title "one energy", \
     "polhode_stepped.tsv" using 1:2 with points linetype 1 pointsize 0.5 title "stepped", \
     "axes.tsv" using 1:2 with points pointtype 7 pointsize 0.6 linecolor rgb "#22303a" notitle, \
     "axes.tsv" using 1:2:3 with labels offset 0,0.9 textcolor rgb "#22303a" notitle
