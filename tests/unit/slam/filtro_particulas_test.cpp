// SPDX-License-Identifier: GPL-3.0-or-later
#include "fastslam/filtro_particulas.hpp"

#include <gtest/gtest.h>

#include <Eigen/Dense>
#include <random>
#include <set>

#include "hitos/base/error.hpp"
#include "hitos/slam/filters.hpp"
#include "hitos/slam/robot.hpp"
#include "resampling/methods.hpp"
#include "room_tour.hpp"
#include "same_beliefs.hpp"

namespace hitos {
namespace {

FilterParams room_params(int particles) {
    FilterParams params;
    params.particles = particles;
    return params;
}

/// FastSLAM 1.0 [T tables 3.2, 6.3] as slow and plain as can be: whole particles copied, weights
/// not in logarithms, every landmark evaluated; only the random draws are the filter's.
class SlowFastSlam {
  public:
    SlowFastSlam(const FilterParams& params, std::uint64_t seed)
        : params_(params),
          seed_(seed),
          robot_(make_robot(params.motion)),
          particles_(static_cast<std::size_t>(params.particles)) {}

    void step(const std::vector<Control>& controls, const Observation& observation) {
        const MotionIncrement increment = sum_controls(controls);
        for (std::size_t i = 0; i < particles_.size(); ++i) {
            RandomStream random(seed_, RandomPurpose::motion, step_, static_cast<std::uint32_t>(i));
            particles_[i].pose = step_ == 0 ? robot_->mean(particles_[i].pose, increment)
                                            : robot_->sample(particles_[i].pose, increment, random);
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
                       const Measurement& measured,
                       std::vector<std::pair<int, Measurement>>& todo) const {
        const auto& [z, r, identity] = measured;
        double best = params_.association.p0;
        double second = 0.0;
        int at = -1;
        for (std::size_t n = 0; n < known; ++n) {
            const Innovation nu = S::innovation(z, pose, map[n].mean);
            const Matrix2 q = nu.jacobian * map[n].covariance * nu.jacobian.transpose() + r;
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
        if (!ambiguous) todo.emplace_back(at, measured);
        return best;
    }

    template <class S>
    void apply(std::vector<LandmarkEstimate<S>>& map, const Pose& pose,
               const std::vector<std::pair<int, Measurement>>& todo) const {
        for (const auto& [at, measured] : todo) {
            const auto& [z, r, identity] = measured;
            if (at < 0) {
                const Matrix2 g = S::inverse_jacobian(pose, z);
                LandmarkEstimate<S> fresh{S::inverse(pose, z), g * r * g.transpose()};
                normalize(fresh);
                map.push_back(fresh);
                continue;
            }
            auto& landmark = map[static_cast<std::size_t>(at)];
            const Innovation nu = S::innovation(z, pose, landmark.mean);
            const Matrix2 h = nu.jacobian;
            const Matrix2 q = h * landmark.covariance * h.transpose() + r;
            const Matrix2 k = landmark.covariance * h.transpose() * q.inverse();
            landmark.mean = S::from_state(S::to_state(landmark.mean) + k * nu.nu);
            landmark.covariance = ((Matrix2::Identity() - k * h) * landmark.covariance).eval();
            normalize(landmark);
        }
    }

    void observe(Particle& particle, const Observation& observation) const {
        std::vector<std::pair<int, Measurement>> lines;
        std::vector<std::pair<int, Measurement>> corners;
        Measurements seen;
        measure(observation, params_.observation, seen);
        for (const Measurement& line : seen.of<SensorRecta>()) {
            particle.weight *= observe_one<SensorRecta>(particle.lines, particle.lines.size(),
                                                        particle.pose, line, lines);
        }
        for (const Measurement& corner : seen.of<SensorEsquina>()) {
            particle.weight *= observe_one<SensorEsquina>(particle.corners, particle.corners.size(),
                                                          particle.pose, corner, corners);
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

    FilterParams params_;
    std::uint64_t seed_;
    std::unique_ptr<Robot> robot_;
    std::uint64_t step_ = 0;
    std::vector<Particle> particles_;
    Particle best_;
};

void compare_with_slow(const FilterParams& params, const Tour& tour = make_tour(120, 0.1)) {
    FiltroParticulas fast(params, 5, 1);
    SlowFastSlam slow(params, 5);
    for (std::size_t k = 0; k < tour.controls.size(); ++k) {
        feed(fast, tour.controls[k], tour.observations[k]);
        slow.step(tour.controls[k], tour.observations[k]);
        if (tour.observations[k].empty()) continue;
        const auto& best = slow.best();
        const LandmarkMap map = fast.best_map();
        ASSERT_EQ(static_cast<std::size_t>(fast.best_count(FeatureKind::line)), best.lines.size())
            << "step " << k;
        ASSERT_EQ(static_cast<std::size_t>(fast.best_count(FeatureKind::corner)),
                  best.corners.size());
        ASSERT_NEAR(fast.statistics().best_log_weight, std::log(best.weight), 1e-6);
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
    FilterParams params = room_params(30);
    params.resampling.rule = ResamplingRule::neff;
    params.resampling.neff_threshold = 12.0;
    compare_with_slow(params);
}

TEST(FiltroParticulas, EqualsTheSlowAlgorithmWithProportionalNoise) {
    FilterParams params = room_params(40);
    params.motion.model = "proportional";
    params.observation = {0.001, 0.0001};
    compare_with_slow(params);
}

TEST(FiltroParticulas, EqualsTheSlowAlgorithmWithCovariancesOfItsOwnForEveryFeature) {
    compare_with_slow(room_params(30), with_covariances(make_tour(120, 0.1)));
}

TEST(FiltroParticulas, MapsTheRoom) {
    const Tour tour = make_tour(300, 0.1);
    FiltroParticulas filter(room_params(100), 1, 1);
    for (std::size_t k = 0; k < tour.controls.size(); ++k) {
        feed(filter, tour.controls[k], tour.observations[k]);
    }
    EXPECT_EQ(filter.best_count(FeatureKind::line), 4);
    EXPECT_EQ(filter.best_count(FeatureKind::corner), 4);
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
    constexpr std::size_t kParticles = 16000;  // enough work for every part of a step
    const Tour tour = make_tour(60, 0.1);
    FiltroParticulas alone(room_params(kParticles), 3, 1);
    std::vector<std::unique_ptr<FiltroParticulas>> others;
    for (const int threads : {2, 7}) {
        others.push_back(std::make_unique<FiltroParticulas>(room_params(kParticles), 3, threads));
    }
    for (std::size_t k = 0; k < tour.controls.size(); ++k) {
        feed(alone, tour.controls[k], tour.observations[k]);
        for (auto& other : others) {
            feed(*other, tour.controls[k], tour.observations[k]);
            ASSERT_EQ(other->history_nodes(), alone.history_nodes()) << k;
            ASSERT_EQ(other->best_hypothesis(), alone.best_hypothesis()) << k;
        }
    }
    for (const auto& other : others) {
        expect_same(*other, alone, kParticles);
        EXPECT_EQ(other->best_history(), alone.best_history());
        for (std::size_t i = 0; i < kParticles; i += 97) {
            EXPECT_EQ(other->history(i), alone.history(i));
        }
    }
}

TEST(FiltroParticulas, SameBitsWithAnyVectors) {
    const Tour tour = make_tour(80, 0.1);
    for (const char* model : {"odometry", "proportional"}) {
        FilterParams params = room_params(150);  // blocks that are full and one that is not
        params.motion.model = model;
        use_vectors(VectorTarget::sse2);
        FiltroParticulas plain(params, 3, 1);
        for (std::size_t k = 0; k < tour.controls.size(); ++k) {
            feed(plain, tour.controls[k], tour.observations[k]);
        }
        for (const VectorTarget target : {VectorTarget::avx2, VectorTarget::avx512}) {
            if (use_vectors(target) != target) continue;  // this machine has none
            FiltroParticulas wide(params, 3, 1);
            for (std::size_t k = 0; k < tour.controls.size(); ++k) {
                feed(wide, tour.controls[k], tour.observations[k]);
            }
            expect_same(wide, plain, 150);
        }
        use_vectors(VectorTarget::avx512);
    }
}

TEST(FiltroParticulas, SameBitsWhereSomebodyAsksWhatIsWeighed) {
    const Tour tour = make_tour(80, 0.1);
    for (const bool exclusive : {false, true}) {
        FilterParams params = room_params(100);
        params.association.exclusive = exclusive;
        FiltroParticulas asked(params, 3, 1);
        FiltroParticulas unasked(params, 3, 1);
        AssociationRecord record;
        const Scan scan;
        for (std::size_t k = 0; k < tour.controls.size(); ++k) {
            asked.step({scan, tour.controls[k], tour.observations[k], nullptr, &record});
            feed(unasked, tour.controls[k], tour.observations[k]);
        }
        expect_same(asked, unasked, 100);
    }
}

TEST(FiltroParticulas, AnotherSeedIsAnotherRun) {
    const Tour tour = make_tour(30, 0.1);
    FiltroParticulas a(room_params(50), 1, 1);
    FiltroParticulas b(room_params(50), 2, 1);
    for (std::size_t k = 0; k < tour.controls.size(); ++k) {
        feed(a, tour.controls[k], tour.observations[k]);
        feed(b, tour.controls[k], tour.observations[k]);
    }
    EXPECT_NE(a.best_pose(), b.best_pose());
}

TEST(FiltroParticulas, TheFirstScanAndRestDrawNoNoise) {
    FiltroParticulas filter(room_params(20), 1, 1);
    Observation seen;
    seen.lines.push_back({{3.0, 0.2}, 0, 0});
    for (int k = 0; k < 5; ++k) feed(filter, {}, seen);
    for (const WeightedPose& hypothesis : filter.hypotheses()) EXPECT_EQ(hypothesis.pose, Pose{});
    EXPECT_EQ(filter.best_count(FeatureKind::line), 1);
}

TEST(FiltroParticulas, NothingObservedMeansNothingResampled) {
    const Tour tour = make_tour(20, 0.1);
    FiltroParticulas filter(room_params(20), 1, 1);
    for (int k = 0; k < 10; ++k)
        feed(filter, tour.controls[static_cast<std::size_t>(k)], Observation{});
    EXPECT_EQ(filter.steps(), 10U);
    EXPECT_EQ(filter.best_history().size(), 10U);
    // All poses still differ: nobody was copied.
    const auto hypotheses = filter.hypotheses();
    for (std::size_t i = 1; i < hypotheses.size(); ++i) {
        EXPECT_NE(hypotheses[i].pose, hypotheses[0].pose);
    }
}

TEST(FiltroParticulas, OfEqualWeightsTheFirstIsTheBest) {
    FilterParams params = room_params(20);
    params.resampling = {ResamplingRule::neff, 0.0};  // never: particles keep their places
    FiltroParticulas filter(params, 1, 1);
    Observation seen;
    seen.lines.push_back({{3.0, 0.2}, 0, 0});
    feed(filter, {}, seen);  // all weigh p0
    const Control control{{0.4, 0.0, 0.1}, 0.2};
    feed(filter, std::span(&control, 1), Observation{});  // all part
    ASSERT_NE(filter.hypotheses().front().pose, filter.hypotheses().back().pose);
    EXPECT_EQ(filter.best_pose(), filter.hypotheses().front().pose);
}

TEST(FiltroParticulas, AnIgnoredObservationNamesNoLandmark) {
    FilterParams params = room_params(10);
    FiltroParticulas filter(params, 1, 1);
    Observation walls;
    walls.lines.push_back({{3.0, 0.0}, 0, 0});
    walls.lines.push_back({{3.5, 0.0}, 0, 0});
    feed(filter, {}, walls);
    const LandmarkMap before = filter.best_map();
    Observation between;
    between.lines.push_back({{3.26, 0.0}, 0, 0});
    feed(filter, {}, between);
    ASSERT_EQ(filter.associations().size(), 1U);
    EXPECT_EQ(filter.associations()[0].outcome, Association::Outcome::ignored);
    EXPECT_EQ(filter.associations()[0].landmark, -1);
    const LandmarkMap after = filter.best_map();
    ASSERT_EQ(after.size(), 2U);
    for (std::size_t i = 0; i < 2; ++i) {
        EXPECT_EQ(after[i].observations, 1);
        EXPECT_EQ(after[i].value, before[i].value);
        EXPECT_EQ(after[i].covariance, before[i].covariance);
    }
}

TEST(FiltroParticulas, EveryResamplingMethodMapsTheRoom) {
    const Tour tour = make_tour(150, 0.1);
    std::set<double> ends;
    for (const ResamplingMethodEntry& entry : resampling_methods().entries()) {
        FilterParams params = room_params(100);
        params.resampling.method = entry.word;
        FiltroParticulas filter(params, 1, 1);
        for (std::size_t k = 0; k < tour.controls.size(); ++k) {
            feed(filter, tour.controls[k], tour.observations[k]);
        }
        EXPECT_EQ(filter.best_count(FeatureKind::line), 4) << entry.word;
        EXPECT_EQ(filter.best_count(FeatureKind::corner), 4) << entry.word;
        EXPECT_NEAR(filter.best_pose().x, tour.truth.back().x, 0.3) << entry.word;
        ends.insert(filter.best_pose().x);
    }
    EXPECT_EQ(ends.size(), 4U);  // each draws in its own way
}

TEST(FiltroParticulas, MemoryDoesNotGrowWithCopies) {
    const Tour tour = make_tour(400, 0.1);
    FiltroParticulas filter(room_params(100), 1, 1);
    for (std::size_t k = 0; k < tour.controls.size(); ++k) {
        feed(filter, tour.controls[k], tour.observations[k]);
    }
    EXPECT_LE(filter.map_leaves(), 2U * (100U + 2U * 80U));  // with those that two blocks keep
    EXPECT_LT(filter.history_nodes(), 400U + 100U * 60U);    // 40,000 without sharing
}

TEST(FiltroParticulas, AssociationsOfTheBestAreTold) {
    FiltroParticulas filter(room_params(10), 1, 1);
    Observation seen;
    seen.lines.push_back({{3.0, 0.2}, 0, 0});
    seen.corners.push_back({2.0, 1.0});
    feed(filter, {}, seen);
    ASSERT_EQ(filter.associations().size(), 2U);
    EXPECT_EQ(filter.associations()[0].outcome, Association::Outcome::created);
    EXPECT_EQ(filter.associations()[1].kind, FeatureKind::corner);
    EXPECT_EQ(filter.associations()[1].landmark, 1);
    feed(filter, {}, seen);
    EXPECT_EQ(filter.associations()[0].outcome, Association::Outcome::matched);
    EXPECT_EQ(filter.associations()[0].landmark, 0);
    EXPECT_EQ(filter.associations()[1].landmark, 1);
}

// Multinomial and stratified resampling may leave no copy of the best.
TEST(FiltroParticulas, AssociationsAreOfTheMapThatIsShownWhateverResamplingLeaves) {
    int checked = 0;
    for (const char* method : {"multinomial", "stratified"}) {
        for (std::uint64_t seed = 1; seed <= 20; ++seed) {
            FilterParams params = room_params(4);
            params.resampling.method = method;
            params.association.p0 = 5.0;  // so that maps differ
            params.motion.sigma_x_m = params.motion.sigma_y_m = 0.3;
            params.motion.sigma_theta_rad = 0.15;
            FiltroParticulas filter(params, seed, 1);
            const Tour tour = make_tour(40, 0.4);
            for (std::size_t k = 0; k < tour.controls.size(); ++k) {
                feed(filter, tour.controls[k], tour.observations[k]);
                const LandmarkMap map = filter.best_map();
                for (const Association& association : filter.associations()) {
                    if (association.landmark < 0) continue;
                    ASSERT_LT(static_cast<std::size_t>(association.landmark), map.size());
                    const ICaracteristica& landmark =
                        map[static_cast<std::size_t>(association.landmark)];
                    EXPECT_EQ(landmark.kind(), association.kind);
                    EXPECT_EQ(landmark.last_seen, k) << method << ", seed " << seed;
                    ++checked;
                }
            }
        }
    }
    EXPECT_GT(checked, 1000);
}

TEST(FiltroParticulas, RefusesImpossibleParameters) {
    EXPECT_THROW(make_filter(room_params(0), 1, 1), ConfigError);
    FilterParams params = room_params(1);
    params.association.p0 = 0.0;
    EXPECT_THROW(make_filter(params, 1, 1), ConfigError);
}

}  // namespace
}  // namespace hitos
