set title "The powers of ten are nearly Fibonacci's numbers: 1, 1, 2, 3, 5, 8, 13"
set xlabel "removal"
set ylabel "size of the removed product (kg m²)"
set logscale y
set xrange [0.7:7.3]
set yrange [1e-14:0.4]
set xtics 1,1,7
set ytics ("10^{-1}" 1e-1, "10^{-2}" 1e-2, "10^{-3}" 1e-3, "10^{-5}" 1e-5, "10^{-8}" 1e-8, "10^{-13}" 1e-13)
unset key
set label 1 "removed" at 6.25, 3e-8 left textcolor linetype 1
set label 2 "the two before, multiplied\nand divided by a difference\nof moments" at 4.6, 2e-11 right textcolor linetype 2
plot "removed.tsv" using 1:2 with linespoints linestyle 1, \
     "removed.tsv" using 1:($3 > 0 ? $3 : NaN) with points linestyle 2 pointtype 6 pointsize 1.5
