// SPDX-License-Identifier: GPL-3.0-or-later
// Landmarks as tables, map data and graphs.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <limits>

#include "files/ieee_map_file.hpp"
#include "files/landmark_table.hpp"
#include "hitos/base/error.hpp"
#include "map_drawings.hpp"
#include "support.hpp"

namespace hitos {
namespace {

using test::message_of;
using ::testing::HasSubstr;
using ::testing::Not;

TEST(LandmarkTable, HasARowForEachInTheOrderOfTheMapFile) {
    test::SmallMap small;
    std::swap(small.map[0], small.map[2]);  // lines come first all the same
    const std::string table = landmark_table(small.map);
    EXPECT_THAT(table, HasSubstr("\n1,line,1,1,-3.141592653589793,,,,,,,,,,,0,1,1\n"));
    EXPECT_THAT(table,
                HasSubstr("\n2,line,2,2,1.5707963267948966,,,0.01,0.001,0.0004,,,,,,7,2,10\n"));
    EXPECT_THAT(table, HasSubstr("\n3,corner,1,,,-1,2,,,,0.04,0,0.01,,,3,1,1\n"));
}

TEST(LandmarkTable, SaysHowFarALineWasSeen) {
    test::SmallMap small;
    small.map[0].from_m = -5.0;
    small.map[0].to_m = 1.0;
    EXPECT_THAT(landmark_table(small.map), HasSubstr(",,,,-5,1,7,2,10\n"));
}

TEST(LandmarkTable, RefusesWhatIsNotFinite) {
    test::SmallMap small;
    small.map[1].value = Recta{std::numeric_limits<double>::infinity(), 0.0};
    EXPECT_THAT(message_of<Error>([&] { landmark_table(small.map); }), HasSubstr("landmark 2"));
}

TEST(IeeeMapFile, SegmentsStandByTheFootOfTheirNormal) {
    const test::SmallMap small;
    const std::string xml =
        ieee_map_xml({"a<b>\x01\xff", "fastslam", small.map, small.segments, Grid()});
    EXPECT_THAT(xml, HasSubstr("<name>a&lt;b&gt;?\xef\xbf\xbd</name>"));
    EXPECT_THAT(xml, HasSubstr(R"(<line_segment id="line_1_1" rho="2" alpha="1.5707963267948966" )"
                               R"(psi_a=")"));
    EXPECT_THAT(xml, HasSubstr(R"( covariance_rhorho="0.01" covariance_rhoalpha="0.001" )"
                               R"(covariance_alphaalpha="0.0004"/>)"));
    // Of y = 2 places grow towards smaller x.
    const auto psi_of_second = [&xml](const std::string& name) {
        return std::stod(xml.substr(xml.find(name, xml.find("line_1_2")) + name.size()));
    };
    EXPECT_NEAR(psi_of_second("psi_a=\""), -5.0, 1e-9);
    EXPECT_NEAR(psi_of_second("psi_b=\""), -2.0, 1e-9);
    EXPECT_THAT(xml, HasSubstr(R"(id="line_2_1" rho="1" alpha="3.141592653589793")"));
    EXPECT_THAT(xml, HasSubstr(R"(<point id="corner_1" x="-1" y="2" covariance_xx="0.04" )"
                               R"(covariance_xy="0" covariance_yy="0.01"/>)"));
    EXPECT_THAT(xml, Not(HasSubstr("<grid"))) << "there is none";
}

TEST(IeeeMapFile, CellsStandFromBelowInPerCent) {
    GridParams params;
    params.resolution_m = 0.1;
    Grid grid(params);
    Scan scan;
    scan.points = {{0.2, 0.0}};
    scan.run_starts = {0};
    grid.add(scan, {0.05, 0.05, kPi / 2.0});
    const std::string xml = ieee_map_xml({"", "", {}, {}, grid});
    // Log-odds of one miss, -0.4, and of one hit, 0.85.
    EXPECT_THAT(xml, HasSubstr("<row y=\"0\">40</row>\n        <row y=\"1\">40</row>\n"
                               "        <row y=\"2\">70</row>"));
    EXPECT_THAT(xml, HasSubstr(R"(size_x="1" size_y="3")"));
}

TEST(IeeeMapFile, RefusesSegmentsOfNoLine) {
    test::SmallMap small;
    small.segments[0].landmark = 2;
    EXPECT_THAT(message_of<Error>([&] {
                    ieee_map_xml({"", "", small.map, small.segments, Grid()});
                }),
                HasSubstr("no line"));
}

}  // namespace
}  // namespace hitos
