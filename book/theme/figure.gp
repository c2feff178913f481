# What every figure shares. The colours are names that the book's style sheet turns into its own, light or dark.
set terminal svg size 640,400 dynamic font "sans-serif,14" name name noenhanced background rgb "white"
set output name.".svg"
set datafile separator "\t"
set key autotitle columnhead
