// SPDX-License-Identifier: GPL-3.0-or-later
// How fast a run is shown.
#pragma once

#include <chrono>
#include <cstdint>

namespace hitos {

/// How fast a run goes.
struct Pace {
    enum class Kind : std::uint8_t {
        full,      ///< as fast as possible
        recorded,  ///< `rate` times as fast as the stamps of the scans
        scans,     ///< `rate` scans a second
    };
    Kind kind = Kind::full;
    double rate = 1.0;

    bool operator==(const Pace&) const = default;
};

/// Says when a run takes its next scan. What it fell behind by more than kMostBehind, because the
/// machine or the algorithm is slower, is not made up for.
class Pacer {
  public:
    using Clock = std::chrono::steady_clock;
    static constexpr std::chrono::milliseconds kMostBehind{250};
    static constexpr std::chrono::seconds kLongestGap{5};

    const Pace& pace() const { return pace_; }
    void set(const Pace& pace) {
        pace_ = pace;
        begin();
    }
    /// Counts from the next call of next() on.
    void begin() { begun_ = false; }
    /// When the scan after these `steps`, the last of which is `duration_s` after the first, may be
    /// taken. With `recorded` it is as long after the one before as that was after its own, but no
    /// longer than kLongestGap: where a recording paused, nobody waits.
    Clock::time_point next(std::uint64_t steps, double duration_s, Clock::time_point now);

  private:
    Pace pace_;
    bool begun_ = false;
    Clock::time_point since_;
    double from_ = 0.0;  // scans, or seconds of the tour, at since_
};

}  // namespace hitos
