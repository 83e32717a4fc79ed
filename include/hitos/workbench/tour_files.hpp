// SPDX-License-Identifier: GPL-3.0-or-later
// What a simulated tour is written as: the log that a robot would have written, and what is true.
#pragma once

#include <filesystem>
#include <functional>
#include <memory>
#include <span>
#include <string>

#include "hitos/capture/tour_reader.hpp"
#include "hitos/simulation/drive/simulated_tour.hpp"

namespace hitos {

/// An empty path: not wanted.
struct TourFiles {
    std::string format = "normalized";  ///< of the log: one of writable_formats()
    std::filesystem::path log;          ///< one that ends in .gz is compressed
    std::filesystem::path truth;        ///< the true path (TUM), one pose for each scan
    std::filesystem::path reference;    ///< the map of the walls
    std::filesystem::path picture;      ///< walls, true path, odometry, way points
};

/// Writes the files of a tour that is not driven any more; they change places together, the log
/// last. `told` is called after every scan of the log; where it throws, as on every failure,
/// nothing has changed. Throws ConfigError for a format that cannot be written, and FileError where
/// a file cannot be, is one of the `inputs` or another one's twin.
void write_tour_files(const std::shared_ptr<const SimulatedTour>& tour, const TourFiles& files,
                      std::span<const std::filesystem::path> inputs,
                      const std::function<void(const TourReader&)>& told = {});

/// Where the true path of a log lies beside it: "tour.truth.tum" of "tour.log.gz".
std::filesystem::path truth_beside(const std::filesystem::path& log);

}  // namespace hitos
