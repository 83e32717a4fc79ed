// SPDX-License-Identifier: GPL-3.0-or-later
#include "hitos/capture/recorded_tour.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include "hitos/base/error.hpp"
#include "hitos/capture/archivo.hpp"
#include "hitos/capture/procesador.hpp"
#include "support.hpp"

namespace hitos {
namespace {

bool always(std::size_t /*bytes*/) {
    return true;
}

/// Scans before the odometry, damage of both sequences before, between and behind what can be read,
/// repeated scans and stamps that go back: all that a report counts.
std::string damaged_log() {
    std::string text = "laser 0 0 x\nposition 0 0 y 0 0 0 0 0\nposition 0 3 0 0 0 0 0 0\n";
    for (int i = 1; i <= 15; ++i) {
        text += fmt::format(
            "laser 0 {0} {0} 0 0\nlaser 0 {0} {0} 0 0\nlaser 0 {0} damaged\n\x01\n"
            "position 0 {0}.5 z 0 0 0 0 0\nposition 0 {0}.5 {0} 0 0 0 0 0\n"
            "position 0 {0}.25 {0} 0 0 0 0 0\n",
            i);
    }
    return text + "laser 0 99 x\nposition 0 99 y 0 0 0 0 0\n";
}

std::string told(const ReadReport& report) {
    std::string text =
        fmt::format("{} {} {} {} {} {} {} {}", report.scans, report.odometry,
                    report.duplicate_scans, report.stamps_backwards, report.early_scans,
                    report.early_scans_left_out, report.skipped, report.of_recording);
    for (const auto& skip : report.examples) {
        text += fmt::format("\n{} {}", skip.line, skip.reason.english());
    }
    return text;
}

class RecordedTourTest : public testing::Test {
  protected:
    Procesador reader(const ReadOptions& options = {}) const {
        return Procesador(open_log(log_, kAutoFormat), options);
    }

    test::TempFolder folder_;
    std::filesystem::path log_ = folder_.put("a.log", damaged_log());
};

// Whatever the order of the two sequences, at every place.
TEST_F(RecordedTourTest, GivesAndReportsWhatItsReaderWould) {
    const auto tour = record_tour(reader(), always);
    ASSERT_TRUE(tour);
    EXPECT_EQ(tour->scans.items.size(), 15U);
    RecordedReader recorded(tour);
    EXPECT_EQ(recorded.name(), log_.string());
    EXPECT_EQ(recorded.format(), "radish");
    EXPECT_EQ(tour->scans.notes.back().report.early_scans, 2U);
    for (const int scans_first : {0, 1, 3, 40}) {
        Procesador plain = reader();
        recorded.restart();
        for (int i = 0; i < 100; ++i) {
            if (i >= scans_first) {
                ASSERT_EQ(recorded.next_odometry(), plain.next_odometry()) << i;
                ASSERT_EQ(told(recorded.report()), told(plain.report())) << i;
            }
            ASSERT_EQ(recorded.next_scan(), plain.next_scan()) << i;
            ASSERT_EQ(told(recorded.report()), told(plain.report())) << i;
        }
        EXPECT_EQ(recorded.report().skipped, 49U);
        EXPECT_EQ(recorded.report().examples.size(), ReadReport::kExamples);
    }
}

TEST_F(RecordedTourTest, KnowsWhatWasLeftOutAndWhatItsLinesAre) {
    ReadOptions options;
    options.leave_out_early_scans = true;
    RecordedReader recorded(record_tour(reader(options), always));
    EXPECT_EQ(recorded.next_scan()->time_s, 3.0);
    EXPECT_EQ(recorded.report().early_scans_left_out, 2U);
    EXPECT_FALSE(recorded.report().of_recording);
    const auto bag =
        std::filesystem::path(HITOS_SOURCE_DIR) / "tests/unit/capture/two-lasers-cut.bag";
    options.scan_topic = "all";
    RecordedReader recording(record_tour(Procesador(open_log(bag, kAutoFormat, options)), always));
    for (int round = 0; round < 2; ++round) {
        EXPECT_TRUE(recording.report().of_recording);
        EXPECT_TRUE(recording.reopen()->report().of_recording);
        recording.restart();
    }
}

TEST_F(RecordedTourTest, IsReadByManyIndependently) {
    RecordedReader recorded(record_tour(reader(), always));
    EXPECT_EQ(recorded.progress(), 0.0);
    EXPECT_TRUE(recorded.next_scan());
    const auto other = recorded.reopen();
    EXPECT_EQ(other->progress(), 0.0);
    EXPECT_EQ(other->next_scan()->time_s, 1.0);
    EXPECT_EQ(recorded.next_scan()->time_s, 2.0);
    while (recorded.next_scan()) {
    }
    EXPECT_EQ(recorded.progress(), 1.0);
}

TEST_F(RecordedTourTest, IsNotMadeWhereItMayNotGrow) {
    std::size_t all = 0;
    ASSERT_TRUE(record_tour(reader(), [&](std::size_t bytes) { return (all += bytes) > 0; }));
    EXPECT_GT(all, 15 * (sizeof(Scan) + 3 * sizeof(Point2)));
    for (const std::size_t most : {std::size_t{0}, all / 2, all - 1}) {
        std::size_t taken = 0;
        EXPECT_FALSE(record_tour(reader(), [&](std::size_t bytes) {
            return (taken += bytes) <= most;
        })) << most;
    }
}

TEST_F(RecordedTourTest, TellsWhatReadingTells) {
    Procesador opened = reader();
    std::filesystem::remove(log_);
    EXPECT_THROW(record_tour(opened, always), FileError);
}

}  // namespace
}  // namespace hitos
