// SPDX-License-Identifier: GPL-3.0-or-later
// What the particle filter is made of, where it is known which landmark every observation is of.

#include <random>

#include "fastslam/particle_block.hpp"
#include "hitos/slam/robot.hpp"
#include "models/map_store.hpp"
#include "speed_workloads.hpp"

namespace speed {
namespace {

using namespace hitos;
using S = SensorEsquina;

constexpr std::size_t kPoints = 560;
constexpr std::size_t kSeen = 17;
constexpr std::size_t kLanes = LaneBatch<S>::kLanes;

/// Particles with maps of their own, each of all points.
class Particles {
  public:
    explicit Particles(std::size_t count) : maps_(false), poses_(count) {
        std::mt19937 engine(7);
        std::uniform_real_distribution<double> place(-50.0, 50.0);
        for (std::size_t i = 0; i < kPoints; ++i) points_.push_back({place(engine), place(engine)});
        const Matrix2 sure = 1e-3 * Matrix2::Identity();
        for (std::size_t m = 0; m < count; ++m) {
            auto landmarks = maps_.landmarks<S>(maps_.create());
            for (const Esquina& point : points_) landmarks.set(landmarks.append(), {point, sure});
        }
    }
    std::size_t count() const { return poses_.size(); }

    /// Everybody moves a centimetre, with noise.
    void predict(std::uint64_t step) {
        const Control control{{0.05, 0.0, 0.02}, 0.2};
        const MotionIncrement increment = sum_controls(std::span(&control, 1));
        for (std::size_t first = 0; first < count(); first += kLanes) {
            const RandomRow row{1, RandomPurpose::motion, step, static_cast<std::uint32_t>(first)};
            robot_->sample_row(std::span(poses_).subspan(first, lanes_from(first)), increment, row);
        }
    }
    /// Everybody sees seventeen of the points: likelihoods and updates.
    void update(std::uint64_t step) {
        for (std::size_t first = 0; first < count(); first += kLanes) {
            for (std::size_t j = 0; j < kSeen; ++j) {
                see((step * 31 + j * 33) % kPoints, first, lanes_from(first));
            }
        }
        keep(log_likelihood_);
    }

  private:
    std::size_t lanes_from(std::size_t first) const { return std::min(kLanes, count() - first); }
    void see(std::size_t landmark, std::size_t first, std::size_t lanes) {
        const Vector2 z = S::predict(poses_[first], points_[landmark]);
        const LaneObservation seen{z(0), z(1), 4e-4, 0.0, 1e-4};
        std::array<double*, kLanes> values{};
        for (std::size_t k = 0; k < lanes; ++k) {
            auto landmarks = maps_.landmarks<S>(first + k);
            values.at(k) = landmarks.own_leaf_of(landmark).values.data() + landmark % 8;
            batch_.load(k, values.at(k), poses_[first + k]);
        }
        batch_.compare(lanes, seen);
        batch_.update(lanes, seen);
        for (std::size_t k = 0; k < lanes; ++k) {
            batch_.store(k, values.at(k));
            log_likelihood_ += batch_.log_likelihoods[k];
        }
    }

    LaneBatch<S> batch_{};
    MapStore maps_;
    std::vector<Pose> poses_;
    std::vector<Esquina> points_;
    double log_likelihood_ = 0.0;
    std::unique_ptr<Robot> robot_ = make_robot([] {
        MotionParams params;
        params.model = "proportional";
        return params;
    }());
};

}  // namespace

void measure_kernels(const Options& options) {
    Particles particles(static_cast<std::size_t>(options.particles));
    const auto count = static_cast<double>(options.particles * options.steps);
    std::uint64_t step = 0;
    const Cost prediction = cheapest(
        options.seconds / 2.0, [] {},
        [&] {
            for (int i = 0; i < options.steps; ++i) particles.predict(++step);
        });
    print_per(prediction, count, "prediction");
    const Cost update = cheapest(
        options.seconds, [] {},
        [&] {
            for (int i = 0; i < options.steps; ++i) particles.update(++step);
        });
    print_per(update, count * kSeen, "update");
}

}  // namespace speed
