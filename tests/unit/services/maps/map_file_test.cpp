// SPDX-License-Identifier: GPL-3.0-or-later
#include "hitos/services/files/map_file.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <random>

#include "hitos/base/error.hpp"
#include "support.hpp"

namespace hitos {
namespace {

using test::message_of;
using test::TempFolder;
using ::testing::HasSubstr;

ICaracteristica line_at(double rho, double theta) {
    return {Recta{rho, theta}};
}
ICaracteristica corner_at(double x, double y) {
    return {Esquina{x, y}};
}

Recta line_of(std::string_view text) {
    return std::get<Recta>(parse_map(text, "m").at(0).value);
}

std::string map_refusal(std::string_view text) {
    return message_of<FormatError>([&] { parse_map(text, "m.map"); });
}

std::ptrdiff_t count_of(const LandmarkMap& map, FeatureKind kind) {
    return std::ranges::count(map, kind, &ICaracteristica::kind);
}

TEST(ParseMap, ReadsLinesAndCornersInOrder) {
    const LandmarkMap map =
        parse_map("# a map\n\nx: -1.5 y: 2e1\nrho: 9 theta: 90 # north\r\n", "m");
    ASSERT_EQ(map.size(), 2U);
    EXPECT_EQ(std::get<Esquina>(map[0].value), (Esquina{-1.5, 20.0}));
    EXPECT_EQ(std::get<Recta>(map[1].value), (Recta{9.0, kPi / 2.0}));
    EXPECT_EQ(map[1].observations, 0);
    EXPECT_TRUE(map[1].covariance.isZero(0.0));
}

TEST(ParseMap, IsTolerantOfCaseAndSpacing) {
    for (const char* text : {"rho: 1 theta: 2", "RHO:1 Theta:2", "  rho : 1\ttheta  :  2  ",
                             "rho:+1.0 theta:2e0\r", "rho: 1 theta: 2#x"}) {
        EXPECT_EQ(line_of(text), (Recta{1.0, 2.0 * (kPi / 180.0)})) << text;
    }
    EXPECT_EQ(std::get<Esquina>(parse_map("X:1 Y :2", "m")[0].value), (Esquina{1.0, 2.0}));
}

TEST(MapFile, LandmarksMayHaveNames) {
    const LandmarkMap map = parse_map("x: 1 y: 2 identity: 7\nx: 3 y: 4\n", "m");
    ASSERT_EQ(map.size(), 2U);
    EXPECT_EQ(map[0].identity, 7);
    EXPECT_EQ(map[1].identity, -1);
    EXPECT_EQ(map_to_text(map), "x: 1 y: 2 identity: 7\nx: 3 y: 4\n");
    for (const char* identity : {"-1", "1.5", "3e9"}) {
        EXPECT_THAT(map_refusal(std::string("x: 1 y: 2 identity: ") + identity),
                    HasSubstr("expected a whole number from 0"));
    }
    EXPECT_THAT(map_refusal("x: 1 y: 2 name: 3"), HasSubstr("expected"));
}

TEST(MapFile, ReadsTheMarksOfMrclam) {
    const LandmarkMap map = parse_map(
        "# UTIAS Multi-Robot Cooperative Localization and Mapping Dataset\n# x\n"
        "  6 \t 5.5 \t 4.25 \t 0.0002 \t 0.0004\n 20 1 2 0 0\n",
        "m");
    ASSERT_EQ(map.size(), 2U);
    EXPECT_EQ(std::get<Esquina>(map[0].value), (Esquina{5.5, 4.25}));
    EXPECT_EQ(map[1].identity, 20);
}

TEST(ParseMap, BringsLinesToNormalForm) {
    EXPECT_EQ(line_of("rho: 1 theta: 180"), (Recta{1.0, kPi}));
    EXPECT_EQ(line_of("rho: 1 theta: -180"), (Recta{1.0, kPi}));
    EXPECT_EQ(line_of("rho: 1 theta: 540"), (Recta{1.0, kPi}));
    EXPECT_EQ(line_of("rho: 1 theta: 450"), (Recta{1.0, kPi / 2.0}));
    EXPECT_EQ(line_of("rho: -1 theta: 90"), (Recta{1.0, -kPi / 2.0}));
    EXPECT_EQ(line_of("rho: -1 theta: 0"), (Recta{1.0, kPi}));
    EXPECT_EQ(line_of("rho: -1 theta: -180"), (Recta{1.0, 0.0}));
    EXPECT_FALSE(std::signbit(line_of("rho: -0 theta: 1").rho));
}

TEST(ParseMap, NormalFormIsTheSameLine) {
    std::mt19937_64 random(3);
    std::uniform_real_distribution<double> rhos(-20.0, 20.0);
    std::uniform_real_distribution<double> angles(-2000.0, 2000.0);
    for (int i = 0; i < 2000; ++i) {
        const double rho = rhos(random);
        const double degrees = angles(random);
        const Recta recta =
            line_of("rho: " + std::to_string(rho) + " theta: " + std::to_string(degrees));
        EXPECT_GE(recta.rho, 0.0);
        EXPECT_GT(recta.theta, -kPi);
        EXPECT_LE(recta.theta, kPi);
        const double theta = std::stod(std::to_string(degrees)) * kPi / 180.0;
        const double signed_rho = std::stod(std::to_string(rho));
        EXPECT_NEAR(foot(recta).x, signed_rho * std::cos(theta), 1e-11);
        EXPECT_NEAR(foot(recta).y, signed_rho * std::sin(theta), 1e-11);
    }
}

TEST(ParseMap, NamesLineFoundAndExpected) {
    const std::string expected =
        R"(; expected "rho: <metres> theta: <degrees>" or "x: <metres> y: <metres>")";
    EXPECT_EQ(map_refusal("x: 1 y: 2\n\nrho 1 theta 2\n"),
              "m.map:3: found \"rho 1 theta 2\"" + expected);
    for (const char* text :
         {"rho: 1", "rho: 1 y: 2", "x: 1 theta: 2", "theta: 1 rho: 2", "z: 1", ": 1 y: 2", "1 2"}) {
        EXPECT_EQ(map_refusal(text), std::string("m.map:1: found \"") + text + '"' + expected);
    }
}

TEST(ParseMap, RefusesWhatIsNoFiniteNumber) {
    EXPECT_EQ(map_refusal("rho: nan theta: 1"),
              "m.map:1: rho is \"nan\"; expected a finite number");
    EXPECT_EQ(map_refusal("rho: 1 theta: -inf"),
              "m.map:1: theta is \"-inf\"; expected a finite number");
    EXPECT_EQ(map_refusal("x: 1,5 y: 2"),
              "m.map:1: x is \"1,5\", with a decimal comma; expected a decimal point");
    EXPECT_EQ(map_refusal("x: 1 y:"), "m.map:1: y is \"\"; expected a finite number");
    EXPECT_EQ(map_refusal("x: 1 y: 1e999"), "m.map:1: y is \"1e999\"; expected a finite number");
}

TEST(ParseMap, RefusesWhatFollowsTheFeature) {
    EXPECT_EQ(map_refusal("x: 1 y: 2 3"),
              "m.map:1: found \"3\" after the feature; expected the end of the line");
    EXPECT_EQ(map_refusal("rho: 1 theta: 2 x: 1 y: 2"),
              "m.map:1: found \"x: 1 y: 2\" after the feature; expected the end of the line");
}

TEST(ParseMap, RefusesAMapWithoutLandmarks) {
    for (const char* text : {"", "\n\n", "# rho: 1 theta: 2\n"}) {
        EXPECT_THAT(map_refusal(text),
                    HasSubstr("m.map: no landmark in the file; expected \"rho: "));
    }
}

TEST(MapToText, PutsLinesBeforeCornersAndZeroWithoutSign) {
    EXPECT_EQ(map_to_text({corner_at(-0.0, 1.5), line_at(0.1, -kPi / 2.0), corner_at(1e-9, 1e20),
                           line_at(2.0, -0.0)}),
              "rho: 0.1 theta: -90\nrho: 2 theta: 0\nx: 0 y: 1.5\nx: 1e-09 y: 1e+20\n");
    EXPECT_EQ(map_to_text({}), "");
}

TEST(MapToText, WholeDegreesStayWhole) {
    for (int degrees = -179; degrees <= 180; ++degrees) {
        const std::string text = "rho: 1 theta: " + std::to_string(degrees) + "\n";
        EXPECT_EQ(map_to_text(parse_map(text, "m")), text);
    }
}

TEST(MapToText, ReadsBack) {
    std::mt19937_64 random(4);
    std::uniform_real_distribution<double> lengths(-50.0, 50.0);
    std::uniform_real_distribution<double> angles(-kPi, kPi);
    LandmarkMap map;
    for (int i = 0; i < 3000; ++i)
        map.push_back(line_at(std::abs(lengths(random)), angles(random)));
    for (int i = 0; i < 3000; ++i) map.push_back(corner_at(lengths(random), lengths(random)));
    const LandmarkMap back = parse_map(map_to_text(map), "m");
    ASSERT_EQ(back.size(), map.size());
    for (std::size_t i = 0; i < 3000; ++i) {
        const Recta a = std::get<Recta>(map[i].value);
        const Recta b = std::get<Recta>(back[i].value);
        EXPECT_EQ(a.rho, b.rho);
        EXPECT_GE(b.theta, std::nextafter(a.theta, -4.0));
        EXPECT_LE(b.theta, std::nextafter(a.theta, 4.0));
    }
    for (std::size_t i = 3000; i < map.size(); ++i) {
        EXPECT_EQ(std::get<Esquina>(map[i].value), std::get<Esquina>(back[i].value));
    }
}

TEST(MapToText, RefusesLandmarksThatAreNotFinite) {
    const double nan = std::numeric_limits<double>::quiet_NaN();
    EXPECT_EQ(message_of<Error>([&] {
                  map_to_text({corner_at(0.0, 0.0), line_at(1.0, nan)});
              }),
              "landmark 1 of the map, a line (1, nan), is not finite and cannot be written");
    EXPECT_THAT(message_of<Error>([&] { map_to_text({corner_at(HUGE_VAL, 0.0)}); }),
                HasSubstr("landmark 0 of the map, a corner (inf, 0)"));
}

TEST(MapFiles, AreWrittenAndRead) {
    const TempFolder folder;
    const auto path = folder / "a.map";
    write_map({line_at(1.0, kPi), corner_at(1.0, 2.0)}, path);
    EXPECT_EQ(test::content(path), "rho: 1 theta: 180\nx: 1 y: 2\n");
    EXPECT_EQ(read_map(path).size(), 2U);
    EXPECT_EQ(folder.files(), 1U);
}

TEST(MapFiles, ErrorsNameTheFile) {
    const TempFolder folder;
    const auto missing = folder / "none.map";
    EXPECT_EQ(message_of<FileError>([&] { read_map(missing); }),
              missing.string() + ": no such file");
    EXPECT_THAT(message_of<FileError>([&] { read_map(folder.path()); }), HasSubstr("directory"));
    const auto bad = folder.put("bad.map", "x: 1 y: 2\nx: 1\n");
    EXPECT_THAT(message_of<FormatError>([&] { read_map(bad); }), HasSubstr(bad.string() + ":2: "));
    EXPECT_THAT(message_of<FileError>([&] { write_map({corner_at(1, 2)}, bad / "m.map"); }),
                HasSubstr((bad / "m.map").string()));
    const double nan = std::numeric_limits<double>::quiet_NaN();
    EXPECT_THROW(write_map({corner_at(nan, 2)}, bad), Error);
    EXPECT_EQ(test::content(bad), "x: 1 y: 2\nx: 1\n");
    EXPECT_EQ(folder.files(), 1U);
}

struct ReferenceMap {
    const char* name;
    int lines;
    int corners;
};
class ReferenceMaps : public ::testing::TestWithParam<ReferenceMap> {};

TEST_P(ReferenceMaps, HoldTheLandmarksOfTheThesis) {
    const LandmarkMap map = read_map(std::filesystem::path(HITOS_SOURCE_DIR) / "data" / "maps" /
                                     (std::string(GetParam().name) + ".map"));
    EXPECT_EQ(count_of(map, FeatureKind::line), GetParam().lines);
    EXPECT_EQ(count_of(map, FeatureKind::corner), GetParam().corners);
    EXPECT_EQ(map_to_text(parse_map(map_to_text(map), "m")), map_to_text(map));
}

INSTANTIATE_TEST_SUITE_P(Thesis, ReferenceMaps,
                         ::testing::Values(ReferenceMap{"recinto", 4, 4},
                                           ReferenceMap{"lineamedia", 5, 4},
                                           ReferenceMap{"bigloop", 8, 8},
                                           ReferenceMap{"bigloop2", 10, 12},
                                           ReferenceMap{"complex", 12, 14}),
                         [](const auto& map) { return std::string(map.param.name); });

}  // namespace
}  // namespace hitos
