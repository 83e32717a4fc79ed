// SPDX-License-Identifier: GPL-3.0-or-later
// A world, a robot that drives through it, and what its laser and its wheels say: no file is
// written and nothing is mapped.
//
// usage: drive_through_a_world WORLD.toml
#include <cstdio>
#include <exception>
#include <memory>

#include "hitos/simulation/drive/simulated_tour.hpp"
#include "hitos/simulation/drive/simulated_tour_reader.hpp"
#include "hitos/simulation/worlds/world.hpp"

int main(int argc, char** argv) {
    if (argc != 2) {
        std::fprintf(stderr, "usage: drive_through_a_world WORLD.toml\n");
        return 2;
    }
    try {
        hitos::World world = hitos::read_world(argv[1]);
        world.laser.sigma_m = 0.0;  // an exact laser
        const auto tour = std::make_shared<const hitos::SimulatedTour>(world);
        hitos::SimulatedTourReader reader(tour);
        std::size_t scans = 0;
        std::size_t points = 0;
        while (const auto scan = reader.next_scan()) {
            ++scans;
            points += scan->points.size();
        }
        std::printf("%zu scans, %zu points\n", scans, points);
        return 0;
    } catch (const std::exception& error) {
        std::fprintf(stderr, "drive_through_a_world: %s\n", error.what());
        return 1;
    }
}
