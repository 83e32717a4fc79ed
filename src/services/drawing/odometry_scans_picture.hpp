// SPDX-License-Identifier: GPL-3.0-or-later
// The true walls and the scans where the odometry puts them [P fig 3a].
#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <unordered_set>
#include <vector>

#include "hitos/base/message.hpp"
#include "hitos/capture/scan.hpp"
#include "hitos/services/files/trajectory_file.hpp"

namespace hitos {

/// What noise of odometry and laser makes of a tour that nothing has corrected. Everything in the
/// map's frame, whose origin is the odometry's.
class OdometryScansPicture {
  public:
    explicit OdometryScansPicture(Walls walls) : walls_(std::move(walls)) {}

    /// The next scan with its pose by odometry. Of points in the same square centimetre one is
    /// kept, so that the picture grows with the place and not with the tour.
    void add(const Scan& scan, const Pose& odometry);
    /// Draws odometry_scans.png by gnuplot, with its script (odometry_scans.gp): true walls grey,
    /// points blue, the odometry's path magenta; equal axes in metres. Returns why there is no
    /// picture, else an empty text. Throws FileError.
    Message write(const std::filesystem::path& folder) const;

  private:
    std::string script() const;

    Walls walls_;
    std::vector<Point2> points_;
    std::unordered_set<std::uint64_t> cells_;
    std::vector<Point2> path_;
};

}  // namespace hitos
