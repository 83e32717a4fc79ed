// SPDX-License-Identifier: GPL-3.0-or-later
#include "hitos/services/evaluation/reference_fit.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "hitos/base/error.hpp"
#include "hitos/services/evaluation/relative_error.hpp"
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

std::optional<Advice> doubt_of(const Trajectory& path, const Trajectory& reference) {
    const std::vector<Advice> doubts = fit_of_reference(path, reference).doubts();
    return doubts.empty() ? std::nullopt : std::optional(doubts.front());
}

TEST(ReferenceFit, CountsThePosesThatHaveOneOfTheReference) {
    const Trajectory path = path_from(0.0, 1.0, 100);
    EXPECT_EQ(fit_of_reference(path, path).common, 100U);
    EXPECT_FALSE(doubt_of(path, path));
    EXPECT_FALSE(doubt_of(path, path_from(0.0, 1.0, 50)));
    const ReferenceFit fit = fit_of_reference(path, path_from(0.0, 1.0, 49));
    ASSERT_EQ(fit.doubts().size(), 1U);
    EXPECT_EQ(fit.doubts().front().figure, "49/100");
    // Between its poses a dense reference is interpolated.
    EXPECT_GE(fit_of_reference(path, path_from(0.17, 0.4, 248)).common, 98U);
}

TEST(ReferenceFit, TwoPlacesAtOneStampAreOfTwoRobots) {
    const Trajectory path = path_from(0.0, 1.0, 100);
    Trajectory twice = path;
    twice.insert(twice.end(), path.begin(), path.end());
    EXPECT_FALSE(doubt_of(path, twice)) << "the same places";
    for (std::size_t i = path.size(); i < twice.size(); ++i) twice[i].pose.y += 5.0;
    const std::optional<Advice> doubt = doubt_of(path, twice);
    ASSERT_TRUE(doubt);
    EXPECT_THAT(doubt->text, HasSubstr("two places at one stamp"));
    EXPECT_EQ(doubt->figure, "5.00 m");
    EXPECT_FALSE(fit_of_path(path, twice).judges_loops());
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

/// Round two rooms of unlike size, so that it has left bends and right ones.
Trajectory tour(double bias_rad_m = 0.0) {
    Trajectory path;
    Pose pose;
    for (int i = 0; i < 800; ++i) {
        path.push_back({0.5 * i, pose});
        const double bend = i % 200 < 90 ? 0.18 : -0.1;
        pose = compose(pose, {0.1 + 0.05 * std::sin(0.1 * i), 0.0,
                              (i % 25 < 5 ? bend : 0.0) + 0.1 * bias_rad_m});
    }
    return path;
}

/// At the same times.
Trajectory another_tour() {
    Trajectory path;
    Pose pose;
    for (int i = 0; i < 800; ++i) {
        path.push_back({0.5 * i, pose});
        pose = compose(pose, {i % 60 < 30 ? 0.02 : 0.3, 0.0, i % 22 < 11 ? 0.25 : -0.1});
    }
    return path;
}

template <class Change>
std::string doubt_where(const Trajectory& path, Change change) {
    Trajectory reference = path;
    for (StampedPose& pose : reference) pose.pose = change(pose.pose);
    const auto doubt = doubt_of(path, reference);
    return doubt ? doubt->words() : std::string();
}

TEST(ReferenceFit, SaysHowAReferenceOfAnotherShapeDiffers) {
    // So does the path that bad odometry tells.
    const Trajectory odometry = tour(0.03);
    ASSERT_GT(trajectory_error(odometry, tour())->rmse_m, 5.0);
    EXPECT_FALSE(doubt_of(odometry, tour()));
    for (const Trajectory& path : {tour(), odometry}) {
        EXPECT_EQ(doubt_where(path, [](Pose at) { return at; }), "");
        // Of another frame.
        EXPECT_EQ(doubt_where(path, [](Pose at) { return compose({40.0, -9.0, 2.0}, at); }), "");
        EXPECT_THAT(doubt_where(path,
                                [](Pose at) {
                                    return Pose{at.x, -at.y, -at.theta};
                                }),
                    HasSubstr("mirror image of the path ("));
        EXPECT_THAT(doubt_where(path,
                                [](Pose at) {
                                    return Pose{at.y, at.x, at.theta};
                                }),
                    HasSubstr("mirror image of the path ("));
        const auto times = [](double scale) {
            return [scale](Pose at) { return Pose{scale * at.x, scale * at.y, at.theta}; };
        };
        EXPECT_THAT(doubt_where(path, times(1000.0)), HasSubstr("1e+03 times as large as the path: "
                                                                "it is in millimetres"));
        EXPECT_THAT(doubt_where(path, times(100.0)), HasSubstr("it is in centimetres"));
        EXPECT_THAT(doubt_where(path, times(3.2808)), HasSubstr("it is in feet"));
        EXPECT_THAT(doubt_where(path, times(0.5)), HasSubstr("0.5 times as large"));
        EXPECT_EQ(doubt_where(path, times(1.1)), "");
    }
    const auto other = doubt_of(tour(), another_tour());
    ASSERT_TRUE(other);
    EXPECT_THAT(other->words(), HasSubstr("nowhere like the reference trajectory"));
    // What hardly moves has no shape.
    EXPECT_FALSE(doubt_of(path_from(0.0, 1.0, 50), tour()));
}

Trajectory with_clock(Trajectory path, double shift_s) {
    for (StampedPose& pose : path) pose.time_s += shift_s;
    return path;
}

/// As a run has it: near its truth, but not on it.
Trajectory shaken(Trajectory path) {
    for (std::size_t i = 0; i < path.size(); ++i) {
        const auto turn = static_cast<double>(i);
        path[i].pose.x += 0.01 * std::sin(0.7 * turn);
        path[i].pose.y += 0.01 * std::cos(1.1 * turn);
    }
    return path;
}

TEST(ReferenceFit, SaysByHowMuchAClockIsOff) {
    for (const double shift_s : {-30.0, -3.0, 0.6, 1.5, 6.0, 50.0}) {
        const ReferenceFit fit = fit_of_reference(shaken(tour()), with_clock(tour(), shift_s));
        ASSERT_TRUE(fit.misfit) << shift_s;
        EXPECT_NEAR(std::stod(fit.misfit->figure), std::abs(shift_s), 0.11);
        EXPECT_THAT(fit.misfit->words(), HasSubstr(shift_s < 0.0 ? " later: its clock is behind"
                                                                 : " earlier: its clock is ahead"));
        EXPECT_FALSE(fit.judges_loops());
    }
    EXPECT_TRUE(fit_of_reference(shaken(tour()), tour()).judges_loops());
    // Of a path that is bent no clock makes a good one.
    EXPECT_FALSE(fit_of_reference(tour(0.03), tour()).misfit);
}

TEST(ReferenceFit, IsNotLedAstrayByLaps) {
    // Round a square in 100 s, each side in a time of its own: else a quarter of a lap would do.
    constexpr std::array kSides{40, 60, 70, 30};
    Trajectory laps;
    Pose corner;
    for (int side = 0; side < 16; ++side) {
        const int poses = kSides[static_cast<std::size_t>(side % 4)];
        for (int i = 0; i < poses; ++i) {
            laps.push_back({0.5 * static_cast<double>(laps.size()),
                            compose(corner, {10.0 * i / poses, 0.0, 0.0})});
        }
        corner = compose(corner, {10.0, 0.0, kPi / 2});
    }
    Trajectory drifted = laps;
    for (std::size_t i = 0; i < drifted.size(); ++i)
        drifted[i].pose.x += 0.002 * static_cast<double>(i);
    EXPECT_FALSE(fit_of_reference(drifted, laps).misfit);
    EXPECT_FALSE(fit_of_reference(shaken(laps), laps).misfit);
    // What lies 70 s off lies 30 s off as well.
    for (const double shift_s : {3.0, 30.0, -30.0}) {
        const ReferenceFit fit = fit_of_reference(shaken(laps), with_clock(laps, shift_s));
        ASSERT_TRUE(fit.misfit) << shift_s;
        EXPECT_NEAR(std::stod(fit.misfit->figure), std::abs(shift_s), 0.11);
    }
}

template <class Change>
Trajectory with_headings(Trajectory path, Change change) {
    for (std::size_t i = 0; i < path.size(); ++i)
        path[i].pose.theta = wrap_angle(change(path[i].pose.theta, static_cast<double>(i)));
    return path;
}

TEST(ReferenceFit, KnowsWhetherAReferenceHasHeadings) {
    const Trajectory path = shaken(tour());
    const PairSpacing spacing{.length = 1.0};
    for (const double heading : {0.0, 1.2}) {
        const Trajectory positions = with_headings(tour(), [&](double, double) { return heading; });
        const ReferenceFit fit = fit_of_reference(path, positions);
        ASSERT_TRUE(fit.headings);
        EXPECT_FALSE(fit.misfit);
        EXPECT_FALSE(fit.judges_loops());
        EXPECT_THAT(fit.headings->words(), HasSubstr("has no headings"));
        EXPECT_FALSE(relative_error(path, positions, spacing));
        const auto error = trajectory_error(path, positions);
        EXPECT_FALSE(error->heading_rmse_rad);
        EXPECT_EQ(error->rmse_m, trajectory_error(path, tour())->rmse_m);
    }
    const auto wild = [](double, double i) { return 7.3 * i * i; };
    const auto doubt = doubt_of(path, with_headings(tour(), wild));
    ASSERT_TRUE(doubt);
    EXPECT_THAT(doubt->words(), HasSubstr("headings of the reference trajectory are none of this"));
    // Driven backwards; but not by one of both alone, nor off by another angle.
    const auto backwards = [](double theta, double) { return theta + kPi; };
    EXPECT_FALSE(doubt_of(with_headings(path, backwards), with_headings(tour(), backwards)));
    const auto across = [](double theta, double) { return theta - kPi / 2.0; };
    const auto turned = doubt_of(path, with_headings(tour(), across));
    ASSERT_TRUE(turned);
    EXPECT_THAT(turned->words(), HasSubstr("are off by -90°"));
    EXPECT_TRUE(doubt_of(path, with_headings(tour(), backwards)));
    EXPECT_FALSE(relative_error(path, with_headings(tour(), across), spacing));
    const auto slightly = [](double theta, double) { return theta + 0.2; };
    EXPECT_FALSE(doubt_of(path, with_headings(tour(), slightly)));
    EXPECT_TRUE(relative_error(path, tour(), spacing));
    // A robot that turns nowhere, as one on omnidirectional wheels; and a path that missed turns.
    const auto still = [](double, double) { return 0.4; };
    EXPECT_FALSE(doubt_of(with_headings(path, still), with_headings(tour(), still)));
    EXPECT_FALSE(doubt_of(with_headings(path, still), tour()));
}

/// Two days' tours, one behind the other.
Trajectory two_days() {
    Trajectory both = tour();
    for (StampedPose pose : tour()) {
        pose.begins = both.size() == tour().size();
        pose.time_s += 1e5;
        both.push_back(pose);
    }
    return both;
}

TEST(ReferenceFit, MayBeOfOneOfTwoTours) {
    for (const double day_s : {0.0, 1e5}) {
        const ReferenceFit fit = fit_of_reference(two_days(), with_clock(tour(), day_s));
        EXPECT_EQ(fit.common, 800U);
        EXPECT_EQ(fit.poses, 800U);
        EXPECT_TRUE(fit.doubts().empty());
    }
    Trajectory part = with_clock(tour(), 1e5);
    part.resize(60);  // 30 s of 400
    EXPECT_THAT(refusal(two_days(), part), HasSubstr("60 of 1600 poses"));
    EXPECT_THAT(refusal(two_days(), with_clock(tour(), 5e4)), HasSubstr("0 of 1600 poses"));
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

constexpr const char* kRooms =
    "rho: 1 theta: -90\nrho: 2 theta: 90\nrho: 2 theta: 0\nrho: 19 theta: 0\nrho: 16 theta: 0\n"
    "rho: 9 theta: 90\nrho: 6 theta: 90\nrho: 1 theta: 180\nx: 2 y: 2\nx: 19 y: -1\nx: 16 y: 2\n"
    "x: 19 y: 9\nx: 16 y: 6\nx: -1 y: 9\nx: 2 y: 6\nx: -1 y: -1\n";

TEST(ReferenceFit, SaysHowAReferenceMapIsRead) {
    const LandmarkMap map = parse_map(kRooms, "rooms");
    const auto doubt = [&](const std::string& reference) {
        const auto found = doubt_of_map(map, parse_map(reference, "reference"));
        return found ? found->words() : std::string();
    };
    EXPECT_EQ(doubt(kRooms), "");
    EXPECT_THAT(doubt("rho: 1 theta: -1.5708\nrho: 2 theta: 1.5708\nrho: 2 theta: 0\n"
                      "rho: 19 theta: 0\nrho: 16 theta: 0\nrho: 9 theta: 1.5708\n"
                      "rho: 6 theta: 1.5708\nrho: 1 theta: 3.14159\nx: 2 y: 2\nx: 19 y: -1\n"
                      "x: 16 y: 2\nx: 19 y: 9\nx: 16 y: 6\nx: -1 y: 9\nx: 2 y: 6\nx: -1 y: -1\n"),
                HasSubstr("has its angles in radians"));
    EXPECT_THAT(doubt("rho: -90 theta: 1\nrho: 90 theta: 2\nrho: 0 theta: 2\nrho: 0 theta: 19\n"
                      "rho: 0 theta: 16\nrho: 90 theta: 9\nrho: 90 theta: 6\nrho: 180 theta: 1\n"
                      "x: 2 y: 2\nx: 19 y: -1\nx: 16 y: 2\nx: 19 y: 9\nx: 16 y: 6\nx: -1 y: 9\n"
                      "x: 2 y: 6\nx: -1 y: -1\n"),
                HasSubstr("rho and theta of its lines in each other's place"));
    LandmarkMap changed = map;
    const auto change = [&](auto line, auto corner) {
        for (std::size_t i = 0; i < map.size(); ++i) {
            if (const auto* wall = std::get_if<Recta>(&map[i].value)) {
                changed[i].value = line(*wall);
            } else {
                changed[i].value = corner(std::get<Esquina>(map[i].value));
            }
        }
        return doubt(map_to_text(changed));
    };
    EXPECT_THAT(change(
                    [](Recta wall) {
                        return Recta{1000.0 * wall.rho, wall.theta};
                    },
                    [](Esquina at) {
                        return Esquina{1000.0 * at.x, 1000.0 * at.y};
                    }),
                HasSubstr("is in millimetres"));
    EXPECT_THAT(change(
                    [](Recta wall) {
                        return Recta{wall.rho / 0.3048, wall.theta};
                    },
                    [](Esquina at) {
                        return Esquina{at.x / 0.3048, at.y / 0.3048};
                    }),
                HasSubstr("is in feet"));
    EXPECT_THAT(change(
                    [](Recta wall) {
                        return Recta{wall.rho, wrap_angle(-wall.theta)};
                    },
                    [](Esquina at) {
                        return Esquina{at.x, -at.y};
                    }),
                HasSubstr("its y axis points the other way"));
    // Of a building that has half of these walls in the same places the others are far from any.
    for (std::size_t i = 0; i < map.size(); ++i) {
        changed[i] = map[i];
        if (i % 4 == 0) changed[i].value = Esquina{40.0, 40.0};
    }
    EXPECT_THAT(doubt(map_to_text(changed)), HasSubstr("Less than four fifths of the landmarks"));
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
