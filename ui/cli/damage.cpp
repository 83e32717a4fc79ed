// SPDX-License-Identifier: GPL-3.0-or-later
#include "damage.hpp"

#include <fmt/format.h>

#include "hitos/base/plural.hpp"

namespace hitos::cli {

std::string damage_text(const ReadReport& report) {
    std::string text;
    const auto are = [](std::uint64_t count, const char* one, const char* several) {
        return count == 1 ? one : several;
    };
    if (report.early_scans > 0) {
        text += fmt::format(
            "{} before the first odometry reading and {} used as if the robot had stood still "
            "until then; source.early_scans=leave_out leaves {} out\n",
            fmt::format("{} {}", report.early_scans,
                        are(report.early_scans, "scan lies", "scans lie")),
            are(report.early_scans, "is", "are"), are(report.early_scans, "it", "them"));
    }
    if (report.early_scans_left_out > 0) {
        text += fmt::format(
            "{} before the first odometry reading {} left out, as source.early_scans says\n",
            fmt::format("{} {}", report.early_scans_left_out,
                        are(report.early_scans_left_out, "scan", "scans")),
            are(report.early_scans_left_out, "was", "were"));
    }
    if (report.skipped > 0) {
        text += fmt::format("{} damaged {} skipped", report.skipped,
                            report.of_recording ? are(report.skipped, "message or record was",
                                                      "messages or records were")
                                                : are(report.skipped, "line was", "lines were"));
        if (!report.examples.empty()) {
            text += fmt::format("; {}", report.placed(report.examples.front()).english());
        }
        text += '\n';
    }
    if (report.stamps_backwards > 0) {
        text +=
            fmt::format("{} no later than the one ahead of it in the log, whose order was kept\n",
                        plural(report.stamps_backwards, "time stamp"));
    }
    return text;
}

}  // namespace hitos::cli
