// SPDX-License-Identifier: GPL-3.0-or-later
// What the logger's times, the last number of a CARMEN line, say of the stamps.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "hitos/capture/fuente.hpp"
#include "hitos/capture/tour_reader.hpp"

namespace hitos {

/// How the stamps of a log's first scans and of its ODOM lines lie against the logger's one clock.
struct CarmenClocks {
    /// To be added to the scans' stamps [s], where they are of another clock than those of ODOM.
    std::optional<double> scans_late_s;
    /// The scans' stamps and those of ODOM, each in order, are out of order among each other.
    bool to_and_fro = false;
    /// What makes a stamp of a logger's time [s], where stamps have too few digits and it has not.
    std::optional<double> from_logger_s;
    std::string scans;              ///< the message that they are in
    std::uint64_t asked = 0;        ///< lines of the kind whose stamps are coarse,
    std::uint64_t of_one_time = 0;  ///< and those with the stamp of the one before
};

/// Looks ahead in the log.
CarmenClocks carmen_clocks(const Fuente& fuente);

/// Those doubts, as far as the options do not take them away.
std::vector<TourFinding> carmen_doubts(const Fuente& fuente, const ReadOptions& options);

}  // namespace hitos
