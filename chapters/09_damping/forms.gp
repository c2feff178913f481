set title "What does a step leave of the speed?"
set xlabel "k h"
set ylabel "part of the speed left"
set yrange [-1.3:1]
set xrange [0:2.3]
set arrow 1 from 0, 0 to 2.3, 0 nohead linestyle 7
set arrow 2 from 0, -1 to 2.3, -1 nohead linecolor rgb "#555555" dashtype 2
set label 1 "below 0: turned round" at 0.06, -0.12 left textcolor linetype 7
set label 2 "below -1: faster than before" at 0.06, -1.12 left textcolor linetype 7
plot "forms.tsv" using 1:2 with lines linestyle 1 title "  exp(-k h)" at end, \
     "forms.tsv" using 1:4 with lines linestyle 3 title "  1/(1 + k h)" at end, \
     "forms.tsv" using 1:3 with lines linestyle 2 title "  1 - k h" at end
