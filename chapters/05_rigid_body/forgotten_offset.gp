@drawing 500,560
set output name.".svg"
# The same six moments twice, once above the other.
set multiplot layout 2,1 margins 0.09,0.99,0.1,0.86 spacing 0,0.14 title "Without the offset the hammer spins about the end of its handle" font "sans-serif,18"
set size ratio -1
set xrange [0:2.1]
set yrange [-0.05:1.05]
set xtics 0.5
set ytics 0.5
set label 4 "height (m)" at graph -0.09, graph 1.12 left textcolor rgb "#22303a" # an axis' own name is left out where its room is short
set label 2 "path of the\ncentre of mass" at 1.5, 0.9 left textcolor linetype 7
# Nine corners and a gap for each pose.
pose(n) = 10 * n
set format x ""
set label 1 "drawn with the offset" at graph 1, graph 1.12 right textcolor linetype 1
plot for [n=0:5] "forgotten_offset.tsv" using 1:2 every ::pose(n)::(pose(n) + 8) with filledcurves closed \
       fillstyle transparent solid 0.35 border linetype 1 dashtype solid linetype 1 linewidth 1.6 notitle, \
     "forgotten_offset_paths.tsv" using 1:2 with lines linestyle 7 notitle, \
     "" using 1:2 every 32 with points pointtype 7 pointsize 0.5 linecolor rgb "#22303a" notitle
set format x "%g"
set xlabel "distance (m)"
unset label 2
set label 3 "path of the head" at 0.85, 0.13 left textcolor linetype 4
set label 1 "drawn without it" at graph 1, graph 1.12 right textcolor linetype 2
plot for [n=0:5] "forgotten_offset.tsv" using 3:4 every ::pose(n)::(pose(n) + 8) with filledcurves closed \
       fillstyle transparent solid 0.35 border linetype 2 dashtype solid linetype 2 linewidth 1.6 notitle, \
     "forgotten_offset_paths.tsv" using 1:2 with lines linestyle 7 notitle, \
     "" using 3:4 with lines linestyle 4 dashtype solid linewidth 1.2 notitle, \
     "" using 1:2 every 32 with points pointtype 7 pointsize 0.5 linecolor rgb "#22303a" notitle
unset multiplot
