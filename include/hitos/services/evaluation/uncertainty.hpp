// SPDX-License-Identifier: GPL-3.0-or-later
// How sure each landmark is from scan to scan [P fig 3c].
#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

#include "hitos/base/message.hpp"
#include "hitos/features/caracteristica.hpp"

namespace hitos {

/// The standard deviations of one landmark of the best hypothesis after one scan.
struct LandmarkSigma {
    std::uint64_t scan = 0;  ///< number of the scan, from 0
    double time_s = 0.0;     ///< stamp of the scan
    FeatureKind kind = FeatureKind::line;
    int landmark = 0;      ///< number among the landmarks of its kind, from 0
    double sigma_1 = 0.0;  ///< of rho of a line, of x of a corner [m]
    double sigma_2 = 0.0;  ///< of theta of a line [rad], of y of a corner [m]
};

/// Records them in bounded memory: where there would be more entries than the bound, every second
/// recorded scan is dropped and only every second one recorded from then on.
class UncertaintyRecord {
  public:
    static constexpr std::size_t kMostEntries = 200'000;
    explicit UncertaintyRecord(std::size_t most_entries = kMostEntries)
        : most_entries_(most_entries) {}

    /// The map of the best hypothesis after a scan; once for every scan, in order.
    void note(double time_s, const LandmarkMap& map);
    void clear();

    /// In the order of scans, lines before corners.
    const std::vector<LandmarkSigma>& entries() const { return entries_; }
    /// Memory that it takes.
    std::size_t bytes() const { return entries_.size() * sizeof(LandmarkSigma); }
    /// Scan numbers that are multiples of this are recorded.
    std::uint64_t every() const { return every_; }

  private:
    std::size_t most_entries_;
    std::vector<LandmarkSigma> entries_;
    std::uint64_t scans_ = 0;
    std::uint64_t every_ = 1;
};

/// One entry a line: scan (from 1), time_s, kind (line, corner), landmark (among its kind, from 1,
/// in the order of the map file), sigma_1, sigma_2.
std::string uncertainty_csv(const UncertaintyRecord& record);

/// Writes uncertainty.csv, and by gnuplot uncertainty.png with its data and script
/// (uncertainty.dat, uncertainty.gp): a curve for each landmark over the scans. Returns why there
/// is no picture, else an empty text. Throws FileError.
Message write_uncertainty(const UncertaintyRecord& record, const std::filesystem::path& folder);

}  // namespace hitos
