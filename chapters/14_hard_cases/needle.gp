set title "A needle: what is wrong in one step is wrong by orders of magnitude"
set xlabel "time (s)"
set ylabel "energy by that at the start"
set logscale y
set format y "10^{%T}"
set termoption enhanced
set key below left Left reverse samplen 1.5 maxrows 3
plot for [i=2:5] "needle.tsv" using 1:i with lines linestyle i title columnhead(i), \
     "" using 1:6 with lines linestyle 1 title columnhead(6)
