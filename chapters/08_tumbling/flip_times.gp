set title "A tenth of the wobble, the same wait more for each flip"
set xlabel "wobble / spin"
set ylabel "from flip to flip (s)"
set logscale x
set xrange [1:1e-8] reverse
set format x "10^{%T}"
set termoption enhanced
set yrange [0:12]
set key below left Left reverse maxrows 2
plot "flip_times.tsv" using 1:4 with lines linestyle 4 title "2 ln(1/wobble)/κ", \
     "flip_times.tsv" using 1:2 with lines linestyle 7 title "exact, elliptic", \
     "flip_times.tsv" using 1:3 with points linestyle 1 title "stepped"
