// SPDX-License-Identifier: GPL-3.0-or-later
#include "hitos/capture/scan_clock.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <string>

#include "hitos/base/error.hpp"
#include "hitos/base/text_input.hpp"
#include "hitos/capture/archivo.hpp"

namespace hitos {
namespace {

constexpr double kCents = 100.0;

double to_hundredths(double seconds) {
    return std::round(seconds * kCents) / kCents + 0.0;  // no "-0"
}

}  // namespace

ScanClock::ScanClock(std::string_view text) {
    constexpr double kGreatest = 1e10;
    for (const std::string_view word : input::listed(text)) {
        const std::size_t sign = word.find('@');
        const auto number = [&](std::size_t begin, std::size_t count) {
            return sign == std::string_view::npos ? std::nullopt
                                                  : input::parse_number(word.substr(begin, count));
        };
        const std::optional<double> added = number(0, sign);
        const std::optional<double> at = number(sign + 1, std::string_view::npos);
        const std::size_t known = points_.size();
        const bool third = known > 1 && at && points_[known - 2].at_s == *at;
        if (!added || !at || !(std::abs(*added) <= kGreatest) || !(std::abs(*at) <= kGreatest) ||
            (known > 0 && *at < points_.back().at_s) || third) {
            throw ConfigError(
                kScanClockKey,
                HITOS_TEXT("Errors",
                           "found \"%1\", expected seconds to add to the scans' times and after "
                           "how many seconds of the tour, in their order and no more than two of "
                           "one second, as in \"0@0,-1.39@680\""),
                text);
        }
        points_.push_back({*at, *added});
    }
}

double ScanClock::at(double elapsed_s, bool after_leaps) const {
    if (points_.empty()) return 0.0;
    const auto later = after_leaps ? std::ranges::upper_bound(points_, elapsed_s, {}, &Point::at_s)
                                   : std::ranges::lower_bound(points_, elapsed_s, {}, &Point::at_s);
    if (later == points_.begin()) return later->added_s;
    const Point& before = *(later - 1);
    if (later == points_.end()) return before.added_s;
    const double share = (elapsed_s - before.at_s) / (later->at_s - before.at_s);
    return std::lerp(before.added_s, later->added_s, share);
}

double ScanClock::step_s(double before_s, double stamp_s) {
    constexpr double kSetBack = 0.02;  // where the time of a scan is not known
    return stamp_s > before_s ? stamp_s - before_s : kSetBack;
}

double ScanClock::added(double stamp_s) {
    if (points_.empty()) return 0.0;
    if (last_s_) elapsed_s_ += step_s(*last_s_, stamp_s);
    last_s_ = stamp_s;
    return at(elapsed_s_, false);
}

ScanClock ScanClock::always(double added_s) {
    return ScanClock(std::vector<Point>{{0.0, added_s}});
}

ScanClock ScanClock::plus(const ScanClock& other) const {
    if (points_.empty()) return other;
    // Seconds as this clock tells them pass faster or slower than the log's.
    const auto of_log = [&](double told_s) {
        constexpr int kRounds = 20;
        double elapsed_s = told_s;
        for (int i = 0; i < kRounds; ++i) {
            elapsed_s = told_s - (at(elapsed_s, false) - at(0.0, false));
        }
        return elapsed_s;
    };
    ScanClock more = other;
    for (Point& point : more.points_) {
        if (points_.size() > 1) point.at_s = of_log(point.at_s);
    }
    std::vector<double> times;
    for (const Point& point : points_) times.push_back(point.at_s);
    for (const Point& point : more.points_) times.push_back(point.at_s);
    std::ranges::sort(times);
    times.erase(std::unique(times.begin(), times.end()), times.end());
    ScanClock sum;
    for (const double time_s : times) {
        const Point before{time_s, at(time_s, false) + more.at(time_s, false)};
        const Point after{time_s, at(time_s, true) + more.at(time_s, true)};
        sum.points_.push_back(before);
        if (after != before) sum.points_.push_back(after);
    }
    return sum;
}

std::string ScanClock::text() const {
    std::string text;
    for (const Point& point : points_) {
        if (!text.empty()) text += ',';
        text +=
            fmt::format("{:.2f}@{:.10g}", to_hundredths(point.added_s), to_hundredths(point.at_s));
    }
    return text;
}

}  // namespace hitos
