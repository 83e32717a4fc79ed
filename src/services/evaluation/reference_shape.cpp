// SPDX-License-Identifier: GPL-3.0-or-later
// Whether a reference trajectory has the shape of the path, mirrored or of another size.

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <complex>
#include <vector>

#include "hitos/base/median.hpp"
#include "hitos/base/translatable.hpp"
#include "hitos/services/evaluation/reference_fit.hpp"
#include "stamp_pairs.hpp"

namespace hitos {
namespace {

using Points = std::vector<std::complex<double>>;

constexpr double kLongestPiece = 10.0;  // [m] of way; so far odometry that is bad bends it little
constexpr double kShortestPiece = 0.5;
constexpr double kPieces = 12.0;       // at least, of a short path
constexpr std::size_t kFewPieces = 6;  // say nothing
constexpr std::size_t kFewPoses = 4;   // nor does a piece of fewer
constexpr double kUnlike = 0.25;       // recorded tours: 0.01, their odometry 0.02 to 0.07
constexpr double kBent = 0.1;          // by how much a mirror has to change a piece
constexpr std::size_t kFewBends = 4;
constexpr double kMostOdometry = 1.25;  // times as long as the way is odometry that is badly gauged
constexpr double kElsewhere = 1.0 / 3.0;  // of the reference's extent

/// A piece of the path and what the reference has of it, about their means: their squares, and what
/// the best turn makes of their product, as they are and in a mirror (Umeyama, 1991, in the plane).
struct Piece {
    double path = 0.0;
    double reference = 0.0;
    double straight = 0.0;
    double mirrored = 0.0;

    /// From 0, the same shape, to 1, nothing in common; the path is `scale` times as large.
    double unlike(double scale, bool mirror) const {
        const double squares = scale * scale * path + reference;
        if (!(squares > 0.0)) return 0.0;
        const double both = 2.0 * scale * (mirror ? mirrored : straight);
        return std::sqrt(std::clamp((squares - both) / squares, 0.0, 1.0));
    }
};

Piece piece_of(const Points& path, const Points& reference, std::size_t from, std::size_t to) {
    const auto count = static_cast<double>(to - from);
    std::complex<double> mean;
    std::complex<double> mean_there;
    for (std::size_t i = from; i < to; ++i) {
        mean += path[i] / count;
        mean_there += reference[i] / count;
    }
    Piece piece;
    std::complex<double> straight;
    std::complex<double> mirrored;
    for (std::size_t i = from; i < to; ++i) {
        const std::complex<double> own = path[i] - mean;
        const std::complex<double> there = reference[i] - mean_there;
        piece.path += std::norm(own);
        piece.reference += std::norm(there);
        straight += std::conj(own) * there;
        mirrored += own * there;
    }
    piece.straight = std::abs(straight);
    piece.mirrored = std::abs(mirrored);
    return piece;
}

/// Of equal way along the path.
std::vector<Piece> pieces_of(const Points& path, const Points& reference) {
    double way = 0.0;
    for (std::size_t i = 1; i < path.size(); ++i) way += std::abs(path[i] - path[i - 1]);
    const double length = std::min(kLongestPiece, way / kPieces);
    std::vector<Piece> pieces;
    if (!(length >= kShortestPiece)) return pieces;
    double driven = 0.0;
    std::size_t from = 0;
    for (std::size_t i = 1; i <= path.size(); ++i) {
        if (i < path.size()) driven += std::abs(path[i] - path[i - 1]);
        if (i < path.size() && driven < length) continue;
        if (i - from >= kFewPoses) pieces.push_back(piece_of(path, reference, from, i));
        from = i;
        driven = 0.0;
    }
    std::erase_if(pieces, [](const Piece& piece) {
        return !(piece.path > 0.0) || !std::isfinite(piece.path + piece.reference);
    });
    return pieces;
}

double middle_unlike(const std::vector<Piece>& pieces, double scale, bool mirror) {
    std::vector<double> of_each;
    of_each.reserve(pieces.size());
    for (const Piece& piece : pieces) of_each.push_back(piece.unlike(scale, mirror));
    return median(of_each);
}

Advice of_another_size(double scale) {
    struct Unit {
        double per_metre = 1.0;
        std::string_view said;
    };
    constexpr double kNear = 0.15;
    const std::array units{
        Unit{1000.0, HITOS_TEXT("Advice",
                                "The reference trajectory is %1 times as large as the path: it is "
                                "in millimetres; divide its positions by 1000. Errors against it "
                                "are none of the path's.")},
        Unit{100.0, HITOS_TEXT("Advice",
                               "The reference trajectory is %1 times as large as the path: it is "
                               "in centimetres; divide its positions by 100. Errors against it "
                               "are none of the path's.")},
        Unit{1.0 / 0.3048, HITOS_TEXT("Advice",
                                      "The reference trajectory is %1 times as large as the path: "
                                      "it is in feet; multiply its positions by 0.3048. Errors "
                                      "against it are none of the path's.")}};
    const std::string figure = fmt::format("{:.3g}", scale);
    for (const Unit& unit : units) {
        if (std::abs(std::log(scale / unit.per_metre)) < kNear) return {unit.said, figure, {}};
    }
    return {HITOS_TEXT("Advice",
                       "The reference trajectory is %1 times as large as the path, piece by piece: "
                       "one of the two is not in metres. Errors against it are none of the "
                       "path's."),
            figure,
            {}};
}

}  // namespace

std::optional<Advice> doubt_of_shape(const Trajectory& path, const Trajectory& reference,
                                     double tolerance_s) {
    Points own;
    Points there;
    for (const Matched& pair : matched_by_stamp(path, reference, tolerance_s)) {
        own.emplace_back(path[pair.estimate].pose.x, path[pair.estimate].pose.y);
        there.emplace_back(pair.reference.x, pair.reference.y);
    }
    const std::vector<Piece> pieces = pieces_of(own, there);
    if (pieces.size() < kFewPieces) return std::nullopt;
    std::vector<double> ratios;
    ratios.reserve(pieces.size());
    for (const Piece& piece : pieces) ratios.push_back(piece.reference / piece.path);
    const double scale = std::sqrt(median(ratios));
    const double straight = middle_unlike(pieces, scale, false);
    const double mirrored = middle_unlike(pieces, scale, true);
    if (std::min(straight, mirrored) < kUnlike &&
        (scale > kMostOdometry || scale * kMostOdometry < 1.0)) {
        return of_another_size(scale);
    }
    std::size_t bent = 0;
    std::size_t against = 0;
    for (const Piece& piece : pieces) {
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
    const Piece whole = piece_of(own, there, 0, own.size());
    const double squares = whole.path + whole.reference - 2.0 * whole.straight;
    if (squares <= kElsewhere * kElsewhere * whole.reference) return std::nullopt;
    return Advice{HITOS_TEXT("Advice",
                             "The path is nowhere like the reference trajectory, not even over "
                             "short pieces (%1 off, after alignment): that is of another tour, or "
                             "the path went wrong from its start."),
                  fmt::format("{:.1f} m", std::sqrt(squares / static_cast<double>(own.size()))),
                  {}};
}

}  // namespace hitos
