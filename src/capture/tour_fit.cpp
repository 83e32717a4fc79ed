// Whether the scans fit the odometry: as the tour says, or in another way.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "hitos/capture/tour_examination.hpp"

namespace hitos {
namespace {

using Kind = TourFinding::Kind;
using Hypothesis = TourExamination::Hypothesis;

/// How much better than what the tour says another reading of it has to fit.
constexpr double kClearly = 0.06;
/// A scan of which less lies on its neighbour says nothing about where it was.
constexpr double kFits = 0.4;
constexpr double kShortestDelay = 0.3;  // [s]

std::string seconds_words(double seconds) {
    return fmt::format("{:.{}f} s", seconds, std::abs(seconds) < 10.0 ? 2 : 1);
}

/// The best of some hypotheses by the agreement of every `every`-th pair.
struct Best {
    Hypothesis hypothesis;
    double agreement = 0.0;

    void try_out(const TourExamination& examination, const Hypothesis& other) {
        const std::optional<double> found = examination.agreement(other);
        if (!found || *found <= agreement) return;
        hypothesis = other;
        agreement = *found;
    }
};

/// The delay by which the scans fit best: of those that fit about as well, as on every lap of a
/// tour, the shortest. `begins`: from the first scan to the odometry's first reading; looked round
/// too where the clocks are `apart`; `asked`: which pairs are.
Best best_delay(const TourExamination& examination, double begins, bool apart,
                const Hypothesis& asked) {
    constexpr double kLongest = 60.0;
    constexpr double kStep = 0.5;
    constexpr double kFine = 0.05;
    constexpr double kAsWell = 0.01;
    const double middle = apart ? begins : 0.0;
    const auto at = [&](double delay) {
        Best one;
        Hypothesis hypothesis = asked;
        hypothesis.delay_s = delay;
        one.try_out(examination, hypothesis);
        return one;
    };
    std::vector<Best> tried;
    for (double away = -kLongest; away <= kLongest; away += kStep)
        tried.push_back(at(middle + away));
    const Best highest = *std::ranges::max_element(tried, {}, &Best::agreement);
    Best best = highest;
    for (const Best& one : tried) {
        if (one.agreement >= highest.agreement - kAsWell &&
            std::abs(one.hypothesis.delay_s - middle) <
                std::abs(best.hypothesis.delay_s - middle)) {
            best = one;
        }
    }
    for (double step = kStep; step >= kFine; step /= kStep / kFine) {
        for (bool better = true; better;) {
            better = false;
            for (const double next :
                 {best.hypothesis.delay_s - step, best.hypothesis.delay_s + step}) {
                const Best one = at(next);
                if (one.agreement <= best.agreement) continue;
                best = one;
                better = true;
            }
        }
    }
    return best;
}

/// Where the clocks run at different speeds, so that what is to be added grows over the tour.
std::optional<TourFinding> clock_speed(const TourExamination& examination, double told,
                                       const Best& late, double seconds, std::size_t every) {
    constexpr double kMostGained = 10.0;  // [s] over the tour
    constexpr double kMostDelay = 5.0;    // at its beginning
    constexpr double kStep = 0.5;
    constexpr double kFitsWell = 0.85;  // better than that a clock cannot make it
    if (told > kFitsWell || !(seconds > 0.0)) return std::nullopt;
    Best best;
    for (double gained = -kMostGained; gained <= kMostGained; gained += kStep) {
        for (double delay = -kMostDelay; delay <= kMostDelay; delay += kStep) {
            best.try_out(examination,
                         {.delay_s = delay, .gained = gained / seconds, .every = 4 * every});
        }
    }
    for (double step = kStep / 2.0; step > kStep / 32.0; step /= 2.0) {
        const Hypothesis about = best.hypothesis;
        best.agreement = 0.0;
        for (const double gained : {-step, 0.0, step}) {
            for (const double delay : {-step, 0.0, step}) {
                best.try_out(examination, {.delay_s = about.delay_s + delay,
                                           .gained = about.gained + gained / seconds,
                                           .every = every});
            }
        }
    }
    const double gained_s = best.hypothesis.gained * seconds;
    if (best.agreement < std::max(kFits, std::max(told, late.agreement) + kClearly) ||
        std::abs(gained_s) < kShortestDelay) {
        return std::nullopt;
    }
    return TourFinding{
        Kind::clock_speed, best.hypothesis.gained,
        message(HITOS_TEXT("Errors",
                           "the scans' clock does not run as fast as the odometry's: they fit it "
                           "where %1 are added at the beginning and %2 at the end (%3 % of their "
                           "points, against %4 % as they are stamped)"),
                seconds_words(best.hypothesis.delay_s),
                seconds_words(best.hypothesis.delay_s + gained_s),
                std::lround(100.0 * best.agreement), std::lround(100.0 * told)),
        marked(HITOS_TEXT("Errors",
                          "set the clocks of both computers alike, and record again; mapped in "
                          "parts, each with its --scan-delay, it is less wrong"))};
}

}  // namespace

void TourExamination::doubt_fit(std::vector<TourFinding>& found) const {
    if (path_.size() < 2 || pairs_.empty() || (way_m_ == 0.0 && turned_rad_ == 0.0)) return;
    const double apart =
        path_.front().time_s > last_scan_s_
            ? path_.front().time_s - last_scan_s_
            : (first_scan_s_ > path_.back().time_s ? path_.back().time_s - first_scan_s_ : 0.0);
    // What is asked costs a fraction of a second: enough pairs for a mean, not all of them.
    constexpr std::size_t kAsked = 128;
    const std::size_t every = std::max<std::size_t>(pairs_.size() / kAsked, 1);
    const double told = agreement({.every = every}).value_or(0.0);
    const Best late =
        best_delay(*this, path_.front().time_s - first_scan_s_, apart != 0.0, {.every = every});
    if (apart != 0.0) {
        Message when = message(
            HITOS_TEXT("Errors",
                       "scans are stamped from %1 to %2 s and the odometry from %3 to %4 s: they "
                       "share no time, so that the robot stands still in the map"),
            fmt::format("{:.3f}", first_scan_s_), fmt::format("{:.3f}", last_scan_s_),
            fmt::format("{:.3f}", path_.front().time_s),
            fmt::format("{:.3f}", path_.back().time_s));
        const bool fits = late.agreement > kFits;
        found.push_back(
            {Kind::clocks_apart, fits ? late.hypothesis.delay_s : apart, std::move(when),
             fits ? message(HITOS_TEXT("Errors",
                                       "the scans fit the odometry where %1 are added to their "
                                       "times: --scan-delay %2"),
                            seconds_words(late.hypothesis.delay_s),
                            fmt::format("{:.2f}", late.hypothesis.delay_s))
                  : marked(HITOS_TEXT("Errors",
                                      "set the clocks of both computers alike, and record again")),
             fits ? std::optional(late.hypothesis.delay_s) : std::nullopt});
        return;
    }
    const double seconds = last_scan_s_ - first_scan_s_;
    if (std::optional<TourFinding> speed = clock_speed(*this, told, late, seconds, every)) {
        found.push_back(*std::move(speed));
        return;
    }
    const std::size_t before = found.size();
    doubt_mounting(told, late.agreement, every, found);
    if (found.size() > before) return;
    if (late.agreement >= kFits && late.agreement >= told + kClearly &&
        std::abs(late.hypothesis.delay_s) >= kShortestDelay) {
        found.push_back(
            {Kind::scan_delay, late.hypothesis.delay_s,
             message(HITOS_TEXT("Errors",
                                "the scans fit the odometry of %1 from theirs (%2 % of their "
                                "points, against %3 % as they are stamped): their clocks differ, "
                                "and the map is wrong by what the robot drove meanwhile"),
                     seconds_words(late.hypothesis.delay_s), std::lround(100.0 * late.agreement),
                     std::lround(100.0 * told)),
             message(HITOS_TEXT("Errors", "add that to their times: --scan-delay %1"),
                     fmt::format("{:.2f}", late.hypothesis.delay_s)),
             late.hypothesis.delay_s});
        return;
    }
    doubt_scale(found);
}

/// Whether the laser fits better turned or mirrored, than as it is told and than at another time.
void TourExamination::doubt_mounting(double told, double late, std::size_t every,
                                     std::vector<TourFinding>& found) const {
    Best turned;
    constexpr int kTurns = 36;
    for (int i = 0; i < kTurns; ++i) {
        const double turn_rad = wrap_angle(2.0 * kPi * i / kTurns);
        turned.try_out(*this, {.turn_rad = turn_rad, .every = every});
        turned.try_out(*this, {.turn_rad = turn_rad, .mirrored = true, .every = every});
    }
    if (turned.agreement < kFits || turned.agreement < told + kClearly ||
        turned.agreement <= late) {
        return;
    }
    const double degrees = turned.hypothesis.turn_rad * kDegreesPerRadian;
    if (turned.hypothesis.mirrored) {
        found.push_back(
            {Kind::mirrored_laser, 1.0,
             message(HITOS_TEXT("Errors",
                                "the scans turn against the odometry (%1 % of their points fit "
                                "mirrored, %2 % as they are): the map is a mirror image"),
                     std::lround(100.0 * turned.agreement), std::lround(100.0 * told)),
             message(HITOS_TEXT("Errors",
                                "the laser is upside down, turned by %1 degrees, or the odometry "
                                "counts turns to the right; mend the transform of its frame"),
                     std::lround(degrees))});
        return;
    }
    found.push_back(
        {Kind::turned_laser, turned.hypothesis.turn_rad,
         message(HITOS_TEXT("Errors",
                            "the scans move %1 degrees off where the odometry drives (%2 % of "
                            "their points fit turned so, %3 % as they are): the map's path and "
                            "walls do not fit each other"),
                 std::lround(degrees), std::lround(100.0 * turned.agreement),
                 std::lround(100.0 * told)),
         marked(HITOS_TEXT("Errors",
                           "the laser is mounted otherwise than the recording says; mend the "
                           "transform of its frame"))});
}

/// Whether the way between two scans is longer or shorter by the scans than by the odometry.
void TourExamination::doubt_scale(std::vector<TourFinding>& found) const {
    constexpr double kLeast = 0.1;
    constexpr double kStep = 0.05;
    constexpr int kSteps = 10;
    // Over the way of a pair a tenth is a few centimetres.
    const Hypothesis asked{.near_m = 0.02, .near_per_range = 0.005};
    Best best;
    for (int i = -kSteps; i <= kSteps; ++i) {
        Hypothesis hypothesis = asked;
        hypothesis.scale = 1.0 + i * kStep;
        best.try_out(*this, hypothesis);
    }
    const double told = agreement(asked).value_or(0.0);
    const double scale = best.hypothesis.scale;
    if (std::abs(scale - 1.0) < kLeast - kStep / 2.0 || best.agreement < told + kClearly) return;
    found.push_back(
        {Kind::odometry_scale, scale,
         message(HITOS_TEXT("Errors",
                            "by the scans the robot drives %1 times as far as by the odometry (%2 "
                            "% of their points fit so, %3 % as it is told)"),
                 fmt::format("{:.2f}", scale), std::lround(100.0 * best.agreement),
                 std::lround(100.0 * told)),
         message(HITOS_TEXT("Errors",
                            "registration finds it (--preset recorded); else --set "
                            "source.odometry_scale=%1"),
                 fmt::format("{:.2f}", scale))});
}

/// Whether scans fit the odometry better as they are stamped than as they were received.
bool TourExamination::contradicted(const TourFinding& stamps) const {
    const std::optional<double> stamped = agreement(Hypothesis{});
    const std::optional<double> received = agreement({.delay_s = stamps.value});
    return !received || (stamped && *stamped > *received);
}

}  // namespace hitos
