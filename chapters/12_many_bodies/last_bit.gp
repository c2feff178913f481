@drawing 480,380
set title "Change one bit of one number, and half a minute later the motion is different"
set xlabel "time (s)"
set ylabel "distance (m)"
set logscale y
set format y "10^{%T}"
set yrange [1e-16:10]
set ytics 1e-15, 1e5
unset key
set label 1 "float" at 9.5, 1e-4 left textcolor linetype 2
set label 2 "double" at 19, 1e-7 left textcolor linetype 1
seen(x) = x > 0 ? x : NaN
plot "last_bit.tsv" using 1:(seen($2)) with lines linetype 2, "" using 1:(seen($3)) with lines linetype 1
