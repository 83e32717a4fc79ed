// SPDX-License-Identifier: GPL-3.0-or-later
#include "hitos/workbench/presets.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>
#include <set>
#include <string>

#include "hitos/base/error.hpp"
#include "hitos/services/configuration/archivo_configuracion.hpp"
#include "hitos/services/run/algoritmo.hpp"
#include "hitos/workbench/open_tour.hpp"
#include "hitos/workbench/shipped_data.hpp"

namespace hitos {
namespace {

TEST(Presets, AreTheConfigurationsThatComeWithHitos) {
    std::set<std::string> files;
    for (const auto& entry :
         std::filesystem::directory_iterator(std::filesystem::path(HITOS_SOURCE_DIR) / "config")) {
        if (entry.path().stem() != "init") files.insert(entry.path().stem().string());
    }
    std::set<std::string> words;
    for (const Preset& preset : presets()) {
        words.emplace(preset.word);
        const Configuracion configuration = preset_configuration(preset.word);
        EXPECT_NO_THROW(check(configuration)) << preset.word;
        EXPECT_TRUE(configuration.source.file.empty()) << preset.word;
        EXPECT_EQ(preset.purpose.back(), '.') << preset.word;
    }
    EXPECT_EQ(words, files);
}

TEST(Presets, AWordThatIsNoneIsAnsweredWithTheOthers) {
    try {
        static_cast<void>(preset_configuration("simulatd"));
        FAIL();
    } catch (const ConfigError& error) {
        EXPECT_THAT(error.what(), testing::HasSubstr("'simulatd'"));
        EXPECT_THAT(error.what(), testing::HasSubstr("simulated, thesis"));
    }
}

TEST(Presets, TheSourceDecidesWhereNobodyChooses) {
    const std::string root = HITOS_SOURCE_DIR;
    EXPECT_EQ(suited_preset(find_world("recinto").string()), "simulated");
    EXPECT_EQ(suited_preset("not/there.toml"), "simulated");
    EXPECT_EQ(suited_preset(find_world("posts").string()), "landmarks");
    EXPECT_EQ(suited_preset(find_world("orchard").string()), "trees");
    for (const char* world : {"corridor-cluttered", "park", "campus"})  // with what is no wall
        EXPECT_EQ(suited_preset(find_world(world).string()), "recorded") << world;
    for (const char* log :
         {"data/logs/radish.log.gz", "data/logs/carmen-flaser.log.gz",
          "data/logs/carmen-rawlaser.log.gz", "data/logs/carmen-robotlaser.log.gz",
          "tests/unit/capture/two-lasers-cut.bag"}) {
        EXPECT_EQ(suited_preset(root + '/' + log), "recorded") << log;
    }
    for (const char* log : {"data/logs/player-laser.log.gz", "data/logs/player-ranger.log.gz",
                            "data/logs/normalized.log.gz", "data/bigloop.log.gz", "README.md",
                            "data/maps/bigloop.map"}) {
        EXPECT_EQ(suited_preset(root + '/' + log), "") << log;
    }
    EXPECT_EQ(suited_preset(""), "");
    // Else one that cannot be read just now is run with other values.
    EXPECT_THROW(static_cast<void>(suited_preset("data/none.log")), FileError);
}

TEST(Presets, TheSuitedParametersNameNoSource) {
    const std::string logs = std::string(HITOS_SOURCE_DIR) + "/data/logs/";
    const auto text = [](const Configuracion& c) { return ArchivoConfiguracion::to_text(c); };
    EXPECT_EQ(text(suited_configuration(logs + "radish.log.gz")),
              text(preset_configuration("recorded")));
    EXPECT_EQ(text(suited_configuration(logs + "player-laser.log.gz")), text({}));
    EXPECT_EQ(text(suited_configuration("a.toml")), text(preset_configuration("simulated")));
    EXPECT_THROW(static_cast<void>(preset_configuration(kAutoPreset)), ConfigError);
}

std::vector<Advice> advice_of(Configuracion configuration, const std::filesystem::path& source,
                              int scans) {
    configuration.source.file = source.string();
    configuration.filter.particles = 5;
    Algoritmo run(configuration, open_tour(configuration), {.step_grid = false});
    for (int i = 0; i < scans && run.step(); ++i) {
    }
    return run.advice();
}

TEST(Advice, PresetsSuitTheWorldsTheyAreMadeFor) {
    for (const char* preset : {"simulated", "thesis", "ekf", "paper"}) {
        for (const char* world : {"recinto", "iusiani", "corridor"}) {
            const auto advice = advice_of(preset_configuration(preset), find_world(world), 150);
            EXPECT_TRUE(advice.empty()) << preset << ", " << world << ": " << advice[0].words();
        }
    }
}

TEST(Advice, TellsOfALaserThatIsTooRoughForTheThesis) {
    Configuracion configuration = preset_configuration("thesis");
    configuration.source.world_set.clear();  // the world's own 10 mm
    const auto advice = advice_of(configuration, find_world("bigloop2"), 150);
    ASSERT_EQ(advice.size(), 1U);
    EXPECT_EQ(advice[0].preset, "simulated");
    EXPECT_THAT(advice[0].words(), testing::HasSubstr("split_merge.dmax"));
    EXPECT_THAT(advice[0].words(), testing::EndsWith("Try --preset simulated."));
}

TEST(Advice, TellsOfKeyFramesUnderNoiseOfEveryScan) {
    // The robot drives at half a metre a second: with two scans in five seconds, far.
    Configuracion configuration = preset_configuration("thesis");
    configuration.source.world_set += " laser.rate=0.4";
    const auto advice = advice_of(configuration, find_world("recinto"), 60);
    ASSERT_EQ(advice.size(), 1U);
    EXPECT_THAT(advice[0].words(), testing::HasSubstr("between scans"));
    configuration.filter.motion.sigma_x_m = 0.1;  // noise that covers such a step
    EXPECT_TRUE(advice_of(configuration, find_world("recinto"), 60).empty());
}

TEST(Advice, OffersRegistrationForTheRecordingOfARobot) {
    const std::filesystem::path log =
        std::filesystem::path(HITOS_SOURCE_DIR) / "data/logs/carmen-flaser.log.gz";
    const auto advice = advice_of(preset_configuration("recorded-fastslam1"), log, 5);
    ASSERT_FALSE(advice.empty());
    EXPECT_EQ(advice[0].preset, "recorded");
    EXPECT_THAT(advice[0].words(), testing::EndsWith("Try --preset recorded."));
    for (const Advice& other : advice_of(preset_configuration("recorded"), log, 5)) {
        EXPECT_NE(other.preset, "recorded") << other.words();
    }
    Configuracion configuration = preset_configuration("recorded-fastslam1");
    configuration.source.read.scan_topic = "all";
    const auto of_ros = advice_of(
        configuration,
        std::filesystem::path(HITOS_SOURCE_DIR) / "tests/unit/capture/two-lasers-cut.bag", 5);
    ASSERT_FALSE(of_ros.empty());
    EXPECT_EQ(of_ros[0].preset, "recorded");
}

TEST(Advice, SaysNothingInTheFirstScans) {
    Configuracion configuration = preset_configuration("thesis");
    configuration.source.world_set.clear();
    EXPECT_TRUE(advice_of(configuration, find_world("bigloop2"), 10).empty());
}

}  // namespace
}  // namespace hitos
