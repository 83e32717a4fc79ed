// SPDX-License-Identifier: GPL-3.0-or-later
// A picture of a simulated tour.
#pragma once

#include <filesystem>

#include "hitos/simulation/drive/simulated_tour.hpp"

namespace hitos {

/// Draws walls (black), the true path (red), the path that the noisy odometry tells (grey), way
/// points with their numbers (blue), start with heading (green) and a scale bar, in the world's
/// frame. The extension says the kind: .png, .jpg or .jpeg. Throws FileError.
void write_tour_picture(const SimulatedTour& tour, const std::filesystem::path& path);

}  // namespace hitos
