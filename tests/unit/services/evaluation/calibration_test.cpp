// SPDX-License-Identifier: GPL-3.0-or-later
// Whether regions hold the truth as often as they say.
#include "evaluation/calibration.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <random>
#include <span>
#include <utility>
#include <vector>

#include "hitos/slam/slam_filter.hpp"

namespace hitos {
namespace {

// Tables of the chi-square distribution.
TEST(Calibration, KnowsTheQuantilesOfTheTables) {
    EXPECT_NEAR(chi_square_probability(7.8147, 3), 0.95, 1e-5);
    EXPECT_NEAR(chi_square_probability(2.3660, 3), 0.50, 1e-5);
    EXPECT_NEAR(chi_square_probability(11.3449, 3), 0.99, 1e-5);
    EXPECT_NEAR(chi_square_probability(3.8415, 1), 0.95, 1e-5);
    EXPECT_NEAR(chi_square_probability(0.4549, 1), 0.50, 1e-4);
    EXPECT_NEAR(chi_square_probability(5.9915, 2), 0.95, 1e-5);
    EXPECT_NEAR(chi_square_probability(1.3863, 2), 0.50, 1e-5);
    EXPECT_EQ(chi_square_probability(0.0, 3), 0.0);
    EXPECT_EQ(chi_square_probability(std::nan(""), 3), 0.0);
}

TEST(NeesInterval, HasItsProbabilityAtEitherEnd) {
    for (const int degrees : {1, 2, 3}) {
        const NeesInterval one = nees_interval(1, degrees);
        EXPECT_NEAR(chi_square_probability(one.low, degrees), 0.025, 1e-12);
        EXPECT_NEAR(chi_square_probability(one.high, degrees), 0.975, 1e-12);
    }
    EXPECT_NEAR(nees_interval(1, 3).low, kNeesLow, 1e-7);
    EXPECT_NEAR(nees_interval(1, 3).high, kNeesHigh, 1e-6);
    // Bar-Shalom, Li and Kirubarajan, section 5.4.2: fifty runs of two values.
    EXPECT_NEAR(nees_interval(50, 2).low, 1.48, 0.005);
    EXPECT_NEAR(nees_interval(50, 2).high, 2.59, 0.005);
}

TEST(NeesInterval, HoldsTheMeansOfIndependentRuns) {
    constexpr int kRuns = 10;
    constexpr int kCases = 20000;
    std::mt19937_64 random(3);
    std::normal_distribution<double> normal;
    const NeesInterval interval = nees_interval(kRuns, 2);
    int below = 0;
    int above = 0;
    for (int i = 0; i < kCases; ++i) {
        double sum = 0.0;
        for (int value = 0; value < 2 * kRuns; ++value) {
            const double error = normal(random);
            sum += error * error;
        }
        below += sum / kRuns < interval.low ? 1 : 0;
        above += sum / kRuns > interval.high ? 1 : 0;
    }
    // Four standard deviations of a binomial variable.
    const double slack = 4.0 * std::sqrt(0.025 * 0.975 / kCases);
    EXPECT_NEAR(static_cast<double>(below) / kCases, 0.025, slack);
    EXPECT_NEAR(static_cast<double>(above) / kCases, 0.025, slack);
}

TEST(Calibration, OfTrueCovariancesEveryRegionHoldsItsShare) {
    std::mt19937 random(7);
    std::normal_distribution<double> normal;
    for (const int degrees : {1, 2, 3}) {
        Coverage sure(degrees);
        Coverage too_sure(degrees);  // half the true deviation
        constexpr int kDraws = 40'000;
        for (int i = 0; i < kDraws; ++i) {
            double squared = 0.0;
            for (int d = 0; d < degrees; ++d) squared += std::pow(normal(random), 2);
            sure.add(squared);
            too_sure.add(4.0 * squared);
        }
        EXPECT_EQ(sure.count(), kDraws);
        EXPECT_NEAR(sure.mean(), degrees, 0.05);
        EXPECT_NEAR(too_sure.mean(), 4.0 * degrees, 0.2);
        for (std::size_t i = 0; i < kRegions.size(); ++i) {
            EXPECT_NEAR(sure.inside(i), kRegions[i], 0.01) << degrees << " " << kRegions[i];
            // Of one value 99 % of what is twice as sure is still 80 %.
            EXPECT_LT(too_sure.inside(i), kRegions[i] - 0.05) << degrees;
        }
    }
}

ICaracteristica line(double rho, double theta, double sigma) {
    ICaracteristica landmark;
    landmark.value = Recta{rho, theta};
    landmark.covariance = sigma * sigma * Eigen::Matrix2d::Identity();
    return landmark;
}

ICaracteristica corner(double x, double y, double sigma) {
    ICaracteristica landmark;
    landmark.value = Esquina{x, y};
    landmark.covariance = sigma * sigma * Eigen::Matrix2d::Identity();
    return landmark;
}

TEST(Calibration, CountsLandmarksAgainstTheNearestOfTheirKind) {
    const LandmarkMap truth{line(2.0, 0.1, 0.0), line(5.0, 0.1, 0.0), corner(1.0, 1.0, 0.0)};
    Coverage coverage(2);
    // Two deviations in rho: 4.
    count_landmarks(coverage, {line(2.2, 0.1, 0.1)}, truth);
    EXPECT_NEAR(coverage.mean(), 4.0, 1e-9);
    // The same line written from the other side: 0.
    count_landmarks(coverage, {line(-2.0, 0.1 - kPi, 0.1)}, truth);
    EXPECT_EQ(coverage.count(), 2);
    EXPECT_NEAR(coverage.mean(), 2.0, 1e-9);
    // 9 + 16.
    count_landmarks(coverage, {corner(1.3, 0.6, 0.1)}, truth);
    EXPECT_NEAR(coverage.mean(), (4.0 + 25.0) / 3.0, 1e-9);
    // Without uncertainty, and of a kind that the truth lacks.
    count_landmarks(coverage, {line(2.0, 0.1, 0.0)}, truth);
    count_landmarks(coverage, {corner(1.0, 1.0, 0.1)}, {line(2.0, 0.1, 0.0)});
    EXPECT_EQ(coverage.count(), 3);
}

/// Hypotheses with maps as they are told.
class ToldMaps final : public SlamFilter {
  public:
    explicit ToldMaps(std::vector<LandmarkMap> maps, Eigen::MatrixXd joint = {})
        : maps_(std::move(maps)), joint_(std::move(joint)) {}
    void step(const SlamInput& /*input*/) override {}
    std::uint64_t steps() const override { return 1; }
    Pose best_pose() const override { return {}; }
    LandmarkMap best_map() const override { return maps_.front(); }
    std::vector<Pose> best_history() const override { return {{}}; }
    int best_count(FeatureKind /*kind*/) const override { return 0; }
    std::span<const Association> associations() const override { return {}; }
    std::vector<WeightedPose> hypotheses() const override {
        return std::vector<WeightedPose>(maps_.size(),
                                         {{}, 1.0 / static_cast<double>(maps_.size())});
    }
    LandmarkMap map(std::size_t hypothesis) const override { return maps_.at(hypothesis); }
    FilterStatistics statistics() const override { return {}; }
    Eigen::Matrix3d pose_covariance() const override { return Eigen::Matrix3d::Zero(); }
    Eigen::MatrixXd joint_covariance() const override { return joint_; }

  private:
    std::vector<LandmarkMap> maps_;
    Eigen::MatrixXd joint_;
};

// The mixture's mean is that of its parts, and its variance theirs and that of their means.
TEST(Calibration, ParticlesMapsAreMixed) {
    const ToldMaps filter({{corner(1.0, 1.0, 0.1)}, {corner(1.4, 1.0, 0.3)}});
    const LandmarkMap mixed = mixed_map(filter);
    const auto& point = std::get<Esquina>(mixed.at(0).value);
    EXPECT_NEAR(point.x, 1.2, 1e-12);
    EXPECT_NEAR(point.y, 1.0, 1e-12);
    EXPECT_NEAR(mixed[0].covariance(0, 0), 0.5 * (0.01 + 0.09) + 0.04, 1e-12);
    EXPECT_NEAR(mixed[0].covariance(1, 1), 0.05, 1e-12);
    EXPECT_NEAR(mixed[0].covariance(0, 1), 0.0, 1e-12);
}

TEST(Calibration, AParticleThatLacksALandmarkSaysNothingOfIt) {
    const ToldMaps filter(
        {{corner(1.0, 1.0, 0.1), corner(6.0, 1.0, 0.1)}, {corner(6.0, 1.0, 0.1)}});
    const LandmarkMap mixed = mixed_map(filter);
    EXPECT_NEAR(std::get<Esquina>(mixed.at(0).value).x, 1.0, 1e-12);
    EXPECT_NEAR(mixed[0].covariance(0, 0), 0.01, 1e-12);
}

TEST(Calibration, ALineIsMixedHoweverItIsWritten) {
    const ToldMaps filter({{line(0.02, 0.1, 0.1)}, {line(0.02, 0.1 - kPi, 0.1)}});
    const LandmarkMap mixed = mixed_map(filter);
    EXPECT_NEAR(std::get<Recta>(mixed.at(0).value).rho, 0.0, 1e-12);
    EXPECT_NEAR(mixed[0].covariance(0, 0), 0.01 + 0.0004, 1e-12);
    const ToldMaps turned({{line(1.0, 0.1, 0.1)}, {line(1.0, 0.3, 0.1)}});
    const LandmarkMap both = mixed_map(turned);
    EXPECT_NEAR(std::get<Recta>(both.at(0).value).theta, 0.2, 1e-12);
    EXPECT_NEAR(both[0].covariance(1, 1), 0.01 + 0.01, 1e-12);
}

/// Two walls 3 m apart whose normals point along x, seen at y = 4, and one across them.
LandmarkMap walls() {
    return {line(1.0, 0.0, 0.0), line(4.0, 0.0, 0.0), line(2.0, kPi / 2.0, 0.0)};
}
std::vector<LineExtent> seen_walls() {
    return {{0, {1.0, 3.0}, {1.0, 5.0}, 20}, {1, {4.0, 3.0}, {4.0, 5.0}, 20}};
}

TEST(CalibrationOfDistances, IsOfWhatTheParticlesHave) {
    Coverage coverage(1);
    // 3.1 m and 3.3 m, each with a variance of 2 * 0.1^2: 0.2 m off with 0.02 + 0.01 (in rho; the
    // lines' angles do the same at both, 4 m from where theta turns them).
    LandmarkMap first{line(1.0, 0.0, 0.1), line(4.1, 0.0, 0.1)};
    LandmarkMap second{line(1.0, 0.0, 0.1), line(4.3, 0.0, 0.1)};
    for (LandmarkMap* map : {&first, &second})
        for (ICaracteristica& wall : *map) wall.covariance(1, 1) = 0.0;
    count_distances(coverage, ToldMaps({first, second}), seen_walls(), walls());
    EXPECT_EQ(coverage.count(), 1);
    EXPECT_NEAR(coverage.mean(), 0.04 / 0.03, 1e-9);
    // An angle that is not known turns the far wall away by 4 m times it.
    first[1].covariance(1, 1) = second[1].covariance(1, 1) = 0.0001;
    Coverage turned(1);
    count_distances(turned, ToldMaps({first, second}), seen_walls(), walls());
    EXPECT_NEAR(turned.mean(), 0.04 / (0.03 + 16.0 * 0.0001), 1e-9);
}

TEST(CalibrationOfDistances, ErrorsCommonToBothWallsAreNone) {
    const LandmarkMap map{line(1.1, 0.0, 0.5), line(-4.0, -kPi, 0.5)};  // from the other side
    Eigen::MatrixXd joint = Eigen::MatrixXd::Zero(7, 7);
    const auto at = [&](int row, int column) -> double& { return joint(3 + row, 3 + column); };
    at(0, 0) = at(2, 2) = 0.26;  // 0.25 of it is common to both, with the sign of the normal
    at(0, 2) = at(2, 0) = -0.25;
    Coverage coverage(1);
    count_distances(coverage, ToldMaps({map}, joint), seen_walls(), walls());
    EXPECT_EQ(coverage.count(), 1);
    EXPECT_NEAR(coverage.mean(), 0.01 / 0.02, 1e-9);
}

// The law: with errors as the covariance has them, every region holds its share.
TEST(CalibrationOfDistances, OfTrueCovariancesEveryRegionHoldsItsShare) {
    std::mt19937 random(11);
    std::normal_distribution<double> normal;
    Eigen::MatrixXd root = Eigen::MatrixXd::Zero(7, 7);
    for (int row = 3; row < 7; ++row)
        for (int column = 3; column <= row; ++column)
            root(row, column) = (row % 2 == 1 ? 0.05 : 0.004) * normal(random);
    const Eigen::MatrixXd joint = root * root.transpose();
    Coverage coverage(1);
    constexpr int kDraws = 20'000;
    for (int i = 0; i < kDraws; ++i) {
        Eigen::VectorXd draw(7);
        for (double& value : draw) value = normal(random);
        const Eigen::VectorXd error = root * draw;
        count_distances(
            coverage,
            ToldMaps({{line(1.0 + error(3), error(4), 0.1), line(4.0 + error(5), error(6), 0.1)}},
                     joint),
            seen_walls(), walls());
    }
    EXPECT_EQ(coverage.count(), kDraws);
    EXPECT_NEAR(coverage.mean(), 1.0, 0.05);
    for (std::size_t i = 0; i < kRegions.size(); ++i)
        EXPECT_NEAR(coverage.inside(i), kRegions[i], 0.015) << kRegions[i];
}

TEST(CalibrationOfDistances, AreBetweenWallsBesideEachOtherThatWereSeen) {
    const LandmarkMap truth{line(1.0, 0.0, 0.0), line(4.0, 0.0, 0.0), line(9.0, -kPi, 0.0)};
    const LandmarkMap map{line(1.0, 0.0, 0.1), line(4.0, 0.0, 0.1), line(9.0, -kPi, 0.1)};
    std::vector<LineExtent> seen = seen_walls();
    seen.push_back({2, {-9.0, 3.0}, {-9.0, 5.0}, 20});
    const auto count = [&](const std::vector<LineExtent>& extents, const ToldMaps& filter) {
        Coverage coverage(1);
        count_distances(coverage, filter, extents, truth);
        return coverage.count();
    };
    EXPECT_EQ(count(seen, ToldMaps({map, map})), 2);          // 10 m and 3 m, not 13
    EXPECT_EQ(count(seen_walls(), ToldMaps({map, map})), 1);  // one was not seen
    EXPECT_EQ(count(seen, ToldMaps({map})), 0);               // which has no joint covariance
    LandmarkMap askew = map;
    std::get<Recta>(askew[1].value).theta = 0.4;
    EXPECT_EQ(count(seen, ToldMaps({askew, askew})), 1);
}

}  // namespace
}  // namespace hitos
