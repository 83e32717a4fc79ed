#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-3.0-or-later
# Installs what is missing, builds, and opens the window on the ready tour in data/. Without a
# display it maps the same tour from the command line; the results lie in out/. Arguments go to the
# program. It installs and builds the one program that it runs, and says before about how long that takes.
set -euo pipefail
cd "$(dirname "$0")"

program=hitos-cli window=OFF lists=(program) seconds=420 # of processor time, to compile it from nothing
if [ -n "${DISPLAY:-}${WAYLAND_DISPLAY:-}" ]; then
    program=hitos window=ON lists+=(window) seconds=720
fi
if [ ! -x build/release/bin/$program ]; then
    minutes=$((seconds / $(nproc) / 60 + 1))
    echo "Hitos: installs the packages that are missing of $(printf '.ci/packages/%s ' "${lists[@]}")" \
        "(about two minutes where all are), builds build/release/bin/$program (about $minutes minutes" \
        "on $(nproc) processors) and runs it."
fi
.ci/install-packages "${lists[@]}"
cmake --preset release --log-level=WARNING -DHITOS_WINDOW=$window -DHITOS_PYTHON=OFF -DHITOS_TESTS=OFF
cmake --build --preset release --target $program

if [ $window = ON ]; then
    exec build/release/bin/hitos "$@"
fi
tour=(data/bigloop-noisy.log.gz --config config/thesis.cfg --reference data/maps/bigloop.map)
build/release/bin/hitos-cli run "${tour[@]}" --out out/bigloop --replace "$@"
echo "Open out/bigloop/grid_best.png and out/bigloop/grid_odometry.png to compare them."
