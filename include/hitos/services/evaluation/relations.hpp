// SPDX-License-Identifier: GPL-3.0-or-later
// Relations between poses, by which the SLAM benchmark of Kümmerle et al. measures a trajectory
// without a common frame: R. Kümmerle, B. Steder, C. Dornhege, M. Ruhnke, G. Grisetti, C.
// Stachniss, A. Kleiner, "On measuring the accuracy of SLAM algorithms", Autonomous Robots 27,
// 2009.
#pragma once

#include <filesystem>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "hitos/services/evaluation/error_figures.hpp"
#include "hitos/services/evaluation/measures.hpp"
#include "hitos/services/evaluation/pose_pairs.hpp"

namespace hitos {

/// Where the robot was at one time, seen from where it was at another: delta* of the paper, in the
/// plane.
struct PoseRelation {
    double from_s = 0.0;  ///< t1
    double to_s = 0.0;    ///< t2; may lie before t1
    Pose pose_from_to;
    friend bool operator==(const PoseRelation&, const PoseRelation&) = default;
};

/// A relation and what an estimate makes of it.
struct MeasuredRelation {
    PoseRelation relation;
    bool has_from = false;  ///< the estimate has a pose at t1
    bool has_to = false;    ///< and at t2
    /// Between the estimated poses; nothing where one of them is missing.
    std::optional<Pose> estimate_from_to;

    /// trans() and rot() of the paper for estimate ⊖ relation: the distance [m] between both, and
    /// the absolute angle [rad] in [0, pi]. 0 without an estimate.
    double translation_m() const;
    double rotation_rad() const;
};

/// Plain or gzip text, `t1 t2 x y z roll pitch yaw` a line, in the file's order; `#` comments and
/// empty lines are passed over. Times in seconds, lengths in metres, angles in radians; z, roll and
/// pitch must be numbers and are not used. Throws FileError, or FormatError with the line; a file
/// without any relation is an error.
std::vector<PoseRelation> read_relations(const std::filesystem::path& path);
/// As read_relations(), from text; `name` stands in messages.
std::vector<PoseRelation> parse_relations(std::string_view text, const std::string& name);

/// The same format, with the fewest digits that read back as the same bits. Throws Error for a
/// relation that is not finite.
std::string relations_text(std::span<const PoseRelation> relations);

/// What the trajectory says about those pairs of its poses. Throws nothing; pairs are of its size.
std::vector<PoseRelation> relations_of(const Trajectory& trajectory,
                                       std::span<const PosePair> pairs);

/// Each relation beside the estimate, whose poses are those with the stamps nearest to t1 and t2,
/// within the tolerance [s]; nothing is interpolated. A pose may serve any number of relations.
std::vector<MeasuredRelation> measure_relations(Trajectory estimate,
                                                std::span<const PoseRelation> relations,
                                                double tolerance_s = kSameStamp);

/// Over the relations that could be measured.
struct RelationErrors {
    int used = 0;
    int without_from = 0;  ///< the estimate has no pose at t1 alone
    int without_to = 0;    ///< at t2 alone
    int without_both = 0;
    ErrorFigures translation_m;
    ErrorFigures rotation_rad;
    ErrorFigures translation_squared_m2;  ///< of the squares, whose means the paper adds up
    ErrorFigures rotation_squared_rad2;
};
RelationErrors relation_errors(std::span<const MeasuredRelation> measured);

/// One row a relation, with the heading
/// `t1,t2,x_m,y_m,yaw_rad,slam_x_m,slam_y_m,slam_yaw_rad,translation_error_m,rotation_error_rad,missing`;
/// what was not measured is empty, and `missing` says at which time there is no pose.
std::string relations_csv(std::span<const MeasuredRelation> measured);

}  // namespace hitos
