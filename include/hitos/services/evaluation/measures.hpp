// SPDX-License-Identifier: GPL-3.0-or-later
// How good a map or a trajectory is [T 10.3].
#pragma once

#include <optional>

#include "hitos/services/files/map_file.hpp"
#include "hitos/services/files/trajectory_file.hpp"

namespace hitos {

/// Stamps of an estimate and of a reference that are no further apart [s] are of one moment, where
/// nothing else is asked for.
inline constexpr double kSameStamp = 0.02;

/// A landmark further away than this from all of a reference map is none of these [m]: ten
/// times a wall's error, and less than the way from one to the next; docs/evaluation.md has errors
/// of maps.
inline constexpr double kSameLandmark = 1.0;

/// Errors of a landmark map against a reference map.
struct MapError {
    double mean_m = 0.0;  ///< [T 10.3]: mean over the landmarks of the distance to the nearest
                          ///< reference landmark of the same kind
    double maximum_m = 0.0;
    int landmarks = 0;  ///< landmarks compared
    int lines = 0;
    int corners = 0;
    int without_reference = 0;  ///< landmarks of a kind that the reference lacks; not in the mean
    int reference_landmarks = 0;
    /// Reference landmarks that are the nearest of some landmark within kSameLandmark; or of one of
    /// the same identity, however far.
    int reference_found = 0;
};

/// Whether both maps say which landmarks they hold (ICaracteristica::identity).
bool have_identities(const LandmarkMap& map, const LandmarkMap& reference);

/// Nothing where no landmark can be compared. Where both maps have identities, a landmark is
/// compared with that of its own.
std::optional<MapError> map_error(const LandmarkMap& map, const LandmarkMap& reference);

/// The rigid motion that takes the map nearest to the reference (least squares over the pairs of
/// map_error, found anew until they no longer change), and the error after it. It takes the
/// frame's error at the start out of the figure. The search starts at no motion and only goes
/// downhill: neither the sum of squares nor the mean is greater than without alignment, which stays
/// where it is the better one. What the map does not
/// fix (the way along parallel lines) stays as it is. Where both maps say which landmarks they
/// hold, it starts at the best motion of these, however far that is.
struct AlignedMapError {
    Pose pose_reference_map;
    MapError error;
};
std::optional<AlignedMapError> aligned_map_error(const LandmarkMap& map,
                                                 const LandmarkMap& reference);

/// Absolute trajectory error after the best rigid alignment without scale (Horn 1987; Umeyama
/// 1991), over the poses at whose stamps the reference tells where the robot was: between two of
/// its poses that are no more than 0.5 s apart, or twice `tolerance_s`, it is interpolated; else
/// the stamps have to agree within `tolerance_s`, nearest first, every pose once. Where the
/// positions do not fix a rotation (a robot at rest) there is none. Nothing where no stamps agree.
struct TrajectoryError {
    double rmse_m = 0.0;  ///< ATE: root mean square distance
    double mean_m = 0.0;
    double maximum_m = 0.0;
    std::optional<double> heading_rmse_rad;  ///< nothing where the reference has no headings
    int poses = 0;                           ///< pairs compared
    Pose pose_reference_estimate;
};
std::optional<TrajectoryError> trajectory_error(const Trajectory& estimate,
                                                const Trajectory& reference,
                                                double tolerance_s = kSameStamp);

}  // namespace hitos
