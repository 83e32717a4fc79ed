// SPDX-License-Identifier: GPL-3.0-or-later
// The true, the odometry's and the estimated path over the map [P fig 3b].
#pragma once

#include <filesystem>
#include <optional>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "hitos/base/message.hpp"
#include "hitos/services/files/line_extents.hpp"

namespace hitos {

/// What the picture shows, all in the map's frame.
struct PathsPicture {
    Trajectory truth;
    Trajectory odometry;
    Trajectory estimate;
    LandmarkMap map;
    std::vector<LineExtent> segments;
    Walls walls;  ///< true ones, where they are known
};

/// The part of a reference trajectory that belongs to a run, moved so that both begin alike: its
/// pose at the stamp nearest to the run's first becomes the run's first pose. The frame of the map
/// is fixed by that pose, while a reference may have any. Empty where no stamp is within 0.5 s of
/// the first. Of a run of several tours the first of these that it has counts.
/// `pose_reference_run`, where given, says instead how the frames lie: an error of the first
/// heading would move a long tour's far end by metres.
Trajectory in_frame_of_run(const Trajectory& reference, const Trajectory& run,
                           const std::optional<Pose>& pose_reference_run = std::nullopt);

/// Draws paths.png by gnuplot, with its script (paths.gp): the true path blue, the odometry
/// magenta, the estimate black, segments green, corners red, true walls grey; equal axes in metres.
/// Returns why there is no picture, else an empty text. Throws FileError.
Message write_paths_picture(const PathsPicture& picture, const std::filesystem::path& folder);

}  // namespace hitos
