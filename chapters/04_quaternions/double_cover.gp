@drawing 410,360
set output name.".svg"
set title "After one turn the arrow is back where it was; the quaternion takes two"
set xlabel "turned about {/:Italic z} (degrees)"
set ylabel "component"
set xtics 180
set xrange [0:720]
set yrange [-1.05:1.05]
set label 1 "the quaternion's\nreal part" at 733, 0.62 left textcolor linetype 2
plot "double_cover.tsv" using 1:2 with lines linestyle 1 title "  the arrow's {/:Italic x}" at end, \
     "double_cover.tsv" using 1:3 with lines linestyle 2 notitle, \
     "double_cover.tsv" using 1:4 with lines linestyle 3 title "  its part along {/:Italic k}" at end
