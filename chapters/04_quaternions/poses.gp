@drawing 420,400
set output name.".svg"
set title "Two quarter turns in the other order leave the book facing another way"
unset border
unset tics
unset grid
unset key
set size ratio -1
set xrange [-1.6:8.5]
set yrange [-7.6:2]
set margins 0, 0, 0, 2
# One book lies; from it the two orders lead to the right, one above the other.
below = 5.3
of(kind) = strcol(1) eq kind ? column(2) : NaN
across(x) = x > 8.5 ? x - 6.8 : x
down(x, y) = x < 1.7 ? y - 2 : x > 8.5 ? y - below : y
set label 1 "as it lies" at -0.1, -3.5 center textcolor linetype 7
set label 2 "turned about {/:Italic x}" at 3.4, -2 center textcolor linetype 7
set label 3 "then about {/:Italic z}" at 6.8, -2 center textcolor linetype 7
set label 5 "turned about {/:Italic z}" at 3.4, -2 - below center textcolor linetype 7
set label 6 "then about {/:Italic x}" at 6.8, -2 - below center textcolor linetype 7
set label 7 "spine" at 1.1, -1.15 center textcolor linetype 2
set arrow 1 from 1, -0.6 to 2, 0 head filled linecolor rgb "#555555"
set arrow 2 from 1.3, -2.9 to 2.2, -4.3 head filled linecolor rgb "#555555"
set arrow 3 from 5, 0 to 5.7, 0 head filled linecolor rgb "#555555"
set arrow 4 from 5, -below to 5.7, -below head filled linecolor rgb "#555555"
# The world's axes, below the book that lies.
axis(letter) = strcol(1) eq "axis ".letter ? 0 : NaN
foot = -6.4
plot for [n=0:4] "poses.tsv" using (across(of(sprintf("page %d", n)))):(down($2, $3)) with filledcurves closed fillstyle solid 0.12 border linetype 7 dashtype solid linetype 7, \
     for [n=0:4] "poses.tsv" using (across(of(sprintf("spine %d", n)))):(down($2, $3)) with filledcurves closed fillstyle solid 0.75 border linetype 6 dashtype solid linetype 6, \
     for [n=0:4] "poses.tsv" using (across(of(sprintf("cover %d", n)))):(down($2, $3)) with filledcurves closed fillstyle solid 0.5 border linetype 1 dashtype solid linetype 1, \
     "poses.tsv" using (across(of("head"))):(down($2, $3)):4:5 with vectors head filled linetype 2 dashtype solid linewidth 1.6, \
     for [letter in "x y z"] "poses.tsv" using (axis(letter)):(foot):4:5 with vectors head filled linetype 7 dashtype solid, \
     for [letter in "x y z"] "poses.tsv" using (axis(letter) + 1.3 * $4):(foot + 1.3 * $5):(formula(letter)) with labels textcolor linetype 7
