// SPDX-License-Identifier: GPL-3.0-or-later
#include "hitos/workbench/tour_files.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sys/resource.h>

#include <csignal>
#include <filesystem>
#include <memory>
#include <stdexcept>
#include <string>
#include <vector>

#include "hitos/base/error.hpp"
#include "hitos/simulation/worlds/world.hpp"
#include "unit/capture/test_files.hpp"

namespace hitos {
namespace {

using test::TempDir;
using ::testing::HasSubstr;

std::shared_ptr<const SimulatedTour> some_tour() {
    return std::make_shared<const SimulatedTour>(
        parse_world("walls = [[[-1, -1], [9, -1], [9, 4], [-1, 4], [-1, -1]]]\n"
                    "[tour]\nway_points = [[5, 1], [7, 2]]\n",
                    "room.toml"));
}

TEST(TourFiles, TheTruthLiesBesideItsLog) {
    EXPECT_EQ(truth_beside("a/tour.log"), "a/tour.truth.tum");
    EXPECT_EQ(truth_beside("tour.log.gz"), "tour.truth.tum");
    EXPECT_EQ(truth_beside("/b/tour.2.mcap"), "/b/tour.2.truth.tum");
    EXPECT_EQ(truth_beside("tour"), "tour.truth.tum");
}

TEST(TourFiles, AFullDiskLeavesWhatWasThere) {
    const TempDir folder;
    TourFiles files;
    files.log = folder.put("tour.log", "old log");
    files.truth = folder.put("tour.truth.tum", "old truth");
    const auto tour = some_tour();
    struct rlimit before {};
    ::getrlimit(RLIMIT_FSIZE, &before);
    struct rlimit small = before;
    small.rlim_cur = 16384;  // the truth finds room, the log none
    const auto handler = std::signal(SIGXFSZ, SIG_IGN);
    ::setrlimit(RLIMIT_FSIZE, &small);
    const std::string error =
        test::message_of<FileError>([&] { write_tour_files(tour, files, {}); });
    ::setrlimit(RLIMIT_FSIZE, &before);
    std::signal(SIGXFSZ, handler);
    EXPECT_THAT(error, HasSubstr(files.log.string() + ": "));
    EXPECT_THAT(error, HasSubstr("File too large"));
    EXPECT_EQ(test::content(files.log), "old log");
    EXPECT_EQ(test::content(files.truth), "old truth");
    EXPECT_EQ(folder.files(), 2U);
}

TEST(TourFiles, WhatAFormatCannotSayIsToldOfTheLogThatWasAskedFor) {
    const TempDir folder;
    World posts = some_tour()->world();
    posts.landmarks.at = {{3.0, 1.0}};
    TourFiles files;
    files.format = "player";
    files.log = folder / "tour.log";
    const std::string error = test::message_of<FormatError>(
        [&] { write_tour_files(std::make_shared<const SimulatedTour>(posts), files, {}); });
    EXPECT_THAT(error, HasSubstr((folder / "tour.log").string() + ": the landmarks of line"));
    EXPECT_THAT(error, HasSubstr("write them in the normalized format"));
    EXPECT_FALSE(std::filesystem::exists(files.log));
}

TEST(TourFiles, WhoStopsItLeavesNothing) {
    const TempDir folder;
    TourFiles files;
    files.log = folder / "tour.log";
    files.truth = folder / "tour.truth.tum";
    const auto stop = [](const TourReader& reader) {
        if (reader.report().scans == 3) throw std::runtime_error("enough");
    };
    EXPECT_THROW(write_tour_files(some_tour(), files, {}, stop), std::runtime_error);
    EXPECT_EQ(folder.files(), 0U);
}

TEST(TourFiles, NothingIsWrittenOverWhatItComesFrom) {
    const TempDir folder;
    const std::vector<std::filesystem::path> inputs{folder.put("room.toml", "walls")};
    TourFiles files;
    files.log = inputs[0];
    EXPECT_THROW(write_tour_files(some_tour(), files, inputs), FileError);
    files.log = folder / "tour.log";
    files.truth = files.log;
    EXPECT_THROW(write_tour_files(some_tour(), files, inputs), FileError);
    files.truth.clear();
    files.format = "rosbag";
    EXPECT_THROW(write_tour_files(some_tour(), files, inputs), ConfigError);
    EXPECT_EQ(test::content(inputs[0]), "walls");
    EXPECT_EQ(folder.files(), 1U);
}

}  // namespace
}  // namespace hitos
