@drawing 560,460
set title "Only a rule whose turns keep L closes the book of L"
set xlabel "largest part of {/:Italic L} that is unexplained"
set logscale x
set format x "10^{%T}"
set xrange [1e-15:1e4]
set xtics 1e-15, 1e5
set yrange [11.6:-0.6]
set ytics scale 0
set grid noytics
unset key
set label 1 "double" at 2e-13, 2.1 center textcolor linetype 1
set label 2 "float" at 1.5e-4, 2.1 center textcolor linetype 2
plot "random_in_double.tsv" using 3:0:ytic(1) with points linetype 1 pointtype 7 pointsize 0.9, \
     "random_in_float.tsv" using 3:0 with points linetype 2 pointtype 5 pointsize 0.8
