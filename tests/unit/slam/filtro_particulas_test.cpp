#include "filtro_particulas.hpp"

#include <gtest/gtest.h>

#include <Eigen/Dense>
#include <random>

#include "hitos/capture/error.hpp"
#include "hitos/slam/filters.hpp"

namespace hitos {
namespace {

/// A square room driven round: exact observations of its walls and corners, noisy odometry.
struct Tour {
    std::vector<std::vector<Control>> controls;
    std::vector<Observation> observations;
    std::vector<Pose> truth;
};

Tour make_tour(int steps, double odometry_error) {
    const std::vector<Recta> walls{{5.0, 0.0}, {5.0, kPi / 2}, {5.0, kPi}, {5.0, -kPi / 2}};
    const std::vector<Esquina> corners{{5, 5}, {-5, 5}, {-5, -5}, {5, -5}};
    std::mt19937 engine(53);
    std::normal_distribution<double> normal(0.0, 1.0);
    Tour tour;
    Pose pose;
    for (int k = 0; k < steps; ++k) {
        const Control control{{0.4, 0.0, 0.15}, k == 0 ? 0.0 : 0.2};
        pose = compose(pose, displacement(control.twist, control.duration_s));
        Control logged = control;
        logged.twist.v *= 1.0 + odometry_error * normal(engine);
        logged.twist.w *= 1.0 + odometry_error * normal(engine);
        tour.controls.push_back({logged});
        tour.truth.push_back(pose);
        Observation seen;
        if (k % 7 != 3) {  // every seventh scan shows nothing
            for (const Recta& wall : walls) {
                Recta local = transform(inverse(pose), wall);
                local.rho = std::abs(local.rho + 0.01 * normal(engine));
                local.theta = wrap_angle(local.theta + 0.003 * normal(engine));
                if (std::abs(local.theta) < 1.6) seen.lines.push_back({local, 0, 0});
            }
            for (const Esquina& corner : corners) {
                Esquina local = transform(inverse(pose), corner);
                local.x += 0.01 * normal(engine);
                local.y += 0.01 * normal(engine);
                if (local.x > 0.0) seen.corners.push_back(local);
            }
        }
        tour.observations.push_back(seen);
    }
    return tour;
}

FastSlamParams room_params(int particles) {
    FastSlamParams params;
    params.particles = particles;
    return params;
}

/// FastSLAM 1.0 [T tables 3.2, 6.3] as slow and plain as can be: whole particles copied, weights
/// not in logarithms, every landmark evaluated; only the random draws are the filter's.
class SlowFastSlam {
  public:
    SlowFastSlam(const FastSlamParams& params, std::uint64_t seed)
        : params_(params),
          seed_(seed),
          robot_(params.motion),
          particles_(static_cast<std::size_t>(params.particles)) {
        r_ << params.observation.var_rho_m2, 0.0, 0.0, params.observation.var_theta_rad2;
    }

    void step(const std::vector<Control>& controls, const Observation& observation) {
        const MotionIncrement increment = sum_controls(controls);
        for (std::size_t i = 0; i < particles_.size(); ++i) {
            RandomStream random(seed_, RandomPurpose::motion, step_, static_cast<std::uint32_t>(i));
            particles_[i].pose = step_ == 0 ? robot_.mean(particles_[i].pose, increment)
                                            : robot_.sample(particles_[i].pose, increment, random);
            particles_[i].path.push_back(particles_[i].pose);
        }
        if (!observation.empty()) {
            for (auto& particle : particles_) observe(particle, observation);
            best_ = particles_[0];
            for (const auto& particle : particles_) {
                if (particle.weight > best_.weight) best_ = particle;
            }
            resample();
        }
        ++step_;
    }

    struct Particle {
        Pose pose;
        double weight = 1.0;
        std::vector<LandmarkEstimate<SensorRecta>> lines;
        std::vector<LandmarkEstimate<SensorEsquina>> corners;
        std::vector<Pose> path;
    };
    const Particle& best() const { return best_; }
    const std::vector<Particle>& particles() const { return particles_; }

  private:
    template <class S>
    double observe_one(std::vector<LandmarkEstimate<S>>& map, std::size_t known, const Pose& pose,
                       const Vector2& z, std::vector<std::pair<int, Vector2>>& todo) const {
        double best = params_.association.p0;
        double second = 0.0;
        int at = -1;
        for (std::size_t n = 0; n < known; ++n) {
            const Innovation nu = S::innovation(z, pose, map[n].mean);
            const Matrix2 q = nu.jacobian * map[n].covariance * nu.jacobian.transpose() + r_;
            const double w = std::exp(-0.5 * nu.nu.dot(q.inverse() * nu.nu)) /
                             (2.0 * kPi * std::sqrt(q.determinant()));
            if (w > best) {
                second = at >= 0 ? best : 0.0;
                best = w;
                at = static_cast<int>(n);
            } else if (at >= 0) {
                second = std::max(second, w);
            }
        }
        const bool ambiguous = at >= 0 && second > params_.association.p0 &&
                               second > params_.association.ambiguity_ratio * best;
        if (!ambiguous) todo.emplace_back(at, z);
        return best;
    }

    template <class S>
    void apply(std::vector<LandmarkEstimate<S>>& map, const Pose& pose,
               const std::vector<std::pair<int, Vector2>>& todo) const {
        for (const auto& [at, z] : todo) {
            if (at < 0) {
                const Matrix2 g = S::inverse_jacobian(pose, z);
                LandmarkEstimate<S> fresh{S::inverse(pose, z), g * r_ * g.transpose()};
                S::normalize(fresh.mean, fresh.covariance);
                map.push_back(fresh);
                continue;
            }
            auto& landmark = map[static_cast<std::size_t>(at)];
            const Innovation nu = S::innovation(z, pose, landmark.mean);
            const Matrix2 h = nu.jacobian;
            const Matrix2 q = h * landmark.covariance * h.transpose() + r_;
            const Matrix2 k = landmark.covariance * h.transpose() * q.inverse();
            landmark.mean = S::from_state(S::to_state(landmark.mean) + k * nu.nu);
            landmark.covariance = ((Matrix2::Identity() - k * h) * landmark.covariance).eval();
            S::normalize(landmark.mean, landmark.covariance);
        }
    }

    void observe(Particle& particle, const Observation& observation) const {
        std::vector<std::pair<int, Vector2>> lines;
        std::vector<std::pair<int, Vector2>> corners;
        for (const auto& line : observation.lines) {
            particle.weight *=
                observe_one<SensorRecta>(particle.lines, particle.lines.size(), particle.pose,
                                         SensorRecta::measurement(line.recta), lines);
        }
        for (const auto& corner : observation.corners) {
            particle.weight *=
                observe_one<SensorEsquina>(particle.corners, particle.corners.size(), particle.pose,
                                           SensorEsquina::measurement(corner), corners);
        }
        apply<SensorRecta>(particle.lines, particle.pose, lines);
        apply<SensorEsquina>(particle.corners, particle.pose, corners);
    }

    void resample() {
        double sum = 0.0;
        for (const auto& particle : particles_) sum += particle.weight;
        std::vector<double> weights;
        for (const auto& particle : particles_) weights.push_back(particle.weight / sum);
        if (params_.resampling.rule == ResamplingRule::neff &&
            effective_particles(weights) >= params_.resampling.neff_threshold) {
            return;
        }
        const double r = RandomStream(seed_, RandomPurpose::resampling, step_, 0).uniform();
        std::vector<std::uint32_t> selected;
        low_variance_selection(weights, r, selected);
        std::vector<Particle> next;
        for (const auto i : selected) {
            next.push_back(particles_[i]);
            next.back().weight = 1.0;
        }
        particles_ = next;
    }

    FastSlamParams params_;
    std::uint64_t seed_;
    Robot robot_;
    Matrix2 r_;
    std::uint64_t step_ = 0;
    std::vector<Particle> particles_;
    Particle best_;
};

void compare_with_slow(const FastSlamParams& params) {
    const Tour tour = make_tour(120, 0.1);
    FiltroParticulas fast(params, 5, 1);
    SlowFastSlam slow(params, 5);
    for (std::size_t k = 0; k < tour.controls.size(); ++k) {
        fast.step(tour.controls[k], tour.observations[k]);
        slow.step(tour.controls[k], tour.observations[k]);
        if (tour.observations[k].empty()) continue;
        const auto& best = slow.best();
        const LandmarkMap map = fast.best_map();
        ASSERT_EQ(static_cast<std::size_t>(fast.best_lines()), best.lines.size()) << "step " << k;
        ASSERT_EQ(static_cast<std::size_t>(fast.best_corners()), best.corners.size());
        ASSERT_NEAR(fast.best_pose().x, best.pose.x, 1e-6);
        ASSERT_NEAR(fast.best_pose().theta, best.pose.theta, 1e-6);
        for (std::size_t i = 0; i < best.lines.size(); ++i) {
            const auto& line = std::get<Recta>(map[i].value);
            ASSERT_NEAR(line.rho, best.lines[i].mean.rho, 1e-6);
            ASSERT_NEAR(wrap_angle(line.theta - best.lines[i].mean.theta), 0.0, 1e-6);
            ASSERT_LT((map[i].covariance - best.lines[i].covariance).cwiseAbs().maxCoeff(), 1e-6);
        }
        for (std::size_t i = 0; i < best.corners.size(); ++i) {
            const auto& corner = std::get<Esquina>(map[best.lines.size() + i].value);
            ASSERT_NEAR(corner.x, best.corners[i].mean.x, 1e-6);
        }
        const auto history = fast.best_history();
        ASSERT_EQ(history.size(), best.path.size());
        ASSERT_NEAR(history[k / 2].x, best.path[k / 2].x, 1e-6);
    }
}

TEST(FiltroParticulas, EqualsTheSlowAlgorithm) {
    compare_with_slow(room_params(30));
}

TEST(FiltroParticulas, EqualsTheSlowAlgorithmWithNeff) {
    FastSlamParams params = room_params(30);
    params.resampling.rule = ResamplingRule::neff;
    params.resampling.neff_threshold = 12.0;
    compare_with_slow(params);
}

TEST(FiltroParticulas, EqualsTheSlowAlgorithmWithProportionalNoise) {
    FastSlamParams params = room_params(40);
    params.motion.model = MotionModel::proportional;
    params.observation = {0.001, 0.0001};
    compare_with_slow(params);
}

TEST(FiltroParticulas, MapsTheRoom) {
    const Tour tour = make_tour(300, 0.1);
    FiltroParticulas filter(room_params(100), 1, 1);
    for (std::size_t k = 0; k < tour.controls.size(); ++k) {
        filter.step(tour.controls[k], tour.observations[k]);
    }
    EXPECT_EQ(filter.best_lines(), 4);
    EXPECT_EQ(filter.best_corners(), 4);
    EXPECT_NEAR(filter.best_pose().x, tour.truth.back().x, 0.2);
    EXPECT_NEAR(filter.best_pose().y, tour.truth.back().y, 0.2);
    for (const ICaracteristica& landmark : filter.best_map()) {
        if (const auto* line = std::get_if<Recta>(&landmark.value)) {
            EXPECT_NEAR(line->rho, 5.0, 0.25);
        }
        EXPECT_GT(landmark.observations, 50);
        EXPECT_GT(landmark.covariance.determinant(), 0.0);
    }
}

TEST(FiltroParticulas, SameBitsForAnyNumberOfThreads) {
    const Tour tour = make_tour(60, 0.1);
    const FastSlamParams params = room_params(1500);  // enough work for parallel steps
    std::vector<std::vector<Pose>> histories;
    std::vector<LandmarkMap> maps;
    for (const int threads : {1, 2, 7}) {
        FiltroParticulas filter(params, 3, threads);
        for (std::size_t k = 0; k < tour.controls.size(); ++k) {
            filter.step(tour.controls[k], tour.observations[k]);
        }
        histories.push_back(filter.best_history());
        maps.push_back(filter.best_map());
    }
    for (std::size_t i = 1; i < maps.size(); ++i) {
        EXPECT_EQ(histories[i], histories[0]);
        ASSERT_EQ(maps[i].size(), maps[0].size());
        for (std::size_t k = 0; k < maps[0].size(); ++k) {
            EXPECT_EQ(maps[i][k].value, maps[0][k].value);
            EXPECT_EQ(maps[i][k].covariance, maps[0][k].covariance);
        }
    }
}

TEST(FiltroParticulas, AnotherSeedIsAnotherRun) {
    const Tour tour = make_tour(30, 0.1);
    FiltroParticulas a(room_params(50), 1, 1);
    FiltroParticulas b(room_params(50), 2, 1);
    for (std::size_t k = 0; k < tour.controls.size(); ++k) {
        a.step(tour.controls[k], tour.observations[k]);
        b.step(tour.controls[k], tour.observations[k]);
    }
    EXPECT_NE(a.best_pose(), b.best_pose());
}

TEST(FiltroParticulas, TheFirstScanAndRestDrawNoNoise) {
    FiltroParticulas filter(room_params(20), 1, 1);
    Observation seen;
    seen.lines.push_back({{3.0, 0.2}, 0, 0});
    for (int k = 0; k < 5; ++k) filter.step({}, seen);
    for (const WeightedPose& hypothesis : filter.hypotheses()) EXPECT_EQ(hypothesis.pose, Pose{});
    EXPECT_EQ(filter.best_lines(), 1);
}

TEST(FiltroParticulas, NothingObservedMeansNothingResampled) {
    const Tour tour = make_tour(20, 0.1);
    FiltroParticulas filter(room_params(20), 1, 1);
    for (int k = 0; k < 10; ++k)
        filter.step(tour.controls[static_cast<std::size_t>(k)], Observation{});
    EXPECT_FALSE(filter.statistics().resampled);
    EXPECT_EQ(filter.steps(), 10U);
    EXPECT_EQ(filter.best_history().size(), 10U);
    // All poses still differ: nobody was copied.
    const auto hypotheses = filter.hypotheses();
    for (std::size_t i = 1; i < hypotheses.size(); ++i) {
        EXPECT_NE(hypotheses[i].pose, hypotheses[0].pose);
    }
}

TEST(FiltroParticulas, MemoryDoesNotGrowWithCopies) {
    const Tour tour = make_tour(400, 0.1);
    FiltroParticulas filter(room_params(100), 1, 1);
    for (std::size_t k = 0; k < tour.controls.size(); ++k) {
        filter.step(tour.controls[k], tour.observations[k]);
    }
    EXPECT_LE(filter.map_blocks(), 101U);
    EXPECT_LT(filter.history_nodes(), 400U + 100U * 60U);  // 40,000 without sharing
}

TEST(FiltroParticulas, AssociationsOfTheBestAreTold) {
    FiltroParticulas filter(room_params(10), 1, 1);
    Observation seen;
    seen.lines.push_back({{3.0, 0.2}, 0, 0});
    seen.corners.push_back({2.0, 1.0});
    filter.step({}, seen);
    ASSERT_EQ(filter.associations().size(), 2U);
    EXPECT_EQ(filter.associations()[0].outcome, Association::Outcome::created);
    EXPECT_EQ(filter.associations()[1].kind, FeatureKind::esquina);
    EXPECT_EQ(filter.associations()[1].landmark, 1);
    filter.step({}, seen);
    EXPECT_EQ(filter.associations()[0].outcome, Association::Outcome::matched);
    EXPECT_EQ(filter.associations()[0].landmark, 0);
    EXPECT_EQ(filter.associations()[1].landmark, 1);
}

TEST(FiltroParticulas, RefusesImpossibleParameters) {
    EXPECT_THROW(make_fastslam(room_params(0), 1, 1), ConfigError);
    FastSlamParams params = room_params(1);
    params.association.p0 = 0.0;
    EXPECT_THROW(make_fastslam(params, 1, 1), ConfigError);
}

}  // namespace
}  // namespace hitos
