// SPDX-License-Identifier: GPL-3.0-or-later
// Whether a reference trajectory has another clock than the path.

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>
#include <vector>

#include "hitos/base/translatable.hpp"
#include "hitos/services/files/tour_time.hpp"
#include "reference_doubts.hpp"

namespace hitos {
namespace {

constexpr double kMostShift = 60.0;  // [s] or half of the path's time; further off nothing fits
constexpr double kCoarse = 0.5;      // [s] in which a robot indoors turns little
constexpr int kHalvings = 6;         // of it, down to 8 ms
constexpr double kLeastShift = 0.2;  // [s] less is what one calls the stamp of a scan
constexpr std::size_t kSamples = 200;
constexpr double kLeastError =
    0.05;                        // [m] at the stamps as they are; else there is nothing to gain
constexpr double kCommon = 0.8;  // of the poses that the reference tells of as it is
// Of the right clock no other fits clearly better: seven recorded tours and their odometry, six
// worlds of three laps, no error falls below 0.7 of what it was.
constexpr double kBetter = 0.6;        // the error as a whole
constexpr double kPieceBetter = 0.75;  // and what pieces have unlike
constexpr double kPieceUnlike = 0.1;   // which is little then
constexpr double kOfExtent = 0.05;     // as is the error
constexpr double kAsGood = 1.5;        // of two shifts
constexpr std::size_t kMostShifts = 4;

struct ShiftFit {
    double shift_s = 0.0;  // the reference's stamps less the path's
    double error_m = std::numeric_limits<double>::infinity();  // after rigid alignment
    double extent_m = 0.0;
    std::size_t common = 0;
};

/// Path and reference at a number of poses.
class Shifted {
  public:
    Shifted(const Trajectory& path, Trajectory reference, double tolerance_s)
        : reference_(std::move(reference)), tolerance_s_(tolerance_s) {
        std::erase_if(reference_,
                      [](const StampedPose& pose) { return !std::isfinite(pose.time_s); });
        std::ranges::stable_sort(reference_, {}, &StampedPose::time_s);
        const std::size_t step = path.size() / kSamples + 1;
        for (std::size_t i = 0; i < path.size(); i += step) samples_.push_back(path[i]);
    }

    ShiftFit by(double shift_s) const {
        PathPoints own;
        PathPoints there;
        for (const StampedPose& pose : samples_) {
            const auto found = pose_at(reference_, pose.time_s + shift_s, tolerance_s_);
            if (!found) continue;
            own.emplace_back(pose.pose.x, pose.pose.y);
            there.emplace_back(found->x, found->y);
        }
        ShiftFit fit{.shift_s = shift_s, .common = own.size()};
        if (own.empty()) return fit;
        const PathPiece whole = piece_of(own, there, 0, own.size());
        const auto count = static_cast<double>(own.size());
        fit.error_m = std::sqrt(std::max(0.0, whole.squares()) / count);
        fit.extent_m = std::sqrt(whole.reference / count);
        return fit;
    }

    /// From one that is better than what lies half a step of the coarse search beside it.
    ShiftFit best_near(ShiftFit best, std::size_t least_common) const {
        double step = kCoarse;
        for (int halving = 0; halving < kHalvings; ++halving) {
            step /= 2.0;
            for (const double shift_s : {best.shift_s - step, best.shift_s + step}) {
                const ShiftFit other = by(shift_s);
                if (other.common >= least_common && other.error_m < best.error_m) best = other;
            }
        }
        return best;
    }

  private:
    Trajectory reference_;
    double tolerance_s_;
    Trajectory samples_;
};

/// The best of several shifts that are each better than those beside it, the least of those as
/// good.
ShiftFit best_shift(const Shifted& shifted, double most_s, std::size_t least_common) {
    std::vector<ShiftFit> all;
    const int most = static_cast<int>(most_s / kCoarse);
    for (int i = -most; i <= most; ++i) {
        all.push_back(shifted.by(i * kCoarse));
        if (all.back().common < least_common)
            all.back().error_m = std::numeric_limits<double>::infinity();
    }
    std::vector<ShiftFit> found;
    for (std::size_t i = 0; i < all.size(); ++i) {
        const bool least = (i == 0 || all[i].error_m <= all[i - 1].error_m) &&
                           (i + 1 == all.size() || all[i].error_m <= all[i + 1].error_m);
        if (least && std::isfinite(all[i].error_m)) found.push_back(all[i]);
    }
    std::ranges::stable_sort(found, {}, &ShiftFit::error_m);
    if (found.size() > kMostShifts) found.resize(kMostShifts);
    double best_m = std::numeric_limits<double>::infinity();
    for (ShiftFit& fit : found) {
        fit = shifted.best_near(fit, least_common);
        best_m = std::min(best_m, fit.error_m);
    }
    std::erase_if(found, [&](const ShiftFit& fit) { return fit.error_m > kAsGood * best_m; });
    std::ranges::stable_sort(found, {}, [](const ShiftFit& fit) { return std::abs(fit.shift_s); });
    return found.empty() ? ShiftFit{} : found.front();
}

double piece_unlike(const Trajectory& path, const Trajectory& reference, double tolerance_s) {
    PathPoints own;
    PathPoints there;
    for (const Matched& pair : matched_by_stamp(path, reference, tolerance_s)) {
        own.emplace_back(path[pair.estimate].pose.x, path[pair.estimate].pose.y);
        there.emplace_back(pair.reference.x, pair.reference.y);
    }
    const std::vector<PathPiece> pieces = pieces_of(own, there);
    return pieces.size() < kFewPieces ? 1.0 : middle_unlike(pieces, 1.0, false);
}

}  // namespace

std::optional<Advice> doubt_of_clock(const Trajectory& path, const Trajectory& reference,
                                     double tolerance_s) {
    const Shifted shifted(path, reference, tolerance_s);
    const ShiftFit as_it_is = shifted.by(0.0);
    if (as_it_is.common < kFewPieces || as_it_is.error_m <= kLeastError) return std::nullopt;
    const double most_s = std::min(kMostShift, tour_duration_s(path) / 2.0);
    const auto least_common =
        static_cast<std::size_t>(std::ceil(kCommon * static_cast<double>(as_it_is.common)));
    if (!(most_s > 0.0)) return std::nullopt;
    const ShiftFit best = best_shift(shifted, most_s, least_common);
    if (!(best.error_m <= kBetter * as_it_is.error_m) || best.error_m > kOfExtent * best.extent_m ||
        std::abs(best.shift_s) < kLeastShift) {
        return std::nullopt;
    }
    Trajectory moved = reference;
    for (StampedPose& pose : moved) pose.time_s -= best.shift_s;
    const double unlike = piece_unlike(path, moved, tolerance_s);
    if (unlike > kPieceUnlike ||
        unlike > kPieceBetter * piece_unlike(path, reference, tolerance_s)) {
        return std::nullopt;
    }
    return Advice{
        best.shift_s < 0.0
            ? HITOS_TEXT("Advice",
                         "The reference trajectory fits the path where its stamps are taken %1 "
                         "later: its clock is behind that of the scans. Add them to its stamps; "
                         "errors against it as it is are none of the path's.")
            : HITOS_TEXT("Advice",
                         "The reference trajectory fits the path where its stamps are taken %1 "
                         "earlier: its clock is ahead of that of the scans. Subtract them from its "
                         "stamps; errors against it as it is are none of the path's."),
        fmt::format("{:.1f} s", std::abs(best.shift_s)),
        {}};
}

}  // namespace hitos
