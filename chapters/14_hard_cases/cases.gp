@drawing 560,400
set title "The eight bodies, and the angle of their spin in a step"
unset border
unset tics
unset grid
unset key
set size ratio -1
set xrange [-1.6:11.2]
set yrange [-6.2:1.7]
set margins 0, 0, 0, 2
of(kind) = strcol(1) eq kind ? column(2) : NaN
# The names in words, which the table's narrow columns have no room for.
array name[8] = ["A ordinary", "B stable axis", "C thin rod", "D needle", "a disc", "A, fastest", "A, crawling", "A, fast"]
name_of(n) = n >= 0 && n < 8 ? name[int(n) + 1] : ""
angle(x) = x <= 0 ? "" : x < 1e-3 ? sprintf("10^{%.0f} rad", log10(x)) : x < 1 ? sprintf("%.2f rad", x) : sprintf("%.0f rad", x)
plot for [n=0:23] "cases.tsv" using (of(sprintf("face %d", n))):3 with filledcurves closed fillstyle transparent solid (0.2 + 0.2 * (n % 3)) border linetype 1 dashtype solid linetype 1 linewidth 1, \
     "cases.tsv" using (of("spin")):3:4:5 with vectors head size 0.22,20 filled linetype 2 dashtype solid linewidth 2, \
     "cases.tsv" using (strcol(1) eq "name" ? $2 : NaN):3:(name_of(strcol(1) eq "name" ? $4 : -1)) with labels center textcolor linetype 7, \
     "cases.tsv" using (strcol(1) eq "pace" ? $2 : NaN):3:(angle($4)) with labels center textcolor rgb "#555555"
