// SPDX-License-Identifier: GPL-3.0-or-later
#include "hitos/services/study/study_shard.hpp"

#include <fmt/format.h>

#include <charconv>
#include <cstdlib>

#include "hitos/base/error.hpp"
#include "hitos/base/text_input.hpp"

namespace hitos {
namespace {

std::optional<int> whole_number(std::string_view text) {
    int value = 0;
    const auto [stop, error] = std::from_chars(text.data(), text.data() + text.size(), value);
    if (error != std::errc{} || stop != text.data() + text.size()) return std::nullopt;
    return value;
}

/// The variables in which one scheduler tells a task its place.
struct ArrayVariables {
    const char* id;
    const char* first;
    const char* last;
    const char* step;
    const char* count;  ///< null where the scheduler does not tell it
};

constexpr ArrayVariables kSlurm{"SLURM_ARRAY_TASK_ID", "SLURM_ARRAY_TASK_MIN",
                                "SLURM_ARRAY_TASK_MAX", "SLURM_ARRAY_TASK_STEP",
                                "SLURM_ARRAY_TASK_COUNT"};
constexpr ArrayVariables kGridEngine{"SGE_TASK_ID", "SGE_TASK_FIRST", "SGE_TASK_LAST",
                                     "SGE_TASK_STEPSIZE", nullptr};

int number(const Environment& environment, const char* name) {
    const std::optional<std::string> text = environment(name);
    const std::optional<int> value = text ? whole_number(*text) : std::nullopt;
    if (!value) {
        const Message found =
            text ? message(HITOS_TEXT("Errors", "found %1"), input::in_quotes(*text))
                 : message(HITOS_TEXT("Errors", "is not set"));
        throw ConfigError(
            name,
            HITOS_TEXT("Errors", "%1, expected a whole number; say the shard with --shard i/n"),
            found);
    }
    return *value;
}

StudyShard shard_of(const Environment& environment, const ArrayVariables& names) {
    const int id = number(environment, names.id);
    const int first = number(environment, names.first);
    const int last = number(environment, names.last);
    const int step = environment(names.step) ? number(environment, names.step) : 1;
    if (step < 1 || id < first || id > last || (id - first) % step != 0) {
        throw ConfigError(
            names.id,
            HITOS_TEXT(
                "Errors",
                "found task %1 of an array from %2 to %3 by %4; say the shard with --shard i/n"),
            id, first, last, step);
    }
    const int count = (last - first) / step + 1;
    if (names.count != nullptr && environment(names.count) &&
        number(environment, names.count) != count) {
        throw ConfigError(names.count,
                          HITOS_TEXT("Errors",
                                     "found %1 tasks in an array from %2 to %3 by %4: it has gaps; "
                                     "say the shard with --shard i/n"),
                          number(environment, names.count), first, last, step);
    }
    return {(id - first) / step + 1, count};
}

}  // namespace

StudyShard parse_shard(std::string_view text) {
    const std::size_t slash = text.find('/');
    const auto index = whole_number(text.substr(0, slash));
    const auto count =
        slash == std::string_view::npos ? std::nullopt : whole_number(text.substr(slash + 1));
    if (!index || !count || *index < 1 || *count < *index) {
        throw ConfigError(
            "--shard", HITOS_TEXT("Errors", "found %1, expected i/n with 1 <= i <= n, such as 2/8"),
            input::in_quotes(text));
    }
    return {*index, *count};
}

Environment process_environment() {
    return [](const char* name) -> std::optional<std::string> {
        // Read before any thread starts; nothing in Hitos sets variables.
        const char* value = std::getenv(name);  // NOLINT(concurrency-mt-unsafe)
        if (value == nullptr) return std::nullopt;
        return value;
    };
}

std::optional<StudyShard> scheduler_shard(const Environment& environment) {
    if (environment(kSlurm.id)) return shard_of(environment, kSlurm);
    // Outside arrays Grid Engine sets the word "undefined".
    const auto grid_engine = environment(kGridEngine.id);
    if (grid_engine && *grid_engine != "undefined") return shard_of(environment, kGridEngine);
    for (const char* name : {"PBS_ARRAY_INDEX", "PBS_ARRAYID"}) {
        if (const auto index = environment(name)) {
            throw ConfigError(name,
                              HITOS_TEXT("Errors",
                                         "found task %1, but PBS does not tell how many there are; "
                                         "say the shard with --shard $%2/n"),
                              input::in_quotes(*index), name);
        }
    }
    return std::nullopt;
}

}  // namespace hitos
