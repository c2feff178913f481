set title "The terminal speed depends on the form, and on the step"
set xlabel "k h"
set ylabel "terminal speed (g/k)"
set yrange [0:2]
plot "terminal.tsv" using 1:3 with lines linestyle 7 title "  kick, 1/(1 + k h): exact" at end, \
     "terminal.tsv" using 1:5 with lines linestyle 3 title "  1/(1 + k h), kick" at end, \
     "terminal.tsv" using 1:2 with lines linestyle 1 title "  kick, exp(-k h)" at end, \
     "terminal.tsv" using 1:4 with lines linestyle 2 title "  kick, 1 - k h" at end
