set title "By way of the origin, a body's tensor loses digits with the square of the distance"
set xlabel "distance of the body from the model's origin (m)"
set ylabel "relative error of I in float"
set logscale xy
set xrange [0.7:15000]
set yrange [1e-8:1e3]
set format x "10^{%T}"
set format y "10^{%T}"
set termoption enhanced
plot "far_parts.tsv" using 1:($2 > 0 ? $2 : NaN) with points linestyle 2 title "by way of the origin", \
     1.2e-7*x**2 with lines linestyle 7 title "square of the distance, times one rounding", \
     "far_parts.tsv" using 1:($3 > 0 ? $3 : 1.3e-8) with points linestyle 1 title "seen from within (no error: at the foot)"
