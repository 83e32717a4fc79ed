// SPDX-License-Identifier: GPL-3.0-or-later
#include "path_pieces.hpp"

#include <algorithm>
#include <cmath>

#include "hitos/base/median.hpp"

namespace hitos {
namespace {

constexpr double kLongestPiece = 10.0;  // [m] of way
constexpr double kShortestPiece = 0.5;
constexpr double kPieces = 12.0;      // at least, of a short path
constexpr std::size_t kFewPoses = 4;  // say nothing of a piece

}  // namespace

double PathPiece::unlike(double scale, bool mirror) const {
    const double squares = scale * scale * path + reference;
    if (!(squares > 0.0)) return 0.0;
    const double both = 2.0 * scale * (mirror ? mirrored : straight);
    return std::sqrt(std::clamp((squares - both) / squares, 0.0, 1.0));
}

PathPiece piece_of(const PathPoints& path, const PathPoints& reference, std::size_t from,
                   std::size_t to) {
    const auto count = static_cast<double>(to - from);
    std::complex<double> mean;
    std::complex<double> mean_there;
    for (std::size_t i = from; i < to; ++i) {
        mean += path[i] / count;
        mean_there += reference[i] / count;
    }
    PathPiece piece;
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

std::vector<PathPiece> pieces_of(const PathPoints& path, const PathPoints& reference) {
    double way = 0.0;
    for (std::size_t i = 1; i < path.size(); ++i) way += std::abs(path[i] - path[i - 1]);
    const double length = std::min(kLongestPiece, way / kPieces);
    std::vector<PathPiece> pieces;
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
    std::erase_if(pieces, [](const PathPiece& piece) {
        return !(piece.path > 0.0) || !std::isfinite(piece.path + piece.reference);
    });
    return pieces;
}

double middle_unlike(const std::vector<PathPiece>& pieces, double scale, bool mirror) {
    std::vector<double> of_each;
    of_each.reserve(pieces.size());
    for (const PathPiece& piece : pieces) of_each.push_back(piece.unlike(scale, mirror));
    return median(of_each);
}

}  // namespace hitos
