set terminal svg size 960,420 dynamic font "sans-serif,16" name name noenhanced background rgb "#fffffe"
set output name.".svg"
set multiplot layout 1,2
set title scene
set xlabel across." (m)"
set ylabel up." (m)"
plot for [k = 1:paths] sprintf("path%d.tsv", k) using 1:2 with lines linestyle k
set title "Energies"
set xlabel "time (s)"
set ylabel "energy (J)"
plot "energy.tsv" using 1:2 with lines linestyle 1, "" using 1:3 with lines linestyle 2, "" using 1:4 with lines linestyle 3
unset multiplot
