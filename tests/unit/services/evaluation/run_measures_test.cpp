// SPDX-License-Identifier: GPL-3.0-or-later
// The table of a run's figures: its words, and what is made of them.
#include "hitos/services/evaluation/run_measures.hpp"

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <optional>
#include <set>
#include <string>

#include "hitos/base/error.hpp"
#include "support.hpp"

namespace hitos {
namespace {

using ::testing::Contains;
using ::testing::HasSubstr;
using ::testing::Not;

const Measure& measure(const char* word) {
    return run_measures().find(word);
}

TEST(RunMeasures, WordsOfStatisticsHaveTheUnitAtTheirEnd) {
    EXPECT_EQ(measure("trajectory_error_m").stem(), "trajectory_error");
    EXPECT_EQ(measure("error_m").word_of("minimum"), "error_minimum_m");
    EXPECT_EQ(measure("error_m").word_of("variance", true), "error_variance_m2");
    EXPECT_EQ(measure("blur_m2").word_of("variance", true), "blur_variance_m4");
    EXPECT_EQ(measure("landmarks").word_of("variance", true), "landmarks_variance");
    EXPECT_EQ(measure("run_seconds").stem(), "run_seconds") << "its unit is no ending of it";
    EXPECT_EQ(printed_unit("m^2"), "m²");
    EXPECT_EQ(squared_unit(squared_unit("m")), "m^4");
}

TEST(RunMeasures, AMeanOfCountsHasADigitMore) {
    EXPECT_EQ(measure("lines").rounded(12.0, false), "12");
    EXPECT_EQ(measure("lines").rounded(12.25, true), "12.2");
    EXPECT_EQ(measure("error_m").rounded(0.1234, true), measure("error_m").rounded(0.1234, false));
}

TEST(RunMeasures, EachHasItsOwnWordsAndWhatHelpTextsSayOfIt) {
    std::set<std::string> words;
    std::set<std::string> stems;
    std::set<std::string> places;
    for (const Measure& one : run_measures().entries()) {
        const std::string& compared = one.compared_word.empty() ? one.word : one.compared_word;
        EXPECT_TRUE(words.insert(compared).second) << one.word;
        EXPECT_TRUE(stems.insert(one.stem()).second) << one.word;
        EXPECT_TRUE(one.place.empty() || places.insert(one.place).second) << one.word;
        EXPECT_FALSE(one.label.empty()) << one.word;
        EXPECT_EQ(one.take != nullptr, !one.purpose.empty()) << one.word;
        EXPECT_TRUE(one.take != nullptr || !one.place.empty()) << one.word << " is nowhere";
    }
    EXPECT_THAT(taken_measures(), Contains(&measure("error_m")));
    EXPECT_THAT(taken_measures(), Not(Contains(&measure("run_seconds"))));
}

TEST(RunMeasures, AWordThatStandsForSomethingElseIsRefused) {
    const auto refusal = [](const char* word, const char* unit) {
        Measure own{word, "own", Measure::About::course, unit};
        own.take = [](const MeasuredRun&) { return std::optional(1.0); };
        return test::message_of<ConfigError>([&] { run_measures().add(own); });
    };
    ASSERT_TRUE(run_measures().knows("error_m"));  // from here on it is closed
    for (const char* word : {"cell", "seed", "ok", "scans", "seconds", "map"}) {
        EXPECT_THAT(refusal(word, ""), HasSubstr(fmt::format("say \"{}\" of something", word)));
    }
    EXPECT_THAT(refusal("seconds_s", "s"), HasSubstr("word \"seconds_s\", but tables"));
    EXPECT_THAT(refusal("error_m2", "m^2"), HasSubstr("say \"error\" of something else"));
    EXPECT_THAT(refusal("way_m", "m"), HasSubstr("comes too late")) << "nothing but that";
}

TEST(RunMeasures, ValuesAreKeptByMeasure) {
    RunFigures figures;
    EXPECT_EQ(figures["error_m"], std::nullopt);
    figures["error_m"] = 0.5;
    EXPECT_EQ(figures[measure("error_m")], 0.5);
    EXPECT_EQ(figures["aligned_error_m"], std::nullopt);
    EXPECT_NE(figures, RunFigures());
    EXPECT_THROW(figures["error"], ConfigError);
}

}  // namespace
}  // namespace hitos
