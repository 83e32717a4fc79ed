// SPDX-License-Identifier: GPL-3.0-or-later
// Which pairs of poses to take: options of evaluate and relations.
#pragma once

#include <CLI/CLI.hpp>
#include <string>

#include "hitos/services/evaluation/pose_pairs.hpp"
#include "options.hpp"

namespace hitos::cli {

/// `prefix` stands before the names, as in --rpe-consecutive. Returns that of the slack.
inline CLI::Option* add_spacing_options(CLI::App& command, const std::string& prefix,
                                        PairSpacing& spacing) {
    command.add_flag(
        "--" + prefix + "consecutive", spacing.consecutive,
        "Pairs one after the other (default: one that begins at every pose; which pairs "
        "exactly: docs/evaluation.md)");
    return command
        .add_option("--" + prefix + "slack", spacing.tolerance,
                    "Share of the way or time that such a pair may miss it by (default: 0.1)")
        ->check(non_negative());
}

}  // namespace hitos::cli
