// SPDX-License-Identifier: GPL-3.0-or-later
#include "hitos/simulation/drive/noisy_reader.hpp"

#include <gmock/gmock.h>

#include "hitos/base/error.hpp"
#include "hitos/capture/archivo.hpp"
#include "hitos/capture/procesador.hpp"
#include "hitos/simulation/drive/simulated_tour_reader.hpp"
#include "unit/capture/test_files.hpp"
#include "worlds.hpp"

namespace hitos {
namespace {

using test::Log;
using test::read_all;

const std::string kLog = std::string(HITOS_SOURCE_DIR) + "/data/bigloop.log.gz";

std::unique_ptr<TourReader> plain(const std::filesystem::path& path) {
    return std::make_unique<Procesador>(open_log(path));
}

std::unique_ptr<TourReader> noisy(double level, std::uint64_t seed) {
    return make_noisy_reader(plain(kLog), level, OdometryNoiseKind::relative_sigma, seed);
}

TEST(NoisyReader, IsTheReaderWithNoiseOnItsOdometry) {
    const Log expected = read_all(*plain(kLog));
    const Log log = read_all(*noisy(0.1, 7));
    OdometryNoise noise(0.1, OdometryNoiseKind::relative_sigma, 7);
    EXPECT_EQ(log.scans, expected.scans);
    ASSERT_EQ(log.odometry.size(), expected.odometry.size());
    std::size_t changed = 0;
    for (std::size_t i = 0; i < log.odometry.size(); ++i) {
        EXPECT_EQ(log.odometry[i], noise(expected.odometry[i]));
        if (log.odometry[i] != expected.odometry[i]) ++changed;
    }
    EXPECT_GT(changed, 1000U);
}

TEST(NoisyReader, BeginsAnewWithTheSameNoise) {
    const auto reader = noisy(0.1, 3);
    std::vector<Odometria> first;
    for (int i = 0; i < 50; ++i) first.push_back(*reader->next_odometry());
    const auto again = reader->reopen();
    reader->restart();
    for (const Odometria& reading : first) {
        EXPECT_EQ(again->next_odometry(), reading);
        EXPECT_EQ(reader->next_odometry(), reading);
    }
    EXPECT_EQ(reader->format(), "player");
    EXPECT_EQ(reader->name(), kLog);
}

TEST(NoisyReader, TellsOfTheDamageInTheLog) {
    const test::TempFolder folder;
    const auto path = folder.put("damaged.log",
                                 "ODOM 0 0 0\nLASER 0 1 1 1\nLASER 1 2 broken\nODOM x\nODOM 2 1 0\n"
                                 "LASER 2 1 1 1\n");
    const Log log = read_all(*make_noisy_reader(plain(path), 0.1, OdometryNoiseKind::variance, 1));
    EXPECT_EQ(log.report.scans, 2U);
    EXPECT_EQ(log.report.skipped, 2U);
    ASSERT_EQ(log.report.examples.size(), 2U);
    EXPECT_EQ(log.report.examples[0].line, 3U);
    EXPECT_EQ(log.report.examples[1].line, 4U);
}

TEST(NoisyReader, KnowsTheTruthThatItsReaderKnows) {
    const auto tour = std::make_shared<const SimulatedTour>(test::small_world());
    const auto reader = make_noisy_reader(std::make_unique<SimulatedTourReader>(tour), 0.1,
                                          OdometryNoiseKind::variance, 1);
    ASSERT_TRUE(reader->truth());
    EXPECT_EQ(reader->truth()->path, SimulatedTourReader(tour).truth()->path);
    EXPECT_FALSE(noisy(0.1, 1)->truth());
}

TEST(NoisyReader, AnImpossibleLevelIsRefused) {
    EXPECT_THROW(noisy(-0.1, 1), ConfigError);
}

}  // namespace
}  // namespace hitos
