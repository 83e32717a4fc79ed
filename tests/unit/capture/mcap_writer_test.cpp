// SPDX-License-Identifier: GPL-3.0-or-later
// Tours written as MCAP: what a reader that is told nothing of Hitos may count on.
#include <gmock/gmock.h>

#include <array>
#include <cmath>
#include <limits>
#include <sstream>

#include "hitos/capture/log_writer.hpp"
#include "recordings/recording.hpp"
#include "ros/message_writing.hpp"
#include "test_files.hpp"

namespace hitos {
namespace {

using test::content;
using test::Log;
using test::TempDir;
using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;

/// A scan whose rays i have the range i + 1 m; those that 5 divides see nothing.
Scan plain_scan(double time_s, std::uint32_t rays, const Pose& mount = {},
                double max_range_m = 1e6) {
    Scan scan;
    scan.time_s = time_s;
    scan.fan = {-1.5, 1.5, rays, max_range_m, mount};
    for (std::uint32_t i = 0; i < rays; ++i) {
        if (i % 5 == 0) continue;
        if (i % 5 == 1) scan.run_starts.push_back(static_cast<std::uint32_t>(scan.points.size()));
        const double range = i + 1.0;
        const double angle = scan.fan.angle_rad(i);
        scan.points.push_back(
            transform(mount, Point2{range * std::cos(angle), range * std::sin(angle)}));
        scan.rays.push_back(i);
    }
    return scan;
}

struct McapSaid {
    std::string topic;
    std::uint64_t time_ns;
    std::string bytes;
};

/// Everything that stands in the file; fails where its reader finds a problem.
std::vector<McapSaid> said_in(const std::filesystem::path& path) {
    Topics topics([](const Topic&) { return true; });
    const auto recording = open_mcap(path, {topics, true});
    std::vector<McapSaid> all;
    while (const auto found = recording->next()) {
        all.push_back({found->topic->name, static_cast<std::uint64_t>(found->log_time_ns),
                       std::string(found->bytes)});
    }
    const auto problem = recording->take_problem();
    EXPECT_FALSE(problem) << problem->reason.english();
    return all;
}

std::vector<LaserScanMessage> lasers_in(const std::filesystem::path& path) {
    std::vector<LaserScanMessage> lasers;
    for (const McapSaid& said : said_in(path)) {
        if (said.topic == "/scan") lasers.push_back(decode_laser_scan(said.bytes, Encoding::cdr));
    }
    return lasers;
}

TEST(McapWriter, ATourWithoutAnythingIsAWholeFile) {
    const TempDir folder;
    make_log_writer("mcap", folder / "a.mcap")->finish();
    EXPECT_THAT(said_in(folder / "a.mcap"), IsEmpty());
    EXPECT_TRUE(content(folder / "a.mcap").ends_with("\x89MCAP0\r\n"));
}

TEST(McapWriter, WhatIsNoPointIsInfinite) {
    const TempDir folder;
    const auto writer = make_log_writer("mcap", folder / "a.mcap");
    writer->write(plain_scan(1.0, 11, {}, 12.5));
    writer->finish();
    const std::vector<LaserScanMessage> lasers = lasers_in(folder / "a.mcap");
    ASSERT_EQ(lasers.size(), 1U);
    constexpr float kNone = std::numeric_limits<float>::infinity();
    EXPECT_THAT(lasers[0].ranges_m, ElementsAre(kNone, 2, 3, 4, 5, kNone, 7, 8, 9, 10, kNone));
    EXPECT_FLOAT_EQ(static_cast<float>(lasers[0].min_angle_rad), -1.5F);
    EXPECT_FLOAT_EQ(static_cast<float>(lasers[0].step_rad), 0.3F);
    EXPECT_EQ(lasers[0].min_range_m, 0.0);
    EXPECT_EQ(lasers[0].max_range_m, 12.5);
    EXPECT_EQ(lasers[0].header.frame, "laser");
}

// Ranges as floats stay what they are to the last bit; a float may round up to the greatest range.
TEST(McapWriter, NoRoundingMakesAPointOfNothingOrNothingOfAPoint) {
    const TempDir folder;
    for (const double greatest : {8.0, 81.91, 0.3, 81.9167, 5.6004999}) {
        Scan scan;
        scan.fan = {0.0, 0.4, 5, greatest, {}};
        std::vector<double> ranges{1e-60, 0.1, 0.25, greatest - 1e-9, std::nextafter(greatest, 0)};
        for (std::uint32_t i = 0; i < 5; ++i) {
            const double angle = scan.fan.angle_rad(i);
            // Nothing lies between the greatest range as it is printed and itself.
            const double range = std::min(ranges[i], std::round(greatest * 1000.0) / 1000.0);
            scan.points.push_back({range * std::cos(angle), range * std::sin(angle)});
            scan.rays.push_back(i);
            if (std::hypot(scan.points[i].x, scan.points[i].y) < greatest) continue;
            scan.points[i] = {0.2, 0.0};
        }
        scan.run_starts = {0};
        const auto writer = make_log_writer("mcap", folder / "a.mcap");
        writer->write(scan);
        writer->finish();
        const Log log = test::read_log(folder / "a.mcap");
        ASSERT_EQ(log.scans.size(), 1U);
        EXPECT_THAT(log.scans[0].rays, ElementsAre(0, 1, 2, 3, 4)) << greatest;
        EXPECT_FLOAT_EQ(static_cast<float>(log.scans[0].fan.max_range_m),
                        static_cast<float>(greatest));
    }
}

TEST(McapWriter, EveryPlaceOfALaserHasAFrameOfItsOwn) {
    const TempDir folder;
    const auto writer = make_log_writer("mcap", folder / "a.mcap");
    const std::array<Pose, 2> mounts{Pose{0.2, 0.05, -0.7}, Pose{-0.1, 0.0, 3.0}};
    for (std::size_t i = 0; i < 6; ++i)
        writer->write(plain_scan(10.0 + static_cast<double>(i), 11, mounts.at(i % 2)));
    writer->finish();
    std::vector<std::size_t> told;
    for (const McapSaid& said : said_in(folder / "a.mcap")) {
        if (said.topic != "/tf_static") continue;
        told.push_back(decode_transforms(said.bytes, Encoding::cdr).size());
    }
    EXPECT_THAT(told, ElementsAre(1, 2));  // the last message of a latched topic says all
    const Log log = test::read_log(folder / "a.mcap");
    ASSERT_EQ(log.scans.size(), 6U);
    for (std::size_t i = 0; i < 6; ++i) {
        test::expect_near(log.scans[i].fan.pose_robot_laser, mounts.at(i % 2), 1e-12);
    }
}

TEST(McapWriter, WhatARecordingHasComesBackToTheLastBit) {
    const TempDir folder;
    const auto write = [&](const Log& log, const char* name) {
        const auto writer = make_log_writer("mcap", folder / name);
        for (const Odometria& reading : log.odometry) writer->write(reading);
        for (const Scan& scan : log.scans) writer->write(scan);
        writer->finish();
        return test::read_log(folder / name);
    };
    Log tour;
    for (int i = 0; i < 30; ++i) {
        tour.odometry.push_back({1.7e9 + 0.1 * i, i == 0 ? Twist{} : Twist{0.4, 0.01, 0.3}, 0});
        tour.scans.push_back(plain_scan(1.7e9 + 0.1 * i + 0.033, 181, {0.1, 0.0, 0.2}));
    }
    const Log once = write(tour, "a.mcap");
    const Log again = write(once, "b.mcap");
    ASSERT_EQ(once.scans.size(), tour.scans.size());
    const std::vector<LaserScanMessage> first = lasers_in(folder / "a.mcap");
    const std::vector<LaserScanMessage> second = lasers_in(folder / "b.mcap");
    ASSERT_EQ(first.size(), second.size());
    for (std::size_t i = 0; i < first.size(); ++i) {
        EXPECT_EQ(first[i].header.stamp_ns, second[i].header.stamp_ns);
        EXPECT_EQ(first[i].ranges_m, second[i].ranges_m);
        EXPECT_EQ(first[i].min_angle_rad, second[i].min_angle_rad);
        EXPECT_EQ(first[i].step_rad, second[i].step_rad);
        EXPECT_EQ(once.scans[i].time_s, tour.scans[i].time_s);
    }
    test::expect_near(test::summed(again.odometry).back(), test::summed(tour.odometry).back(),
                      1e-9);
}

TEST(McapWriter, LongToursHaveManyChunksAndTheSameBytesEachTime) {
    const TempDir folder;
    for (const char* name : {"a.mcap", "b.mcap"}) {
        const auto writer = make_log_writer("mcap", folder / name);
        for (int i = 0; i < 150; ++i) writer->write(plain_scan(0.5 * i, 20'000), nullptr);
        writer->finish();
    }
    EXPECT_EQ(content(folder / "a.mcap"), content(folder / "b.mcap"));
    const std::vector<McapSaid> all = said_in(folder / "a.mcap");
    ASSERT_EQ(all.size(), 151U);
    EXPECT_EQ(all.back().time_ns, 74'500'000'000U);
    // 12 MB of messages in chunks that were closed behind 4 MiB: the word stands in each of them
    // and in its index.
    const std::string bytes = content(folder / "a.mcap");
    const std::string word("\4\0\0\0zstd", 8);
    std::size_t chunks = 0;
    for (std::size_t at = 0; (at = bytes.find(word, at)) != std::string::npos; ++at) ++chunks;
    EXPECT_EQ(chunks, 2U * 3U);
}

TEST(McapWriter, WhatNoStampOfRosCanSayIsRefused) {
    const TempDir folder;
    for (const double time_s : {-0.5, 2147483647.5, 1e12}) {
        const auto writer = make_log_writer("mcap", folder / "a.mcap");
        EXPECT_THAT(
            test::message_of<FormatError>([&] { writer->write(plain_scan(time_s, 11), nullptr); }),
            HasSubstr("cannot be a stamp of ROS"));
        EXPECT_THROW(writer->write(Odometria{time_s, {}, 0}), FormatError);
    }
    EXPECT_EQ(folder.files(), 0U);
}

TEST(McapWriter, TimesAreRoundedToTheNearestNanosecond) {
    EXPECT_EQ(stamp_of(0.0), 0);
    EXPECT_EQ(stamp_of(0.1), 100'000'000);
    EXPECT_EQ(stamp_of(12.9999999999), 13'000'000'000);
    EXPECT_EQ(stamp_of(1.25e-9), 1);
    // What is read as a double of seconds is written as the stamp that it was read from.
    for (const std::int64_t stamp_ns : {123'456'789'012'345LL, 7LL, 4'999'999'999'999'999LL}) {
        EXPECT_EQ(stamp_of(seconds_of(stamp_ns)), stamp_ns);
    }
    // Those of today are held to 0.24 µs, and no further rounding is added.
    const double today_s = 1732406400.123456;
    EXPECT_EQ(seconds_of(stamp_of(today_s)), today_s);
}

TEST(McapWriter, NamesThatEndInGzAreRefused) {
    const TempDir folder;
    EXPECT_THAT(
        test::message_of<FileError>([&] { make_log_writer("mcap", folder / "tour.mcap.gz"); }),
        HasSubstr("choose a name without .gz"));
    EXPECT_EQ(folder.files(), 0U);
}

TEST(McapWriter, DefinitionsHoldEveryTypeThatTheyName) {
    for (const std::string& text :
         {laser_scan_definition(), odometry_definition(), transforms_definition()}) {
        std::istringstream lines(text);
        for (std::string line; std::getline(lines, line);) {
            const std::string type = line.substr(0, line.find_first_of(" ["));
            if (type.find('/') == std::string::npos || type.starts_with("MSG:")) continue;
            EXPECT_THAT(text, HasSubstr("\nMSG: " + type + "\n"));
        }
    }
}

}  // namespace
}  // namespace hitos
