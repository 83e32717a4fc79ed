// SPDX-License-Identifier: GPL-3.0-or-later
// What a registration holds: the path, its graph and the local map.
#pragma once

#include <cstdint>
#include <limits>
#include <optional>
#include <span>
#include <vector>

#include "graph_editor.hpp"
#include "hitos/registration/laid_drawing.hpp"
#include "hitos/registration/odometry_step.hpp"
#include "hitos/registration/pose_graph_solver.hpp"
#include "hitos/registration/registration.hpp"
#include "key_graph.hpp"
#include "loop_closer.hpp"
#include "point_map.hpp"
#include "scan_matcher.hpp"
#include "step_matcher.hpp"

namespace hitos {

inline constexpr double kMapHalf = 45.0;    // [m], of the local map
inline constexpr double kOldKeysWay = 6.0;  // [m] along the graph, of old keys in the local map
inline constexpr double kBesideKey = kNearKey + 2.0;  // [m] how far they may lie as keys lie now

class Registration::Impl {
  public:
    Impl(const RegistrationParams& params, int threads)
        : params_(params),
          threads_(threads),
          matcher_(params.point_sigma_m),
          step_matcher_(params, matcher_),
          closer_(params, matcher_),
          editor_(parse_graph_edits(params.edits)) {}

    RegisteredStep add(const Scan& scan, std::span<const Control> controls);
    void finish(bool another_follows);
    void set_edits(const std::string& edits) {
        editor_.replace(parse_graph_edits(edits));
        params_.edits = edits;
    }
    bool foresee(const std::string& edits);
    LoopRecord fitted_loop(std::uint64_t scan, std::uint64_t earlier, const Pose& start) const;
    /// What can be drawn anew of the graph and takes a hundred megabytes.
    void drop_pictures() { closer_.rest(); }
    std::vector<Pose> path() const;

    RegistrationClock& clock() { return clock_; }
    const KeyGraph& graph() const { return graph_; }
    const std::vector<LoopRecord>& loops() const { return loops_; }
    const std::vector<LoopRecord>& refused_loops() const { return refused_; }
    std::span<const PoseEdge> told_edges() const;
    double chi_square() const { return tension(graph_.edges); }
    RegistrationFigures figures() const;
    const std::vector<SecondTour>& later_tours() const { return figures_.later_tours; }
    std::vector<ChangedPlace> changes() const;
    std::optional<PathCorrection> correction() const {
        if (corrections_.empty()) return std::nullopt;
        return PathCorrection{corrections_, graph_.poses, told_edges(), held_ > 0};
    }

  private:
    /// A scan hangs on the newest key of its time, or on the first one after the robot was carried.
    struct Placed {
        std::uint32_t key;
        Pose pose_key_scan;
    };

    /// An anchor or a fixed place in the graph, by how much it has bent it, and how much of that
    /// the graph explains.
    struct NotedChange {
        GraphEdit edit;
        double bent;
        double limit;
    };

    /// Where a scan was placed, from what the robot may have driven.
    struct Guess {
        Pose step;
        Eigen::Vector3d variances;
        Eigen::Matrix3d information;
        MatchedStep matched;
    };

    void step(const DrivenWay& way, bool slipped, RegisteredStep& out);
    Guess placed_by(const Pose& step, const Eigen::Vector3d& variances) const;
    std::optional<Guess> stood(const Pose& raw) const;
    void learn(const DrivenWay& way, const Guess& guess, const Pose& before);
    void refresh_map(const Pose& about);
    bool key_due() const;
    void add_key(std::uint64_t scan, const TourBegin* begin);
    void close_loop(std::vector<KeyPose>& before);
    LoopVerdict close(const LoopFound& found, LoopRecord& record);
    void note_closed(LoopRecord& record, std::vector<KeyPose> now, std::vector<KeyPose>& before,
                     std::size_t corrected = std::numeric_limits<std::size_t>::max());
    void doubt(std::uint64_t scan);
    void believe_where_it_fits(std::span<const Linearization> by_source);
    void believe(std::size_t earlier_key);
    void find_piece(std::vector<KeyPose>& before);
    void lay_piece(const Pose& pose);
    void leave_first_tour();
    void begin_second_tour(std::uint64_t scan, const TourBegin& begin);
    void note_found(const CarriedPiece& piece, std::uint64_t scan, std::uint64_t beside);
    std::vector<CarriedPiece>::iterator tour_not_found(std::size_t earlier_key);
    void lay_where_said(const Pose& pose, std::size_t from);
    GraphSolution solution(int iterations, bool robust) const {
        return {iterations, robust, held_};
    }
    void edit_graph(std::vector<KeyPose>& before);
    PoseEdge edge_by_hand(const GraphEdit& edit) const;
    PoseEdge anchor(const GraphEdit& edit) const;
    std::size_t number_of(const GraphEdit& edit) const;
    void expect_like_the_others(const GraphEdit& edit) const;
    void blame_one(const std::vector<KeyPose>& poses, double tension_before,
                   std::vector<double>& bent);
    void note_known_places(std::span<const GraphEdit> edits, std::span<const double> bent,
                           std::size_t edges);
    std::vector<AnchorFigures> anchor_figures() const;
    void tell_edges(bool anew);
    LoopRecord loop_by_hand(const GraphEdit& edit, const PoseEdge& edge);
    bool reaches_far(const GraphEdit& edit) const;
    void bend(const GraphEdit& edit);
    void unbend(const GraphEdit& edit);
    void part(const GraphEdit& edit);
    void say_of_step(std::uint64_t scan, std::span<const GraphEdit> edits);
    void weigh_loops();
    double tension(std::span<const PoseEdge> edges) const;
    double squared_distance(const PoseEdge& edge, const std::optional<LaidDrawing>& drawing) const;
    /// What closing something may add to the tension: three standard deviations in each direction,
    /// and the new edges' own.
    static double explained_chi_square(std::size_t edges) {
        return 3.0 * 9.0 + 3.0 * static_cast<double>(edges);
    }
    std::size_t newest_in_map() const { return static_cast<std::size_t>(params_.key_scans); }
    void correct(const std::vector<KeyPose>& keys_before);
    void register_anew(std::vector<std::vector<std::uint32_t>>& older);

    RegistrationParams params_;
    int threads_;
    ScanMatcher matcher_;
    StepMatcher step_matcher_;
    LoopCloser closer_;
    GraphEditor editor_;
    LateralCalibration calibration_;
    KeyGraph graph_;
    std::vector<Placed> placed_;  // by scan
    Pose now_;
    // Since the last key.
    Pose odometry_;
    Eigen::Vector3d odometry_variances_ = Eigen::Vector3d::Zero();
    double variance_m2_ = 0.0;
    double variance_rad2_ = 0.0;
    double travelled_m_ = 0.0;

    PointMap map_;
    std::vector<std::uint32_t> map_keys_;
    bool map_stale_ = true;
    bool in_crowd_ = false;  // of the map's older keys
    // Where the robot may have been carried, as long as nothing has told that it was not.
    std::vector<CarriedPiece> carried_;
    std::size_t held_ = 0;                    // keys that stay where they are
    std::vector<std::uint64_t> forced_keys_;  // scans that are keys by changes alone
    GraphWays ways_;                          // from the last key that was looked for
    std::vector<std::uint32_t> beside_;       // it, by the graph: what the local map may have
    std::vector<SurfacePoint> points_;
    std::vector<Linearization> by_source_;

    std::vector<Pose> corrections_;  // by scan, of the last add() or finish()
    std::vector<LoopRecord> loops_;
    std::vector<LoopRecord> refused_;
    std::vector<NotedChange> anchors_;
    std::vector<NotedChange> fixes_;
    std::vector<PoseEdge> told_;  // the graph's edges for who knows no drawing, where there is one
    std::size_t told_of_ = 0;     // how many of the graph's they are
    RegistrationFigures figures_;
    RegistrationClock clock_;
};

}  // namespace hitos
