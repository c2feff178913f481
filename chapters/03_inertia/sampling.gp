set title "How many particles does half the error take?"
set xlabel "particles"
set ylabel "relative error of the tensor"
set logscale xy
set format x "10^{%T}"
set format y "10^{%T}"
set termoption enhanced
plot "sampling.tsv" using 1:3 with lines linestyle 7 title "power of the count, fitted", \
     "sampling.tsv" using 1:2 with points linestyle 1 title "random places, RMS of 100 seeds", \
     "lattice.tsv" using 1:2 with linespoints linestyle 2 title "lattice"
