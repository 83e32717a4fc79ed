#include "hitos/workbench/recorded_tour.hpp"

#include <gtest/gtest.h>

#include "hitos/services/run/open_source.hpp"
#include "support.hpp"

namespace hitos {
namespace {

// Damage, a repeated scan and a stamp that goes back: what a report counts.
constexpr const char* kLog =
    "position 0 1 0 0 0 0 0 0\nlaser 0 1 1 0 0\nlaser 0 1 1 0 0\nlaser 0 2 x\n"
    "position 0 0.5 1 0 0 0 0 0\nlaser 0 2 2 0 0\n";

class RecordedTourTest : public testing::Test {
  protected:
    RecordedReader reader() {
        return {"name", "radish", [this] {
                    ++opened_;
                    SourceParams source;
                    source.file = folder_.put("a.log", kLog);
                    return std::make_shared<const RecordedTour>(*open_source(source));
                }};
    }
    test::TempFolder folder_;
    int opened_ = 0;
};

TEST_F(RecordedTourTest, IsAskedForOnceAndOnlyWhenItIsRead) {
    RecordedReader reader = this->reader();
    EXPECT_EQ(reader.progress(), 0.0);
    EXPECT_EQ(reader.report().skipped, 0U);
    EXPECT_EQ(opened_, 0);
    EXPECT_TRUE(reader.next_odometry());
    EXPECT_TRUE(reader.next_scan());
    reader.restart();
    EXPECT_TRUE(reader.next_scan());
    EXPECT_EQ(opened_, 1);
    EXPECT_EQ(reader.name(), "name");
    EXPECT_EQ(reader.format(), "radish");
    const auto other = reader.reopen();
    EXPECT_EQ(other->name(), "name");
    EXPECT_EQ(other->format(), "radish");
    EXPECT_EQ(other->progress(), 0.0);
    EXPECT_EQ(other->next_scan()->time_s, 1.0);
    EXPECT_EQ(opened_, 2);
}

TEST_F(RecordedTourTest, ReportsWhatWasReadSoFarAndWhatTheLogLost) {
    RecordedReader reader = this->reader();
    EXPECT_EQ(reader.next_scan()->time_s, 1.0);
    EXPECT_EQ(reader.report().scans, 1U);
    EXPECT_EQ(reader.report().odometry, 0U);
    EXPECT_EQ(reader.report().duplicate_scans, 1U);
    EXPECT_EQ(reader.report().stamps_backwards, 1U);
    ASSERT_EQ(reader.report().skipped, 1U);
    EXPECT_EQ(reader.report().examples.at(0).line, 4U);
    EXPECT_EQ(reader.progress(), 0.5);
    EXPECT_EQ(reader.next_scan()->time_s, 2.0);
    EXPECT_FALSE(reader.next_scan());
    EXPECT_EQ(reader.progress(), 1.0);
    EXPECT_TRUE(reader.next_odometry());
    EXPECT_TRUE(reader.next_odometry());
    EXPECT_FALSE(reader.next_odometry());
    EXPECT_EQ(reader.report().odometry, 2U);
    reader.restart();
    EXPECT_EQ(reader.report().scans, 0U);
    EXPECT_EQ(reader.report().odometry, 0U);
    EXPECT_EQ(reader.report().skipped, 1U);
    EXPECT_EQ(reader.progress(), 0.0);
}

}  // namespace
}  // namespace hitos
