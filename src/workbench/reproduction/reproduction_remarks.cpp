#include "reproduction_remarks.hpp"

namespace hitos {

std::string reproduction_introduction() {
    return R"(`hitos-cli reproduce` wrote this document. It runs every row of `data/results.csv` (chapter 10 of the
thesis, synthetic worlds) and sets error, variance and number of landmarks beside the thesis's:

```sh
hitos-cli reproduce --report docs/reproduction.md
```

* Fixed parameters: those of the thesis's table for that figure and no others; what a table does not
  name stays at the default. Infinite Neff is resampling after every scan.
* The motion numbers of the tables are taken as standard deviations per scan, the observation
  covariances as variances: no other reading gives errors and landmark counts like the thesis's.
* Tours: the worlds of `data/worlds`, laser sigma 3 mm, odometry with relative sigma 0.1 at 10 Hz. Run
  k of a value has seed k for the filter, the laser's noise and the odometry's noise.
* Error of a run: mean distance of its landmarks to the nearest true one of the same kind, no
  alignment. The thesis divides the variance by an unknown n or n - 1; ours is n - 1.
* The working range of a parameter is the one that the text of its section calls good, world by world
  where the text does so. In it the error should be at most 0.05 m above the thesis's, and the number
  of landmarks within 0.5 (complex: 1.5) of the true one.
* Outside it only the tendency counts: a row is harmed where it has no landmarks, 1.5 times the mean
  error of the working range and 0.05 m more, or a number of landmarks that is off by more than 1.

)";
}

std::string reproduction_remarks() {
    return R"(The thesis's tours, its simulator's settings and its program are not published, so figures can
agree in size and tendency only. What we know of the differences:

* **Lower errors in the working range.** Our tours begin northwards, so that walls across both
  directions fix the frame at once, and go round every loop at least twice. A tour that leaves
  eastwards sees nothing that fixes x for the first 11 m.
* **Few particles (`p` 5 to 20).** The thesis gets surplus landmarks, we hardly any: with the motion
  noise read as standard deviations a handful of particles still follows the robot. Why its filter
  loses the way sooner we do not know. In the larger worlds our error hardly depends on the number of
  particles; in `recinto` it falls up to 500.
* **Small `mpuntos`.** The thesis finds up to a hundred false lines with 3 points; we a few. Our
  extraction breaks a run of points at every ray without return, and in an ideal world with 3 mm of
  noise few short pieces are left to be taken for lines. What broke up its lines the thesis does not
  say.
* **Large `mpuntos` (25, 30).** All lines are found, but three or more corners of the inner blocks are
  not: a corner needs both of its walls in one scan with that many rays each, and where our tours see
  these corners one of the walls gives fewer. This is the one place in the working range where the
  number of landmarks misses by more than a little.
* **`dmax` 0.001.** Our laser has 3 mm of noise, more than the limit, so hardly a corner is found; the
  thesis's simulator had no noise and finds most. At 0.1 both are harmed, we less.
* **`mlon` 5.** How long a piece of wall a scan shows depends on the tour's distance from it; in
  `recinto` and `lineamedia` our tours still show 5 m of every wall, the thesis's did not.
* **Small `es`.** The thesis loses its corners below 0.1, we do not. Where two walls meet the
  extraction splits at a point that both lines keep, so the intersection lies on both of them; ours is
  then the true number of landmarks.
* **Large `es`.** The error agrees; we take more far intersections for corners than the thesis.
* **`sensor_rho` 0.001.** Too much trust in the observations makes surplus landmarks on both sides,
  fewer with us.
* **`p0` 10.** The thesis's map grows to 308 landmarks, ours by a few. With these covariances the
  likelihood of a perfect match is 23, so most observations still find their landmark; the thesis's
  program must have come to lower values.

Two variances in `data/results.csv` are not those that the text prints: `lineamedia`, `mlon` 1.2 (0.0019
in the text) and `bigloop2`, `sensor_theta` 0.005 (0.0059). They enter none of the counts.

)";
}

}  // namespace hitos
