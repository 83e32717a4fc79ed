// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include <Eigen/Dense>
#include <random>

#include "fastslam/filtro_particulas.hpp"
#include "hitos/slam/proposal.hpp"
#include "hitos/slam/robot.hpp"
#include "models/map_store.hpp"
#include "registered_tour.hpp"

namespace hitos {
namespace {

using Eigen::Matrix3d;
using Eigen::MatrixXd;
using Eigen::Vector3d;
using Eigen::VectorXd;

FilterParams posterior_params() {
    FilterParams params;
    params.proposal = "posterior";
    params.motion.sigma_x_m = 0.2;
    params.motion.sigma_y_m = 0.3;
    params.motion.sigma_theta_rad = 0.05;
    params.observation = {1e-3, 1e-4};
    params.association.p0 = 1e-6;
    return params;
}

double log_density(const VectorXd& x, const VectorXd& mean, const MatrixXd& covariance) {
    const VectorXd away = x - mean;
    return -0.5 * away.dot(covariance.inverse() * away) -
           0.5 * std::log((2.0 * kPi * covariance).determinant());
}

/// A particle's map of three walls, of which each is at a right angle to the one before.
class MapOfWalls {
  public:
    explicit MapOfWalls(double var_rho, double var_theta) {
        handle_ = maps_.create();
        auto lines = maps_.landmarks<SensorRecta>(handle_);
        for (const Recta& wall : {Recta{5.0, 0.0}, Recta{4.0, kPi / 2.0}, Recta{6.0, kPi}}) {
            Matrix2 covariance;
            covariance << var_rho, 0.0, 0.0, var_theta;
            lines.set(lines.append(), {wall, covariance});
        }
    }
    ParticleMap map() const { return {maps_, handle_}; }

  private:
    MapStore maps_;
    MapStore::Handle handle_ = 0;
};

/// A step 1 m ahead after which two walls are seen, not quite where they should be.
struct Step {
    Step() {
        seen.lines.push_back({{3.93, 0.02}, 0, 0});
        seen.lines.push_back({{4.05, kPi / 2.0 + 0.03}, 0, 0});
    }
    SlamInput input() const { return {scan, std::span(&control, 1), seen}; }

    Scan scan;
    Control control{{1.0, 0.0, 0.0}, 1.0};
    Observation seen;
    Pose before;
};

Vector3d vector_of(const Pose& pose) {
    return {pose.x, pose.y, pose.theta};
}

/// The walls' h is linear in the pose, so the posterior is the Gaussian that information adds up
/// to: [table 13.3], Sigma_x = [H' Q^-1 H + P^-1]^-1, mu_x = x + Sigma_x H' Q^-1 (z - h(x)).
struct Dense {
    Dense(const Step& step, const FilterParams& params, double var_rho, double var_theta) {
        const auto robot = make_robot(params.motion);
        const MotionIncrement increment = sum_controls(std::span(&step.control, 1));
        prior = vector_of(robot->mean(step.before, increment));
        p = robot->noise_covariance(step.before, increment);
        Matrix3d information = p.inverse();
        Vector3d weighted = Vector3d::Zero();
        const std::array<Recta, 2> walls{Recta{5.0, 0.0}, Recta{4.0, kPi / 2.0}};
        MatrixXd h(4, 3);
        MatrixXd q = MatrixXd::Zero(4, 4);
        VectorXd nu(4);
        for (Eigen::Index i = 0; i < 2; ++i) {
            const Recta& wall = walls.at(static_cast<std::size_t>(i));
            const Recta& seen = step.seen.lines.at(static_cast<std::size_t>(i)).recta;
            const double c = std::cos(wall.theta);
            const double s = std::sin(wall.theta);
            h.middleRows<2>(2 * i) << -c, -s, 0.0, 0.0, 0.0, -1.0;
            nu.segment<2>(2 * i) << seen.rho - (wall.rho - prior(0) * c - prior(1) * s),
                seen.theta - (wall.theta - prior(2));
            q(2 * i, 2 * i) = params.observation.var_rho_m2 + var_rho;
            q(2 * i + 1, 2 * i + 1) = params.observation.var_theta_rad2 + var_theta;
        }
        information += h.transpose() * q.inverse() * h;
        weighted = h.transpose() * q.inverse() * nu;
        covariance = information.inverse();
        mean = prior + covariance * weighted;
        evidence = log_density(nu, VectorXd::Zero(4), h * p * h.transpose() + q);
    }
    Vector3d prior;
    Matrix3d p;
    Vector3d mean;
    Matrix3d covariance;
    double evidence;  ///< ln p(z), the weight of [table 13.3]
};

TEST(PosteriorProposal, DrawsFromTheDensePosterior) {
    // Landmarks whose angle is known: no lever, so that h of the landmark is linear too.
    const FilterParams params = posterior_params();
    const Step step;
    const Dense dense(step, params, 2e-3, 0.0);
    const MapOfWalls walls(2e-3, 0.0);
    const auto proposal = proposals().find("posterior").make(params);
    proposal->begin(step.input(), false);
    Vector3d sum = Vector3d::Zero();
    Matrix3d squares = Matrix3d::Zero();
    constexpr std::uint32_t kDraws = 20000;
    for (std::uint32_t i = 0; i < kDraws; ++i) {
        RandomStream random(3, RandomPurpose::motion, 1, i);
        const ParticleMap map = walls.map();
        const ProposedPose drawn = proposal->draw({step.before, map}, random);
        const Vector3d x = vector_of(drawn.pose);
        sum += (x - dense.mean) / kDraws;
        squares += (x - dense.mean) * (x - dense.mean).transpose() / kDraws;
        // The correction of the weight is the quotient of the densities ...
        const double log_motion = log_density(x, dense.prior, dense.p);
        const double log_drawn = log_density(x, dense.mean, dense.covariance);
        ASSERT_NEAR(drawn.log_weight, log_motion - log_drawn, 1e-6);
        // ... so that with the likelihood at the drawn pose every draw weighs p(z).
        double log_likelihood = 0.0;
        const std::array<Recta, 2> known{Recta{5.0, 0.0}, Recta{4.0, kPi / 2.0}};
        for (std::size_t k = 0; k < 2; ++k) {
            const Innovation seen = SensorRecta::innovation(
                SensorRecta::measurement(step.seen.lines[k].recta), drawn.pose, known.at(k));
            Matrix2 q = Matrix2::Zero();
            q(0, 0) = 1e-3 + 2e-3;
            q(1, 1) = 1e-4;
            log_likelihood += log_density(seen.nu, Vector2::Zero(), q);
        }
        ASSERT_NEAR(drawn.log_weight + log_likelihood, dense.evidence, 1e-6);
    }
    for (int i = 0; i < 3; ++i) {
        EXPECT_NEAR(sum(i), 0.0, 5.0 * std::sqrt(dense.covariance(i, i) / kDraws));
        for (int j = 0; j < 3; ++j) {
            EXPECT_NEAR(squares(i, j), dense.covariance(i, j),
                        0.05 * std::sqrt(dense.covariance(i, i) * dense.covariance(j, j)));
        }
    }
    EXPECT_LT(dense.covariance(0, 0), 0.1 * dense.p(0, 0));  // the walls say a lot
}

TEST(PosteriorProposal, AssociatesWithThePosesUncertainty) {
    // 0.4 m off: hopeless for a landmark known to millimetres from the predicted pose, two sigmas
    // once that is unsure by 0.2 m.
    FilterParams params = posterior_params();
    Step step;
    step.seen.lines.resize(1);
    step.seen.lines[0].recta = {3.6, 0.0};
    const MapOfWalls walls(1e-4, 1e-6);
    const auto drawn_x = [&] {
        const auto proposal = proposals().find("posterior").make(params);
        proposal->begin(step.input(), false);
        RandomStream random(3, RandomPurpose::motion, 1, 1);
        const ParticleMap map = walls.map();
        return proposal->draw({step.before, map}, random).pose.x;
    };
    EXPECT_NEAR(drawn_x(), 1.4, 0.15);
    params.association.method = AssociationMethod::gated_nearest;
    EXPECT_NEAR(drawn_x(), 1.4, 0.15);
    // Where nothing fits, the motion model is what is drawn from.
    step.seen.lines[0].recta = {2.0, 0.9};
    RandomStream random(3, RandomPurpose::motion, 1, 1);
    const auto robot = make_robot(params.motion);
    EXPECT_NEAR(drawn_x(), robot->sample({}, sum_controls(std::span(&step.control, 1)), random).x,
                1e-12);
}

TEST(PosteriorProposal, AnAmbiguousObservationTellsThePoseNothing) {
    FilterParams params = posterior_params();
    Step step;
    step.seen.lines.resize(1);
    step.seen.lines[0].recta = {4.6, 0.0};  // wall at 5 or at 6 (seen from behind: another angle)
    MapStore maps;
    const auto handle = maps.create();
    auto lines = maps.landmarks<SensorRecta>(handle);
    const Matrix2 covariance = Vector2(1e-3, 1e-4).asDiagonal();
    lines.set(lines.append(), {{5.5, 0.0}, covariance});
    lines.set(lines.append(), {{5.7, 0.0}, covariance});
    const ParticleMap map(maps, handle);
    for (const AmbiguityRule rule : {AmbiguityRule::keep_likelihood, AmbiguityRule::off}) {
        params.association.ambiguity = rule;
        const auto proposal = proposals().find("posterior").make(params);
        proposal->begin(step.input(), false);
        RandomStream random(3, RandomPurpose::motion, 1, 1);
        const double log_weight = proposal->draw({step.before, map}, random).log_weight;
        EXPECT_EQ(log_weight == 0.0, rule != AmbiguityRule::off);
    }
}

TEST(PosteriorProposal, DrawsNothingWhereThereIsNoNoise) {
    const FilterParams params = posterior_params();
    const auto robot = make_robot(params.motion);
    const MapOfWalls walls(1e-3, 1e-4);
    const ParticleMap map = walls.map();
    const auto proposal = proposals().find("posterior").make(params);
    const Step moving;
    Step without_motion;
    without_motion.control.twist = {};
    const Step& resting = without_motion;
    for (const auto& [step, first] : {std::pair(&moving, true), std::pair(&resting, false)}) {
        proposal->begin(step->input(), first);
        RandomStream random(3, RandomPurpose::motion, 1, 1);
        RandomStream untouched = random;
        const ProposedPose drawn = proposal->draw({step->before, map}, random);
        EXPECT_EQ(drawn.pose,
                  robot->mean(step->before, sum_controls(std::span(&step->control, 1))));
        EXPECT_EQ(drawn.log_weight, 0.0);
        EXPECT_EQ(random.next(), untouched.next());
    }
}

TEST(PosteriorProposal, ADirectionWithoutNoiseStaysWithoutIt) {
    // Straight ahead: only the first increment has noise, so only x is unsure.
    FilterParams params = posterior_params();
    params.motion.model = "increments";
    params.motion.ratio_x = 0.2;
    const Step step;
    const MapOfWalls walls(2e-3, 0.0);
    const ParticleMap map = walls.map();
    const auto proposal = proposals().find("posterior").make(params);
    proposal->begin(step.input(), false);
    const double p = 0.04;
    const double q = 3e-3;
    const double variance = 1.0 / (1.0 / p + 1.0 / q);
    const double mean = 1.0 + variance * (5.0 - 1.0 - 3.93) / q;
    for (std::uint32_t i = 0; i < 20; ++i) {
        RandomStream random(3, RandomPurpose::motion, 1, i);
        const ProposedPose drawn = proposal->draw({step.before, map}, random);
        EXPECT_EQ(drawn.pose.y, 0.0);
        EXPECT_EQ(drawn.pose.theta, 0.0);
        const auto one = [](double value) { return VectorXd::Constant(1, value); };
        const auto square = [](double value) { return MatrixXd::Constant(1, 1, value); };
        EXPECT_NEAR(drawn.log_weight,
                    log_density(one(drawn.pose.x), one(1.0), square(p)) -
                        log_density(one(drawn.pose.x), one(mean), square(variance)),
                    1e-9);
    }
}

TEST(PosteriorProposal, IsFastSlam1WhereTheMotionIsAllButCertain) {
    const Tour tour = make_tour(60, 0.0);
    FilterParams params;
    params.particles = 20;
    params.motion.sigma_x_m = params.motion.sigma_y_m = params.motion.sigma_theta_rad = 1e-5;
    params.observation = {0.003, 0.0003};
    params.resampling = {ResamplingRule::neff, 0.0};  // never: particles keep their places
    FiltroParticulas one(params, 1, 1);
    params.proposal = "posterior";
    FiltroParticulas two(params, 1, 1);
    for (std::size_t k = 0; k < tour.controls.size(); ++k) {
        feed(one, tour.controls[k], tour.observations[k]);
        feed(two, tour.controls[k], tour.observations[k]);
        const auto first = one.hypotheses();
        const auto second = two.hypotheses();
        for (std::size_t i = 0; i < first.size(); ++i) {
            // The same draws, the noise's own size apart from each other, but for a thousandth.
            ASSERT_NEAR(second[i].pose.x, first[i].pose.x, 1e-7) << k;
            ASSERT_NEAR(second[i].pose.theta, first[i].pose.theta, 1e-7) << k;
            ASSERT_NEAR(second[i].weight / first[i].weight, 1.0, 1e-2) << k;
        }
    }
    EXPECT_NE(one.hypotheses()[0].pose.x, one.hypotheses()[1].pose.x);
    EXPECT_EQ(one.best_map().size(), two.best_map().size());
}

/// Weighted mean and spread of all hypotheses after the room's first steps, never resampled, with
/// the mean weight.
struct Population {
    Vector3d mean = Vector3d::Zero();
    Matrix3d covariance = Matrix3d::Zero();
    double neff = 0.0;
};

Population population(const FilterParams& params, const Tour& tour, std::uint64_t seed) {
    FiltroParticulas filter(params, seed, 1);
    for (std::size_t k = 0; k < tour.controls.size(); ++k) {
        feed(filter, tour.controls[k], tour.observations[k]);
    }
    Population all;
    const auto hypotheses = filter.hypotheses();
    for (const WeightedPose& h : hypotheses) all.mean += h.weight * vector_of(h.pose);
    for (const WeightedPose& h : hypotheses) {
        const Vector3d away = vector_of(h.pose) - all.mean;
        all.covariance += h.weight * away * away.transpose();
    }
    all.neff = filter.statistics().neff;
    return all;
}

TEST(PosteriorProposal, WeightsMakeTheDistributionThatOfFastSlam1) {
    const Tour tour = make_tour(3, 0.1);
    FilterParams params;
    params.particles = 40000;
    params.motion.sigma_x_m = params.motion.sigma_y_m = 0.1;
    params.motion.sigma_theta_rad = 0.03;
    params.observation = {0.01, 0.001};
    params.association.p0 = 1e-9;  // every wall is found again
    params.association.ambiguity = AmbiguityRule::off;
    params.resampling = {ResamplingRule::neff, 0.0};  // never
    const Population one = population(params, tour, 1);
    params.proposal = "posterior";
    const Population two = population(params, tour, 2);
    EXPECT_GT(two.neff, 4.0 * one.neff);  // what it is for
    for (int i = 0; i < 3; ++i) {
        const double sigma = std::sqrt(one.covariance(i, i));
        EXPECT_NEAR(two.mean(i), one.mean(i),
                    5.0 * sigma * std::sqrt(1.0 / one.neff + 1.0 / two.neff))
            << i;
        EXPECT_NEAR(std::sqrt(two.covariance(i, i)), sigma, 5.0 * sigma / std::sqrt(2.0 * one.neff))
            << i;
    }
}

TEST(PosteriorProposal, GoesWithTheRegisteredPath) {
    const Tour tour = make_tour(150, 0.1);
    const auto path = registered_path(tour, 0.03);
    FilterParams params;
    params.particles = 30;
    params.proposal = "posterior";
    params.motion.model = "registered";
    params.observation = {0.003, 0.0003};
    FiltroParticulas filter(params, 1, 1);
    feed_registered(filter, tour, path, 0, 150);
    EXPECT_EQ(filter.best_count(FeatureKind::line), 4);
    EXPECT_EQ(filter.best_count(FeatureKind::corner), 4);
    EXPECT_NEAR(filter.best_pose().x, tour.truth.back().x, 0.1);
}

}  // namespace
}  // namespace hitos
