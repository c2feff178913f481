set title "The line ends at the stick's length"
set xlabel "time (s)"
set ylabel "length (m)"
plot "line.tsv" using 1:2 with lines linestyle 1 title "stick"
