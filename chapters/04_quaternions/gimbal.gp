@drawing 600,330
set output name.".svg"
set title "At a pitch of 90 degrees the first and third axes coincide"
unset border
unset tics
unset grid
unset key
set size ratio -1
set xrange [-1.5:5.0]
set yrange [-1.6:1.7]
set margins 0, 0, 0, 2
of(kind) = strcol(1) eq kind ? column(2) : NaN
set label 1 "three axes: any turn" at 0, -1.45 center textcolor linetype 7
set label 2 "two axes: one direction lost" at 3.4, -1.45 center textcolor linetype 7
set label 3 "yaw" at 0.1, 1.3 left textcolor linetype 1
set label 4 "yaw and roll" at 3.5, 1.35 left textcolor linetype 2
plot "gimbal.tsv" using (of("outer back")):3 with lines linetype 1 dashtype (2,3) linewidth 1.4, \
     "gimbal.tsv" using (of("middle back")):3 with lines linetype 3 dashtype (2,3) linewidth 1.4, \
     "gimbal.tsv" using (of("inner back")):3 with lines linetype 2 dashtype (2,3) linewidth 1.4, \
     "gimbal.tsv" using (of("outer")):3 with lines linetype 1 dashtype solid linewidth 2.4, \
     "gimbal.tsv" using (of("middle")):3 with lines linetype 3 dashtype solid linewidth 2.4, \
     "gimbal.tsv" using (of("inner")):3 with lines linetype 2 dashtype solid linewidth 2.4, \
     "gimbal.tsv" using (of("yaw")):3:4:5 with vectors head filled linetype 1 dashtype solid linewidth 2, \
     "gimbal.tsv" using (of("pitch")):3:4:5 with vectors head filled linetype 3 dashtype solid linewidth 2, \
     "gimbal.tsv" using (of("roll")):3:4:5 with vectors head filled linetype 2 dashtype solid linewidth 2, \
     "gimbal.tsv" using (of("pitch") + $4 + 0.07):($3 + $5):("pitch") with labels left textcolor linetype 3, \
     "gimbal.tsv" every ::::1200 using (of("roll") + $4 - 0.08):($3 + $5 + 0.12):($2 < 2 ? "roll" : "") with labels right textcolor linetype 2
