set title "Three forms agree while k h is small, and one changes sign"
set xlabel "k h"
set ylabel "part of the speed left"
set yrange [-1.3:1]
set xrange [0:2.3]
set arrow from 0, -1 to 2.3, -1 nohead linecolor rgb "#555555" dashtype 2
plot "forms.tsv" using 1:2 with lines linestyle 1 title "exp(-k h)", \
     "forms.tsv" using 1:4 with lines linestyle 3 title "1/(1 + k h)", \
     "forms.tsv" using 1:3 with lines linestyle 2 title "1 - k h"
