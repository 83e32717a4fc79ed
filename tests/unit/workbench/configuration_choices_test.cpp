// SPDX-License-Identifier: GPL-3.0-or-later
#include "hitos/workbench/configuration_choices.hpp"

#include <gmock/gmock.h>

#include "hitos/base/error.hpp"
#include "hitos/workbench/shipped_data.hpp"
#include "support.hpp"

namespace hitos {
namespace {

using ::testing::HasSubstr;

TEST(ChooseValues, TakesAssignmentsInOrderThenSeedAndThreads) {
    Configuracion configuration;
    choose_values(configuration,
                  {{"filter.particles=5", "run.seed=4", "filter.particles=6"}, 9, 2});
    EXPECT_EQ(configuration.filter.particles, 6);
    EXPECT_EQ(configuration.run.seed, 9U);
    EXPECT_EQ(configuration.run.threads, 2);
    choose_values(configuration, {});
    EXPECT_EQ(configuration.run.seed, 9U);
}

TEST(ChooseValues, RefusesWhatCannotBe) {
    Configuracion configuration;
    EXPECT_THAT(test::message_of<ConfigError>([&] {
                    choose_values(configuration, {{"filter.particles=0"}, {}, {}});
                }),
                HasSubstr("filter.particles"));
    EXPECT_THROW(choose_values(configuration, {{}, {}, -1}), ConfigError);
    // Each allowed, impossible together.
    EXPECT_THROW(choose_values(configuration, {{"grid.hit=0", "grid.miss=0"}, {}, {}}),
                 ConfigError);
}

TEST(ShippedFile, IsFoundFromTheProgramsPlace) {
    EXPECT_TRUE(std::filesystem::exists(shipped_file("data/bigloop.log.gz")));
    EXPECT_TRUE(std::filesystem::exists(shipped_file("config/simulated.cfg")));
    EXPECT_TRUE(shipped_file("data/atlantis").empty());
}

}  // namespace
}  // namespace hitos
