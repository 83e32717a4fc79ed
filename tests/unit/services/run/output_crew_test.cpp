// SPDX-License-Identifier: GPL-3.0-or-later
#include "results/output_crew.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <atomic>
#include <filesystem>
#include <fstream>
#include <functional>
#include <map>
#include <new>
#include <optional>
#include <set>
#include <stdexcept>
#include <string>
#include <vector>

#include "hitos/services/configuration/archivo_configuracion.hpp"
#include "hitos/services/grid/grid.hpp"
#include "hitos/services/grid/grid_builder.hpp"
#include "hitos/services/run/open_source.hpp"
#include "support.hpp"

namespace hitos {
namespace {

using test::content;
using test::TempFolder;

AlgoritmoOptions along(OdometryGridAhead& ahead) {
    AlgoritmoOptions options;
    options.taken = [&ahead](const Scan& scan, const Pose& pose) { ahead.add(scan, pose); };
    return options;
}

/// Counts how often the tour is read from its beginning.
class CountedReader final : public TourReader {
  public:
    explicit CountedReader(std::unique_ptr<TourReader> reader,
                           std::shared_ptr<int> readings = std::make_shared<int>(0))
        : reader_(std::move(reader)), readings_(std::move(readings)) {
        ++*readings_;
    }
    std::shared_ptr<const int> readings() const { return readings_; }
    std::optional<Scan> next_scan() override { return reader_->next_scan(); }
    std::optional<Odometria> next_odometry() override { return reader_->next_odometry(); }
    void restart() override {
        ++*readings_;
        reader_->restart();
    }
    std::unique_ptr<TourReader> reopen() const override {
        return std::make_unique<CountedReader>(reader_->reopen(), readings_);
    }
    const ReadReport& report() const override { return reader_->report(); }
    std::optional<double> progress() const override { return reader_->progress(); }
    std::string name() const override { return reader_->name(); }
    std::string format() const override { return reader_->format(); }
    ReadOptions options() const override { return {}; }
    std::vector<TourFinding> findings() const override { return reader_->findings(); }
    std::optional<Truth> truth() const override { return reader_->truth(); }

  private:
    std::unique_ptr<TourReader> reader_;
    std::shared_ptr<int> readings_;
};

class OutputCrewTest : public testing::Test {
  protected:
    static Algoritmo tour(int threads = 1, const AlgoritmoOptions& options = {}) {
        Configuracion configuration;
        configuration.source.file =
            std::string(HITOS_SOURCE_DIR) + "/data/logs/player-laser.log.gz";
        configuration.filter.particles = 7;
        configuration.run.threads = threads;
        return {configuration, open_source(configuration.source), options};
    }
    static void run_all(Algoritmo& run) {
        while (run.step()) {
        }
    }
    static std::map<std::string, std::string> files_in(const std::filesystem::path& folder) {
        std::map<std::string, std::string> files;
        for (const auto& entry : std::filesystem::directory_iterator(folder)) {
            files[entry.path().filename().string()] = content(entry.path());
        }
        return files;
    }
    /// Writes the file half, then does `before`, then writes it whole.
    static RunOutput output(const std::string& name, std::function<void()> before = {}) {
        RunOutput output;
        output.names = {name};
        output.write = [name, before = std::move(before)](const FinishedRun&,
                                                          const std::filesystem::path& folder) {
            std::ofstream(folder / name) << "half";
            if (before) before();
            std::ofstream(folder / name) << "whole";
            return Message();
        };
        return output;
    }
    std::vector<Message> write(const std::vector<RunOutput>& outputs, int threads,
                               const WritingObserver& told = {}) {
        std::vector<const RunOutput*> all;
        for (const RunOutput& one : outputs) all.push_back(&one);
        const FinishedRun finished{run_, references_, summary_, {}, {}, {}, {}};
        return OutputCrew(finished, folder_.path(), told, all.size()).write(all, threads);
    }

    Algoritmo run_ = tour();
    References references_;
    RunSummary summary_;
    TempFolder folder_;
};

TEST_F(OutputCrewTest, ThreadsAndAGridBuiltAheadChangeNoFile) {
    std::map<std::string, std::string> written;
    for (const int threads : {1, 2, 3}) {
        OdometryGridAhead ahead(run_.configuration().grid);
        Algoritmo run = tour(threads, along(ahead));
        run_all(run);
        const TempFolder folder;
        StagedFolder staged = results_folder(folder.path());
        write_results(run, {}, 1.0, staged, {}, threads == 2 ? &ahead : nullptr);
        std::map<std::string, std::string> files = files_in(folder.path());
        EXPECT_TRUE(files.contains("grid_odometry.png"));
        for (const char* states_threads : {"config.cfg", "summary.json"}) {
            files.erase(states_threads);
        }
        if (threads > 1) {
            EXPECT_EQ(files, written);
        }
        written = std::move(files);
    }
}

TEST_F(OutputCrewTest, AGridAheadIsOfTheScansThatItWasGiven) {
    const GridParams& params = run_.configuration().grid;
    OdometryGridAhead ahead(params);
    OdometryGridAhead other(params);
    Algoritmo run = tour(1, along(ahead));
    for (int i = 0; i < 10; ++i) run.step();
    other.add(run.scan(), run.odometry_trajectory().back().pose);
    run_all(run);
    EXPECT_FALSE(other.take(50));
    EXPECT_FALSE(other.take(1));  // it was asked before, and keeps nothing
    const std::optional<Grid> grid = ahead.take(50);
    ASSERT_TRUE(grid);
    const Grid whole = build_grid(params, run.reader(), run.odometry_trajectory());
    EXPECT_EQ(grid->picture().grey, whole.picture().grey);
    EXPECT_EQ(grid->area(), whole.area());
}

TEST_F(OutputCrewTest, ATourIsReadOnceHoweverManyFilesAreWrittenOfIt) {
    auto counted = std::make_unique<CountedReader>(open_source(run_.configuration().source));
    const std::shared_ptr<const int> readings = counted->readings();
    Algoritmo run(run_.configuration(), std::move(counted), {.grid_of = 0});
    run_all(run);
    const TempFolder folder;
    StagedFolder staged = results_folder(folder.path());
    const std::vector<std::string> also = {"map-server", "carmen", "ieee-1873"};
    EXPECT_TRUE(write_results(run, {}, 1.0, staged, {}, nullptr, also).not_written.empty());
    EXPECT_EQ(*readings, 1);
    // What does not fit into the memory is read again.
    auto again = std::make_unique<CountedReader>(open_source(run_.configuration().source));
    const std::shared_ptr<const int> more = again->readings();
    Algoritmo small(run_.configuration(), std::move(again), {.remember_bytes = 1000});
    run_all(small);
    const TempFolder other;
    write_results(small, {}, 1.0, other.path());
    EXPECT_GT(*more, 1);
    EXPECT_EQ(files_in(other.path()).at("grid_best.png"),
              files_in(folder.path()).at("grid_best.png"));
}

TEST_F(OutputCrewTest, PicturesOfOneFolderDoNotDisturbEachOther) {
    Algoritmo run = tour(3, {.step_grid = true, .uncertainty = true});
    run_all(run);
    References references;
    references.trajectory = run.best_trajectory();
    references.walls = {{{0.0, -1.0}, {5.0, -1.0}}};
    std::map<std::string, std::string> written;
    for (int i = 0; i < 5; ++i) {
        const TempFolder folder;
        const RunSummary summary = write_results(run, references, 1.0, folder.path());
        for (const NotWritten& missing : summary.not_written) {
            EXPECT_THAT(missing.reason.english(), ::testing::HasSubstr("not installed"));
        }
        std::map<std::string, std::string> files = files_in(folder.path());
        if (i > 0) {
            EXPECT_EQ(files, written);
        }
        written = std::move(files);
    }
}

TEST_F(OutputCrewTest, TheObserverIsAskedOnceMoreWhenAllIsWritten) {
    run_all(run_);
    folder_.put("map.txt", "before");
    std::vector<std::string> told;
    const WritingObserver changed_at_last = [&](const WritingProgress& now) {
        told.push_back(now.file);
        if (now.number == now.count) throw std::runtime_error("the log has changed");
    };
    EXPECT_THROW(write_results(run_, {}, 1.0, folder_.path(), changed_at_last), std::runtime_error);
    EXPECT_EQ(told.back(), "summary.json");
    const std::map<std::string, std::string> before = {{"map.txt", "before"}};
    EXPECT_EQ(files_in(folder_.path()), before);
}

TEST_F(OutputCrewTest, WhatFailsIsTriedAgainAloneAndLeavesNoHalf) {
    std::atomic<int> times = 0;
    const std::vector<RunOutput> outputs = {
        output("a"),
        output("b",
               [&] {
                   if (times++ == 0) throw std::bad_alloc();
               }),
        output("c", [] { throw std::runtime_error("it cannot be"); }),
        output("d"),
    };
    const std::vector<Message> reasons = write(outputs, 2);
    EXPECT_EQ(times, 2);
    ASSERT_EQ(reasons.size(), 4U);
    EXPECT_THAT(reasons[2].english(), ::testing::HasSubstr("it cannot be"));
    for (const std::size_t place : {0U, 1U, 3U}) EXPECT_TRUE(reasons[place].empty()) << place;
    const std::map<std::string, std::string> expected = {
        {"a", "whole"}, {"b", "whole"}, {"d", "whole"}};
    EXPECT_EQ(files_in(folder_.path()), expected);
}

TEST_F(OutputCrewTest, AloneNothingIsTriedTwice) {
    int times = 0;
    const auto reasons = write({output("a",
                                       [&] {
                                           ++times;
                                           throw std::bad_alloc();
                                       })},
                               1);
    EXPECT_EQ(times, 1);
    EXPECT_THAT(reasons.at(0).english(), ::testing::HasSubstr("memory"));
    EXPECT_TRUE(files_in(folder_.path()).empty());
}

TEST_F(OutputCrewTest, EachIsToldOfOnceAndTheObserverMayEndIt) {
    std::vector<RunOutput> outputs;
    for (const char* name : {"a", "b", "c", "d", "e", "f"}) outputs.push_back(output(name));
    outputs.front().essential = true;
    std::set<std::string> names;
    std::vector<std::size_t> numbers;
    write(outputs, 3, [&](const WritingProgress& now) {
        EXPECT_EQ(now.count, 6U);
        numbers.push_back(now.number);
        names.insert(now.file);
    });
    EXPECT_EQ(numbers, (std::vector<std::size_t>{1, 2, 3, 4, 5, 6}));
    EXPECT_EQ(names.size(), 6U);
    const auto changed = [](const WritingProgress& now) {
        if (now.number == 3) throw std::runtime_error("the log has changed");
    };
    EXPECT_THROW(write(outputs, 3, changed), std::runtime_error);
    // An essential one ends it too.
    outputs.front() = output("a", [] { throw std::runtime_error("no room"); });
    outputs.front().essential = true;
    EXPECT_THROW(write(outputs, 3), std::runtime_error);
}

TEST_F(OutputCrewTest, WhatReadsTheTourAgainIsLeftOutWhereTheRunIsToEnd) {
    run_all(run_);
    const auto names = [](const RunSummary& summary) {
        std::set<std::string> files;
        for (const NotWritten& missing : summary.not_written) files.insert(missing.file);
        return files;
    };
    StagedFolder folder = results_folder(folder_ / "ended");
    const RunSummary summary =
        write_results(run_, references_, 1.0, folder, {}, nullptr, {}, [] { return true; });
    EXPECT_THAT(names(summary), testing::IsSupersetOf({"grid_best.png", "grid_odometry.png"}));
    for (const char* file : {"map.txt", "segments.txt", "trajectory.tum", "grid_best_steps.png",
                             "map.dxf", "summary.json"}) {
        EXPECT_TRUE(std::filesystem::exists(folder_ / "ended" / file)) << file;
    }
    EXPECT_FALSE(std::filesystem::exists(folder_ / "ended" / "grid_best.png"));
    // Asked while it is written, it ends soon, and keeps what was written before.
    int asked = 0;
    StagedFolder later = results_folder(folder_ / "later");
    const RunSummary cut = write_results(run_, references_, 1.0, later, {}, nullptr, {},
                                         [&asked] { return ++asked > 20; });
    EXPECT_FALSE(names(cut).empty());
    EXPECT_TRUE(std::filesystem::exists(folder_ / "later" / "map.txt"));
    for (const std::string& file : names(cut)) {
        EXPECT_FALSE(std::filesystem::exists(folder_ / "later" / file)) << file;
    }
}

}  // namespace
}  // namespace hitos
