set title "Without the offset the hammer spins about the end of its handle"
set xlabel "distance (m)"
set ylabel "height (m)"
set size ratio -1
set xrange [0:2]
set yrange [0:1.05]
set xtics 0.5
set ytics 0.5
set label 1 "with the offset" at 0.6, 0.07 left textcolor linetype 1
set label 2 "without it" at 1.9, 0.42 left textcolor linetype 2
set label 3 "path of the centre of mass" at 1.12, 0.97 left textcolor linetype 7
# Nine corners and a gap for each pose, of which the first, the third and the last are drawn.
pose(n) = 10 * n
plot "forgotten_offset_paths.tsv" using 1:2 with lines linestyle 7 notitle, \
     for [n=0:4:2] "forgotten_offset.tsv" using 1:2 every ::pose(n)::(pose(n) + 8) with filledcurves closed \
       fillstyle transparent solid 0.35 border linetype 1 dashtype solid linetype 1 linewidth 1.6 notitle, \
     for [n=0:4:2] "forgotten_offset.tsv" using 3:4 every ::pose(n)::(pose(n) + 8) with lines linestyle 2 linewidth 1.4 notitle
