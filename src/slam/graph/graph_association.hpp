// SPDX-License-Identifier: GPL-3.0-or-later
// Which landmark of the graph an observed feature belongs to.
#pragma once

#include <span>
#include <utility>
#include <vector>

#include "association/association.hpp"
#include "association/scan_twins.hpp"
#include "graph_window.hpp"

namespace hitos {

/// The pose of a scan beside the window's newest key.
struct BelievedPose {
    Pose pose;                             ///< of the robot in the world
    Matrix3 covariance = Matrix3::Zero();  ///< given the keys before the window
    Matrix3 by_key = Matrix3::Identity();  ///< d(pose)/d(newest key)
};

/// What became of an observed feature.
struct FoundFeature {
    FeatureKind kind = FeatureKind::line;
    std::uint32_t observed = 0;  ///< index in Observation::lines or ::corners
    Measurement measured;
    Point2 low, high;  ///< ends of what was seen of a line, in the robot's frame
    Association::Outcome outcome = Association::Outcome::ignored;
    Association::Reason reason = Association::Reason::between_gates;
    std::uint32_t landmark = 0;   ///< of the graph, where matched
    double log_likelihood = 0.0;  ///< where matched
    /// Where created: the feature before whose landmark this one belongs to too; or its own place.
    std::size_t first = 0;
};

/// Compares by gated nearest neighbour [T 5.3] with AssociationRule. Of lines only those are
/// compared that were seen from the same side and whose extents meet: infinite lines alone take two
/// walls in one direction, with a door between them, for one.
class GraphAssociation {
  public:
    /// Parts of a line that are at most this far apart meet [m]; half a door.
    static constexpr double kReach = 0.5;

    explicit GraphAssociation(const FilterParams& params);

    /// What it compares is added to `recorded`, where that is not null: landmarks of the graph.
    void find(const LandmarkGraph& graph, const GraphWindow& window, const BelievedPose& believed,
              const Observation& observation, std::vector<RecordedFeature>* recorded);
    const std::vector<FoundFeature>& found() const { return found_; }
    /// Pairs of lines that find() could not choose between, since what it saw covers a part of
    /// both.
    const std::vector<std::pair<std::uint32_t, std::uint32_t>>& bridged() const { return bridged_; }
    /// Whether a feature says itself that it is a landmark which the window does not reach.
    bool closes() const { return closes_; }
    /// Squared Mahalanobis distance of the gate.
    double gate() const { return rule_.gate(); }
    /// And of that from which on a feature is new.
    double new_gate() const { return new_gate_; }

  private:
    struct Candidate {
        std::uint32_t landmark = 0;
        double log_likelihood = 0.0;
        double shared_m = 0.0;  ///< of extents of lines
        double seen_m = 0.0;    ///< of the line itself, along this one
    };

    template <Sensor S>
    void find(const LandmarkGraph& graph, const GraphWindow& window, const BelievedPose& believed,
              FoundFeature& feature, std::vector<RecordedFeature>* recorded);
    /// The landmarks that a feature is compared with: the one that it says itself, where there is
    /// one, else those that can be reached.
    std::span<const std::uint32_t> compared(const LandmarkGraph& graph, const GraphWindow& window,
                                            const FoundFeature& feature);
    void note_bridges(const LandmarkGraph& graph, const BestTwo& inside);
    void find_twins();

    ObservationParams observation_;
    bool known_association_;
    AssociationRule rule_;
    double log_ratio_;
    ScanTwins twins_;
    double new_gate_;  ///< squared Mahalanobis distance beyond which a feature is of no landmark
    // Working memory of a scan.
    Measurements measurements_;
    std::vector<FoundFeature> found_;
    std::vector<Candidate> inside_;
    std::vector<std::uint32_t> known_;  // the landmark that a feature says, or none
    bool closes_ = false;
    std::vector<std::pair<std::uint32_t, std::uint32_t>> bridged_;
};

}  // namespace hitos
