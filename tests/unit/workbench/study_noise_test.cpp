// SPDX-License-Identifier: GPL-3.0-or-later
// Runs of a study that share what they read are the runs that read for themselves.
#include "hitos/workbench/study_noise.hpp"

#include "unit/services/study/study_fixture.hpp"

namespace hitos {
namespace {

class StudyNoiseTest : public StudyTest {
  protected:
    std::map<std::string, std::string> files_of(Study study, double noise, std::size_t bytes) {
        study.parameters.resize(1);
        study.seeds = 2;
        set_study_source(study, noise, OdometryNoiseKind::relative_sigma);
        std::filesystem::remove_all(study.layout.folder);
        StudyOptions options;
        options.threads = 2;
        options.shared_bytes = bytes;
        EXPECT_EQ(run(study, options).failed, 0U);
        return files("out");
    }
    /// Shared and not.
    void expect_same(const Study& study, double noise) {
        EXPECT_EQ(files_of(study, noise, StudyOptions{}.shared_bytes), files_of(study, noise, 0));
    }
    /// Few scans.
    Study world_study() const {
        Study study = this->study("out");
        study.configuration.source.file = HITOS_SOURCE_DIR "/data/worlds/recinto.toml";
        study.configuration.source.world_set = "laser.rate=0.5";
        return study;
    }
};

TEST_F(StudyNoiseTest, OfALogWithNoiseOfEachRun) {
    const Study study = this->study("out");
    expect_same(study, 0.0);
    expect_same(study, 0.3);
    EXPECT_NE(files_of(study, 0.3, StudyOptions{}.shared_bytes), files_of(study, 0.0, 0));
}

TEST_F(StudyNoiseTest, OfAWorldWithATourOfEachSeedOrOneForAll) {
    for (const double noise : {0.0, 0.3}) {
        Study study = world_study();
        expect_same(study, noise);
        study.configuration.source.tour_seed = 7;
        expect_same(study, noise);
    }
}

// What decides a world's tour beside the run is told apart.
TEST_F(StudyNoiseTest, AVariedWorldIsNotShared) {
    Study study = world_study();
    study.configuration.source.tour_seed = 7;
    study.parameters = {find_study_parameter("source.world_set")};
    study.parameters[0].values = {{"laser.rate=0.5"}, {"laser.rate=0.25"}};
    expect_same(study, 0.0);
    const auto files = files_of(study, 0.0, StudyOptions{}.shared_bytes);
    EXPECT_NE(files.at("maps/source.world_set-laser.rate_0.5--v1-s1.map"),
              files.at("maps/source.world_set-laser.rate_0.25--v2-s1.map"));
}

}  // namespace
}  // namespace hitos
