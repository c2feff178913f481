@drawing 540,420
set title "What becomes of the spin about the shaft?"
set xlabel "time (s)"
set ylabel "rate (rad/s)"
set ytics 5
set yrange [-11:13]
unset key
set label 1 "shaft,\nand exact" at 3.15, -6 center textcolor linetype 1
set label 2 "shaft, no term" at 6.2, 11.9 center textcolor linetype 2
set label 3 "bar" at 2.1, 8 left textcolor linetype 3
set label 4 "third axis" at 6.1, -1.7 center textcolor linetype 4
plot "t_handle.tsv" using 1:3 with lines linestyle 1, \
     "t_handle.tsv" using 1:5 with lines linestyle 7, \
     "t_handle.tsv" using 1:6 with lines linestyle 2, \
     "t_handle.tsv" using 1:2 with lines linestyle 3, \
     "t_handle.tsv" using 1:4 with lines linestyle 4
