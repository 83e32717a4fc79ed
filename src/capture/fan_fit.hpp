// SPDX-License-Identifier: GPL-3.0-or-later
// From points back to a fan's ranges, for formats that log ranges.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "hitos/base/message.hpp"
#include "hitos/capture/scan.hpp"

namespace hitos {

/// The greatest range written where a scan does not say its own: the one of SICK scanners.
inline constexpr double kUnknownMaxRange = 81.91;

/// More rays than any laser has: what says so is damaged.
inline constexpr std::uint32_t kMostScannerRays = 1'000'000;

/// A scan as ranges. Rays without a point have range 0.
struct Sweep {
    Fan fan;  ///< max_range_m is set
    std::vector<double> ranges_m;
};

/// Turns scans into sweeps. Scans of normalised logs have no fan: one is derived from the points'
/// bearings and kept from scan to scan as long as it fits.
class FanFitter {
  public:
    /// `path` names the file under way in messages.
    explicit FanFitter(std::string path) : path_(std::move(path)) {}

    /// Throws FormatError where the points lie on no regular fan, or beyond its greatest range.
    Sweep sweep(const Scan& scan);
    /// Throws the FormatError of a scan that cannot be written as ranges.
    [[noreturn]] void fail(const Scan& scan, const Message& problem) const;

  private:
    void derive(const Scan& scan);

    std::string path_;
    Fan derived_;
};

}  // namespace hitos
