// SPDX-License-Identifier: GPL-3.0-or-later
// A robot that a test drives.
#pragma once

#include "gui_fixture.hpp"
#include "world/live_drive.hpp"
#include "world/world_view.hpp"
#include "world/world_window.hpp"

namespace hitos::window {

/// A window whose robot is driven by the test, a control period at a time, so that nothing depends
/// on the machine's speed.
struct DriveFixture : Fixture {
    DriveFixture() : Fixture(false) {
        world_window().drive_through(write("room.toml", kRoom));
        drive().rest();
    }

    ~DriveFixture() {
        if (window) drive().give_up();
    }

    static constexpr const char* kRoom =
        "# A room with a door.\n"
        "walls = [[[-1, -2], [5, -2], [5, 3], [-1, 3], [-1, -2]]]  # all round\n"
        "doors = [[[2, -2], [2, 0]]]\n"
        "[tour]\n"
        "way_points = [[1, 0]]\n";

    WorldWindow& world_window() { return window->open_world_window(); }
    LiveDrive& drive() { return world_window().drive(); }
    void periods(int count) {
        for (int k = 0; k < count; ++k) drive().drive_period();
    }
    /// The run has come to where the robot is.
    bool caught_up() { return steps() == drive().tour()->scans() && shows_everything(); }
};

}  // namespace hitos::window
