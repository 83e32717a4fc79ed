// SPDX-License-Identifier: GPL-3.0-or-later
// A path and a reference, piece by piece: over ten metres even bad odometry bends little.
#pragma once

#include <complex>
#include <cstddef>
#include <vector>

namespace hitos {

/// Positions; the reference's are at the stamps of the path's.
using PathPoints = std::vector<std::complex<double>>;

inline constexpr double kUnlike = 0.25;       // recorded tours: 0.01, their odometry 0.02 to 0.07
inline constexpr std::size_t kFewPieces = 6;  // say nothing

/// A piece of the path and what the reference has of it, about their means: their squares, and what
/// the best turn makes of their product, as they are and in a mirror (Umeyama, 1991, in the plane).
struct PathPiece {
    double path = 0.0;
    double reference = 0.0;
    double straight = 0.0;
    double mirrored = 0.0;

    /// From 0, the same shape, to 1, nothing in common; the path is `scale` times as large.
    double unlike(double scale, bool mirror) const;
    /// Of squares that the best rigid motion leaves.
    double squares() const { return path + reference - 2.0 * straight; }
};

/// Of the poses from one to before another.
PathPiece piece_of(const PathPoints& path, const PathPoints& reference, std::size_t from,
                   std::size_t to);

/// Of equal way along the path; none of a path of a few metres.
std::vector<PathPiece> pieces_of(const PathPoints& path, const PathPoints& reference);

double middle_unlike(const std::vector<PathPiece>& pieces, double scale, bool mirror);

}  // namespace hitos
