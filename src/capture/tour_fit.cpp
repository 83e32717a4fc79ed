// Whether the scans fit the odometry: as the tour says, or in another way.
#include <fmt/format.h>

#include <algorithm>
#include <array>
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
    constexpr double kNarrow = 0.1;
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
    // Of a robot that turns fast, what is nearest is narrower than a step.
    for (int i = -4; i <= 4; ++i) tried.push_back(at(middle + i * kNarrow));
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

/// The laser as it would fit best, turned or mirrored.
Best best_mounting(const TourExamination& examination, std::size_t every) {
    Best best;
    constexpr int kTurns = 36;
    for (int i = 0; i < kTurns; ++i) {
        const double turn_rad = wrap_angle(2.0 * kPi * i / kTurns);
        best.try_out(examination, {.turn_rad = turn_rad, .every = every});
        best.try_out(examination, {.turn_rad = turn_rad, .mirrored = true, .every = every});
    }
    return best;
}

/// How far the middle of the turns that fit as well lies from the one that was found [rad].
double off_middle(const TourExamination& examination, const Best& found) {
    constexpr int kDegrees = 15;
    constexpr double kAsWell = 0.01;
    Hypothesis near = found.hypothesis;
    near.near_m = 0.02;  // over the way of a pair some degrees are a few centimetres
    near.near_per_range = 0.005;
    std::array<double, 2 * kDegrees + 1> fits{};
    for (int i = 0; i <= 2 * kDegrees; ++i) {
        near.turn_rad = found.hypothesis.turn_rad + (i - kDegrees) * kRadiansPerDegree;
        fits.at(static_cast<std::size_t>(i)) = examination.agreement(near).value_or(0.0);
    }
    const double least = std::ranges::max(fits) - kAsWell;
    double sum = 0.0;
    int count = 0;
    for (int i = 0; i <= 2 * kDegrees; ++i) {
        if (fits.at(static_cast<std::size_t>(i)) < least) continue;
        sum += i - kDegrees;
        ++count;
    }
    return sum / count * kRadiansPerDegree;
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
    if (doubt_turns(told, late.agreement, every, found)) return;
    const std::size_t before = found.size();
    doubt_mounting(told, late.agreement, every, found);
    if (found.size() > before) return;
    if (late.agreement >= kFits && beats_standing(late.agreement) &&
        late.agreement >= told + kClearly && std::abs(late.hypothesis.delay_s) >= kShortestDelay) {
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
    if (doubt_dead(found)) return;
    doubt_scale(found);
    if (found.size() == before) doubt_turning(found);
}

/// Whether headings are in degrees, or were scaled as if they had been.
bool TourExamination::doubt_turns(double told, double otherwise, std::size_t every,
                                  std::vector<TourFinding>& found) const {
    constexpr double kMuchBetter = 0.2;
    constexpr double kBetterThanNone = 0.1;
    constexpr int kTurns = 36;  // where the first heading points is not known then
    if (told + kMuchBetter > 1.0) return false;
    const auto best_of = [&](double scale) {
        Best best;
        for (int i = 0; i < kTurns; ++i) {
            best.try_out(*this, {.turn_rad = wrap_angle(2.0 * kPi * i / kTurns),
                                 .turn_scale = scale,
                                 .every = every});
        }
        return best;
    };
    const Best less = best_of(kRadiansPerDegree);
    const Best more = best_of(kDegreesPerRadian);
    const Best& best = less.agreement > more.agreement ? less : more;
    // Who never turned, and drove now ahead and now aside, fits by chance too.
    if (best.agreement < told + kMuchBetter || best.agreement <= otherwise ||
        !beats_standing(best.agreement) ||
        best.agreement < best_of(0.0).agreement + kBetterThanNone ||
        best.agreement <= best_mounting(*this, every).agreement) {
        return false;
    }
    const double scale = best.hypothesis.turn_scale;
    found.push_back(
        {Kind::odometry_units, scale,
         message(HITOS_TEXT("Errors",
                            "by the scans the robot turns %1 times as far as by the odometry (%2 % "
                            "of their points fit so, %3 % as it is told): headings are %4"),
                 fmt::format("{:.3g}", scale), std::lround(100.0 * best.agreement),
                 std::lround(100.0 * told),
                 scale < 1.0
                     ? marked(HITOS_TEXT("Errors", "in degrees"))
                     : marked(HITOS_TEXT("Errors", "taken for degrees and turned into radians"))),
         marked(HITOS_TEXT("Errors",
                           "record them in radians; or take how the robot moved from the scans: "
                           "--set source.odometry=scans"))});
    return true;
}

/// Whether so many points fit that the odometry says more than that the robot stands: by chance,
/// and of slow robots, many do.
bool TourExamination::beats_standing(double share) const {
    constexpr double kMore = 0.1;
    const std::optional<double> standing = agreement({.scale = 0.0, .turn_scale = 0.0});
    return !standing || share >= *standing + kMore;
}

/// Whether nothing explains that the scans do not fit.
void TourExamination::doubt_whole(std::vector<TourFinding>& found) const {
    constexpr double kLooksAlike = 0.8;  // from everywhere, as in a corridor
    const double told = agreement(Hypothesis{}).value_or(1.0);
    if (told > kLooksAlike || beats_standing(told)) return;
    found.push_back(
        {Kind::unfit_odometry, told,
         message(HITOS_TEXT("Errors",
                            "the scans do not lie where the odometry puts them (%1 % of their "
                            "points do), and no other time, mounting or scale explains it"),
                 std::lround(100.0 * told)),
         marked(HITOS_TEXT("Errors",
                           "take how it moved from the scans: --set source.odometry=scans"))});
}

/// Whether the laser fits better turned or mirrored, than as it is told and than at another time.
void TourExamination::doubt_mounting(double told, double late, std::size_t every,
                                     std::vector<TourFinding>& found) const {
    Best turned = best_mounting(*this, every);
    if (turned.agreement < kFits || !beats_standing(turned.agreement) ||
        turned.agreement < told + kClearly || turned.agreement <= late) {
        return;
    }
    turned.hypothesis.turn_rad = wrap_angle(turned.hypothesis.turn_rad + off_middle(*this, turned));
    const double degrees = turned.hypothesis.turn_rad * kDegreesPerRadian;
    const Pose& told_pose = pairs_.front().first.pose_robot_laser;
    const std::string place = fmt::format(
        "{:.3g},{:.3g},{}", told_pose.x, told_pose.y,
        std::lround(wrap_angle(told_pose.theta + turned.hypothesis.turn_rad) * kDegreesPerRadian));
    if (turned.hypothesis.mirrored) {
        found.push_back(
            {Kind::mirrored_laser, 1.0,
             message(HITOS_TEXT("Errors",
                                "the scans turn against the odometry (%1 % of their points fit "
                                "mirrored, %2 % as they are): the map is a mirror image"),
                     std::lround(100.0 * turned.agreement), std::lround(100.0 * told)),
             message(HITOS_TEXT("Errors",
                                "the laser is upside down, or its rays go the other way round: "
                                "--laser-pose %1; or the odometry counts turns to the right"),
                     place + ",upside-down")});
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
         message(HITOS_TEXT("Errors",
                            "the laser is mounted otherwise than the recording says: --laser-pose "
                            "%1"),
                 place)});
}

/// Whether the way between two scans is longer or shorter by the scans than by the odometry.
void TourExamination::doubt_scale(std::vector<TourFinding>& found) const {
    constexpr double kLeast = 0.1;
    constexpr double kStep = 0.05;
    constexpr int kSteps = 10;
    constexpr double kFarthest = 12.0;
    // Over the way of a pair a tenth is a few centimetres.
    const Hypothesis asked{.near_m = 0.02, .near_per_range = 0.005};
    Best best;
    const auto try_out = [&](double scale) {
        Hypothesis hypothesis = asked;
        hypothesis.scale = scale;
        best.try_out(*this, hypothesis);
    };
    for (int i = -kSteps; i <= kSteps; ++i) try_out(1.0 + i * kStep);
    if (std::abs(best.hypothesis.scale - 1.0) > (kSteps - 1.5) * kStep) {
        for (double scale = kFarthest; scale > 1.0 / kFarthest; scale /= 1.0 + kStep) {
            try_out(scale);
        }
    }
    const double told = agreement(asked).value_or(0.0);
    const double scale = best.hypothesis.scale;
    if (std::abs(scale - 1.0) < kLeast - kStep / 2.0 || best.agreement < told + kClearly ||
        best.agreement < kFits) {
        return;
    }
    found.push_back(
        {Kind::odometry_scale, scale,
         message(HITOS_TEXT("Errors",
                            "by the scans the robot drives %1 times as far as by the odometry (%2 "
                            "% of their points fit so, %3 % as it is told)"),
                 fmt::format("{:.2f}", scale), std::lround(100.0 * best.agreement),
                 std::lround(100.0 * told)),
         message(HITOS_TEXT("Errors",
                            "say so: --set source.odometry_scale=%1; or the laser's readings are "
                            "%2 times what they should be: let its driver tell metres"),
                 fmt::format("{:.2f}", scale), fmt::format("{:.2f}", scale))});
}

/// Whether scans fit the odometry better as they are stamped, or by another time that was found,
/// than as they were received.
bool TourExamination::prefers_stamps(const TourFinding& receipts,
                                     const std::vector<TourFinding>& own) const {
    const std::optional<double> received = agreement({.delay_s = receipts.value});
    if (!received) return true;
    double best = agreement(Hypothesis{}).value_or(0.0);
    for (const TourFinding& finding : own) {
        if (!finding.scan_delay_s) continue;
        best = std::max(best, agreement({.delay_s = *finding.scan_delay_s}).value_or(0.0));
    }
    return best > *received;
}

}  // namespace hitos
