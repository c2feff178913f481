set title "A coarser step flies lower: the error is half of a h t"
set xlabel "distance (m)"
set ylabel "height (m)"
plot "throw_10.tsv" using 2:3 with linespoints title "10 steps a second", \
     "throw_60.tsv" using 2:3 with lines title "60 steps a second", \
     "throw_60.tsv" using 2:4 with lines dashtype 2 title "exact parabola"
