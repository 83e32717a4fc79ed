// What TourExamination finds to doubt in what it has noted.
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "hitos/capture/tour_examination.hpp"
#include "median.hpp"

namespace hitos {
namespace {

using Kind = TourFinding::Kind;
using Hypothesis = TourExamination::Hypothesis;

/// How much better than what the tour says another reading of it has to fit.
constexpr double kClearly = 0.06;
/// A scan of which less lies on its neighbour says nothing about where it was.
constexpr double kFits = 0.4;

constexpr std::array<std::string_view, 12> kWords{
    "clocks-apart", "scan-delay",     "mirrored-laser",   "turned-laser",
    "no-odometry",  "still-odometry", "leaping-odometry", "odometry-units",
    "laser-units",  "beyond-a-turn",  "blind-laser",      "frozen-laser"};

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
/// too where the clocks are `apart`.
Best best_delay(const TourExamination& examination, double begins, bool apart, std::size_t every) {
    constexpr double kLongest = 60.0;
    constexpr double kStep = 0.5;
    constexpr double kFine = 0.05;
    constexpr double kAsWell = 0.01;
    const double middle = apart ? begins : 0.0;
    const auto at = [&](double delay) {
        Best one;
        one.try_out(examination, {.delay_s = delay, .every = every});
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

}  // namespace

std::string_view word_of(Kind kind) {
    return kWords.at(static_cast<std::size_t>(kind));
}

void TourExamination::doubt_readings(std::vector<TourFinding>& found) const {
    if (scans_ == 0) return;
    const double empty = static_cast<double>(empty_scans_) / static_cast<double>(scans_);
    constexpr double kMostEmpty = 0.9;
    if (empty > kMostEmpty) {
        found.push_back(
            {Kind::blind_laser, empty,
             message(HITOS_TEXT("Errors",
                                "%1 of %2 scans have no reading that can be used, so there is "
                                "nothing to map"),
                     empty_scans_, scans_),
             marked(HITOS_TEXT("Errors",
                               "look whether the range limits of the recording are swapped or "
                               "tiny; source.max_range sets the greatest range"))});
    }
    const double typical = median(medians_);
    constexpr double kFarthest = 200.0;
    if (typical > kFarthest) {
        found.push_back(
            {Kind::laser_units, typical,
             message(HITOS_TEXT("Errors",
                                "half of the readings are beyond %1 m, which no such laser sees; "
                                "the map is that many times too large"),
                     fmt::format("{:.0f}", typical)),
             marked(HITOS_TEXT("Errors",
                               "if they are millimetres, record them as metres, which messages of "
                               "lasers are in"))});
    }
    const double turn = std::abs(fan_.max_angle_rad - fan_.min_angle_rad);
    constexpr double kMoreThanATurn = 0.1;
    if (fan_.count > 1 && turn > 2.0 * kPi + kMoreThanATurn) {
        found.push_back(
            {Kind::beyond_a_turn, turn,
             message(HITOS_TEXT("Errors",
                                "the rays of a scan go over %1 degrees, more than a whole turn; "
                                "they lie upon each other in the map"),
                     fmt::format("{:.0f}", turn * kDegreesPerRadian)),
             marked(HITOS_TEXT("Errors",
                               "if angles were written in degrees, record them in radians"))});
    }
    constexpr double kMostSame = 0.5;
    constexpr std::uint64_t kLeastMoved = 20;
    if (moved_scans_ >= kLeastMoved &&
        static_cast<double>(same_scans_) > kMostSame * static_cast<double>(moved_scans_)) {
        found.push_back(
            {Kind::frozen_laser,
             static_cast<double>(same_scans_) / static_cast<double>(moved_scans_),
             message(HITOS_TEXT("Errors",
                                "%1 of %2 scans taken while the robot moved are the same as the "
                                "one before"),
                     same_scans_, moved_scans_),
             marked(HITOS_TEXT("Errors", "look whether the laser's driver hung"))});
    }
}

void TourExamination::doubt_odometry(std::vector<TourFinding>& found) const {
    if (readings_ == 0) {
        if (scans_ < 2) return;
        found.push_back(
            {Kind::no_odometry, static_cast<double>(scans_),
             marked(HITOS_TEXT("Errors",
                               "there is no odometry, so that all scans are put on one place")),
             marked(HITOS_TEXT("Errors",
                               "record it too: of ROS the topic of the odometry, or /tf together "
                               "with /tf_static"))});
        return;
    }
    constexpr double kNoRobot = 20.0;
    const double speed = median(speeds_);
    if (speed > kNoRobot) {
        found.push_back(
            {Kind::odometry_units, speed,
             message(HITOS_TEXT("Errors",
                                "by the odometry the robot mostly drives at %1 m/s, which none "
                                "of its kind does"),
                     fmt::format("{:.0f}", speed)),
             marked(HITOS_TEXT("Errors", "if positions are millimetres, record them as metres"))});
    } else if (leaps_ > 0) {
        found.push_back(
            {Kind::leaping_odometry, longest_step_m_,
             message(
                 HITOS_TEXT("Errors",
                            "the odometry leaps, by up to %1 m (line %2) and %3 in all, as where a "
                            "driver begins anew; the map falls in pieces there"),
                 fmt::format("{:.1f}", longest_step_m_), longest_step_line_, leaps_),
             marked(HITOS_TEXT("Errors", "map it with registration: --preset recorded"))});
    }
    if (way_m_ > 0.0 || turned_rad_ > 0.0) return;
    const std::optional<double> still = agreement(Hypothesis{});
    constexpr double kStandsStill = 0.8;
    if (!still || *still > kStandsStill) return;
    found.push_back(
        {Kind::still_odometry, 0.0,
         marked(HITOS_TEXT("Errors",
                           "the scans change and the odometry says that the robot never moved; "
                           "all scans are put on one place")),
         marked(HITOS_TEXT("Errors",
                           "if its messages hold velocities, take these: --set "
                           "source.odometry=velocities"))});
}

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
    const Best late = best_delay(*this, path_.front().time_s - first_scan_s_, apart != 0.0, every);
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
                  : marked(HITOS_TEXT(
                        "Errors", "set the clocks of both computers alike, and record again"))});
        return;
    }
    Best turned;
    constexpr int kTurns = 36;
    for (int i = 0; i < kTurns; ++i) {
        const double turn_rad = wrap_angle(2.0 * kPi * i / kTurns);
        turned.try_out(*this, {.turn_rad = turn_rad, .every = every});
        turned.try_out(*this, {.turn_rad = turn_rad, .mirrored = true, .every = every});
    }
    const Best& best = turned.agreement > late.agreement ? turned : late;
    constexpr double kShortest = 0.3;
    if (best.agreement < kFits || best.agreement < told + kClearly) return;
    if (&best == &late) {
        if (std::abs(late.hypothesis.delay_s) < kShortest) return;
        found.push_back(
            {Kind::scan_delay, late.hypothesis.delay_s,
             message(HITOS_TEXT("Errors",
                                "the scans fit the odometry of %1 from theirs (%2 % of their "
                                "points, against %3 % as they are stamped): their clocks differ, "
                                "and the map is wrong by what the robot drove meanwhile"),
                     seconds_words(late.hypothesis.delay_s), std::lround(100.0 * late.agreement),
                     std::lround(100.0 * told)),
             message(HITOS_TEXT("Errors", "add that to their times: --scan-delay %1"),
                     fmt::format("{:.2f}", late.hypothesis.delay_s))});
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

std::vector<TourFinding> TourExamination::findings() const {
    std::vector<TourFinding> found;
    doubt_readings(found);
    if (found.empty()) doubt_fit(found);
    doubt_odometry(found);
    std::ranges::stable_sort(found, {}, &TourFinding::kind);
    return found;
}

}  // namespace hitos
