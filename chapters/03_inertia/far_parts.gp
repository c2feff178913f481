set title "By way of the origin, a body's tensor loses digits with the square of the distance"
set xlabel "distance of the body from the model's origin (m)"
set ylabel "relative error of {/:Italic I} in float"
set logscale xy
set xrange [0.7:15000]
set yrange [1e-8:1e3]
set format x "10^{%T}"
set format y "10^{%T}"
unset key
set label 1 "by way of\nthe origin" at 70, 10 right textcolor linetype 2
set label 2 "one rounding, times the\nsquare of the distance" at 130, 3e-5 textcolor linetype 7
set label 3 "seen from within: no error" at 10, 1e-7 textcolor linetype 1
plot "far_parts.tsv" using 1:($2 > 0 ? $2 : NaN) with points linestyle 2, \
     1.2e-7*x**2 with lines linestyle 7, \
     "far_parts.tsv" using 1:($3 > 0 ? $3 : 1.3e-8) with points linestyle 1
