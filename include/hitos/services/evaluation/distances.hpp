// SPDX-License-Identifier: GPL-3.0-or-later
// Named distances between parallel walls, measured in a map and true [P table 1].
#pragma once

#include <filesystem>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "hitos/features/caracteristica.hpp"

namespace hitos {

/// A distance to measure: a point on each of two parallel walls, opposite each other, in the
/// reference frame [m]. The true distance is that of the two points.
struct NamedDistance {
    std::string name;
    Point2 a;
    Point2 b;
    double true_m() const;
    friend bool operator==(const NamedDistance&, const NamedDistance&) = default;
};

/// Two points nearer to each other [m] are no distance.
inline constexpr double kLeastDistance = 1e-3;
/// A wall whose normal is further [rad] off the direction from one point to the other is not it.
inline constexpr double kGreatestTurn = 15.0 * kPi / 180.0;

/// Whether a file can name a distance so: a word without commas, quotes and `#`.
bool is_distance_name(std::string_view name);

/// One a line, `name x1 y1 x2 y2`; names are words, each once, without commas and quotes; `#`
/// comments and empty lines are passed over; plain or gzip. Throws FileError, or FormatError naming
/// the line, what was found and expected: two points of a distance are at least 1 mm apart, and a
/// file without any distance is an error.
std::vector<NamedDistance> read_distances(const std::filesystem::path& path);

/// As read_distances(), from text; `name` stands in messages.
std::vector<NamedDistance> parse_distances(std::string_view text, const std::string& name);

/// The text of such a file, which reads back to the last bit. Throws Error where it could not be
/// read: a name that is none or stands twice, points that are no distance apart, or no distance.
std::string distances_text(std::span<const NamedDistance> distances);

/// What a map makes of a distance.
struct MeasuredDistance {
    NamedDistance distance;
    std::optional<double> slam_m;  ///< nothing where a line is missing
    int line_a = -1;               ///< index in the map of the line at a; -1: none
    int line_b = -1;
    std::string missing;  ///< why there is no slam_m

    std::optional<double> error_m() const;        ///< slam - true, with its sign
    std::optional<double> error_percent() const;  ///< of the true distance, without sign, as [P]
};

/// The line of the map that passes nearest to a point, at most `greatest_m` away, and whose normal
/// is at most kGreatestTurn off `normal_rad`; its index, -1 where there is none.
int nearest_line(const LandmarkMap& map, const Point2& point, double normal_rad, double greatest_m);

/// The point of the line nearest to a point.
Point2 projected(const Recta& line, const Point2& point);

/// At each point the line of the map that passes nearest to it, at most 0.5 m and half the true
/// distance away, and whose normal is at most 15 degrees off the direction from a to b. Two points
/// that find the same line have none. The distance is the mean of two readings of a tape: from the
/// foot of a's perpendicular on the first line to the second line, and from b's to the first, which
/// treats both alike where the lines are not quite parallel. Map and reference share their frame.
std::vector<MeasuredDistance> measure_distances(const LandmarkMap& map,
                                                std::span<const NamedDistance> distances);

/// The table as people read it, like [P table 1], with the means over what was found.
std::string distance_table(std::span<const MeasuredDistance> measured);

/// The table as CSV: name, true_m, slam_m, error_m, error_percent, line_a, line_b; the lines by
/// their place in the map file, from 1; what is missing is empty.
std::string distances_csv(std::span<const MeasuredDistance> measured);

}  // namespace hitos
