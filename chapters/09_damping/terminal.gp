set title "The terminal speed depends on the form, and on the step"
set xlabel "c h"
set ylabel "terminal speed (g/c)"
set yrange [0:2]
plot "terminal.tsv" using 1:3 with lines linestyle 7 title "kick, 1/(1 + c h): exact", \
     "terminal.tsv" using 1:5 with lines linestyle 3 title "1/(1 + c h), kick", \
     "terminal.tsv" using 1:2 with lines linestyle 1 title "kick, exp(-c h)", \
     "terminal.tsv" using 1:4 with lines linestyle 2 title "kick, 1 - c h"
