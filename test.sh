#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-3.0-or-later
# Installs what is missing, builds, and runs every test; with the name of a part that part's alone, built
# source by source for those who change it (preset dev).
#
# usage: ./test.sh [PART…] [-DNAME=VALUE…] [ctest's options]
# PART: base, capture, features, registration, slam, simulation, services, workbench, fuzz, integration,
#       programs, window, python
set -euo pipefail
cd "$(dirname "$0")"

parts='base|capture|features|registration|slam|simulation|services|workbench|fuzz|integration|programs'
wanted=() settings=() targets=() lists=(program tests)
while [ $# -gt 0 ]; do
    case $1 in
        window) wanted+=(gui_) targets+=(test_gui) settings+=(-DHITOS_WINDOW=ON) lists+=(window) ;;
        python) wanted+=(python) targets+=(hitos_python) settings+=(-DHITOS_PYTHON=ON) ;;
        -D*) settings+=("$1") ;;
        *) [[ $1 =~ ^($parts)$ ]] || break
            wanted+=("test_$1") targets+=("test_$1") ;;
    esac
    shift
done

if [ ${#wanted[@]} -gt 0 ]; then
    .ci/install-packages "${lists[@]}"
    cmake --preset dev --log-level=WARNING "${settings[@]}"
    cmake --build --preset dev --target "${targets[@]}"
    for part in "${wanted[@]}"; do
        case $part in
            test_*) build/dev/tests/"$part" --gtest_brief=1 ;;
            *) ctest --preset dev -j "$(nproc)" -R "^$part" "$@" ;;
        esac
    done
    exit
fi
if [ ! -d build/release/tests ]; then
    echo "Hitos: installs the packages that are missing of .ci/packages/{program,window,tests} (about three" \
        "minutes where all are), builds everything (about $((1500 / $(nproc) / 60 + 1)) minutes on $(nproc)" \
        "processors) and runs every test (about $((600 / $(nproc) / 60 + 1)) minutes)."
fi
.ci/install-packages program window tests
cmake --preset release --log-level=WARNING -DHITOS_TESTS=ON -DHITOS_WINDOW=ON "${settings[@]}"
cmake --build --preset release
ctest --preset release -j "$(nproc)" "$@"
