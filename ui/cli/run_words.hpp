// SPDX-License-Identifier: GPL-3.0-or-later
// What hitos-cli run says of a run.
#pragma once

#include <cstdint>
#include <string>

#include "hitos/services/results/results.hpp"
#include "report.hpp"

namespace hitos::cli {

/// Its figures, its doubts, and the folder that has its files.
void tell_summary(const RunSummary& summary, const std::string& folder, const Report& report);

/// Processor seconds by stage, and their share of all.
void tell_times(const RunTimes& times, std::uint64_t scans, const Report& report);

}  // namespace hitos::cli
