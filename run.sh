#!/usr/bin/env bash
# Installs what is missing, builds, and opens the window on the ready tour in data/. Without a
# display it maps the same tour from the command line; the results lie in out/. Arguments go to the
# program.
set -euo pipefail
cd "$(dirname "$0")"

.ci/install-packages
cmake --preset release --log-level=WARNING
window=
if [ -n "${DISPLAY:-}${WAYLAND_DISPLAY:-}" ]; then window=hitos; fi
cmake --build --preset release --target hitos-cli $window

cli=build/release/bin/hitos-cli
if [ -n "$window" ]; then
    exec build/release/bin/hitos "$@"
fi
tour=(data/bigloop-noisy.log.gz --config config/thesis.cfg --reference data/maps/bigloop.map)
"$cli" run "${tour[@]}" --out out/bigloop "$@"
echo "Open out/bigloop/grid_best.png and out/bigloop/grid_odometry.png to compare them."
