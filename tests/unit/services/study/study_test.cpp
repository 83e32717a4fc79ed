// SPDX-License-Identifier: GPL-3.0-or-later
#include "hitos/services/study/study.hpp"

#include <gmock/gmock.h>

#include <atomic>

#include "hitos/base/error.hpp"
#include "hitos/base/folder_lock.hpp"
#include "hitos/services/evaluation/measures.hpp"
#include "hitos/services/results/results.hpp"
#include "hitos/services/run/algoritmo.hpp"
#include "hitos/services/run/open_source.hpp"
#include "hitos/services/study/study_check.hpp"
#include "study_fixture.hpp"

namespace hitos {
namespace {

namespace fs = std::filesystem;
using test::content;
using test::message_of;
using ::testing::ElementsAre;
using ::testing::HasSubstr;

TEST_F(StudyTest, ARunOfAStudyIsTheRunThatAlgoritmoDoes) {
    const StudyOutcome outcome = run(study("out"));
    EXPECT_EQ(outcome.computed, 12U);
    EXPECT_EQ(outcome.failed, 0U);
    ASSERT_EQ(outcome.records.size(), 12U);

    Configuracion configuration = study("out").configuration;
    set_parameter(configuration, "split_merge.dmax=0.05");
    set_parameter(configuration, "filter.particles=2");
    configuration.run.seed = 3;
    Algoritmo alone(configuration, open_source(configuration.source));
    while (alone.step()) {
    }
    const std::size_t number = 2 * 3 + 2;  // second dmax, first p, third seed
    EXPECT_EQ(outcome.plan.label(number), "dmax=0.05 p=2 seed 3");
    EXPECT_EQ(content(folder_ / "out" / "maps" / "dmax-0.05-p-2-s3.map"),
              map_to_text(alone.filter().best_map()));
    const StudyRecord& record = outcome.records[number];
    EXPECT_EQ(record.figures["error_m"],
              map_error(alone.filter().best_map(), study("out").reference)->mean_m);
    EXPECT_EQ(record.figures["lines"], 2);
    EXPECT_EQ(record.figures["corners"], 1);
    EXPECT_EQ(record.scans, 31U);
}

TEST_F(StudyTest, ThreadsShardsAndStopsChangeNoByte) {
    run(study("one"));
    const auto expected = files("one");
    EXPECT_EQ(expected.count("maps/dmax-0.02-p-2-s1.map"), 1U);
    EXPECT_EQ(expected.count("summary.tex"), 1U);

    StudyOptions two_threads;
    two_threads.threads = 2;
    run(study("two"), two_threads);
    EXPECT_EQ(files("two"), expected);

    std::vector<StudyLayout> layouts;
    for (int i = 3; i >= 1; --i) {
        StudyOptions shard;
        shard.shard = {i, 3};
        const std::string name = "shard" + std::to_string(i);
        EXPECT_EQ(run(study(name), shard).computed, 4U);
        EXPECT_FALSE(fs::exists(folder_ / name / "quality.csv"));
        layouts.push_back(study_in_folder(folder_ / name));
        run(study("common"), shard);
    }
    merge_study(study_in_folder(folder_ / "merged"), layouts);
    EXPECT_EQ(files("merged"), expected);
    merge_study(study_in_folder(folder_ / "common"));
    EXPECT_EQ(files("common"), expected);
    // The shards' runs are good for a whole study too.
    EXPECT_EQ(run(study("common")).reused, 12U);
}

TEST_F(StudyTest, AStoppedStudyTellsWhatIsDoneAndGoesOnFromThere) {
    run(study("one"));
    std::stop_source stop;
    StudyOptions options;
    options.stop = stop.get_token();
    std::size_t told = 0;
    options.listener = [&](const StudyPlan& plan, std::size_t run, const StudyRecord& record) {
        EXPECT_EQ(plan.runs(), 12U);
        EXPECT_EQ(run, told);
        EXPECT_TRUE(record.ok);
        if (++told == 3) stop.request_stop();
    };
    const StudyOutcome half = run(study("out"), options);
    EXPECT_TRUE(half.stopped);
    EXPECT_EQ(half.computed, 3U);
    EXPECT_EQ(told, 3U);
    EXPECT_FALSE(fs::exists(folder_ / "out" / "quality.csv"));

    std::size_t reused = 0;
    options.stop = {};
    options.listener = [&](const StudyPlan&, std::size_t run, const StudyRecord&) {
        if (run < 3) ++reused;
    };
    const StudyOutcome whole = run(study("out"), options);
    EXPECT_FALSE(whole.stopped);
    EXPECT_EQ(whole.reused, 3U);
    EXPECT_EQ(reused, 3U);
    EXPECT_EQ(files("out"), files("one"));
}

TEST_F(StudyTest, OnlyWhatIsMissingDamagedOrChangedIsDoneAnew) {
    run(study("out"));
    const auto expected = files("out");
    fs::remove(folder_ / "out" / "runs" / "dmax-0.02-p-2-s1.json");
    fs::remove(folder_ / "out" / "maps" / "dmax-0.02-p-2-s2.map");
    folder_.put("out/maps/dmax-0.02-p-2-s3.map", "rho: 1 theta: 2\n");
    folder_.put("out/runs/dmax-0.02-p-3-s1.json", "{\"run\": ");
    folder_.put("out/maps/.hitos-1999999999-0.tmp", "half");  // of a killed process
    const StudyOutcome again = run(study("out"));
    EXPECT_EQ(again.computed, 4U);
    EXPECT_EQ(again.reused, 8U);
    EXPECT_EQ(files("out"), expected);

    Study other = study("out");
    other.configuration.extraction.lines.min_length_m = 0.25;
    EXPECT_EQ(run(other).reused, 0U);
    Study noisy = study("out");
    noisy.setting = "other noise";
    EXPECT_EQ(run(noisy).reused, 0U);
    folder_.put("small.log", small_log() + "ODOM 9 0 0\n");
    EXPECT_EQ(run(noisy).reused, 0U);
    // A tour may be made of more files than the one that is named.
    Study drawn = noisy;
    const fs::path drawing = folder_.put("walls.dxf", "one");
    drawn.inputs = [drawing](const std::string& log) {
        return std::vector<fs::path>{log, drawing};
    };
    EXPECT_EQ(run(drawn).reused, 0U);
    EXPECT_EQ(run(drawn).reused, 12U);
    folder_.put("walls.dxf", "two");
    EXPECT_EQ(run(drawn).reused, 0U);
}

TEST_F(StudyTest, OfAnotherProgramNothingIsUsed) {
    EXPECT_GT(build_identity().size(), 32U + version().size());
    const std::string digest = plan_study(study("out")).digest;
    EXPECT_EQ(plan_study(study("other")).digest, digest) << "the place does not count";
    EXPECT_NE(plan_study(study("out"), "another").digest, digest);
    EXPECT_THAT(build_identity(), ::testing::MatchesRegex("([0-9a-f]{32}|development) .*"));
}

TEST_F(StudyTest, OneProcessAtATimeOrTheShardsOfOnePlan) {
    const Study whole = study("out");
    Study other = whole;
    other.configuration.extraction.lines.min_length_m = 0.25;
    StudyOptions part;
    part.shard = {1, 2};
    fs::create_directory(folder_ / "out");
    {
        const FolderLock held(folder_ / "out" / "study.json");
        EXPECT_THAT(test::message_of<FileError>([&] { run(whole); }),
                    HasSubstr("is being written by process "));
    }
    EXPECT_EQ(run(whole).computed, 12U);
    {
        FolderLock shard(folder_ / "out" / "study.json", FolderLock::Shared{});
        EXPECT_TRUE(shard.alone());
        shard.share();
        EXPECT_THAT(test::message_of<FileError>([&] { run(whole); }),
                    HasSubstr("is being written"));
        EXPECT_EQ(run(whole, part).reused, 6U);
        EXPECT_THAT(test::message_of<FileError>([&] { run(other, part); }),
                    HasSubstr("is the plan of another study"));
    }
    EXPECT_FALSE(fs::exists(folder_ / "out" / ".study.json.hitos-lock"));
    EXPECT_EQ(run(other, part).computed, 6U);
}

TEST_F(StudyTest, MoreValuesAndSeedsKeepWhatIsDone) {
    run(study("out"));
    Study more = study("out");
    more.parameters[0] = parse_study_parameter("dmax=0.02,0.03,0.05");
    more.seeds = 4;
    const StudyOutcome outcome = run(more);
    EXPECT_EQ(outcome.reused, 12U);
    EXPECT_EQ(outcome.computed, 12U);
}

TEST_F(StudyTest, AFailingRunIsReportedAndTheNextGoesOn) {
    Study bad = study("out");
    bad.parameters = {parse_study_parameter("dmax=0.02,-1,many,0.05")};
    std::vector<std::string> told;
    StudyOptions options;
    options.observer = [&](const StudyProgress& progress) {
        if (!progress.failure.empty()) told.push_back(progress.failure);
    };
    const StudyOutcome outcome = run(bad, options);
    EXPECT_EQ(outcome.computed, 12U);
    EXPECT_EQ(outcome.failed, 6U);
    ASSERT_EQ(told.size(), 6U);
    EXPECT_EQ(told[0],
              "dmax=-1 seed 1: split_merge.dmax: -1 is out of range; allowed: 1e-06 to 10 m");
    EXPECT_THAT(told[3], HasSubstr("\"many\" is not a number"));
    EXPECT_TRUE(outcome.records[9].ok);
    EXPECT_THAT(content(folder_ / "out" / "quality.csv"), HasSubstr("\n-1,2,failed,"));
    // Tried again, not taken for done.
    EXPECT_EQ(run(bad).reused, 6U);
}

TEST_F(StudyTest, ASourceThatFailsForOneSeedFailsThatRun) {
    Study study = this->study("out");
    study.parameters.clear();
    std::atomic<int> opened = 0;
    study.source.seeded = [](const SourceParams&) { return true; };
    study.source.open = [&](const SourceParams& source, std::uint64_t seed) {
        ++opened;
        if (seed == 2) throw FileError("tape", verbatim("torn"));
        return open_source(source);
    };
    const StudyOutcome outcome = run(study);
    EXPECT_EQ(outcome.failed, 1U);
    EXPECT_EQ(outcome.records[1].problem.english(), "tape: torn");
    EXPECT_GE(outcome.records[1].seconds, 0.0);  // until it failed
    EXPECT_GE(outcome.records[1].cpu_seconds, 0.0);
    EXPECT_EQ(opened, 4) << "once to see whether it opens at all, then run by run";
}

TEST_F(StudyTest, MissingLogsThatAreVariedFailRunByRun) {
    Study study = this->study("out");
    StudyParameter logs = find_study_parameter("source.file");
    logs.values = {{log_.string()}, {(folder_ / "missing.log").string()}};
    study.parameters = {logs};
    const StudyOutcome outcome = run(study);
    EXPECT_EQ(outcome.failed, 3U);
    EXPECT_THAT(outcome.records[3].problem.english(), HasSubstr("missing.log"));
}

TEST_F(StudyTest, SeveralStudiesGoAtOnceAndShareAFolder) {
    std::vector<Study> studies{study("out"), study("out")};
    studies[0].layout = study_beside(folder_ / "out" / "a.csv");
    studies[1].layout = study_beside(folder_ / "out" / "b.txt");
    studies[1].configuration.filter.particles = 4;
    studies[1].parameters.pop_back();
    StudyProgress last;
    StudyOptions options;
    options.threads = 2;
    options.observer = [&](const StudyProgress& progress) { last = progress; };
    const std::vector<StudyOutcome> outcomes = run_studies(studies, options);
    EXPECT_EQ(outcomes[0].computed, 12U);
    EXPECT_EQ(outcomes[1].computed, 6U);
    EXPECT_EQ(last.runs, 18U);
    EXPECT_EQ(last.finished, 18U);
    EXPECT_EQ(last.fraction, 1.0);
    EXPECT_TRUE(fs::exists(folder_ / "out" / "a-summary.csv"));
    EXPECT_TRUE(fs::exists(folder_ / "out" / "b-maps" / "dmax-0.02-s1.map"));
    EXPECT_THAT(content(folder_ / "out" / "b.txt"), HasSubstr("b-maps/dmax-0.02-s1.map"));
}

TEST_F(StudyTest, WhatNoRunCouldDoEndsTheStudyAtOnce) {
    const auto message = [&](const auto& change) {
        Study bad = study("out");
        change(bad);
        return message_of<ConfigError>([&] { run(bad); });
    };
    const auto vary = [](const char* text) {
        return [text](Study& s) { s.parameters = {parse_study_parameter(text)}; };
    };
    EXPECT_THAT(message([](Study& s) { s.parameters.push_back(s.parameters[0]); }),
                HasSubstr("found 3 parameters; a study varies two"));
    EXPECT_THAT(message([](Study& s) { s.parameters[1] = s.parameters[0]; }),
                HasSubstr("varied by both parameters"));
    EXPECT_THAT(message([](Study& s) { s.parameters[0].values.clear(); }), HasSubstr("no value"));
    EXPECT_THAT(message([](Study& s) { s.parameters[0].values[0].push_back("x"); }),
                HasSubstr("2 components, expected 1"));
    EXPECT_THAT(message(vary("dmax=0.01,1e-2")), HasSubstr("the value 0.01 is given twice"));
    EXPECT_THAT(message(vary("run.seed=1,2")), HasSubstr("set by the study itself"));
    EXPECT_THAT(message(vary("grid.hit=1,2")), HasSubstr("has no effect on a landmark map"));
    EXPECT_THAT(message([&](Study& s) {
                    s.configuration.filter.motion.model = "proportional";
                    vary("mov=1/1/1")(s);
                }),
                HasSubstr("motion.sigma_x: has no effect where motion.model is proportional; set "
                          "it to odometry or no-odometry"));
    EXPECT_THAT(message(vary("ransac.threshold=0.02,0.04")),
                HasSubstr("ransac.threshold: has no effect where features.method is split-merge; "
                          "set it to ransac"));
    EXPECT_THAT(message([&](Study& s) {
                    set_parameter(s.configuration, "filter.algorithm=ekf-slam");
                    vary("resampling.neff_threshold=1,2")(s);
                }),
                HasSubstr("where filter.algorithm is ekf-slam; set it to fastslam"));
    EXPECT_THAT(message([](Study& s) { s.seeds = 0; }), HasSubstr("runs: found 0"));
    EXPECT_THAT(message([](Study& s) { s.first_seed = 0x7fffffffffffffff; }),
                HasSubstr("go beyond"));
    EXPECT_THAT(message([](Study& s) { s.configuration.filter.particles = 0; }),
                HasSubstr("filter.particles"));
    EXPECT_THAT(message([](Study& s) { s.configuration.source.file.clear(); }),
                HasSubstr("source.file"));
    EXPECT_FALSE(fs::exists(folder_ / "out")) << "nothing is made for a hopeless study";
}

TEST_F(StudyTest, FilesThatCannotBeReadOrWrittenAreNamed) {
    Study missing = study("out");
    missing.configuration.source.file = (folder_ / "none.log").string();
    EXPECT_THAT(message_of<FileError>([&] { run(missing); }), HasSubstr("none.log"));
    folder_.put("taken", "a file");
    EXPECT_THAT(message_of<FileError>([&] { run(study("taken")); }), HasSubstr("taken"));
    EXPECT_THAT(message_of<FileError>([&] { study_beside(folder_.path()); }),
                HasSubstr("is a folder; expected the path of the quality file"));
    folder_.put("study.json", R"({"format": "else"})");
    EXPECT_THAT(message_of<FormatError>([&] { merge_study(study_in_folder(folder_.path())); }),
                HasSubstr("study.json: expected format hitos-study 3"));
    folder_.put("study.json", "[");
    EXPECT_THAT(message_of<FormatError>([&] { merge_study(study_in_folder(folder_.path())); }),
                HasSubstr("is no plan of a study"));
}

TEST_F(StudyTest, MergeNamesMissingRunsAndOtherStudies) {
    StudyOptions first;
    first.shard = {1, 2};
    run(study("a"), first);
    EXPECT_THAT(message_of<Error>([&] { merge_study(study_in_folder(folder_ / "a")); }),
                HasSubstr("6 of 12 runs are not there: dmax=0.02 p=2 seed 2"));
    Study other = study("b");
    other.seeds = 1;
    run(other);
    const std::vector<StudyLayout> mixed{study_in_folder(folder_ / "a"),
                                         study_in_folder(folder_ / "b")};
    EXPECT_THAT(
        message_of<FormatError>([&] { merge_study(study_in_folder(folder_ / "c"), mixed); }),
        HasSubstr("is of another study than"));
}

TEST_F(StudyTest, NamesOfFilesAreSafeAndDiffer) {
    Study study = this->study("out");
    StudyParameter logs = find_study_parameter("source.file");
    logs.values = {{"a/b"}, {"a_b"}, {std::string(300, 'x')}};
    study.parameters = {logs};
    const StudyPlan plan = plan_study(study);
    EXPECT_EQ(plan.file_stem(0), "source.file-a_b--v1-s1");
    EXPECT_EQ(plan.file_stem(3), "source.file-a_b-s1");
    EXPECT_LT(plan.file_stem(6).size(), 160U);
    EXPECT_THAT(plan.keys(), ElementsAre("source.file"));
}

}  // namespace
}  // namespace hitos
