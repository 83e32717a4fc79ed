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
    EXPECT_NEAR(chi_square_probability(5.9915, 2), 0.95, 1e-5);
    EXPECT_NEAR(chi_square_probability(1.3863, 2), 0.50, 1e-5);
    EXPECT_EQ(chi_square_probability(0.0, 3), 0.0);
    EXPECT_EQ(chi_square_probability(std::nan(""), 3), 0.0);
}

TEST(Calibration, OfTrueCovariancesEveryRegionHoldsItsShare) {
    std::mt19937 random(7);
    std::normal_distribution<double> normal;
    for (const int degrees : {2, 3}) {
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
            EXPECT_LT(too_sure.inside(i), kRegions[i] - 0.05);
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
    explicit ToldMaps(std::vector<LandmarkMap> maps) : maps_(std::move(maps)) {}
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

  private:
    std::vector<LandmarkMap> maps_;
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
}

}  // namespace
}  // namespace hitos
