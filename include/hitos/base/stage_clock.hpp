// SPDX-License-Identifier: GPL-3.0-or-later
// What the time of some work goes into.
#pragma once

#include <array>
#include <cstddef>
#include <utility>

#include "hitos/base/thread_clock.hpp"

namespace hitos {

/// Sums up a thread's processor time [s] by stages, an enumeration from 0 on; stands still until it
/// is set going.
template <class Stage, std::size_t kStages>
class StageClock {
  public:
    using Seconds = std::array<double, kStages>;

    void set_going() { goes_ = true; }
    bool goes() const { return goes_; }
    /// What is done from now on counts for the stage that ends next.
    void begin() {
        if (goes_) began_ = thread_seconds();
    }
    void ends(Stage stage) {
        if (!goes_) return;
        const double now = thread_seconds();
        seconds_[static_cast<std::size_t>(stage)] += now - std::exchange(began_, now);
    }
    const Seconds& seconds() const { return seconds_; }

  private:
    bool goes_ = false;
    double began_ = 0.0;
    Seconds seconds_{};
};

}  // namespace hitos
