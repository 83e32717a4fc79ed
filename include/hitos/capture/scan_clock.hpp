// SPDX-License-Identifier: GPL-3.0-or-later
// A laser's clock that runs at another speed than the odometry's, or that was set.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace hitos {

/// What is to be added to the scans' times, by how long the tour has lasted.
class ScanClock {
  public:
    /// So many seconds are added at that one.
    struct Point {
        double at_s = 0.0;  ///< since the first scan
        double added_s = 0.0;
        friend bool operator==(const Point&, const Point&) = default;
    };
    /// "0@0,-1.39@680": so many seconds are added at that second after the first scan, evenly more
    /// or less in between; of two points of one second the later one counts from then on. Empty:
    /// nothing. Throws ConfigError, under the parameter's key, for another text.
    explicit ScanClock(std::string_view text = {});
    /// In the order of their times, no more than two of one.
    explicit ScanClock(std::vector<Point> points) : points_(std::move(points)) {}
    /// To a scan of that stamp. Asked for every scan, in order: a clock that is set back does not
    /// shorten the tour.
    double added(double stamp_s);
    /// How much longer the tour has lasted by a stamp that follows on another.
    static double step_s(double before_s, double stamp_s);

    /// The same at all times.
    static ScanClock always(double added_s);
    /// What is added by both, `other` at seconds of the tour as this clock tells them.
    ScanClock plus(const ScanClock& other) const;
    ScanClock plus(double added_s) const { return plus(always(added_s)); }
    std::string text() const;

  private:
    double at(double elapsed_s, bool after_leaps) const;
    std::vector<Point> points_;
    std::optional<double> last_s_;
    double elapsed_s_ = 0.0;
};

}  // namespace hitos
