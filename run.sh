#!/usr/bin/env bash
# Installs what is missing, builds, and maps the ready tour in data/; the results lie in out/.
set -euo pipefail
cd "$(dirname "$0")"

.ci/install-packages
cmake --preset release --log-level=WARNING
cmake --build --preset release --target hitos-cli

cli=build/release/bin/hitos-cli
mkdir -p out
# The recorded odometry is perfect; the thesis adds noise to it, so that there is work to do.
"$cli" convert data/bigloop.log.gz --to normalized --odometry-noise 0.1 --seed 3 \
    --out out/bigloop-noisy.log.gz
"$cli" run out/bigloop-noisy.log.gz --config config/simulated.cfg \
    --reference data/maps/bigloop.map --out out/bigloop "$@"
echo "Open out/bigloop/grid_best.png and out/bigloop/grid_odometry.png to compare them."
