# Draw again with: gnuplot dmax-error.gp
set xlabel 'dmax [m]' noenhanced
set ylabel 'map error [m]'
set grid
set key outside top center horizontal noenhanced
set yrange [0:*]
set xrange [0.0192:0.0408]
set xtics noenhanced
set terminal pngcairo size 900,600
set output 'dmax-error.png'
plot 'dmax-error.dat' index 0 using 1:2:3 with yerrorlines linewidth 1.5 pointtype 7 pointsize 0.7 title 'mean and standard deviation'
set terminal svg size 900,600
set output 'dmax-error.svg'
plot 'dmax-error.dat' index 0 using 1:2:3 with yerrorlines linewidth 1.5 pointtype 7 pointsize 0.7 title 'mean and standard deviation'
unset output
