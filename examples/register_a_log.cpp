// SPDX-License-Identifier: GPL-3.0-or-later
// Registration by itself: every scan is laid on those before it, loops are closed, and out comes a
// path. No filter and no landmarks.
//
// usage: register_a_log LOG PATH.tum
#include <cstdio>
#include <exception>
#include <memory>
#include <vector>

#include "hitos/registration/registration.hpp"
#include "hitos/services/files/trajectory_file.hpp"
#include "hitos/workbench/open_tour.hpp"

int main(int argc, char** argv) {
    if (argc != 3) {
        std::fprintf(stderr, "usage: register_a_log LOG PATH.tum\n");
        return 2;
    }
    try {
        hitos::SourceParams source;
        source.file = argv[1];
        const std::unique_ptr<hitos::TourReader> tour = hitos::open_tour(source);
        hitos::ControlTrack track([&] { return tour->next_odometry(); });
        hitos::Registration registration(hitos::RegistrationParams{});
        std::vector<hitos::Control> controls;
        hitos::Trajectory path;
        while (const auto scan = tour->next_scan()) {
            track.controls_until(*scan, controls);
            registration.add(*scan, controls);
            path.push_back({scan->stamp_s(), {}});
        }
        registration.finish();
        const std::vector<hitos::Pose> poses = registration.path();
        for (std::size_t i = 0; i < path.size(); ++i) path[i].pose = poses[i];
        hitos::write_trajectory(path, argv[2]);
        std::printf("%zu loops in %zu scans\n", registration.loops().size(), path.size());
        return 0;
    } catch (const std::exception& error) {
        std::fprintf(stderr, "register_a_log: %s\n", error.what());
        return 1;
    }
}
