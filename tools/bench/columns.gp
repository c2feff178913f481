@drawing 480,330
set title "Columns a power of two apart begin at the same place in the cache"
set xlabel "place in a cache of 64 places, each as wide as a line"
set ylabel "column"
set xrange [-2:64]
set yrange [0:20]
set xtics 16
set ytics 5
set key off noautotitle
# 4096 floats are 256 lines; the loop's own columns have one line more between their beginnings.
columns = 19
place(n, lines) = int(n * lines) % 64
set samples columns
set label 1 "256 lines\napart" at 1.5, 17.5 left textcolor linetype 2
set label 2 "257 lines apart" at 17.5, 13 left textcolor linetype 1
plot sample [0:columns - 1] "+" using (place(int($1 + 0.5), 256)):($1 + 1) with points linetype 2, \
     [0:columns - 1] "+" using (place(int($1 + 0.5), 257)):($1 + 1) with points linetype 1
