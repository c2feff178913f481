@drawing 420,370
set output name.".svg"
set title "The terminal speed depends on the form, and on the step"
set xlabel "{/:Italic kh}"
set xtics 0.2
set ylabel "terminal speed ({/:Italic g}/{/:Italic k})"
set yrange [0:2]
plot "terminal.tsv" using 1:3 with lines linestyle 7 title "  kick, 1/(1 + {/:Italic kh}): exact" at end, \
     "terminal.tsv" using 1:5 with lines linestyle 3 title "  1/(1 + {/:Italic kh}), kick" at end, \
     "terminal.tsv" using 1:2 with lines linestyle 1 title "  kick, exp(−{/:Italic kh})" at end, \
     "terminal.tsv" using 1:4 with lines linestyle 2 title "  kick, 1 − {/:Italic kh}" at end
