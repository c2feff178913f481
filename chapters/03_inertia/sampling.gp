set title "A lattice needs far fewer particles than chance does"
set xlabel "particles"
set ylabel "relative error of the tensor"
set logscale xy
set format x "10^{%T}"
set format y "10^{%T}"
unset key
set label 1 "random places, RMS of\n100 seeds, and a fitted power" at 900, 0.4 textcolor linetype 1
set label 2 "lattice" at 200, 4e-3 textcolor linetype 2
plot "sampling.tsv" using 1:3 with lines linestyle 7, \
     "sampling.tsv" using 1:2 with points linestyle 1, \
     "lattice.tsv" using 1:2 with linespoints linestyle 2
