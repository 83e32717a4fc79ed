// SPDX-License-Identifier: GPL-3.0-or-later
// What somebody changes by hand in the graph of a tour.
#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "hitos/base/error.hpp"
#include "hitos/base/geometry.hpp"

namespace hitos {

inline constexpr const char* kGraphEditsKey = "registration.edits";

/// [m] Of less of a drawing's wall nobody knows the direction.
inline constexpr double kShortestWall = 0.1;

/// A scan of the tour, from 0, with its stamp and its mark (ScanMark) where they were noted: a
/// change belongs to one tour.
struct EditedScan {
    std::uint64_t scan = 0;
    std::optional<double> stamp_s = std::nullopt;
    std::uint32_t mark = 0;
    friend bool operator==(const EditedScan&, const EditedScan&) = default;
};

/// A change by hand of the graph; scans are named by their numbers, from 0.
struct GraphEdit {
    enum class Kind : std::uint8_t {
        refuse,  ///< `scan` has not come back to `earlier`, nor have the next ones to its
                 ///< neighbours
        close,   ///< it has: `pose` is that of `scan` seen from `earlier`
        fix,     ///< `scan` was made at `pose` of the map
        slip,    ///< what the odometry says of the step to `scan` says nothing
        wall,    ///< the wall that `scan` sees at `bearing` is one of a drawing, from `left` to
                 ///< `right`
        point    ///< what `scan` has at `seen` is `left` of a drawing
    };
    Kind kind = Kind::refuse;
    EditedScan scan;
    EditedScan earlier = {};   ///< of refuse and close
    Pose pose = {};            ///< of close and fix [m, m, rad]
    std::string comment = {};  ///< why, or empty; on one line
    double bearing = 0.0;      ///< of wall, in the robot's frame [rad]
    Point2 seen = {};          ///< of point, in the robot's frame [m]
    /// Of wall, in the drawing's own frame: two places on it, as the robot sees them; of point the
    /// first alone [m].
    Point2 left = {};
    Point2 right = {};

    bool of_two() const { return kind == Kind::refuse || kind == Kind::close; }
    bool has_pose() const { return kind == Kind::close || kind == Kind::fix; }
    bool anchors() const { return kind == Kind::wall || kind == Kind::point; }
    /// Whether its scans have to be keys.
    bool needs_keys() const { return has_pose() || anchors(); }
    friend bool operator==(const GraphEdit&, const GraphEdit&) = default;
};

/// Standard deviations of what somebody says [m, m, rad]: as sure as an eye lays passages on each
/// other, or walls are where they are drawn, and as one is of a place that is known.
inline Eigen::Vector3d sigmas_by_hand(GraphEdit::Kind kind) {
    return kind == GraphEdit::Kind::fix ? Eigen::Vector3d(0.01, 0.01, 0.002)
                                        : Eigen::Vector3d(0.05, 0.05, 0.01);
}

/// "refuse", "close" …
std::string_view word_of(GraphEdit::Kind kind);
/// Nothing for another word.
std::optional<GraphEdit::Kind> edit_kind_of(std::string_view word);

/// Of "refuse 812@65.25 40; close 900 37 0.1 -0.2 1.57; fix 30 1 2 0; slip 55; wall 70 1.57 0 9 4
/// 9; point 80 2 -1 4 9": changes with semicolons or line ends between, each of a word, its scans,
/// counted from 1, with their stamps [s] and marks ("812@65.25~9f3a1c2b") where they are known, and
/// its numbers: a pose, a bearing
/// and a wall's left and right end, or a place seen and in the drawing; # begins a comment, which
/// the change before it on its line keeps. Throws ConfigError of kGraphEditsKey that says which one
/// is wrong.
std::vector<GraphEdit> parse_graph_edits(std::string_view text);
/// Reads back as the same, to the last bit.
std::string text_of(std::span<const GraphEdit> edits);

/// Changes of a file, and where each stands in it.
struct PlacedEdits {
    std::string file;
    std::vector<GraphEdit> edits = {};
    std::vector<std::uint64_t> lines = {};  ///< from 1
};
/// As parse_graph_edits(), of a graph from a file: in place of scans the ids of its poses, from 0
/// and in any order, without stamps. Throws FormatError of the file `name`.
PlacedEdits parse_vertex_edits(std::string_view text, const std::string& name);
/// The error that the change of that number, from 1, is wrong.
FormatError wrong_edit(const PlacedEdits& edits, std::size_t number, const Message& why);

/// Whether only one of two changes of scans can be so.
bool contradict(const GraphEdit& a, const GraphEdit& b);
/// Whether they do the same: but for stamps, marks and comments they are equal.
bool same_change(const GraphEdit& a, const GraphEdit& b);
/// Whether one of them does the same.
bool has_change(std::span<const GraphEdit> edits, const GraphEdit& edit);
/// How many scans come before the first that a change makes otherwise which is in one of the lists
/// alone. `keys` are the key scans of a run with the first list, in their order.
std::uint64_t untouched_scans(std::span<const GraphEdit> before, std::span<const GraphEdit> after,
                              std::span<const std::uint64_t> keys);

/// Throws ConfigError where a change is none, or two contradict each other.
void check_graph_edits(std::span<const GraphEdit> edits);

}  // namespace hitos
