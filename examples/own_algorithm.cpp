// SPDX-License-Identifier: GPL-3.0-or-later
// An algorithm of one's own: the robot is where the odometry says, and a feature within half a
// metre of a landmark is that landmark. It stands beside FastSLAM and EKF-SLAM, chosen by
// filter.algorithm.
//
// usage: own_algorithm LOG
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <exception>
#include <tuple>

#include "hitos/services/configuration/config_parameter.hpp"
#include "hitos/services/run/algoritmo.hpp"
#include "hitos/slam/filters.hpp"
#include "hitos/slam/robot.hpp"
#include "hitos/workbench/open_tour.hpp"

namespace {

class DeadReckoning final : public hitos::SlamFilter {
  public:
    void step(const hitos::SlamInput& input) override {
        pose_ = hitos::compose(pose_, hitos::sum_controls(input.controls).pose_start_end);
        history_.push_back(pose_);
        associations_.clear();
        const auto& [lines, corners] = std::tie(input.observation.lines, input.observation.corners);
        for (std::uint32_t i = 0; i < lines.size(); ++i) {
            note(lines_, hitos::transform(pose_, lines[i].recta), {hitos::FeatureKind::line, i});
        }
        for (std::uint32_t i = 0; i < corners.size(); ++i) {
            note(corners_, hitos::transform(pose_, corners[i]), {hitos::FeatureKind::corner, i});
        }
    }

    std::uint64_t steps() const override { return history_.size(); }
    hitos::Pose best_pose() const override { return pose_; }
    hitos::LandmarkMap best_map() const override {
        hitos::LandmarkMap map = lines_;
        map.insert(map.end(), corners_.begin(), corners_.end());
        return map;
    }
    std::vector<hitos::Pose> best_history() const override { return history_; }
    int best_count(hitos::FeatureKind kind) const override {
        return static_cast<int>((kind == hitos::FeatureKind::line ? lines_ : corners_).size());
    }
    std::span<const hitos::Association> associations() const override { return associations_; }
    std::vector<hitos::WeightedPose> hypotheses() const override { return {{pose_, 1.0}}; }
    hitos::FilterStatistics statistics() const override { return {1.0, 0.0}; }
    Eigen::Matrix3d pose_covariance() const override { return Eigen::Matrix3d::Zero(); }

  private:
    template <class Feature>
    void note(hitos::LandmarkMap& map, const Feature& feature, hitos::Association association) {
        using Outcome = hitos::Association::Outcome;
        hitos::ICaracteristica seen{feature, Eigen::Matrix2d::Zero(), 0};
        const auto near = [b = seen.point()](const hitos::ICaracteristica& known) {
            return std::hypot(known.point().x - b.x, known.point().y - b.y) < 0.5;
        };
        auto found = std::ranges::find_if(map, near);
        association.outcome = found == map.end() ? Outcome::created : Outcome::matched;
        if (found == map.end()) found = map.insert(map.end(), seen);
        ++found->observations;
        const auto place = static_cast<std::int32_t>(found - map.begin());
        const auto before = static_cast<std::int32_t>(&map == &corners_ ? lines_.size() : 0);
        association.landmark = before + place;  // lines stand first in the map
        associations_.push_back(association);
    }

    hitos::Pose pose_;
    std::vector<hitos::Pose> history_;
    hitos::LandmarkMap lines_;
    hitos::LandmarkMap corners_;
    std::vector<hitos::Association> associations_;
};

}  // namespace

int main(int argc, char** argv) {
    if (argc != 2) return std::fputs("usage: own_algorithm LOG\n", stderr), 2;
    try {
        hitos::slam_algorithms().add(
            {{"dead-reckoning", "Dead reckoning", "the pose by odometry alone"},
             [](const hitos::FilterParams&, std::uint64_t, int) {
                 return std::make_unique<DeadReckoning>();
             }});
        hitos::Configuracion configuration;
        configuration.source.file = argv[1];
        hitos::find_parameter("filter.algorithm").set(configuration, "dead-reckoning");
        hitos::Algoritmo run(configuration, hitos::open_tour(configuration.source));
        while (run.step()) {
        }
        std::printf("%s: %zu landmarks in %zu scans\n", configuration.filter.algorithm.c_str(),
                    run.filter().best_map().size(), run.steps());
        return 0;
    } catch (const std::exception& error) {
        std::fprintf(stderr, "own_algorithm: %s\n", error.what());
        return 1;
    }
}
