// SPDX-License-Identifier: GPL-3.0-or-later
// Orientations of messages that are no quaternions of length 1.
#pragma once

#include <cstdint>
#include <vector>

#include "hitos/capture/tour_finding.hpp"
#include "ros/messages.hpp"

namespace hitos {

/// Noted of all messages of one kind, before their length was made 1.
class OddTurns {
  public:
    void note(const Transform& read, std::uint64_t number);
    void note_twist() { has_twist_ = true; }
    void tell_odometry(std::vector<TourFinding>& found) const;
    void tell_transforms(std::vector<TourFinding>& found) const;

  private:
    bool tells() const;
    /// Whether they are quaternions, all of one other length: so they are taken.
    bool alike() const;
    Message what(const Message& of) const;

    std::uint64_t asked_ = 0;
    std::uint64_t odd_ = 0;
    std::uint64_t headings_ = 0;  ///< of these: about z alone, with 1 for w
    double first_length_ = 1.0;   ///< of the first of these,
    std::uint64_t number_ = 0;    ///< and its message
    double least_ = 1.0;
    double greatest_ = 1.0;
    bool has_twist_ = false;
};

}  // namespace hitos
