// SPDX-License-Identifier: GPL-3.0-or-later
// FastSLAM 1.0's proposal: the motion model itself [T table 3.2, line 4].

#include "hitos/slam/robot.hpp"
#include "proposals.hpp"

namespace hitos {
namespace {

class MotionProposal final : public Proposal {
  public:
    explicit MotionProposal(const MotionParams& params) : robot_(make_robot(params)) {}

    void begin(const SlamInput& input, bool first) override {
        increment_ = motion_increment(input);
        first_ = first;
    }
    ProposedPose draw(const Hypothesis& before, RandomStream& random) const override {
        return {first_ ? robot_->mean(before.pose, increment_)
                       : robot_->sample(before.pose, increment_, random)};
    }
    bool draw_row(std::span<Pose> poses, const RandomRow& row) const override {
        return !first_ && robot_->sample_row(poses, increment_, row);
    }

  private:
    std::unique_ptr<Robot> robot_;
    MotionIncrement increment_;
    bool first_ = true;
};

}  // namespace

ProposalEntry motion_proposal() {
    ProposalEntry entry;
    entry.word = "motion";
    entry.label = HITOS_TEXT("ParameterChoice", "Motion model");
    entry.purpose = "poses are drawn from the motion model alone, as in FastSLAM 1.0";
    entry.make = [](const FilterParams& p) { return std::make_unique<MotionProposal>(p.motion); };
    return entry;
}

}  // namespace hitos
