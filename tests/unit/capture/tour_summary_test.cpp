// SPDX-License-Identifier: GPL-3.0-or-later
#include "hitos/capture/tour_summary.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "test_files.hpp"

namespace hitos {
namespace {

using test::TempDir;
using ::testing::AllOf;
using ::testing::HasSubstr;

TourSummary inspect(const std::filesystem::path& path, std::string_view format = kAutoFormat,
                    const InspectProgress& progress = {}) {
    Procesador reader(open_log(path, format));
    return inspect_tour(reader, progress);
}

TEST(TourSummary, CountsAWholeLog) {
    const TempDir folder;
    const auto path = folder.put("a.log",
                                 "# note\nposition 0 10 0 0 0 0 0 0\nposition 0 11 3 4 0 0 0 0\n"
                                 "laser 0 9 1 -1 0 1 0 0 1 1 0\n?\nposition 0 12 3 4 0 0 0 0\n");
    double last = -1.0;
    const TourSummary summary = inspect(path, kAutoFormat, [&](double done) {
        last = done;
        return true;
    });
    EXPECT_EQ(summary.format, "radish");
    EXPECT_EQ(summary.report.scans, 1U);
    EXPECT_EQ(summary.report.odometry, 3U);
    EXPECT_EQ(summary.report.skipped, 1U);
    EXPECT_EQ(summary.first_stamp_s, 9.0);
    EXPECT_EQ(summary.duration_s, 3.0);
    EXPECT_NEAR(summary.distance_m, 5.0, 1e-12);
    EXPECT_EQ(summary.fan.count, 3U);
    const std::vector<Message> lines = first_lines_of(path);
    ASSERT_EQ(lines.size(), 6U);
    EXPECT_EQ(lines[0].english(), "# note");
    EXPECT_TRUE(summary.complete);
    EXPECT_EQ(last, 1.0);
}

TEST(TourSummary, NamesOfTopicsAreToldWithoutControlCharacters) {
    const std::vector<Message> lines =
        lines_of(std::vector<RecordedTopic>{{"/a\x1b[31m", "acme/B\nc", 17}});
    ASSERT_EQ(lines.size(), 1U);
    EXPECT_EQ(lines[0].english(), "/a\\x1b[31m  acme/B c  17");
}

TEST(TourSummary, CanBeStopped) {
    const TempDir folder;
    std::string text;
    for (int i = 0; i < 100; ++i) text += "laser 0 " + std::to_string(i) + " 1 -1 0\n";
    const TourSummary summary =
        inspect(folder.put("a.log", text), "radish", [](double) { return false; });
    EXPECT_FALSE(summary.complete);
    EXPECT_EQ(summary.report.scans, 1U);
}

TEST(TourSummary, NothingReadableIsAnError) {
    const TempDir folder;
    const auto path = folder.put("a.log", "laser 0 1 1\nlaser 0 2 1\n# CARMEN Logfile\n");
    EXPECT_THAT(test::message_of<FormatError>([&] { inspect(path, "carmen"); }),
                HasSubstr("neither scans nor odometry"));
    EXPECT_THAT(test::message_of<Error>([&] { inspect(folder / "none"); }),
                HasSubstr("no such file"));
    const auto damaged = folder.put("b.log", "\nposition 0 1 2\nposition 0 1 2 x\n");
    EXPECT_THAT(
        test::message_of<FormatError>([&] { inspect(damaged); }),
        AllOf(HasSubstr(damaged.string() + ":2: "), HasSubstr("nothing in it can be read")));
}

}  // namespace
}  // namespace hitos
