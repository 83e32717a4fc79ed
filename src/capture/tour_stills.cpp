// SPDX-License-Identifier: GPL-3.0-or-later
// Whether the odometry stands, or is not there, while the scans say that the robot drives; or the
// scans stand while it drives.
#include <cmath>
#include <utility>

#include "hitos/capture/tour_examination.hpp"
#include "remedies.hpp"

namespace hitos {
namespace {

using Kind = TourFinding::Kind;

}  // namespace

/// Held against the first scan of where the odometry stands: from scan to scan, along a wall,
/// little changes. What seems to move while the robot stands (people, doors) leaves most as it was.
void TourExamination::note_still(const Pair& pair, double odometer) {
    constexpr double kStands = 0.01;  // [m], [rad]
    constexpr double kMoved = 0.6;
    constexpr Hypothesis kClosely{.near_m = 0.05, .near_per_range = 0.01};
    if (odometer - open_way_ >= kStands) {
        still_ = {};
        still_view_.reset();
        return;
    }
    if (!still_view_) {
        still_view_ = pair.first;
        still_.begin_s = pair.first.time_s;
    }
    const std::optional<double> same =
        agreement(Pair{*still_view_, pair.second}, Pose{}, kClosely, {});
    if (!same || *same > kMoved) return;
    ++still_.pairs;
    still_.end_s = pair.second.time_s;
    if (still_.pairs > longest_still_.pairs) longest_still_ = still_;
}

/// A laser that hung, or told scans twice.
void TourExamination::doubt_same_scans(std::vector<TourFinding>& found) const {
    constexpr double kMostSame = 0.03;  // no sound laser measures the same twice
    constexpr std::uint64_t kLeastMoved = 20;
    constexpr std::uint64_t kHung = 10;  // in a row
    if ((moved_scans_ >= kLeastMoved &&
         static_cast<double>(same_scans_) > kMostSame * static_cast<double>(moved_scans_)) ||
        longest_same_run_ >= kHung) {
        found.push_back(
            {Kind::frozen_laser,
             static_cast<double>(same_scans_) / static_cast<double>(moved_scans_),
             message(
                 HITOS_TEXT(
                     "Errors",
                     "%1 of %2 scans taken while the robot moved are the same as the one before"),
                 same_scans_, moved_scans_),
             {{2 * same_scans_ <= moved_scans_ && longest_same_run_ < kHung
                   ? marked(HITOS_TEXT(
                         "Errors",
                         "look whether scans are published twice, or the laser's driver hung"))
                   : marked(HITOS_TEXT("Errors", "look whether the laser's driver hung"))}}});
    }
}

void TourExamination::doubt_stills(std::vector<TourFinding>& found) const {
    constexpr std::size_t kLeastPairs = 3;
    if (longest_still_.pairs < kLeastPairs || path_.empty()) return;
    const auto tenths = [](double seconds) { return std::round(seconds * 10.0) / 10.0; };
    const double seconds = longest_still_.end_s - longest_still_.begin_s;
    Message what;
    if (last_.time_s < longest_still_.begin_s + seconds / 2.0) {
        what = message(HITOS_TEXT("Errors",
                                  "the odometry ends %1 s before the scans do, which change on; "
                                  "all of them are put on one place"),
                       tenths(last_scan_s_ - last_.time_s));
    } else if (path_.front().time_s > longest_still_.end_s - seconds / 2.0) {
        what = message(HITOS_TEXT("Errors",
                                  "the odometry begins %1 s after the scans, which change before; "
                                  "all of them are put on one place"),
                       tenths(path_.front().time_s - first_scan_s_));
    } else {
        what = message(HITOS_TEXT("Errors",
                                  "the scans change for %1 s, from second %2 of the tour on, and "
                                  "the odometry stands still; all of them are put on one place"),
                       tenths(seconds), tenths(longest_still_.begin_s - first_scan_s_));
    }
    found.push_back({Kind::still_odometry, seconds, std::move(what), {take_it_from_scans()}});
}

}  // namespace hitos
