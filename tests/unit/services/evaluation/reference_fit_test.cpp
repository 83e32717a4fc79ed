// SPDX-License-Identifier: GPL-3.0-or-later
#include "hitos/services/evaluation/reference_fit.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <string>

#include "hitos/base/error.hpp"
#include "hitos/services/files/reference_files.hpp"
#include "support.hpp"

namespace hitos {
namespace {

using testing::HasSubstr;

/// So many poses, one every step, from a time on.
Trajectory path_from(double from_s, double step_s, int poses) {
    Trajectory path;
    for (int i = 0; i < poses; ++i) path.push_back({from_s + step_s * i, {0.1 * i, 0.0, 0.0}});
    return path;
}

std::string refusal(const Trajectory& path, const Trajectory& reference) {
    try {
        fit_of_reference(path, reference);
    } catch (const Error& error) {
        return error.what();
    }
    return {};
}

TEST(ReferenceFit, CountsThePosesThatHaveOneOfTheReference) {
    const Trajectory path = path_from(0.0, 1.0, 100);
    EXPECT_EQ(fit_of_reference(path, path).common, 100U);
    EXPECT_FALSE(fit_of_reference(path, path).doubt());
    EXPECT_FALSE(fit_of_reference(path, path_from(0.0, 1.0, 50)).doubt());
    const ReferenceFit fit = fit_of_reference(path, path_from(0.0, 1.0, 49));
    ASSERT_TRUE(fit.doubt());
    EXPECT_EQ(fit.doubt()->figure, "49/100");
    // Between its poses a dense reference is interpolated.
    EXPECT_GE(fit_of_reference(path, path_from(0.17, 0.4, 248)).common, 98U);
}

TEST(ReferenceFit, RefusesATrajectoryOfAnotherTour) {
    const Trajectory path = path_from(10.0, 1.0, 100);
    const std::string hours = refusal(path, path_from(7210.0, 1.0, 100));
    EXPECT_THAT(hours, HasSubstr("0 of 100 poses"));
    EXPECT_THAT(hours, HasSubstr("second 10.000 to 109.000, the reference from 7210.000 to "));
    EXPECT_THAT(refusal(path, path_from(50.0, 1.0, 1)), HasSubstr("1 of 100 poses"));
    EXPECT_THAT(refusal(path, path_from(50.0, 1.0, 5)), HasSubstr("5 of 100 poses"));  // 4 s of 99
    EXPECT_EQ(refusal(path, path_from(50.0, 1.0, 11)), "");
    // Of two clocks of the same time some stamps agree by chance.
    Trajectory other = path_from(10.3, 1.0, 100);
    for (const std::size_t i : {3U, 40U, 77U}) other[i].time_s = path[i].time_s;
    EXPECT_THAT(refusal(path, other), HasSubstr("3 of 100 poses"));
}

TEST(ReferenceFit, OfShortPathsWantsEveryPose) {
    const Trajectory two = path_from(0.0, 1.0, 2);
    EXPECT_EQ(refusal(two, two), "");
    EXPECT_THAT(refusal(two, path_from(0.0, 1.0, 1)), HasSubstr("1 of 2 poses"));
}

TEST(ReferenceFit, DoubtsAMapOfAnotherPlace) {
    const LandmarkMap map{{Esquina{0.0, 0.0}}, {Esquina{4.0, 0.0}}, {Recta{3.0, 0.0}}};
    EXPECT_FALSE(doubt_of_map(map, map));
    EXPECT_FALSE(doubt_of_map({}, map));
    LandmarkMap far = map;
    for (std::size_t i : {0U, 1U}) far[i].value = Esquina{50.0, 9.0 * static_cast<double>(i)};
    ASSERT_TRUE(doubt_of_map(map, far));
    EXPECT_EQ(doubt_of_map(map, far)->figure, "1/3");
    // Of no kind that it has.
    EXPECT_EQ(doubt_of_map({{Recta{1.0, 0.0}}}, {{Esquina{1.0, 0.0}}})->figure, "0/1");
}

class ReferenceFilesTest : public testing::Test {
  protected:
    std::string file(const std::string& name, const std::string& text) const {
        return folder_.put(name, text).string();
    }

    const test::TempFolder folder_;
    const std::string map_ = file("a.tum", "# a map\n\nrho: 1 theta: 0\nx: 1 y: 2\n");
    const std::string path_ = file("b.map", "# t x y\n0 1 2 0 0 0 0 1\n1 1 2 0 0 0 0 1\n");
};

TEST_F(ReferenceFilesTest, AreKnownByTheirContent) {
    EXPECT_EQ(reference_kind(map_), ReferenceKind::map);
    EXPECT_EQ(reference_kind(path_), ReferenceKind::trajectory);
    EXPECT_EQ(reference_kind(file("c.txt", "neither\n")), std::nullopt);
    EXPECT_EQ(reference_kind(file("d.csv",
                                  "#t [ns], px, py, pz, qw, qx, qy, qz\n"
                                  "1000000000,0,0,0,1,0,0,0\n")),
              ReferenceKind::trajectory);
    EXPECT_EQ(reference_kind(folder_.path() / "none"), std::nullopt);
    EXPECT_EQ(reference_kind("/dev/zero"), std::nullopt);
}

TEST_F(ReferenceFilesTest, GoWhereTheyBelong) {
    EXPECT_EQ(by_content({map_, path_}).map, map_);
    const ReferenceFiles turned = by_content({path_, map_});
    EXPECT_EQ(turned.map, map_);
    EXPECT_EQ(turned.trajectory, path_);
    EXPECT_EQ(by_content({path_, ""}).trajectory, path_);
    EXPECT_EQ(by_content({"", map_}).map, map_);
    EXPECT_THROW(by_content({path_, path_}), ConfigError);
    EXPECT_THROW(by_content({map_, map_}), ConfigError);
}

}  // namespace
}  // namespace hitos
