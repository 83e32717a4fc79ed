// SPDX-License-Identifier: GPL-3.0-or-later
// The readers of outside bytes, each as one function that a fuzzer calls.
#pragma once

#include <span>
#include <string_view>

namespace hitos::fuzz {

/// Reads the input and checks the laws of its reader. Returns whether the reader took it. What is
/// thrown is a defect of Hitos: a broken law, or an exception that is no hitos::Error.
using Check = bool(std::string_view input);

Check check_player;         ///< logs, by format
Check check_radish;         ///<
Check check_normalized;     ///<
Check check_carmen;         ///<
Check check_rosbag;         ///< ROS recordings, by container
Check check_mcap;           ///<
Check check_db3;            ///<
Check check_foxglove;       ///< frames of a running robot's server: 't' or 'b', then the frame
Check check_gzip;           ///< packed logs and texts; what is not packed is packed first
Check check_configuration;  ///< configuration files
Check check_world;          ///< worlds, beside a drawing of walls
Check check_world_edits;    ///< a world, and behind the first byte 0 what is done to it
Check check_drawing;        ///< drawings of walls
Check check_map;            ///< landmark maps
Check check_segments;       ///< segments of a map
Check check_distances;      ///< named distances
Check check_relations;      ///< relations between poses
Check check_map_server;     ///< YAML files of map_server, beside a picture
Check check_picture;        ///< pictures of walls
Check check_trajectory;     ///< TUM trajectories
Check check_graph;          ///< graphs in g2o's text, solved where they are small
Check check_study_plan;     ///< study.json
Check check_study_record;   ///< runs/*.json of a study
Check check_summary;        ///< summary.json in a folder of results
Check check_assignment;     ///< key=value of --set, of configurations and worlds
Check check_study_values;   ///< name=values, ranges and shards of a study
Check check_figures;        ///< the thesis's figures, results.csv

struct Target {
    std::string_view name;  ///< of its executable, its corpus and its dictionary
    Check* check;
};

/// All of them.
std::span<const Target> targets();

}  // namespace hitos::fuzz
