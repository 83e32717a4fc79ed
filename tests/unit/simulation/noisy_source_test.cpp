#include "hitos/simulation/noisy_source.hpp"

#include <gmock/gmock.h>

#include "hitos/base/error.hpp"
#include "hitos/capture/archivo.hpp"
#include "hitos/capture/procesador.hpp"
#include "support.hpp"

namespace hitos {
namespace {

const std::string kSource = HITOS_SOURCE_DIR;

std::unique_ptr<Fuente> noisy(double level, std::uint64_t seed) {
    return make_noisy_source(open_log(kSource + "/data/bigloop.log.gz"), level,
                             OdometryNoiseKind::relative_sigma, seed);
}

TEST(NoisySource, ReadsAsTheLogWithNoiseOnItsOdometry) {
    Procesador plain(open_log(kSource + "/data/bigloop.log.gz"));
    Procesador with_noise(noisy(0.1, 7));
    OdometryNoise noise(0.1, OdometryNoiseKind::relative_sigma, 7);
    int scans = 0;
    while (const auto expected = plain.next_scan()) {
        const auto scan = with_noise.next_scan();
        ASSERT_TRUE(scan);
        EXPECT_EQ(scan->time_s, expected->time_s);
        EXPECT_EQ(scan->points, expected->points);
        EXPECT_EQ(scan->run_starts, expected->run_starts);
        ++scans;
    }
    EXPECT_FALSE(with_noise.next_scan());
    EXPECT_GT(scans, 1000);
    while (const auto expected = plain.next_odometry()) {
        const auto reading = with_noise.next_odometry();
        ASSERT_TRUE(reading);
        EXPECT_EQ(reading->time_s, expected->time_s);
        EXPECT_EQ(reading->twist, noise(*expected).twist);
    }
    EXPECT_FALSE(with_noise.next_odometry());
}

TEST(NoisySource, BeginsAnewWithTheSameNoise) {
    const auto source = noisy(0.1, 3);
    std::vector<std::string> first;
    first.reserve(50);
    for (int i = 0; i < 50; ++i) first.emplace_back(source->read_odometry_line()->text);
    const auto again = source->reopen();
    for (const std::string& line : first) EXPECT_EQ(again->read_odometry_line()->text, line);
    EXPECT_EQ(source->format(), LogFormat::normalized);
    EXPECT_EQ(source->name(), kSource + "/data/bigloop.log.gz");
}

TEST(NoisySource, TellsOfTheDamageInTheLog) {
    const test::TempFolder folder;
    const auto path = folder.put("damaged.log",
                                 "ODOM 0 0 0\nLASER 0 1 1 1\nLASER 1 2 broken\nODOM x\nODOM 2 1 0\n"
                                 "LASER 2 1 1 1\n");
    Procesador reader(make_noisy_source(open_log(path), 0.1, OdometryNoiseKind::variance, 1));
    while (reader.next_odometry()) {
    }
    while (reader.next_scan()) {
    }
    EXPECT_EQ(reader.report().scans, 2U);
    EXPECT_EQ(reader.report().skipped, 2U);
    ASSERT_EQ(reader.report().examples.size(), 2U);
    EXPECT_EQ(reader.report().examples[0].line, 3U);
    EXPECT_EQ(reader.report().examples[1].line, 4U);
}

TEST(NoisySource, AnImpossibleLevelIsRefused) {
    EXPECT_THROW(noisy(-0.1, 1), ConfigError);
}

}  // namespace
}  // namespace hitos
