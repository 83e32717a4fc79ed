// SPDX-License-Identifier: GPL-3.0-or-later
// What there is to doubt of a reference trajectory, each by itself.
#pragma once

#include <optional>
#include <vector>

#include "hitos/services/evaluation/suitability.hpp"
#include "path_pieces.hpp"
#include "stamp_pairs.hpp"

namespace hitos {

/// Over pieces of ten metres it is a mirror image of the path or of another size, or is nowhere
/// like it and far from it as a whole too. Nothing of a path of a few metres.
std::optional<Advice> doubt_of_shape(const PathPoints& path, const PathPoints& reference);

/// That its clock is another: with its stamps moved by up to a minute, or half of the path's time,
/// it lies much nearer to the path, as a whole and piece by piece. Of two moves that do as much, as
/// by a lap, the lesser one counts.
std::optional<Advice> doubt_of_clock(const Trajectory& path, const Trajectory& reference,
                                     double tolerance_s);

/// What the headings of a reference are worth, where the path has turned enough to tell.
enum class Headings {
    told,
    none,   ///< all the same
    unfit,  ///< neither the path turns so, nor do they look along the reference's own way
    turned  ///< all off by one angle, once the positions lie on the path's
};
struct HeadingsFit {
    Headings headings = Headings::told;
    int turns = 0;  ///< of the path
    int unlike = 0;
    double turned_rad = 0.0;

    bool told() const { return headings == Headings::told; }
    std::optional<Advice> doubt() const;
};
HeadingsFit fit_of_headings(const Trajectory& path, const std::vector<Matched>& matched);

}  // namespace hitos
