// SPDX-License-Identifier: GPL-3.0-or-later
// Which steps of a logged path a robot drives.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <optional>
#include <vector>

#include "hitos/capture/conversor.hpp"
#include "hitos/capture/odometry_axes.hpp"
#include "hitos/capture/to_and_fro.hpp"
#include "hitos/capture/tour_finding.hpp"

namespace hitos {

/// Mends the steps from pose to pose that no robot makes: alone among others, such a step is taken
/// to be as the one before it, and a single pose that is wrong is passed over. A step that makes up
/// for a time in which the odometry hung is one that the robot drove. Times are those that are
/// logged, which may stand still or go back.
class OdometrySteps {
  public:
    /// The step between two readings as it is to be taken. Every reading is asked once, in order.
    Pose taken(const OdometryRecord& before, const OdometryRecord& record);
    void tell(std::vector<TourFinding>& found, const ReadOptions& read) const;

  private:
    struct Told {
        std::uint64_t count = 0;
        double longest_m = 0.0;
        double turn_rad = 0.0;   ///< of the longest; of turns alone, the largest
        std::uint64_t line = 0;  ///< of the longest
        void note(const Pose& step, std::uint64_t at_line);
    };
    struct Place {
        Pose pose;
        friend double apart(const Place& a, const Place& b) {
            const Pose step = between(a.pose, b.pose);
            return std::hypot(step.x, step.y) + std::abs(wrap_angle(step.theta));
        }
    };
    /// What was driven when the pose last changed: how a robot was under way when its
    /// odometry stops.
    struct UnderWay {
        std::optional<double> begin_s;  ///< when it changed
        Pose step;
        Twist twist;
        double before = 0.0;  ///< motion a second, a radian counted as a metre, of the step before
        std::uint64_t still = 0;  ///< readings since then that repeat the pose
        double seconds = 0.0;     ///< that the step took
    };
    /// How often a step's heading turns 57 times as far as something else says, of those steps
    /// where that would be less than half a turn.
    struct Turns {
        std::uint64_t asked = 0;
        std::uint64_t of_degrees = 0;
        std::uint64_t reversed = 0;  ///< such that turn the other way, as a compass does
        std::uint64_t most() const { return std::max(of_degrees, reversed); }
        void note(double told_rad, double other_rad);
        bool are_degrees() const;
    };
    void note_turn(const OdometryRecord& before, const OdometryRecord& record);
    /// `seconds`: since the reading before.
    bool makes_up(const OdometryRecord& record, const Pose& step, double seconds) const;
    bool goes_on(const Pose& step, const Pose& pose, double seconds) const;
    Pose bridged(const OdometryRecord& before, const OdometryRecord& record, double seconds);
    void learn(const OdometryRecord& before, const OdometryRecord& record, const Pose& step);

    ToAndFro<Place> tracks_;
    ToAndFro<Place> positions_;  ///< of all of them the heading left out
    HeadingCheck headings_;
    std::uint64_t turns_of_degrees_ = 0;  ///< steps of 360
    std::uint64_t turn_line_ = 0;         ///< of the first
    Turns by_velocity_;
    Turns by_path_;   ///< by how the direction of the way changes
    Pose last_step_;  ///< in the odometry's frame
    Twist twist_;     ///< of the last step that took time
    UnderWay under_way_;
    Told leaps_;
    std::uint64_t in_a_row_ = 0;  ///< other leaps, right behind another
    Told made_up_;
    double longest_halt_s_ = 0.0;
    bool after_leap_ = false;
    Pose from_;    ///< the last pose before the last leap
    Pose driven_;  ///< from there on, as it was bridged
};

}  // namespace hitos
