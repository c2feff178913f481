set title "Without the offset the hammer spins about the end of its handle"
set xlabel "distance (m)"
set ylabel "height (m)"
set size ratio -1
set xrange [0:2]
set xtics 0.5
set ytics 0.5
plot "forgotten_offset_paths.tsv" using 1:2 with lines linestyle 7 title "path of the centre of mass", \
     "forgotten_offset.tsv" using 1:2 with lines linestyle 1 title "drawn with the offset", \
     "forgotten_offset.tsv" using 3:4 with lines linestyle 2 title "drawn without it"
