# Draw again with: gnuplot landmarks.gp
set xlabel 'split_merge.dmax [m]' noenhanced
set ylabel 'landmarks'
set grid
set key outside top center horizontal noenhanced
set yrange [0:*]
set xrange [0.0192:0.0408]
set xtics noenhanced
set terminal pngcairo size 900,600
set output 'landmarks.png'
plot 'landmarks.dat' index 0 using 1:2:3 with yerrorlines linewidth 1.5 pointtype 7 pointsize 0.7 title 'mean and standard deviation', \
     16 with lines dashtype 2 linecolor 'black' title 'in the reference'
set terminal svg size 900,600
set output 'landmarks.svg'
plot 'landmarks.dat' index 0 using 1:2:3 with yerrorlines linewidth 1.5 pointtype 7 pointsize 0.7 title 'mean and standard deviation', \
     16 with lines dashtype 2 linecolor 'black' title 'in the reference'
unset output
