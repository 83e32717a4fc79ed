// SPDX-License-Identifier: GPL-3.0-or-later
#include "hitos/slam/proposal.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "fastslam/filtro_particulas.hpp"
#include "hitos/base/error.hpp"
#include "hitos/slam/robot.hpp"
#include "room_tour.hpp"

namespace hitos {
namespace {

/// A proposal of a program's own: the robot stays where the scan's time says, in metres along x,
/// and half of the particles are found a third as likely. It counts the landmarks it could have
/// heeded.
class ToldByTheScan final : public Proposal {
  public:
    void begin(const SlamInput& input, bool first) override {
        x_ = first ? 0.0 : input.scan.time_s;
    }
    ProposedPose draw(const Hypothesis& before, RandomStream& random) const override {
        const bool unlikely = random.uniform() < 0.5;
        const auto lines = static_cast<double>(before.map.landmarks<SensorRecta>().size());
        return {{x_, lines, unlikely ? 1.0 : 0.0}, unlikely ? -std::log(3.0) : 0.0};
    }

  private:
    double x_ = 0.0;
};

ProposalEntry told_by_the_scan() {
    ProposalEntry entry;
    entry.word = "told-by-the-scan";
    entry.label = "Told by the scan";
    entry.purpose = "for tests";
    entry.make = [](const FilterParams&) { return std::make_unique<ToldByTheScan>(); };
    return entry;
}

/// Before anything looks into the registry.
const bool kAdded = [] {
    proposals().add(told_by_the_scan());
    return true;
}();

TEST(MotionProposal, DrawsWhatTheRobotDraws) {
    ASSERT_TRUE(kAdded);
    FilterParams params;
    params.motion.model = "proportional";
    const auto proposal = proposals().find("motion").make(params);
    const auto robot = make_robot(params.motion);
    const Control control{{0.5, 0.0, 0.4}, 1.0};
    const MotionIncrement increment = sum_controls(std::span(&control, 1));
    const MapStore maps;
    const ParticleMap map(maps, 0);
    const Pose start{1.0, 2.0, 0.5};
    const Scan scan;
    const Observation nothing;
    for (const bool first : {true, false}) {
        RandomStream random(1, RandomPurpose::motion, 3, 4);
        RandomStream same = random;
        proposal->begin({scan, std::span(&control, 1), nothing}, first);
        const ProposedPose drawn = proposal->draw({start, map}, random);
        EXPECT_EQ(drawn.pose,
                  first ? robot->mean(start, increment) : robot->sample(start, increment, same));
        EXPECT_EQ(drawn.log_weight, 0.0);
    }
    EXPECT_NE(robot->mean(start, increment), start);
}

TEST(Proposals, OneOfAProgramsOwnSeesScanAndMapAndCorrectsTheWeight) {
    FilterParams params;
    params.particles = 40;
    params.proposal = "told-by-the-scan";
    params.resampling = {ResamplingRule::neff, 0.0};  // never
    FiltroParticulas filter(params, 1, 1);
    Observation seen;
    seen.lines.push_back({{3.0, 0.2}, 0, 0});
    feed(filter, {}, seen);
    EXPECT_EQ(filter.best_pose().x, 0.0);
    EXPECT_EQ(filter.best_pose().y, 0.0);
    FiltroParticulas fresh(params, 1, 1);
    Scan scan;
    scan.time_s = 7.0;
    const Observation nothing;
    fresh.step({scan, {}, nothing});
    for (const WeightedPose& hypothesis : fresh.hypotheses()) EXPECT_EQ(hypothesis.pose.x, 0.0);
    filter.step({scan, {}, nothing});
    double likely = 0.0;
    double unlikely = 0.0;
    for (const WeightedPose& hypothesis : fresh.hypotheses()) {
        (hypothesis.pose.theta > 0.0 ? unlikely : likely) = hypothesis.weight;
    }
    EXPECT_NEAR(likely / unlikely, 3.0, 1e-9);
    EXPECT_EQ(filter.hypotheses()[0].pose.x, 7.0);
    EXPECT_EQ(filter.hypotheses()[0].pose.y, 1.0);
}

TEST(Proposals, AnUnknownWordIsRefused) {
    FilterParams params;
    params.proposal = "wish";
    EXPECT_THROW(FiltroParticulas(params, 1, 1), ConfigError);
    EXPECT_THROW(proposals().add(told_by_the_scan()), ConfigError);  // closed by now
}

}  // namespace
}  // namespace hitos
