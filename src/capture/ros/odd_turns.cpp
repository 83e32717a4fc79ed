// SPDX-License-Identifier: GPL-3.0-or-later
#include "ros/odd_turns.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "remedies.hpp"

namespace hitos {
namespace {

using Kind = TourFinding::Kind;

constexpr double kRounding = 1e-2;

}  // namespace

void OddTurns::note(const Transform& read, std::uint64_t number) {
    constexpr double kSame = 1e-6;
    ++asked_;
    if (std::abs(read.length - 1.0) <= kRounding) return;
    least_ = odd_ == 0 ? read.length : std::min(least_, read.length);
    greatest_ = odd_ == 0 ? read.length : std::max(greatest_, read.length);
    if (odd_++ == 0) {
        first_length_ = read.length;
        number_ = number;
    }
    const bool about_z = read.qx == 0.0 && read.qy == 0.0;
    if (about_z && std::abs(read.qw * read.length - 1.0) < kSame) ++headings_;
}

bool OddTurns::tells() const {
    constexpr std::uint64_t kOneIn = 50;
    return odd_ > 0 && odd_ * kOneIn >= asked_;
}

bool OddTurns::alike() const {
    return odd_ == asked_ && greatest_ - least_ <= kRounding * greatest_;
}

Message OddTurns::what(const Message& of) const {
    const Message as = 2 * headings_ > odd_
                           ? marked(HITOS_TEXT("Errors", "as where a heading was written into z"))
                       : alike() ? marked(HITOS_TEXT("Errors", "as where nobody divided by it"))
                                 : marked(HITOS_TEXT("Errors",
                                                     "as where angles were written into it, or "
                                                     "its four numbers are not of one turn"));
    return message(HITOS_TEXT("Errors",
                              "the orientation of %1 of %2 %3 is no quaternion of length 1 (of "
                              "length %4 in message %5), %6"),
                   odd_, asked_, of, fmt::format("{:.3g}", first_length_), number_, as);
}

void OddTurns::tell_odometry(std::vector<TourFinding>& found) const {
    if (!tells()) return;
    std::vector<Remedy> remedies{{marked(
        HITOS_TEXT("Errors", "let its program write (0, 0, sin, cos) of half the heading"))}};
    if (!alike() && has_twist_) remedies.push_back(take_velocities());
    if (!alike()) remedies.push_back(take_it_from_scans());
    found.push_back({Kind::odometry_units, first_length_,
                     what(marked(HITOS_TEXT("Errors", "odometry readings"))), std::move(remedies)});
}

void OddTurns::tell_transforms(std::vector<TourFinding>& found) const {
    if (!tells()) return;
    found.push_back(
        {Kind::assumed_mounting,
         first_length_,
         what(marked(HITOS_TEXT("Errors", "transforms"))),
         {{marked(
             HITOS_TEXT("Errors",
                        "let its program write (0, 0, sin, cos) of half the turn, or say where the "
                        "laser sits: --laser-pose x,y,degrees"))}}});
}

}  // namespace hitos
