@drawing 560,330
set output name.".svg"
set title "One torque: two pairs of numbers, one arrow"
unset border
unset tics
unset grid
unset key
set size ratio -1
set xrange [-1.4:2.4]
set yrange [-1.15:1.3]
set margins 0, 0, 0, 2
of(kind) = strcol(1) eq kind ? column(2) : NaN
set label 1 "components along the world's {/:Italic x} and {/:Italic y}" at 0.35, -0.62 left textcolor linetype 1
set label 2 "along the plate's own axes" at -0.1, 1.15 left textcolor linetype 3
set arrow 1 from 1.0, -0.53 to 0.95, -0.06 head size 0.06,20 filled linecolor rgb "#555555" linewidth 0.8
set arrow 2 from 0.55, 1.06 to 0.62, 0.5 head size 0.06,20 filled linecolor rgb "#555555" linewidth 0.8
plot "two_frames.tsv" using (of("plate")):3 with filledcurves closed fillstyle transparent solid 0.12 border linetype 7 dashtype solid linetype 6, \
     "two_frames.tsv" using (of("world")):3:4:5 with vectors head size 0.08,20 filled linetype 1 dashtype (6,3) linewidth 1.8, \
     "two_frames.tsv" using (of("body")):3:4:5 with vectors head size 0.08,20 filled linetype 3 dashtype (6,3) linewidth 1.8, \
     "two_frames.tsv" using (of("answer")):3:4:5 with vectors head size 0.1,20 filled linetype 4 dashtype solid linewidth 2, \
     "two_frames.tsv" using (of("torque")):3:4:5 with vectors head size 0.12,20 filled linetype 2 dashtype solid linewidth 3, \
     "two_frames.tsv" using (of("its name") + 0.14):3:("torque") with labels left textcolor linetype 2, \
     "two_frames.tsv" using (of("answer's name") + 0.06):($3 + 0.17):("axis it starts to turn about") with labels left textcolor linetype 4
