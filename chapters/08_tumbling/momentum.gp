@drawing 600,430
set output name.".svg"
set multiplot
set label 99 "Without torque the angular momentum must not turn" at screen 0.5, 0.97 center font "sans-serif,18"
set xrange [0:60]
set yrange [0:4]
set ytics 2
set xtics 20
set size 0.47, 0.42
unset key
rule(n) = word("4 5 2 7", n)
names = "|L|_restored implicit steady splitting"
do for [n=1:4] {
  set origin 0.04 + 0.5*((n - 1) % 2), n < 3 ? 0.5 : 0.06
  if (n > 2) { set xlabel "time (s)" } else { unset xlabel }
  if (n % 2) { set ylabel "turn of {/:Italic L} (degree)" } else { unset ylabel }
  set label 1 (n == 1 ? "|{/:Italic L}| restored" : word(names, n)) at 2, 3.6 left textcolor linetype word("2 3 5 1", n) + 0
  plot "momentum.tsv" using 1:(column(rule(n) + 0)) with lines linetype (word("2 3 5 1", n) + 0) linewidth (n == 4 ? 2.6 : 1.2) dashtype solid
  unset label 99
}
unset multiplot
