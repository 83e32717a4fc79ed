// SPDX-License-Identifier: GPL-3.0-or-later
// Maps a recorded tour: log in, landmarks and path out.
//
// usage: map_a_log LOG MAP.txt PATH.tum
#include <cstdio>
#include <exception>

#include "hitos/services/configuration/config_parameter.hpp"
#include "hitos/services/files/map_file.hpp"
#include "hitos/services/files/trajectory_file.hpp"
#include "hitos/services/run/algoritmo.hpp"
#include "hitos/workbench/open_tour.hpp"

int main(int argc, char** argv) {
    if (argc != 4) {
        std::fprintf(stderr, "usage: map_a_log LOG MAP.txt PATH.tum\n");
        return 2;
    }
    try {
        hitos::Configuracion configuration;  // the thesis's recommended values
        configuration.source.file = argv[1];
        hitos::find_parameter("split_merge.min_points").set(configuration, "9");
        configuration.filter.particles = 200;

        hitos::Algoritmo run(configuration, hitos::open_tour(configuration.source));
        while (run.step()) {
        }
        hitos::write_map(run.filter().best_map(), argv[2]);
        hitos::write_trajectory(run.best_trajectory(), argv[3]);
        std::printf("%zu landmarks in %zu scans\n", run.filter().best_map().size(), run.steps());
        return 0;
    } catch (const std::exception& error) {
        std::fprintf(stderr, "map_a_log: %s\n", error.what());
        return 1;
    }
}
