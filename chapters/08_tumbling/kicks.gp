set title "The kicks are perpendicular to L, so L goes round"
set xlabel "L, eastward (g m^2/s)" offset 0,-0.2
set ylabel "L, northward (g m^2/s)"
set termoption enhanced
set size ratio -1
set xrange [-14:14]
set yrange [-14:14]
set xtics 5
set ytics 5
set lmargin at screen 0.16
set rmargin at screen 0.78
set bmargin at screen 0.19
set tmargin at screen 0.9
set key at screen 0.99,0.6 right top vertical maxcols 1 Left reverse samplen 1.6
plot "kicks.tsv" using (0):(0):1:2 with vectors head size 0.6,18 linestyle 6 linewidth 1.3 dashtype solid title "L", \
     "kicks.tsv" using 1:2:3:4 with vectors head size 0.8,20 linestyle 2 linewidth 2 dashtype solid title "kicks"
