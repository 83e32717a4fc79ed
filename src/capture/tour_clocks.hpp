// SPDX-License-Identifier: GPL-3.0-or-later
// What the clocks of scans and odometry did, read off how well the scans lie at many delays.
#pragma once

#include <cstddef>
#include <vector>

namespace hitos {

/// How well each pair of scans lies where the odometry was so much later, in steps of the delay.
/// Asked once of the scans, it answers for every clock: one that is off, that runs at another
/// speed, or that was set in between.
class DelayTable {
  public:
    /// Columns for the delays -steps … steps times `step_s`.
    DelayTable(double step_s, int steps) : step_s_(step_s), steps_(steps) {}

    std::size_t columns() const { return 2 * static_cast<std::size_t>(steps_) + 1; }
    double delay_s(std::size_t column) const {
        return (static_cast<double>(column) - steps_) * step_s_;
    }
    /// A pair's agreement by column, 0 where there is none; in the order of their times.
    void add(double time_s, const std::vector<double>& agreements);

    /// From the first pair to the last.
    double begin_s() const { return times_s_.front(); }
    double seconds() const { return times_s_.back() - times_s_.front(); }

    /// A clock, and the mean agreement with it.
    struct Clock {
        double delay_s = 0.0;   ///< at the first pair
        double gained_s = 0.0;  ///< besides, from the first pair to the last, evenly
        double set_by_s = 0.0;  ///< besides, from `set_at_s` on
        double set_at_s = 0.0;
        double agreement = 0.0;
    };
    /// One that runs at another speed: by no more than `most_s` over the tour.
    Clock drifting(double most_s) const;
    /// One that is set once. Each side is of an eighth of the pairs at least, and lies better by
    /// `clearly` than with the other side's delay; else an agreement of 0.
    Clock set(double clearly) const;

  private:
    std::size_t pairs() const { return times_s_.size(); }
    double at(std::size_t pair, std::size_t column) const {
        return agreements_[pair * columns() + column];
    }

    double step_s_;
    int steps_;
    std::vector<double> times_s_;
    std::vector<double> agreements_;
};

}  // namespace hitos
