// SPDX-License-Identifier: GPL-3.0-or-later
#include "hitos/services/results/kept_run.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "hitos/base/atomic_file.hpp"
#include "hitos/base/error.hpp"
#include "hitos/services/configuration/config_parameter.hpp"
#include "hitos/services/results/results.hpp"
#include "hitos/services/results/results_check.hpp"
#include "ready_tour.hpp"
#include "support.hpp"

namespace hitos {
namespace {

namespace fs = std::filesystem;
using test::content;
using test::small_tour;
using test::TempFolder;
using ::testing::AllOf;
using ::testing::ElementsAre;
using ::testing::ElementsAreArray;
using ::testing::HasSubstr;
using ::testing::IsEmpty;

class KeptRunTest : public testing::Test {
  protected:
    static void SetUpTestSuite() {
        Configuracion configuration = small_tour();
        run = std::make_unique<Algoritmo>(configuration, open_source(configuration.source));
        while (run->steps() < 60 && run->step()) {
        }
    }
    static void TearDownTestSuite() { run.reset(); }

    void SetUp() override {
        References references;
        references.map = run->filter().best_map();
        references.trajectory = run->odometry_trajectory();
        summary_ = write_results(*run, references, 2.5, out_.path());
    }
    /// What read_results() says of the folder.
    std::string refusal_of_folder() const {
        try {
            read_results(out_.path());
        } catch (const Error& error) {
            return error.what();
        }
        return "";
    }

    static inline std::unique_ptr<Algoritmo> run;
    RunSummary summary_;
    TempFolder out_;
};

TEST_F(KeptRunTest, AFolderOfResultsIsTheRunThatWroteIt) {
    const KeptRun kept = read_results(out_.path());
    EXPECT_EQ(kept.scans, 60U);
    EXPECT_EQ(kept.seconds, 2.5);
    EXPECT_THAT(differences(kept.configuration, run->configuration()), IsEmpty());
    EXPECT_EQ(kept.configuration.source.file, run->configuration().source.file);
    ASSERT_EQ(kept.path.size(), 60U);
    EXPECT_NEAR(kept.path.back().pose.x, run->best_trajectory().back().pose.x, 1e-8);
    EXPECT_NEAR(kept.odometry.back().pose.y, run->odometry_trajectory().back().pose.y, 1e-8);
    EXPECT_EQ(kept.figures["trajectory_error_m"], summary_.trajectory_error->rmse_m);
    EXPECT_EQ(kept.figures["error_m"], 0.0);
    const LandmarkMap map = run->filter().best_map();
    ASSERT_EQ(kept.map.size(), map.size());
    ASSERT_FALSE(kept.line_extents.empty());
    for (const LineExtent& extent : kept.line_extents) {
        const auto& line =
            std::get<Recta>(kept.map[static_cast<std::size_t>(extent.landmark)].value);
        EXPECT_NEAR(signed_distance(line, extent.a), 0.0, 1e-9);
        EXPECT_NEAR(signed_distance(line, extent.b), 0.0, 1e-9);
    }
}

TEST_F(KeptRunTest, ARunWithoutLandmarksIsReadToo) {
    Configuracion configuration = run->configuration();
    set_parameter(configuration, "split_merge.min_length=20");  // longer than any wall in sight
    Algoritmo blind(configuration, open_source(configuration.source));
    for (int i = 0; i < 5; ++i) ASSERT_TRUE(blind.step());
    ASSERT_TRUE(blind.filter().best_map().empty());
    write_results(blind, {}, 0.1, out_.path());
    const KeptRun kept = read_results(out_.path());
    EXPECT_EQ(kept.scans, 5U);
    EXPECT_TRUE(kept.map.empty());
    EXPECT_EQ(kept.figures["trajectory_error_m"], std::nullopt);
    EXPECT_EQ(kept.figures["error_m"], std::nullopt);
}

TEST_F(KeptRunTest, AFolderOfSomethingElseIsRefused) {
    const TempFolder other;
    EXPECT_THROW(read_results(other.path()), FileError);
    EXPECT_THROW(read_results(other.path() / "absent"), FileError);
    for (const char* text : {"", "{", "[]", "{}", R"({"scans": "many"})", R"({"scans": 1})"}) {
        write_file(out_.path() / "summary.json", text);
        EXPECT_THAT(refusal_of_folder(), HasSubstr("is no summary of a run")) << text;
    }
}

TEST_F(KeptRunTest, AMissingFileIsNamed) {
    for (const char* file :
         {"trajectory.tum", "odometry.tum", "segments.txt", "map.txt", "config.cfg"}) {
        write_results(*run, {}, 2.5, out_.path());
        std::filesystem::remove(out_.path() / file);
        EXPECT_THAT(refusal_of_folder(), HasSubstr(file));
    }
}

TEST_F(KeptRunTest, AFileThatIsNotTheRunsOwnIsRefused) {
    const fs::path map = out_.path() / "map.txt";
    const std::string text = content(map);
    write_file(map, text + "\n");
    EXPECT_THAT(refusal_of_folder(), AllOf(HasSubstr("map.txt: "), HasSubstr("of another run")));
    write_file(map, text);
    EXPECT_EQ(refusal_of_folder(), "");
    write_file(out_.path() / "grid_best.png", "");  // which it does not read
    EXPECT_EQ(refusal_of_folder(), "");
}

TEST_F(KeptRunTest, SegmentsOfAnotherMapAreRefused) {
    // As a summary says that does not name the files.
    const fs::path file = out_.path() / "summary.json";
    nlohmann::json summary = nlohmann::json::parse(content(file));
    summary.erase("files");
    summary.erase("rest_xxh3_128");
    write_file(file, summary.dump());
    EXPECT_EQ(refusal_of_folder(), "");
    write_file(out_.path() / "segments.txt", "0 0 1 0 4000\n");
    EXPECT_THAT(refusal_of_folder(), HasSubstr("mixes the files of several runs"));
    EXPECT_THAT(test::message_of<FormatError>([&] { check_results(out_.path()); }),
                HasSubstr("does not name the files"));
}

TEST_F(KeptRunTest, AFolderIsCheckedFileByFile) {
    const ResultsCheck whole = check_results(out_.path());
    EXPECT_TRUE(whole.whole());
    EXPECT_EQ(whole.files, summary_.files.size());
    EXPECT_GE(whole.files, 14U);
    fs::remove(out_.path() / "map.dxf");
    write_file(out_.path() / "odometry.tum", "0 0 0 0 0 0 0 1\n");
    write_file(out_.path() / "config.cfg", "[run]\nseed = ");
    std::vector<std::string> others;
    for (const char digit : {'7', '2', '9', '1', '8', '3'}) {
        others.push_back(std::string("grid_particle_") + digit + ".jpg");
        write_file(out_.path() / others.back(), "of another run");
    }
    std::ranges::sort(others);
    write_file(out_.path() / "notes.txt", "mine");
    const ResultsCheck check = check_results(out_.path());
    EXPECT_THAT(check.missing, ElementsAre("map.dxf"));
    EXPECT_THAT(check.changed, testing::UnorderedElementsAre("odometry.tum", "config.cfg"));
    EXPECT_THAT(check.left_over, ElementsAreArray(others));
}

TEST_F(KeptRunTest, ALogIsTheSameByWhateverNameItsFileHas) {
    write_file(out_.path() / "a.log", "a");
    fs::create_hard_link(out_.path() / "a.log", out_.path() / "b.log");
    write_file(out_.path() / "c.log", "a");
    const auto of = [&](const char* name) {
        Configuracion configuration;
        configuration.source.file = (out_.path() / name).string();
        return configuration;
    };
    EXPECT_TRUE(same_log(of("a.log"), of("b.log")));
    EXPECT_TRUE(same_log(of("a.log"), of("./a.log")));
    EXPECT_FALSE(same_log(of("a.log"), of("c.log")));
}

TEST_F(KeptRunTest, AChangedSummaryIsNone) {
    const fs::path file = out_.path() / "summary.json";
    const std::string whole = content(file);
    for (const char* word : {R"("finished": true)", R"("lines": )", R"("rest_xxh3_128": ")"}) {
        std::string changed = whole;
        changed.insert(changed.find(word) + std::string_view(word).size(), "1");
        write_file(file, changed);
        EXPECT_THAT(test::message_of<FormatError>([&] { check_results(out_.path()); }),
                    HasSubstr("summary.json: was changed since the run wrote it"))
            << word;
        EXPECT_THAT(refusal_of_folder(), HasSubstr("was changed since the run wrote it")) << word;
    }
    write_file(file, whole);
    EXPECT_TRUE(check_results(out_.path()).whole());
}

/// Of versions whose summaries stated no digest of themselves.
TEST_F(KeptRunTest, ASummaryThatContradictsTheConfigurationIsNone) {
    const fs::path file = out_.path() / "summary.json";
    auto summary = nlohmann::ordered_json::parse(content(file));
    summary.erase("rest_xxh3_128");
    write_file(file, summary.dump(2) + "\n");
    EXPECT_TRUE(check_results(out_.path()).whole());
    summary["seed"] = 99;
    write_file(file, summary.dump(2) + "\n");
    EXPECT_THAT(test::message_of<FormatError>([&] { check_results(out_.path()); }),
                HasSubstr("summary.json: says seed 99, and config.cfg beside it"));
}

TEST_F(KeptRunTest, ASummaryCannotNameFilesElsewhere) {
    const fs::path file = out_.path() / "summary.json";
    nlohmann::json summary = nlohmann::json::parse(content(file));
    summary.erase("rest_xxh3_128");
    for (const char* name : {"../map.txt", "/etc/passwd", "", "..", "a/b"}) {
        summary["files"] = {{{"name", name}, {"bytes", 1}, {"xxh3_128", ""}}};
        write_file(file, summary.dump());
        EXPECT_THAT(test::message_of<FormatError>([&] { check_results(out_.path()); }),
                    HasSubstr("expected a name without folders"))
            << name;
    }
}

std::vector<std::string> different_keys(const Configuracion& a, const Configuracion& b) {
    std::vector<std::string> keys;
    for (const ConfigParameter* parameter : differences(a, b)) keys.emplace_back(parameter->key);
    return keys;
}

TEST(ConfigurationDifferences, AreThoseThatCanChangeAResult) {
    const Configuracion a = small_tour();
    Configuracion b = a;
    EXPECT_THAT(different_keys(a, b), IsEmpty());
    b.run.threads = 7;
    b.source.file = "other.log";
    EXPECT_THAT(different_keys(a, b), IsEmpty());
    b.run.seed = 99;
    b.filter.particles = 21;
    EXPECT_THAT(different_keys(a, b), ElementsAre("filter.particles", "run.seed"));
}

TEST(ConfigurationDifferences, WhatHasNoEffectInBothIsNone) {
    Configuracion a = small_tour();
    set_parameter(a, "filter.algorithm=ekf-slam");
    Configuracion b = a;
    b.filter.particles = 21;
    EXPECT_THAT(different_keys(a, b), IsEmpty());
    set_parameter(b, "filter.algorithm=fastslam");
    const std::vector<std::string> keys = different_keys(a, b);
    EXPECT_THAT(keys, ::testing::Contains("filter.algorithm"));
    EXPECT_THAT(keys, ::testing::Contains("filter.particles"));
}

}  // namespace
}  // namespace hitos
