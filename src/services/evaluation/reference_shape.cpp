// SPDX-License-Identifier: GPL-3.0-or-later
// Whether a reference trajectory has the shape of the path, mirrored or of another size.

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "hitos/base/median.hpp"
#include "hitos/base/translatable.hpp"
#include "path_pieces.hpp"
#include "reference_doubts.hpp"
#include "reference_units.hpp"
#include "stamp_pairs.hpp"

namespace hitos {
namespace {

constexpr double kBent = 0.1;  // by how much a mirror has to change a piece
constexpr std::size_t kFewBends = 4;
constexpr double kMostOdometry = 1.25;  // times as long as the way is odometry that is badly gauged
constexpr double kElsewhere = 1.0 / 3.0;  // of the reference's extent

Advice of_another_size(double scale) {
    constexpr double kNear = 0.15;
    const std::string figure = fmt::format("{:.3g}", scale);
    for (const ReferenceUnit& unit : kReferenceUnits) {
        if (std::abs(std::log(scale / unit.per_metre)) < kNear)
            return {unit.of_trajectory, figure, {}};
    }
    return {HITOS_TEXT("Advice",
                       "The reference trajectory is %1 times as large as the path, piece by piece: "
                       "one of the two is not in metres. Errors against it are none of the "
                       "path's."),
            figure,
            {}};
}

}  // namespace

std::optional<Advice> doubt_of_shape(const PathPoints& own, const PathPoints& there) {
    const std::vector<PathPiece> pieces = pieces_of(own, there);
    if (pieces.size() < kFewPieces) return std::nullopt;
    std::vector<double> ratios;
    ratios.reserve(pieces.size());
    for (const PathPiece& piece : pieces) ratios.push_back(piece.reference / piece.path);
    const double scale = std::sqrt(median(ratios));
    const double straight = middle_unlike(pieces, scale, false);
    const double mirrored = middle_unlike(pieces, scale, true);
    if (std::min(straight, mirrored) < kUnlike &&
        (scale > kMostOdometry || scale * kMostOdometry < 1.0)) {
        return of_another_size(scale);
    }
    std::size_t bent = 0;
    std::size_t against = 0;
    for (const PathPiece& piece : pieces) {
        const double gain = piece.unlike(scale, false) - piece.unlike(scale, true);
        if (std::abs(gain) <= kBent) continue;
        ++bent;
        if (gain > 0.0) ++against;
    }
    if (mirrored < kUnlike && bent >= kFewBends && 10 * against >= 8 * bent) {
        return Advice{HITOS_TEXT("Advice",
                                 "The reference trajectory is a mirror image of the path (%1 of "
                                 "the bends): its y axis points the other way, or x and y have "
                                 "changed places. Errors against it are none of the path's."),
                      fmt::format("{}/{}", against, bent),
                      {}};
    }
    // Bad odometry is bent, but piece by piece it is like the truth.
    const bool by_chance =
        bent > kFewBends + 1 && 10 * against > 3 * bent && 10 * against < 8 * bent;
    if (straight < kUnlike && !by_chance) return std::nullopt;
    const PathPiece whole = piece_of(own, there, 0, own.size());
    const double squares = whole.squares();
    if (squares <= kElsewhere * kElsewhere * whole.reference) return std::nullopt;
    return Advice{HITOS_TEXT("Advice",
                             "The path is nowhere like the reference trajectory, not even over "
                             "short pieces (%1 off, after alignment): that is of another tour, or "
                             "the path went wrong from its start."),
                  fmt::format("{:.1f} m", std::sqrt(squares / static_cast<double>(own.size()))),
                  {}};
}

}  // namespace hitos
