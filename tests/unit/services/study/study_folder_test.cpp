// SPDX-License-Identifier: GPL-3.0-or-later
// What is in a study's folder is always of one study, and says so.
#include "study/study_folder.hpp"

#include <gmock/gmock.h>
#include <sys/wait.h>
#include <unistd.h>

#include <csignal>
#include <nlohmann/json.hpp>
#include <random>
#include <thread>

#include "hitos/base/error.hpp"
#include "hitos/services/study/study_check.hpp"
#include "results/written_files.hpp"
#include "study/study_files.hpp"
#include "study_fixture.hpp"

namespace hitos {
namespace {

namespace fs = std::filesystem;
using test::content;
using test::message_of;
using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;

class StudyFolderTest : public StudyTest {
  protected:
    StudyLayout layout() const { return study_in_folder(folder_ / "out"); }
    fs::path out(const std::string& name) const { return folder_ / "out" / name; }
    void expect_still_there(const std::map<std::string, std::string>& before) const {
        for (const auto& [name, text] : before) {
            EXPECT_TRUE(fs::exists(out(name)) && content(out(name)) == text) << name;
        }
    }
    /// Of other settings, so that no run can be used again.
    Study other() const {
        Study other = study("out");
        other.configuration.extraction.lines.min_length_m = 0.25;
        other.seeds = 2;
        return other;
    }
    /// Ends the study after a number of runs.
    static StudyOutcome stopped(const Study& study, std::size_t runs) {
        std::stop_source stop;
        StudyOptions options;
        options.stop = stop.get_token();
        std::size_t told = 0;
        options.listener = [&](const StudyPlan&, std::size_t, const StudyRecord&) {
            if (++told == runs) stop.request_stop();
        };
        return run(study, options);
    }
    std::vector<std::string> hidden_files() const {
        std::vector<std::string> names;
        for (const auto& entry : fs::directory_iterator(folder_ / "out")) {
            const std::string name = entry.path().filename().string();
            if (name.starts_with(".")) names.push_back(name);
        }
        return names;
    }
};

TEST_F(StudyFolderTest, IsCheckedRunByRunAndItsTablesMadeAnew) {
    EXPECT_FALSE(is_study(layout()));
    EXPECT_THROW(check_study(layout()), FileError);
    run(study("out"));
    EXPECT_TRUE(is_study(layout()));
    StudyCheck check = check_study(layout());
    EXPECT_TRUE(check.whole());
    EXPECT_EQ(check.runs, 12U);
    EXPECT_EQ(check.failed, 0U);
    const auto whole = files("out");

    folder_.put("out/summary.md", "of another study");
    fs::remove(out("summary.tex"));
    folder_.put("out/landmarks.gp", "changed");
    folder_.put("out/maps/stranger.map", "");
    check = check_study(layout());
    EXPECT_THAT(check.changed, ElementsAre("landmarks.gp", "summary.md", "summary.tex"));
    EXPECT_THAT(check.left_over, ElementsAre("maps/stranger.map"));
    fs::remove(out("maps/stranger.map"));
    EXPECT_EQ(recover_study(layout()).reused, 12U);
    EXPECT_EQ(files("out"), whole);
    EXPECT_TRUE(check_study(layout()).whole());

    folder_.put("out/maps/dmax-0.02-p-2-s3.map", "rho: 1 theta: 2\n");
    check = check_study(layout());
    EXPECT_THAT(check.missing, ElementsAre("dmax=0.02 p=2 seed 3"));
    EXPECT_EQ(check.failed, 0U);
    const StudyOutcome recovered = recover_study(layout());
    EXPECT_EQ(recovered.reused, 11U);
    EXPECT_EQ(recovered.failed, 1U);
    EXPECT_THAT(content(out("quality.csv")), HasSubstr("the run is not there"));
    check = check_study(layout());
    EXPECT_THAT(check.changed, IsEmpty());
    EXPECT_FALSE(check.finished);
    run(study("out"));
    EXPECT_EQ(files("out"), whole);
    EXPECT_THAT(hidden_files(), IsEmpty());
}

TEST_F(StudyFolderTest, ARecordOfAnEarlierVersionHasTheKindsOfLandmarksAlone) {
    const StudyOutcome outcome = run(study("out"));
    ASSERT_GT(outcome.records[0].figures["landmarks"].value(), 0.0);
    const std::string name = "out/runs/" + outcome.plan.file_stem(0) + ".json";
    auto record = nlohmann::ordered_json::parse(content(folder_ / name));
    ASSERT_EQ(record.erase("landmarks"), 1U);
    record.erase("checksum");
    folder_.put(name, study::sealed(record));
    EXPECT_TRUE(check_study(layout()).whole());
    const auto read = study::read_record(layout(), outcome.plan, 0);
    EXPECT_EQ(read.value().figures, outcome.records[0].figures);
}

TEST_F(StudyFolderTest, ARecordThatSomebodyChangedIsNone) {
    run(study("out"));
    const auto whole = files("out");
    std::string record = content(out("runs/dmax-0.02-p-2-s3.json"));
    const std::size_t at = record.find("\"scans\": 31");
    ASSERT_NE(at, std::string::npos);
    record.replace(at, 11, "\"scans\": 32");
    folder_.put("out/runs/dmax-0.02-p-2-s3.json", record);
    EXPECT_THAT(check_study(layout()).missing, ElementsAre("dmax=0.02 p=2 seed 3"));
    EXPECT_EQ(run(study("out")).computed, 1U);
    EXPECT_EQ(files("out"), whole);
    // Likewise the plan.
    std::string plan = content(out("study.json"));
    plan.replace(plan.find("\"seeds\": 3"), 10, "\"seeds\": 2");
    folder_.put("out/study.json", plan);
    EXPECT_THAT(message_of<FormatError>([&] { check_study(layout()); }),
                HasSubstr("study.json: the plan is damaged"));
}

/// A whole plan of other settings than the files were made by.
TEST_F(StudyFolderTest, APlanThatContradictsItsFilesIsNoticed) {
    run(study("out"));
    const study::PlanState state = study::read_plan_state(layout());
    const auto expect_noticed = [&](const char* what, const auto& change) {
        Study another = study("out");
        change(another);
        study::write_plan(layout(), plan_study(another), state);
        EXPECT_FALSE(check_study(layout()).whole()) << what;
    };
    expect_noticed("seeds", [](Study& s) { s.seeds = 2; });
    expect_noticed("first seed", [](Study& s) { s.first_seed = 2; });
    expect_noticed("value", [](Study& s) { s.parameters[0] = parse_study_parameter("dmax=0.03"); });
    expect_noticed("parameter",
                   [](Study& s) { s.configuration.extraction.lines.min_length_m = 0.25; });
    expect_noticed("setting", [](Study& s) { s.setting = "odometry noise 0.1"; });
    expect_noticed("pictures", [](Study& s) { s.pictures = StudyPictures::all; });
    expect_noticed("reference", [](Study& s) { s.reference.pop_back(); });
    folder_.put("other.log", small_log() + "ODOM 9 0 0\n");
    expect_noticed(
        "log", [&](Study& s) { s.configuration.source.file = (folder_ / "other.log").string(); });
    study::write_plan(layout(), plan_study(study("out")), state);
    EXPECT_TRUE(check_study(layout()).whole());
}

TEST_F(StudyFolderTest, PlansOfImpossibleSizesAreRefused) {
    run(study("out"));
    auto plan = nlohmann::ordered_json::parse(content(out("study.json")));
    plan.erase("checksum");
    for (const int seeds : {0, 2'000'000'000, 250'001}) {
        plan["seeds"] = seeds;
        folder_.put("out/study.json", study::sealed(plan));
        EXPECT_THAT(message_of<FormatError>([&] { check_study(layout()); }),
                    HasSubstr("the plan is damaged"))
            << seeds;
    }
    Study many = study("out");
    many.seeds = 250'001;
    EXPECT_THAT(message_of<ConfigError>([&] { plan_study(many); }),
                HasSubstr("4 values and 250001 runs of each are more than 1000000 runs"));
}

TEST_F(StudyFolderTest, AnotherStudyStaysUntilTheNewOneIsComplete) {
    run(study("out"));
    folder_.put("out/maps/notes.txt", "mine");
    folder_.put("out/paper.tex", "mine too");
    auto before = files("out");
    const StudyOutcome half = stopped(other(), 3);
    EXPECT_TRUE(half.stopped);
    EXPECT_TRUE(half.beside);
    EXPECT_TRUE(check_study(layout()).another);
    EXPECT_EQ(check_study(layout()).changed, std::vector<std::string>());
    expect_still_there(before);

    // The first one can still be gone on with, and keeps the other's runs.
    EXPECT_EQ(run(study("out")).reused, 12U);
    const StudyOutcome whole = run(other());
    EXPECT_EQ(whole.reused, 3U);
    EXPECT_FALSE(whole.beside);
    EXPECT_THAT(hidden_files(), IsEmpty());
    const StudyCheck check = check_study(layout());
    EXPECT_THAT(check.left_over, ElementsAre("maps/notes.txt"));
    EXPECT_TRUE(check.changed.empty() && check.missing.empty() && check.finished);
    EXPECT_EQ(content(out("paper.tex")), "mine too");
    fs::remove(out("maps/notes.txt"));
    fs::remove(out("paper.tex"));
    Study alone = other();
    alone.layout = study_in_folder(folder_ / "alone");
    run(alone);
    EXPECT_EQ(files("out"), files("alone"));
}

TEST_F(StudyFolderTest, RunsThatAreTheSameAreTakenOver) {
    run(study("out"));
    Study more = study("out");
    more.seeds = 5;
    more.parameters[0] = parse_study_parameter("dmax=0.02,0.03");
    const StudyOutcome outcome = run(more);
    EXPECT_EQ(outcome.reused, 6U);
    EXPECT_EQ(outcome.computed, 14U);
    more.layout = study_in_folder(folder_ / "alone");
    run(more);
    EXPECT_EQ(files("out"), files("alone"));
}

TEST_F(StudyFolderTest, ShardsOfAnotherStudyAndTheirMergeLeaveTheOldOneUntilTheEnd) {
    run(study("out"));
    const auto before = files("out");
    StudyOptions shard;
    shard.shard = {1, 2};
    run(other(), shard);
    EXPECT_THAT(message_of<Error>([&] { merge_study(layout()); }),
                HasSubstr("4 of 8 runs are not there"));
    expect_still_there(before);
    shard.shard = {2, 2};
    run(other(), shard);
    merge_study(layout());
    EXPECT_TRUE(check_study(layout()).whole());
    EXPECT_EQ(check_study(layout()).runs, 8U);
    EXPECT_THAT(hidden_files(), IsEmpty());
}

TEST_F(StudyFolderTest, WhatCannotBePutInPlaceLeavesTheOldOne) {
    run(study("out"));
    const auto before = files("out");
    fs::remove(out("summary.tex"));
    fs::create_directory(out("summary.tex"));
    folder_.put("out/summary.tex/mine", "");
    EXPECT_THAT(message_of<FileError>([&] { run(other()); }), HasSubstr("out/summary.tex"));
    fs::rename(out("summary.tex"), out("folder"));
    folder_.put("out/summary.tex", before.at("summary.tex"));
    expect_still_there(before);
    EXPECT_TRUE(fs::exists(out("folder/mine")));
    EXPECT_EQ(run(other()).reused, 8U) << "nothing is lost";
    EXPECT_TRUE(check_study(layout()).whole());
}

TEST_F(StudyFolderTest, KillsWhilePuttingInPlaceAreMendedByTheNextOne) {
    run(study("out"));
    StudyOptions runs_alone;
    runs_alone.tables = false;
    run(other(), runs_alone);
    ASSERT_TRUE(check_study(layout()).another);
    fs::copy(folder_ / "out", folder_ / "kept", fs::copy_options::recursive);
    Study fresh = other();
    fresh.layout = study_in_folder(folder_ / "fresh");
    run(fresh);
    const auto expected = files("fresh");

    std::mt19937 random(20261123);
    int interrupted = 0;
    const int kills = test::repeated(10);
    for (int kill = 0; kill < kills; ++kill) {
        fs::remove_all(folder_ / "out");
        fs::copy(folder_ / "kept", folder_ / "out", fs::copy_options::recursive);
        const pid_t child = ::fork();
        if (child == 0) {
            // Only what publishes: the plots take a hundred times as long.
            try {
                study::StudyFolder folder(layout(), plan_study(other()),
                                          study::StudyFolder::Keep::alone);
                std::vector<StudyRecord> records;
                for (std::size_t run = 0; run < folder.plan().runs(); ++run)
                    records.push_back(*folder.done(run));
                folder.publish(records, true);
            } catch (...) {
                ::_exit(1);
            }
            ::_exit(0);
        }
        // Once the list is there, the files change places.
        const fs::path journal = out(".study.json.hitos-next/journal.json");
        bool ended = false;
        while (!ended && !fs::exists(journal)) ended = ::waitpid(child, nullptr, WNOHANG) != 0;
        // Half of the kills come at once: the files cannot all have changed places by then.
        const auto delay = std::chrono::microseconds(kill % 2 == 0 ? 0 : random() % 4000);
        if (delay.count() > 0) std::this_thread::sleep_for(delay);
        if (!ended) {
            ::kill(child, SIGKILL);
            ::waitpid(child, nullptr, 0);
        }
        if (study::is_interrupted(layout())) {
            ++interrupted;
            EXPECT_FALSE(check_study(layout()).whole());
        }
        recover_study(layout());  // which also clears what the killed one left
        const StudyCheck check = check_study(layout());
        EXPECT_THAT(check.changed, IsEmpty());
        EXPECT_THAT(check.missing, IsEmpty());
        EXPECT_THAT(check.left_over, IsEmpty());
        EXPECT_EQ(check.runs, 8U);
        ASSERT_EQ(files("out"), expected) << kill;
    }
    EXPECT_GT(interrupted, 0);
}

TEST_F(StudyFolderTest, AStudyOfFailuresDoesNotReplaceAnother) {
    run(study("out"));
    const auto before = files("out");
    Study bad = study("out");
    bad.parameters = {parse_study_parameter("dmax=-1")};
    const StudyOutcome outcome = run(bad);
    EXPECT_EQ(outcome.failed, 3U);
    EXPECT_TRUE(outcome.beside);
    expect_still_there(before);
    EXPECT_TRUE(check_study(layout()).whole());
}

TEST_F(StudyFolderTest, ALogThatChangesMeanwhileEndsTheStudy) {
    StudyOptions options;
    options.listener = [&](const StudyPlan&, std::size_t run, const StudyRecord&) {
        if (run == 2) folder_.put("small.log", small_log() + "ODOM 9 0 0\n");
    };
    EXPECT_THAT(message_of<FileError>([&] { run(study("out"), options); }),
                HasSubstr("small.log: has changed while it was being worked on; 3 of 12 runs were "
                          "done before, of the file as it was, and the others are left out"));
    folder_.put("small.log", small_log());
    EXPECT_EQ(run(study("out")).reused, 3U) << "no run of the changed log was kept";
}

TEST_F(StudyFolderTest, AMergeTakesTheStudyThatWasWorkedOnLast) {
    StudyOptions whole;
    StudyOptions first;
    first.shard = {1, 2};
    run(study("out"), whole);
    run(other(), first);  // begun and dropped
    fs::remove(out("runs/dmax-0.02-p-2-s1.json"));
    run(study("out"), first);
    merge_study(layout());
    EXPECT_EQ(check_study(layout()).runs, 12U);
    EXPECT_TRUE(check_study(layout()).whole());
    EXPECT_TRUE(check_study(layout()).another);
}

TEST_F(StudyFolderTest, ADamagedJournalIsNone) {
    run(study("out"));
    fs::create_directory(out(".study.json.hitos-new"));
    folder_.put("out/.study.json.hitos-new/journal.json", "{");
    EXPECT_TRUE(check_study(layout()).interrupted);
    recover_study(layout());
    EXPECT_TRUE(check_study(layout()).whole());
    EXPECT_THAT(hidden_files(), IsEmpty());
}

TEST_F(StudyFolderTest, WhatCannotBeLookedAtIsNotLost) {
    run(study("out"));
    const std::string hidden = "out/.study.json.hitos-new/";
    fs::create_directory(folder_ / hidden);
    const std::string journal =
        R"({"with_runs": false, "files": [{"name": "blur.dat", "bytes": 1, "xxh3_128": ")" +
        std::string(32, '0') + R"("}, {"name": "study.json", "bytes": 1, "xxh3_128": ")" +
        std::string(32, '0') + R"("}]})";
    folder_.put(hidden + "journal.json", journal);
    fs::create_symlink("blur.dat", folder_ / hidden / "blur.dat");  // leads to itself
    EXPECT_THAT(message_of<FileError>([&] { recover_study(layout()); }), HasSubstr("blur.dat"));
    EXPECT_EQ(content(folder_ / hidden / "journal.json"), journal) << "the next one goes on";
}

TEST_F(StudyFolderTest, WhatCannotAllBePutInPlaceGoesBackToWhereItWaits) {
    run(study("out"));
    const auto before = files("out");
    Study longer = other();
    longer.seeds = 4;  // one more than the study has that is there
    constexpr std::size_t kDone = 15;
    stopped(longer, kDone);
    const fs::path next = out(".study.json.hitos-next");
    std::vector<WrittenFile> list;
    for (const auto& entry : fs::directory_iterator(next / "maps"))
        list.push_back(written_file(next, "maps/" + entry.path().filename().string()));
    ASSERT_EQ(list.size(), kDone);
    // As many of the two studies' names have changed places as a loss of power has left.
    const auto change_places = [&](const std::string& name) {
        if (fs::exists(out(name))) fs::rename(out(name), folder_ / "kept");
        fs::rename(next / name, out(name));
        if (fs::exists(folder_ / "kept")) fs::rename(folder_ / "kept", next / name);
    };
    change_places("maps/dmax-0.02-p-2-s1.map");
    change_places("maps/dmax-0.02-p-2-s4.map");
    // A file of the former study alone waits, too.
    fs::rename(out("landmarks.gp"), next / "landmarks.gp");
    list.push_back({"maps/lost.map", 1, {}});
    folder_.put("out/.study.json.hitos-next/journal.json",
                nlohmann::json{{"with_runs", true}, {"files", json_of(list)}}.dump());
    run(study("out"));  // finds all done
    expect_still_there(before);
    EXPECT_THAT(check_study(layout()).left_over, IsEmpty());
    EXPECT_THAT(check_study(layout()).missing, IsEmpty());
    EXPECT_EQ(run(longer).reused, kDone);
    EXPECT_TRUE(check_study(layout()).whole());
}

TEST_F(StudyFolderTest, APlanThatCannotBeReadJustNowIsNoReasonToWorkElsewhere) {
    run(study("out"));
    fs::remove(out("study.json"));
    fs::create_symlink("study.json", out("study.json"));  // leads to itself: an error to any reader
    StudyOptions first;
    first.shard = {1, 2};
    EXPECT_THAT(message_of<FileError>([&] { run(study("out"), first); }), HasSubstr("study.json"));
    EXPECT_THAT(hidden_files(), IsEmpty());
}

TEST_F(StudyFolderTest, LeftoversGoFromWhatIsThereAndFromWhatWaits) {
    run(study("out"));
    stopped(other(), 2);
    const std::vector<fs::path> left = {
        folder_.put("out/runs/.hitos-1-0.tmp", "half"), folder_.put("out/maps/.hitos-1-0.tmp", ""),
        folder_.put("out/.study.json.hitos-next/runs/.hitos-2-0.tmp", "half")};
    run(study("out"));
    for (const fs::path& file : left) EXPECT_EQ(fs::exists(file), file == left.back()) << file;
    run(other());
    EXPECT_TRUE(check_study(layout()).whole());
    EXPECT_THAT(hidden_files(), IsEmpty());
}

TEST_F(StudyFolderTest, FilesOfOthersWithTheNamesOfTablesStay) {
    fs::create_directory(folder_ / "out");
    folder_.put("out/blur.png", "mine");
    run(study("out"));
    EXPECT_EQ(content(out("blur.png")), "mine");
    EXPECT_THAT(message_of<FileError>([&] { merge_study(study_in_folder(folder_ / "none")); }),
                HasSubstr("none"));
    EXPECT_FALSE(fs::exists(folder_ / "none"));
}

TEST_F(StudyFolderTest, DamageOfTheLogIsInRecordsAndOutlastsAMerge) {
    folder_.put("small.log", small_log() + "LASER 9 nonsense\n");
    StudyOptions half;
    half.shard = {1, 2};
    run(study("out"), half);
    half.shard = {2, 2};
    run(study("out"), half);
    const StudyOutcome outcome = merge_study(layout());
    const StudyRecord* record = most_damaged(outcome.records);
    ASSERT_NE(record, nullptr);
    EXPECT_EQ(record->report.skipped, 1U);
    EXPECT_THAT(content(out("quality.csv")), HasSubstr(",1,0,0,\"line 63: "));
    EXPECT_THAT(content(out("summary.md")), HasSubstr("The log is damaged: 1 line skipped"));
}

}  // namespace
}  // namespace hitos
