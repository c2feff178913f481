@drawing 420,440
set output name.".svg"
set title "Two quarter turns in the other order leave the book facing another way"
unset border
unset tics
unset grid
unset key
set size ratio -1
set xrange [-1.6:8.5]
set yrange [-8.2:2]
set margins 0, 0, 0, 2
# The second order stands in a row below the first, and begins with the same book.
below = 5.3
of(kind) = strcol(1) eq kind ? column(2) : NaN
across(x) = x > 8.5 ? x - 6.8 : x
down(x, y) = x > 8.5 ? y - below : y
set label 1 "as it lies" at 0, -2 center textcolor linetype 7
set label 2 "turned about {/:Italic x}" at 3.4, -2 center textcolor linetype 7
set label 3 "then about {/:Italic z}" at 6.8, -2 center textcolor linetype 1
set label 4 "as it lies" at 0, -2 - below center textcolor linetype 7
set label 5 "turned about {/:Italic z}" at 3.4, -2 - below center textcolor linetype 7
set label 6 "then about {/:Italic x}" at 6.8, -2 - below center textcolor linetype 2
set label 7 "its spine" at 1.1, 0.75 left textcolor linetype 2
set arrow 1 from -1.4, -2.8 to 8.3, -2.8 nohead linecolor rgb "#b9c2c9"
plot for [n=0:4] "poses.tsv" using (across(of(sprintf("page %d", n)))):(down($2, $3)) with filledcurves closed fillstyle solid 0.12 border linetype 7 dashtype solid linetype 7, \
     for [n=0:4] "poses.tsv" using (across(of(sprintf("spine %d", n)))):(down($2, $3)) with filledcurves closed fillstyle solid 0.75 border linetype 6 dashtype solid linetype 6, \
     for [n=0:4] "poses.tsv" using (across(of(sprintf("cover %d", n)))):(down($2, $3)) with filledcurves closed fillstyle solid 0.5 border linetype 1 dashtype solid linetype 1, \
     "poses.tsv" using (of("page 0")):($3 - below) with filledcurves closed fillstyle solid 0.12 border linetype 7 dashtype solid linetype 7, \
     "poses.tsv" using (of("spine 0")):($3 - below) with filledcurves closed fillstyle solid 0.75 border linetype 6 dashtype solid linetype 6, \
     "poses.tsv" using (of("cover 0")):($3 - below) with filledcurves closed fillstyle solid 0.5 border linetype 1 dashtype solid linetype 1, \
     "poses.tsv" using (across(of("head"))):(down($2, $3)):4:5 with vectors head filled linetype 2 dashtype solid linewidth 1.6, \
     "poses.tsv" using (strcol(1) eq "head" && $2 < 1 ? $2 : NaN):($3 - below):4:5 with vectors head filled linetype 2 dashtype solid linewidth 1.6
