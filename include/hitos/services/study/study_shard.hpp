// SPDX-License-Identifier: GPL-3.0-or-later
// Which part of a study a process does, said by the user or by a job scheduler.
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <string_view>

namespace hitos {

/// Part `index` (1-based) of `count`; 1 of 1 is the whole.
struct StudyShard {
    int index = 1;
    int count = 1;
    bool whole() const { return count == 1; }
    /// Runs are dealt like cards, so that the slow values do not all fall to one shard.
    bool takes(std::size_t run) const {
        return run % static_cast<std::size_t>(count) == static_cast<std::size_t>(index - 1);
    }
    friend bool operator==(const StudyShard&, const StudyShard&) = default;
};

/// Reads "i/n". Throws ConfigError.
StudyShard parse_shard(std::string_view text);

/// The value of an environment variable; nothing where it is not set.
using Environment = std::function<std::optional<std::string>(const char*)>;
Environment process_environment();

/// The shard that Slurm's (SLURM_ARRAY_TASK_*) or Grid Engine's (SGE_TASK_*) array variables say;
/// nothing outside a job array. Throws ConfigError where they do not say how many tasks there are
/// (PBS), or where the array has gaps: then --shard must say it.
std::optional<StudyShard> scheduler_shard(const Environment& environment);

}  // namespace hitos
