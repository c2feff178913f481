@drawing 520,330
set title "The same bits, in a fraction of the time"
set xlabel "time for one body and one step (ns)"
unset key
set border 1
set ytics scale 0
set yrange [2.7:-0.6]
set grid noytics
set xrange [0:*]
set rmargin 12
set xtics 100
ns(x) = x < 10 ? sprintf("%.1f", x) : sprintf("%.0f", x)
named(n, words) = n == 0 ? " in ".words : "" # beside the first two bars
plot "prize.tsv" using (0.5 * $2):($0 - 0.19):(0.5 * $2):(0.17):ytic(1) with boxxyerror linetype 1 dashtype solid fillstyle solid 0.85 noborder, \
     "" using (0.5 * $3):($0 + 0.19):(0.5 * $3):(0.17) with boxxyerror linetype 2 dashtype solid fillstyle solid 0.85 noborder, \
     "" using 2:($0 - 0.19):(sprintf("  %s%s", ns($2), named($0, "float"))) with labels left textcolor linetype 1, \
     "" using 3:($0 + 0.19):(sprintf("  %s%s", ns($3), named($0, "double"))) with labels left textcolor linetype 2
