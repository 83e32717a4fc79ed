// Doubts about tours that are whole: nothing is said of clean ones, and what was made wrong on
// purpose is told with its number.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cmath>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "hitos/base/error.hpp"
#include "hitos/capture/tour_summary.hpp"
#include "hitos/workbench/open_tour.hpp"
#include "hitos/workbench/shipped_data.hpp"
#include "support.hpp"

namespace hitos {
namespace {

namespace fs = std::filesystem;
using Kind = TourFinding::Kind;

const fs::path kShared = HITOS_SHARED_DIR;

/// A tour wholly read, to be made wrong.
struct Readings {
    std::vector<Scan> scans;
    std::vector<Odometria> odometry;

    std::vector<TourFinding> findings() const {
        TourExamination examination;
        auto reading = odometry.begin();
        for (const Scan& scan : scans) {
            for (; reading != odometry.end() && reading->line <= scan.line; ++reading)
                examination.note(*reading);
            examination.note(scan);
        }
        for (; reading != odometry.end(); ++reading) examination.note(*reading);
        return examination.findings();
    }
    std::optional<TourFinding> of_kind(Kind kind) const {
        for (const TourFinding& finding : findings()) {
            if (finding.kind == kind) return finding;
        }
        return std::nullopt;
    }
    /// What is said of it, for the message of a test that fails.
    std::string said() const {
        std::string words;
        for (const TourFinding& finding : findings()) words += finding.what.english() + '\n';
        return words;
    }
};

Readings read(const std::string& source) {
    SourceParams params;
    params.file = source;
    const std::unique_ptr<TourReader> reader = open_tour(params);
    Readings readings;
    while (auto scan = reader->next_scan()) readings.scans.push_back(std::move(*scan));
    while (const auto reading = reader->next_odometry()) readings.odometry.push_back(*reading);
    return readings;
}

class OfWorld : public testing::TestWithParam<std::string> {
  protected:
    Readings tour_ = read(source_named(GetParam()));
};

TEST_P(OfWorld, NothingIsSaid) {
    EXPECT_EQ(tour_.said(), "");
}

TEST_P(OfWorld, ADelayIsToldToATenthOfASecond) {
    if (GetParam() == "corridor") GTEST_SKIP() << "it looks alike at every time";
    for (const double delay : {-14.0, -7.3, 0.8, 20.15}) {
        Readings late = tour_;
        for (Scan& scan : late.scans) scan.time_s += delay;
        const auto found = late.of_kind(Kind::scan_delay);
        ASSERT_TRUE(found) << delay;
        EXPECT_NEAR(found->value, -delay, 0.1);
        EXPECT_NE(found->remedy.english().find("--scan-delay"), std::string::npos);
    }
}

TEST_P(OfWorld, ClocksThatShareNoTimeAreTold) {
    if (GetParam() == "corridor") GTEST_SKIP() << "it looks alike at every time";
    Readings apart = tour_;
    for (Scan& scan : apart.scans) scan.time_s += 3.5e6;
    const auto found = apart.of_kind(Kind::clocks_apart);
    ASSERT_TRUE(found);
    EXPECT_NEAR(found->value, -3.5e6, 0.2);
}

/// Seen by a laser that is turned and, in place of its rays, mirrored.
Scan mounted(const Scan& scan, double turn_rad, bool mirrored) {
    Scan other = scan;
    for (Point2& point : other.points) {
        Point2 seen = transform(inverse(scan.fan.pose_robot_laser), point);
        if (mirrored) seen.y = -seen.y;
        point = transform(compose(scan.fan.pose_robot_laser, {0, 0, -turn_rad}), seen);
    }
    return other;
}

TEST_P(OfWorld, ALaserMountedOtherwiseIsTold) {
    if (GetParam() == "corridor") GTEST_SKIP() << "it looks alike from its other end";
    for (const double degrees : {-90.0, 45.0, 180.0}) {
        Readings turned = tour_;
        for (Scan& scan : turned.scans) scan = mounted(scan, degrees * kRadiansPerDegree, false);
        const auto found = turned.of_kind(Kind::turned_laser);
        ASSERT_TRUE(found) << degrees << '\n' << turned.said();
        const double off = wrap_angle(found->value - degrees * kRadiansPerDegree);
        EXPECT_LE(std::abs(off), 10.0 * kRadiansPerDegree) << degrees;
    }
    Readings mirrored = tour_;
    for (Scan& scan : mirrored.scans) scan = mounted(scan, 0.0, true);
    EXPECT_TRUE(mirrored.of_kind(Kind::mirrored_laser)) << mirrored.said();
}

TEST_P(OfWorld, UnitsAndBrokenDriversAreTold) {
    Readings millimetres = tour_;
    for (Scan& scan : millimetres.scans) {
        for (Point2& point : scan.points) point = {1000.0 * point.x, 1000.0 * point.y};
    }
    EXPECT_TRUE(millimetres.of_kind(Kind::laser_units));
    Readings fast = tour_;
    for (Odometria& reading : fast.odometry) {
        reading.twist.v *= 1000.0;
        reading.twist.v_lateral *= 1000.0;
    }
    EXPECT_TRUE(fast.of_kind(Kind::odometry_units));
    Readings still = tour_;
    for (Odometria& reading : still.odometry) reading.twist = {};
    EXPECT_TRUE(still.of_kind(Kind::still_odometry));
    Readings none = tour_;
    none.odometry.clear();
    EXPECT_TRUE(none.of_kind(Kind::no_odometry));
    Readings leap = tour_;
    leap.odometry[leap.odometry.size() / 2].twist.v = 170.0;
    EXPECT_TRUE(leap.of_kind(Kind::leaping_odometry));
    Readings frozen = tour_;
    for (Scan& scan : frozen.scans) scan.points = frozen.scans.front().points;
    EXPECT_TRUE(frozen.of_kind(Kind::frozen_laser));
    Readings blind = tour_;
    for (Scan& scan : blind.scans) scan.points.clear();
    EXPECT_TRUE(blind.of_kind(Kind::blind_laser));
}

INSTANTIATE_TEST_SUITE_P(Worlds, OfWorld,
                         testing::Values("recinto", "lineamedia", "bigloop", "bigloop2", "complex",
                                         "corridor"),
                         [](const auto& world) { return world.param; });

/// Everything in a folder of recordings whose name ends so.
std::vector<fs::path> recordings(const char* folder, std::string_view ending) {
    std::vector<fs::path> found;
    std::error_code none;
    for (const auto& entry : fs::directory_iterator(kShared / "data" / folder, none)) {
        if (entry.path().string().ends_with(ending) &&
            entry.path().string().find("two-lasers") == std::string::npos)
            found.push_back(entry.path());
    }
    return found;
}

TEST(TourExamination, NothingIsSaidOfRealTours) {
    std::vector<fs::path> tours = recordings("radish", ".log.gz");
    for (const fs::path& log : recordings("player", ".log.gz")) tours.push_back(log);
    for (const fs::path& log : recordings("ros", ".bag")) tours.push_back(log);
    if (tours.empty()) GTEST_SKIP() << "no recordings in " << kShared;
    for (const fs::path& tour : tours) EXPECT_EQ(read(tour.string()).said(), "") << tour;
}

TEST(TourExamination, TellsWhatIsWrongWithRecordingsFromElsewhere) {
    const fs::path foreign = kShared / "data" / "foreign";
    if (!fs::exists(foreign)) GTEST_SKIP() << "no recordings in " << foreign;
    const std::map<std::string, Kind> wrong = {
        {"angles-in-degrees/tour.mcap", Kind::beyond_a_turn},
        {"carmen-millimetres/tour.log", Kind::laser_units},
        {"clock-no-overlap/tour.mcap", Kind::clocks_apart},
        {"clock-offset-12s/tour.mcap", Kind::scan_delay},
        {"clock-offset-60s/tour.mcap", Kind::scan_delay},
        {"laser-backwards/tour.mcap", Kind::turned_laser},
        {"laser-only/tour.mcap", Kind::no_odometry},
        {"mirrored-laser/tour.mcap", Kind::mirrored_laser},
        {"no-tf-static/tour.mcap", Kind::no_odometry},
        {"odometry-reset/tour.mcap", Kind::leaping_odometry},
        {"range-limits-swapped/tour.mcap", Kind::blind_laser},
        {"ranges-in-millimetres/tour.mcap", Kind::laser_units},
        {"twist-only/tour.mcap", Kind::still_odometry}};
    for (const auto& [file, kind] : wrong) {
        const Readings readings = read((foreign / file).string());
        EXPECT_TRUE(readings.of_kind(kind)) << file << ": " << readings.said();
        EXPECT_EQ(readings.findings().size(), 1U) << file << ": " << readings.said();
    }
    for (const char* clean : {"00-control/tour.mcap", "sweep-control/tour.mcap"})
        EXPECT_EQ(read((foreign / clean).string()).said(), "") << clean;
}

TEST(TourExamination, TheDelayThatIsAdvisedMendsTheTour) {
    const fs::path tour = kShared / "data" / "foreign" / "clock-offset-12s" / "tour.mcap";
    if (!fs::exists(tour)) GTEST_SKIP() << "no recording in " << tour;
    SourceParams params;
    params.file = tour.string();
    const double delay = inspect_tour(*open_tour(params)).findings.at(0).value;
    params.read.scan_delay_s = delay;
    EXPECT_TRUE(inspect_tour(*open_tour(params)).findings.empty());
}

}  // namespace
}  // namespace hitos
