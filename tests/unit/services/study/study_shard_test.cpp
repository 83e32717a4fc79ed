// SPDX-License-Identifier: GPL-3.0-or-later
#include "hitos/services/study/study_shard.hpp"

#include <gmock/gmock.h>

#include <map>

#include "hitos/base/error.hpp"
#include "support.hpp"

namespace hitos {
namespace {

using test::message_of;
using ::testing::HasSubstr;

Environment environment(const std::map<std::string, std::string>& variables) {
    return [variables](const char* name) -> std::optional<std::string> {
        const auto found = variables.find(name);
        if (found == variables.end()) return std::nullopt;
        return found->second;
    };
}

Environment slurm(const char* id, const char* first, const char* last, const char* count,
                  const char* step = "1") {
    return environment({{"SLURM_ARRAY_TASK_ID", id},
                        {"SLURM_ARRAY_TASK_MIN", first},
                        {"SLURM_ARRAY_TASK_MAX", last},
                        {"SLURM_ARRAY_TASK_STEP", step},
                        {"SLURM_ARRAY_TASK_COUNT", count}});
}

TEST(StudyShard, EveryRunFallsToExactlyOneShard) {
    for (std::size_t run = 0; run < 50; ++run) {
        int takers = 0;
        for (int i = 1; i <= 7; ++i) takers += StudyShard{i, 7}.takes(run) ? 1 : 0;
        EXPECT_EQ(takers, 1);
        EXPECT_TRUE((StudyShard{1, 1}.takes(run)));
    }
}

TEST(StudyShard, ReadsIOfN) {
    EXPECT_EQ(parse_shard("2/8"), (StudyShard{2, 8}));
    EXPECT_EQ(parse_shard("1/1"), (StudyShard{1, 1}));
    for (const char* bad : {"", "3", "0/4", "5/4", "-1/4", "1/0", "a/b", "1/4x", "1/", "/4"}) {
        EXPECT_THAT(message_of<ConfigError>([&] { parse_shard(bad); }),
                    HasSubstr("expected i/n with 1 <= i <= n"))
            << bad;
    }
}

TEST(StudyShard, FollowsTheArraysOfSlurm) {
    EXPECT_EQ(scheduler_shard(environment({})), std::nullopt);
    EXPECT_EQ(scheduler_shard(slurm("1", "1", "4", "4")), (StudyShard{1, 4}));
    EXPECT_EQ(scheduler_shard(slurm("3", "0", "3", "4")), (StudyShard{4, 4}));
    EXPECT_EQ(scheduler_shard(slurm("7", "1", "10", "4", "3")), (StudyShard{3, 4}));
}

TEST(StudyShard, AnArrayWithGapsMustSayTheShardItself) {
    EXPECT_THAT(message_of<ConfigError>([] { scheduler_shard(slurm("3", "1", "7", "3")); }),
                HasSubstr("it has gaps; say the shard with --shard"));
    EXPECT_THAT(message_of<ConfigError>([] { scheduler_shard(slurm("9", "1", "4", "4")); }),
                HasSubstr("found task 9 of an array from 1 to 4"));
    EXPECT_THAT(message_of<ConfigError>([] { scheduler_shard(slurm("x", "1", "4", "4")); }),
                HasSubstr("SLURM_ARRAY_TASK_ID: found \"x\""));
    EXPECT_THAT(message_of<ConfigError>([] {
                    scheduler_shard(environment({{"SLURM_ARRAY_TASK_ID", "1"}}));
                }),
                HasSubstr("SLURM_ARRAY_TASK_MIN: is not set"));
}

TEST(StudyShard, FollowsGridEngineAndIsNotMisledByPbs) {
    EXPECT_EQ(scheduler_shard(environment({{"SGE_TASK_ID", "undefined"}})), std::nullopt);
    EXPECT_EQ(scheduler_shard(environment({{"SGE_TASK_ID", "5"},
                                           {"SGE_TASK_FIRST", "1"},
                                           {"SGE_TASK_LAST", "9"},
                                           {"SGE_TASK_STEPSIZE", "2"}})),
              (StudyShard{3, 5}));
    EXPECT_THAT(message_of<ConfigError>([] {
                    scheduler_shard(environment({{"PBS_ARRAY_INDEX", "2"}}));
                }),
                HasSubstr("--shard $PBS_ARRAY_INDEX/n"));
}

}  // namespace
}  // namespace hitos
