// SPDX-License-Identifier: GPL-3.0-or-later
#include "stamp_doubts.hpp"

#include <fmt/format.h>

namespace hitos {
namespace {

using Kind = TourFinding::Kind;

constexpr double kNoPace = 60.0;  // of a laser's scans [s]

Remedy one_clock() {
    return {marked(HITOS_TEXT("Errors",
                              "look at what stamps them: one clock, that is set before the first "
                              "message"))};
}

/// On the average.
double pace_s(const StampReturns& returns) {
    constexpr std::uint64_t kLeast = 10;
    if (returns.stamps < kLeast) return 0.0;
    return (returns.last_s - returns.first_s) / static_cast<double>(returns.stamps - 1);
}

bool run_backwards(const StampReturns& returns) {
    return 2 * returns.backwards > returns.stamps;
}

}  // namespace

void doubt_returns(const StampReturns& of_scans, const StampReturns& of_odometry,
                   const ReadReport& report, std::vector<TourFinding>& found) {
    if (run_backwards(of_scans) || run_backwards(of_odometry)) {
        const StampReturns& returns = run_backwards(of_scans) ? of_scans : of_odometry;
        found.push_back(
            {Kind::clock_back,
             static_cast<double>(returns.backwards),
             message(HITOS_TEXT("Errors",
                                "time runs backwards: %1 of %2 stamps are before the one ahead of "
                                "them in the log; where the robot was at a scan is not known"),
                     returns.backwards, returns.stamps),
             {one_clock()}});
        return;
    }
    const bool scans =
        of_scans.rare() && (!of_odometry.rare() || of_scans.most_s > of_odometry.most_s);
    const StampReturns& returns = scans ? of_scans : of_odometry;
    if (returns.rare()) {
        found.push_back(
            {Kind::clock_back,
             returns.most_s,
             message(
                 HITOS_TEXT("Errors",
                            "the clock goes back, at %1 s by %2 s: a recording that was played "
                            "again, or a clock that was set; scans behind that are taken to be of "
                            "times that were, and lie anywhere (%3)"),
                 fmt::format("{:.1f}", returns.at_s), fmt::format("{:.1f}", returns.most_s),
                 report.place(returns.line)),
             {{marked(
                 HITOS_TEXT("Errors",
                            "record or play the tour once; of a log that goes back, make a log of "
                            "each part, and go on with the map of the first"))}}});
    }
    const StampReturns& ahead =
        of_scans.farthest_s >= of_odometry.farthest_s ? of_scans : of_odometry;
    if (ahead.leaps > 0 && StampReturns::kOften * ahead.leaps < ahead.stamps) {
        found.push_back(
            {Kind::broken_stamps,
             ahead.farthest_s,
             message(HITOS_TEXT("Errors",
                                "the clock leaps ahead, at %1 s by %2 days (%3): a clock that was "
                                "set, or two logs in one; scans and odometry behind that may be "
                                "of two times"),
                     fmt::format("{:.1f}", ahead.farthest_at_s),
                     fmt::format("{:.1f}", ahead.farthest_s / StampReturns::kLongest),
                     report.place(ahead.farthest_line)),
             {one_clock()}});
    } else if (const double each_s = pace_s(of_scans); each_s > kNoPace) {
        found.push_back(
            {Kind::broken_stamps,
             each_s,
             message(HITOS_TEXT("Errors",
                                "by their stamps %1 s pass from scan to scan, as where they are "
                                "not of seconds; how fast the robot drives is not known"),
                     fmt::format("{:.3g}", each_s)),
             {{marked(HITOS_TEXT("Errors", "write stamps in seconds"))}}});
    }
}

void doubt_broken_stamps(const BrokenStamps& of_scans, const BrokenStamps& of_odometry,
                         std::vector<TourFinding>& found) {
    constexpr std::uint64_t kFew = 5;
    constexpr double kShare = 0.02;
    const auto many = [](const BrokenStamps& broken) {
        return broken.left_out > kFew &&
               static_cast<double>(broken.left_out) > kShare * static_cast<double>(broken.stamps);
    };
    if (!many(of_scans) && !many(of_odometry)) return;
    const bool scans = many(of_scans);
    const BrokenStamps& most = scans ? of_scans : of_odometry;
    found.push_back(
        {Kind::broken_stamps,
         static_cast<double>(most.left_out) / static_cast<double>(most.stamps),
         message(HITOS_TEXT("Errors",
                            "%1 of %2 %3 are stamped out of line with those before and behind "
                            "them, and left out: stamps that were never set, or of two clocks in "
                            "turn"),
                 most.left_out, most.stamps,
                 scans ? marked(HITOS_TEXT("Errors", "scans"))
                       : marked(HITOS_TEXT("Errors", "odometry readings"))),
         {one_clock()}});
}

}  // namespace hitos
