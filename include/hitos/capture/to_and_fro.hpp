// SPDX-License-Identifier: GPL-3.0-or-later
// Whether places go to and fro between two tracks.
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <deque>

namespace hitos {

/// Takes the places that are told, of whatever kind with a distance `apart(a, b)`, and counts how
/// often they go back to a track that they left, as where two senders tell a place, each as often
/// as it likes.
template <class Place>
class ToAndFro {
  public:
    void note(const Place& place) {
        ++places_;
        if (!seen_.empty()) compare(place);
        seen_.push_front(place);
        if (seen_.size() > kRemembered) seen_.pop_back();
    }
    /// 0 where they are no more than chance.
    std::uint64_t returns() const {
        constexpr std::uint64_t kLeast = 10;
        constexpr std::uint64_t kOneIn = 5;
        constexpr std::uint64_t kOneFarIn = 100;
        if (turns_ >= kLeast && turns_ * kOneIn >= places_) return turns_;
        return far_ >= kLeast && far_ * kOneFarIn >= places_ ? far_ : 0;
    }

  private:
    static constexpr std::size_t kRemembered = 16;

    void compare(const Place& place) {
        constexpr double kJump = 0.01;    // what a robot at rest does not do between two of them
        constexpr double kBetween = 0.5;  // of it: what it does while both senders say the same
        constexpr double kFar = 0.05;
        constexpr double kTimes = 3.0;     // farther than along a track, and than is usual
        constexpr double kOneTrack = 0.2;  // of it: what a track goes on meanwhile
        constexpr std::size_t kTracks = 2;
        constexpr double kNewest = 0.1;
        const double step = apart(seen_.front(), place);
        double nearest = step;
        for (std::size_t i = 1; i < seen_.size(); ++i) {
            const double away = apart(seen_[i], place);
            if (i == 1 && step > kJump && away < kBetween * step) ++turns_;
            nearest = std::min(nearest, away);
        }
        if (step > kFar + kTimes * std::max(nearest, usual_)) {
            // Single places that are wrong are on no track.
            const Place& left = seen_.front();
            const bool again = std::ranges::any_of(
                left_, [&](const Place& before) { return apart(before, left) < kOneTrack * step; });
            if (again) ++far_;
            left_.push_front(left);
            if (left_.size() > kTracks) left_.pop_back();
        }
        usual_ += kNewest * (nearest - usual_);
    }

    std::deque<Place> seen_;  ///< the newest first
    std::deque<Place> left_;  ///< where each track was when it was left last
    double usual_ = 0.0;      ///< from place to place along a track
    std::uint64_t places_ = 0;
    std::uint64_t turns_ = 0;  ///< after one place back to about the one before it,
    std::uint64_t far_ = 0;    ///< and from far away, after however many
};

}  // namespace hitos
