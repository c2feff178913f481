@drawing 560,430
set title "Five bodies, and the angle of their spin in a step"
unset border
unset tics
unset grid
unset key
set size ratio -1
set xrange [-1.6:11.2]
set yrange [-7.4:1.7]
set margins 0, 0, 0, 2
of(kind) = strcol(1) eq kind ? column(2) : NaN
array name[8] = ["A ordinary", "B stable axis", "C thin rod", "D needle", "a disc", "fastest", "crawling", "fast"]
name_of(n) = n == 0 ? "column A" : name[int(n) + 1] # on the dials of A
angle(x) = x <= 0 ? "" : x < 1e-3 ? sprintf("10^{%.0f} rad", log10(x)) : x < 1 ? sprintf("%.2f rad", x) : sprintf("%.0f rad", x)
begins(x) = x < 2 * pi ? 90 - x * 180 / pi : 0 # of a dial's part, degrees
ends(x) = x < 2 * pi ? 90 : 360
dial(n) = strcol(1) eq "dial" ? $2 : NaN
of_a(n) = strcol(1) eq "dial" && ($4 == 0 || $4 > 4) ? column(2) : NaN
plot for [n=0:14] "cases.tsv" using (of(sprintf("face %d", n))):3 with filledcurves closed fillstyle transparent solid (0.2 + 0.2 * (n % 3)) border linetype 1 dashtype solid linetype 1 linewidth 1, \
     "cases.tsv" using (of("spin")):3:4:5 with vectors head size 0.22,20 filled linetype 2 dashtype solid linewidth 2, \
     "cases.tsv" using (of("name")):3:(strcol(1) eq "name" ? name[int($4) + 1] : "") with labels center textcolor linetype 7, \
     "cases.tsv" using (of("dial")):3:(0.45):(begins($5)):(ends($5)) with circles fillstyle solid 0.6 noborder linetype 2 dashtype solid, \
     "cases.tsv" using (of("dial")):3:(0.45) with circles fillstyle empty border linecolor rgb "#555555" linewidth 1 dashtype solid, \
     "cases.tsv" using (of_a(0)):($3 + 0.85):(strcol(1) eq "dial" ? name_of($4) : "") with labels center textcolor linetype 7, \
     "cases.tsv" using (of("dial")):($3 - 0.85):(strcol(1) eq "dial" && $4 != 4 ? angle($5) : "") with labels center textcolor rgb "#555555", \
     "cases.tsv" using (of("axis")):($3 - 0.85):(strcol(1) eq "axis" ? sprintf("%.0f rad, its axis %.0f", $4, $5) : "") with labels center textcolor rgb "#555555"
