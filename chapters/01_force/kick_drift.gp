@drawing 480,480
set output name.".svg"
set title "One step: the kick changes the velocity, and the new velocity carries the ball"
set xlabel "distance (m)"
set ylabel "height (m)"
unset key
set size ratio -1
set xrange [-0.5:5.8]
set yrange [-0.5:5.5]
of(kind) = strcol(1) eq kind ? column(2) : NaN
plot "kick_drift.tsv" using (of("ball")):3 with points linetype 1 pointtype 6 pointsize 2 linewidth 1.6, \
     "kick_drift.tsv" using (of("old")):3:4:5 with vectors head size 0.16,20 filled linetype 7 linewidth 1.6, \
     "kick_drift.tsv" using (of("kick")):3:4:5 with vectors head size 0.16,20 filled linetype 2 dashtype solid linewidth 3, \
     "kick_drift.tsv" using (of("new")):3:4:5 with vectors head size 0.16,20 filled linetype 1 linewidth 3, \
     "kick_drift.tsv" using (of("old name") - 0.3):3:("{/:Italic hv}, old") with labels right textcolor linetype 7, \
     "kick_drift.tsv" using (of("kick name") + 0.12):3:("the kick, {/:Italic h}²{/:Italic a}") with labels left textcolor linetype 2, \
     "kick_drift.tsv" using (of("new name") + 0.2):($3 - 0.25):("{/:Italic hv}, new: the drift") with labels left textcolor linetype 1
