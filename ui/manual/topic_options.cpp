// SPDX-License-Identifier: GPL-3.0-or-later
#include "manual/topic_options.hpp"

namespace hitos::manual {

void add_topic_options(CLI::App& program, TopicChoices& choices) {
    program.add_option("--scan-topic", choices.scan_topic,
                       "Laser topic of a ROS recording with several: one, several with commas "
                       "between them, or all");
    program.add_option("--odom-topic", choices.odom_topic,
                       "Odometry topic of a ROS recording with several, or tf for its transforms");
    program
        .add_option("--same-frames", choices.same_frames,
                    "Frames of a ROS recording that are one: base_footprint=base_link, several "
                    "with commas between them")
        ->type_name("A=B");
    program
        .add_option("--laser-pose", choices.laser_pose,
                    "Where the laser sits on the robot, whatever the log says: metres ahead, "
                    "metres to the left, degrees to the left, and upside-down where it does")
        ->type_name("X,Y,DEGREES[,upside-down]");
    program
        .add_option(
            "--scan-delay", choices.scan_delay,
            "Seconds to add to the scans' times, as check advises, or where their clock "
            "runs at another speed or was set SECONDS@SECOND of the tour,…; hitos-cli looks "
            "for them where it is auto (default: 0)")
        ->type_name("SECONDS");
}

void add_map_options(CLI::App& program, ValueChoices& choices) {
    CLI::Option* map = program.add_option(
        "--map", choices.map,
        "Folder with the results of a run: the robot, which may begin anywhere in its map, is "
        "found in it, and the map goes on with this tour. With that run's parameters unless "
        "--config or --preset say others");
    program
        .add_flag("--localise", choices.localise,
                  "Of the map of --map change nothing: find the robot in it and follow it")
        ->needs(map);
    program
        .add_option("--near", choices.near,
                    "Where in that map this tour begins, give or take 3 m and 30 degrees, for "
                    "places that look alike (default: anywhere)")
        ->type_name("X,Y,DEGREES")
        ->needs(map);
}

}  // namespace hitos::manual
