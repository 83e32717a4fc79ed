#include "hitos/capture/scan_clock.hpp"

#include <algorithm>
#include <cmath>

#include "hitos/base/error.hpp"
#include "hitos/base/text_input.hpp"
#include "hitos/capture/archivo.hpp"

namespace hitos {

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
        if (!added || !at || !(std::abs(*added) <= kGreatest) || !(std::abs(*at) <= kGreatest) ||
            (!points_.empty() && *at < points_.back().at_s)) {
            throw ConfigError(
                kScanClockKey,
                HITOS_TEXT("Errors",
                           "found \"%1\", expected seconds to add to the scans' times and after "
                           "how many seconds of the tour, in their order, as in "
                           "\"0@0,-1.39@680\""),
                text);
        }
        points_.push_back({*at, *added});
    }
}

double ScanClock::added(double stamp_s) {
    constexpr double kSetBack = 0.02;  // where the time of a scan is not known
    if (points_.empty()) return 0.0;
    if (last_s_) elapsed_s_ += stamp_s > *last_s_ ? stamp_s - *last_s_ : kSetBack;
    last_s_ = stamp_s;
    const auto after = std::ranges::lower_bound(points_, elapsed_s_, {}, &Point::at_s);
    if (after == points_.begin()) return after->added_s;
    const Point& before = *(after - 1);
    if (after == points_.end()) return before.added_s;
    const double share = (elapsed_s_ - before.at_s) / (after->at_s - before.at_s);
    return std::lerp(before.added_s, after->added_s, share);
}

}  // namespace hitos
