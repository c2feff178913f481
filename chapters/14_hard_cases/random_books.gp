@drawing 620,480
set title "Only a rule whose turns keep L closes the book of L"
set xlabel "largest part of {/:Italic L} that is unexplained"
set logscale x
set format x "10^{%T}"
set xrange [1e-15:1e4]
set xtics 1e-15, 1e5
set yrange [11.6:-1.7]
set ytics scale 0
set grid noytics
unset key
set label 1 "double" at 2e-13, -1.1 center textcolor linetype 1
set label 2 "float" at 1.5e-4, -1.1 center textcolor linetype 2
plot "random_in_double.tsv" using 3:0:ytic(1) with points linetype 1 pointtype 6 pointsize 1.1, \
     "random_in_float.tsv" using 3:0 with points linetype 2 pointtype 4 pointsize 1
