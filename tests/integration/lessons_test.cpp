// SPDX-License-Identifier: GPL-3.0-or-later
// What the pages of data/lessons say can be seen, seen: each lesson's world and configuration are
// opened as the window opens them and run with several seeds. The numbers of the pages are medians
// over 20 seeds; here are fewer, and the limits leave room.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <optional>

#include "hitos/services/configuration/archivo_configuracion.hpp"
#include "hitos/services/evaluation/distances.hpp"
#include "hitos/services/evaluation/measures.hpp"
#include "hitos/services/evaluation/position_error.hpp"
#include "hitos/services/evaluation/run_loops.hpp"
#include "hitos/services/files/map_file.hpp"
#include "hitos/services/run/algoritmo.hpp"
#include "hitos/services/run/step_figures.hpp"
#include "hitos/workbench/configuration_choices.hpp"
#include "hitos/workbench/open_tour.hpp"
#include "hitos/workbench/shipped_data.hpp"

namespace hitos {
namespace {

constexpr int kSeeds = 10;

/// What a page has the reader change.
struct Change {
    std::vector<std::string> set = {};        ///< as --set has it
    std::vector<std::string> world_set = {};  ///< as --world-set has it
    const char* configuration = "run.cfg";
    const char* world = "world.toml";
};

/// One value of the motion's noise for x, y and heading, as --set has it.
std::vector<std::string> ratios(const std::string& value) {
    return {"motion.ratio_x=" + value, "motion.ratio_y=" + value, "motion.ratio_theta=" + value};
}

/// What is kept of a run.
struct LessonSeen {
    double ate_m = 0.0;
    double odometry_ate_m = 0.0;
    int lines = 0;
    int corners = 0;
    std::vector<StepFigures> steps;
    std::vector<double> position_error_m;  ///< as the plot has it, scan by scan
    std::vector<double> odometry_error_m;  ///< likewise, of the odometry alone
    std::vector<Pose> truth;               ///< in the frame of the start
    LandmarkMap map;
    std::size_t ancestry = 0;  ///< scans of the past that all particles share
};

LessonSeen run(const Lesson& lesson, std::optional<std::uint64_t> seed, const Change& change,
               std::uint64_t tour_seed = 0) {
    Configuracion configuration = ArchivoConfiguracion::read(lesson.folder / change.configuration);
    EXPECT_EQ(std::filesystem::path(configuration.source.file), lesson.world);
    configuration.source.file = (lesson.folder / change.world).string();
    ValueChoices choices{.assignments = change.set,
                         .seed = seed,
                         .threads = 1,
                         .world_assignments = change.world_set};
    if (tour_seed != 0) choices.tour_seed = tour_seed;
    choose_values(configuration, choices);
    Algoritmo algorithm(configuration, open_tour(configuration), {.step_grid = false});
    const Trajectory truth = algorithm.reader().truth().value().path;
    EXPECT_LT(truth.back().time_s - truth.front().time_s, 120.0);
    PositionError position(truth);
    PositionError of_odometry(truth);
    LessonSeen seen;
    while (algorithm.step()) {
        seen.steps.push_back(figures_of(algorithm, 0.0));
        seen.position_error_m.push_back(position.at(seen.steps.back().online).value());
        seen.odometry_error_m.push_back(
            of_odometry.at(algorithm.odometry_trajectory().back()).value());
    }
    for (const StampedPose& pose : truth) seen.truth.push_back(pose.pose);
    const Trajectory best = algorithm.best_trajectory();
    seen.ate_m = trajectory_error(best, truth).value().rmse_m;
    seen.odometry_ate_m = trajectory_error(algorithm.odometry_trajectory(), truth).value().rmse_m;
    seen.map = algorithm.filter().best_map();
    seen.lines = seen.steps.back().lines;
    seen.corners = seen.steps.back().corners;
    const auto branches = algorithm.filter().ancestry();
    if (branches.front().particles == algorithm.filter().hypotheses().size())
        seen.ancestry = branches.front().poses.size();
    return seen;
}

class Lessons : public testing::Test {
  protected:
    static const Lesson& lesson(int number) {
        static const std::vector<Lesson> all = lessons();
        return all.at(static_cast<std::size_t>(number - 1));
    }
    static std::vector<LessonSeen> runs(int number, const Change& change = {}, int seeds = kSeeds) {
        std::vector<LessonSeen> all;
        for (int seed = 1; seed <= seeds; ++seed)
            all.push_back(run(lesson(number), static_cast<std::uint64_t>(seed), change));
        return all;
    }
};

double median(const std::vector<LessonSeen>& all,
              const std::function<double(const LessonSeen&)>& figure) {
    std::vector<double> values;
    for (const LessonSeen& seen : all) values.push_back(figure(seen));
    std::ranges::sort(values);
    return values[values.size() / 2];
}

double ate(const std::vector<LessonSeen>& all) {
    return median(all, [](const LessonSeen& seen) { return seen.ate_m; });
}

double odometry_ate(const std::vector<LessonSeen>& all) {
    return median(all, [](const LessonSeen& seen) { return seen.odometry_ate_m; });
}

long count(const std::vector<LessonSeen>& all,
           const std::function<bool(const LessonSeen&)>& is_so) {
    return std::ranges::count_if(all, is_so);
}

double neff(const std::vector<LessonSeen>& all) {
    return median(all, [](const LessonSeen& seen) {
        std::vector<double> values;
        for (const StepFigures& step : seen.steps) values.push_back(step.neff);
        std::ranges::sort(values);
        return values[values.size() / 2];
    });
}

bool better_than_odometry(const LessonSeen& seen) {
    return seen.ate_m < seen.odometry_ate_m;
}

TEST_F(Lessons, OdometryDriftsByItsNoiseAndItsWayAndTheFilterHardlyDoes) {
    const auto all = runs(1);
    EXPECT_EQ(count(all, better_than_odometry), kSeeds);
    EXPECT_GT(odometry_ate(all), 3.0 * ate(all));
    EXPECT_EQ(
        count(all, [](const LessonSeen& seen) { return seen.lines == 4 && seen.corners == 4; }),
        kSeeds);
    const auto third = runs(1, {.world_set = {"odometry.noise=0.1"}});
    for (std::size_t i = 0; i < all.size(); ++i)
        EXPECT_NEAR(all[i].odometry_ate_m / third[i].odometry_ate_m, 3.0, 0.15);
    const auto none = runs(1, {.world_set = {"odometry.noise=0"}}, 3);
    EXPECT_LT(odometry_ate(none), 1e-6);
    EXPECT_GT(ate(none), 0.01) << "the filter adds its own noise to an odometry that has none";
    const auto one_lap = runs(1, {.world_set = {"tour.laps=1"}});
    EXPECT_GT(odometry_ate(all), 1.3 * odometry_ate(one_lap));
    EXPECT_LT(ate(all), 1.3 * ate(one_lap));
}

/// The first scan after the turn at the far end at which the robot is back at 9 m.
std::size_t on_the_way_back(const LessonSeen& seen) {
    const auto far = std::ranges::max_element(seen.truth, {}, &Pose::x);
    const auto back = std::find_if(far, seen.truth.end(), [](const Pose& p) { return p.x < 9.0; });
    return static_cast<std::size_t>(back - seen.truth.begin());
}

double sigma_along(const LessonSeen& seen, std::size_t step) {
    return std::sqrt(seen.steps[step].covariance(0, 0));
}

double sigma_across(const LessonSeen& seen, std::size_t step) {
    return std::sqrt(seen.steps[step].covariance(1, 1));
}

TEST_F(Lessons, OneWallTellsTheDistanceToItAndNothingOfTheWayAlongIt) {
    const auto all = runs(2);
    EXPECT_GE(count(all,
                    [](const LessonSeen& seen) {
                        const std::size_t back = on_the_way_back(seen);
                        return sigma_along(seen, back) > 2.5 * sigma_across(seen, back);
                    }),
              kSeeds - 1);
    EXPECT_EQ(count(all,
                    [](const LessonSeen& seen) {
                        return sigma_along(seen, seen.steps.size() - 1) <
                               sigma_along(seen, on_the_way_back(seen)) / 4.0;
                    }),
              kSeeds)
        << "the wall across has been seen again";
    const auto across = [](const LessonSeen& seen) {
        const std::size_t back = on_the_way_back(seen);
        return std::abs(seen.steps[back].mean.y - seen.truth[back].y);
    };
    EXPECT_LT(median(all, across), 0.08);
    EXPECT_GT(median(all, [](const LessonSeen& seen) { return seen.odometry_error_m.back(); }),
              0.5);
    EXPECT_LT(median(all, [](const LessonSeen& seen) { return seen.position_error_m.back(); }),
              0.05);
    const auto straight = runs(2, {.world_set = {"tour.look_around=false"}});
    const auto at_end = [](const LessonSeen& seen) {
        return sigma_along(seen, seen.steps.size() - 1);
    };
    EXPECT_GT(median(straight, at_end), 3.0 * median(all, at_end));
    // Trusted less, the wall holds the robot across less.
    const auto rough =
        runs(2, {.set = {"observation.var_rho=0.04", "observation.var_theta=0.00122"}});
    const auto sigma = [](const LessonSeen& seen) {
        return sigma_across(seen, on_the_way_back(seen));
    };
    EXPECT_GT(median(rough, sigma), 2.0 * median(all, sigma));
}

TEST_F(Lessons, ABareCorridorHasNoLengthAndOneWithRecessesHas) {
    const auto length_error = [&](const LessonSeen& seen) {
        const auto measured =
            measure_distances(seen.map, read_distances(lesson(3).folder / "length.distances"));
        EXPECT_TRUE(measured.front().slam_m) << measured.front().missing;
        return std::abs(measured.front().error_m().value_or(1.0));
    };
    const auto bare = runs(3);
    const auto recesses = runs(3, {.world = "recesses.toml"});
    EXPECT_GT(median(bare, length_error), 0.08);
    EXPECT_LT(median(recesses, length_error), 0.04);
    // What nothing observes: neither particles nor a better odometry alone tell it.
    EXPECT_GT(median(runs(3, {.set = {"filter.particles=1000"}}), length_error),
              2.0 * median(recesses, length_error));
    EXPECT_LT(
        median(runs(3, {.set = {"features.detect=lines"}, .world = "recesses.toml"}), length_error),
        0.05);
    const std::vector<std::string> better = {"odometry.noise=0.1"};
    const auto untold = runs(3, {.world_set = better});
    EXPECT_GT(median(untold, length_error),
              1.5 * median(runs(3, {.set = ratios("0.07"), .world_set = better}), length_error));
    // Across, the bare corridor holds the robot well.
    EXPECT_LT(median(bare,
                     [](const LessonSeen& seen) {
                         return std::abs(seen.steps.back().mean.y - seen.truth.back().y);
                     }),
              0.15);
    EXPECT_GT(median(bare, [](const LessonSeen& seen) { return seen.odometry_error_m.back(); }),
              1.0);
}

/// With the seed that comes with the lesson, as who opens it sees it.
TEST_F(Lessons, TheirOwnRunsShowWhatTheyTell) {
    const auto own = [&](int number, const Change& change = {}) {
        return run(lesson(number), std::nullopt, change);
    };
    const auto length = [&](const LessonSeen& seen) {
        const auto measured =
            measure_distances(seen.map, read_distances(lesson(3).folder / "length.distances"));
        return measured.front().error_m().value();
    };
    const LessonSeen bare = own(3);
    EXPECT_NEAR(length(bare), 0.11, 0.02);
    EXPECT_NEAR(length(own(3, {.world = "recesses.toml"})), 0.01, 0.02);
    EXPECT_GT(bare.odometry_error_m.back(), 1.0);
    const LessonSeen three = own(4, {.set = {"filter.particles=3"}});
    EXPECT_GT(three.lines, 10);
    EXPECT_GT(own(4).odometry_error_m.back(), 0.5);
    const std::vector<std::string> few = {"filter.particles=20"};
    const std::vector<std::string> sharp = {few.front(), "observation.var_rho=2.5e-5",
                                            "observation.var_theta=5e-6"};
    EXPECT_GT(own(6, {.set = sharp}).ate_m, 4.0 * own(6, {.set = few}).ate_m);
    std::vector<std::string> nameless = ratios("0.71");
    nameless.emplace_back("association.known=off");
    const std::vector<std::string> loud = {"odometry.noise=1"};
    const LessonSeen named = own(10, {.set = ratios("0.71"), .world_set = loud});
    const LessonSeen unnamed = own(10, {.set = nameless, .world_set = loud});
    EXPECT_EQ(named.corners, 8);
    EXPECT_GT(unnamed.corners, 10);
    EXPECT_GT(unnamed.ate_m, 3.0 * named.ate_m);
}

TEST_F(Lessons, ALoopThatIsClosedTakesTheErrorAway) {
    const auto closes = [](const LessonSeen& seen) {
        const auto at = std::ranges::find_if(
            seen.steps, [](const StepFigures& step) { return step.unseen_s > 30.0; });
        return static_cast<std::size_t>(at - seen.steps.begin());
    };
    const auto worst_before = [&](const LessonSeen& seen) {
        const auto begin = seen.position_error_m.begin();
        return *std::max_element(begin, begin + static_cast<std::ptrdiff_t>(closes(seen)));
    };
    const auto all = runs(4);
    for (const LessonSeen& seen : all) {
        EXPECT_NEAR(seen.steps[closes(seen)].time_s, 47.0, 0.5);
        EXPECT_LT(seen.position_error_m.back(), worst_before(seen) / 3.0);
        EXPECT_EQ(seen.lines, 8);
        EXPECT_EQ(seen.corners, 8);
    }
    EXPECT_GT(median(all, worst_before), 0.08);
    EXPECT_LT(median(all, [](const LessonSeen& seen) { return seen.position_error_m.back(); }),
              0.03);
    EXPECT_GT(median(all, [](const LessonSeen& seen) { return seen.odometry_error_m.back(); }),
              0.5);
    const auto three = runs(4, {.set = {"filter.particles=3"}});
    EXPECT_GE(count(three, [](const LessonSeen& seen) { return seen.lines + seen.corners > 16; }),
              5);
    EXPECT_GT(ate(three), 1.5 * ate(all));
}

TEST_F(Lessons, P0DecidesHowNearWallsMayBe) {
    const auto lines = [](int number) {
        return [=](const LessonSeen& seen) { return seen.lines == number; };
    };
    const auto confused = runs(5);
    EXPECT_EQ(count(confused, lines(5)), kSeeds);
    const auto right = runs(5, {.set = {"association.p0=1"}});
    EXPECT_GE(count(right, lines(7)), kSeeds - 2);
    EXPECT_GT(ate(confused), 1.5 * ate(right));
    const auto tiny = runs(5, {.set = {"association.p0=1e-30"}});
    EXPECT_EQ(
        count(tiny, [](const LessonSeen& seen) { return seen.lines == 5 && seen.corners == 6; }),
        kSeeds);
    const auto many = runs(5, {.set = {"association.p0=10"}});
    EXPECT_EQ(count(many, [](const LessonSeen& seen) { return seen.lines > 9; }), kSeeds);
    const auto endless = runs(5, {.set = {"association.p0=15"}}, 2);
    EXPECT_EQ(count(endless, [](const LessonSeen& seen) { return seen.lines > 1000; }), 2);
    const auto sharp =
        runs(5, {.set = {"observation.var_rho=0.0025", "observation.var_theta=0.0003"}});
    EXPECT_GE(count(sharp, lines(7)), kSeeds - 3);
    EXPECT_GT(ate(confused), 2.0 * ate(sharp));
}

TEST_F(Lessons, TooFewParticlesLoseTheLoopAndMoreThanEnoughGainNothing) {
    const auto of = [&](const char* particles) {
        return runs(6, {.set = {std::string("filter.particles=") + particles}});
    };
    const auto one = of("1");
    EXPECT_GE(count(one, [](const LessonSeen& seen) { return !better_than_odometry(seen); }), 6);
    EXPECT_EQ(count(one, [](const LessonSeen& seen) { return seen.lines > 12; }), kSeeds);
    const auto three = of("3");
    const auto ten = of("10");
    const auto hundred = of("100");
    const auto more = of("300");
    EXPECT_GT(ate(one), 2.0 * ate(three));
    EXPECT_GT(ate(three), 1.5 * ate(ten));
    EXPECT_GT(ate(ten), 1.2 * ate(hundred));
    EXPECT_NEAR(ate(more), ate(hundred), 0.25 * ate(hundred));
    const double shared = median(hundred, [](const LessonSeen& seen) {
        return static_cast<double>(seen.ancestry) / static_cast<double>(seen.steps.size());
    });
    EXPECT_NEAR(shared, 0.75, 0.1) << "of the tour, the past that all particles have in common";
}

TEST_F(Lessons, ALaserThatIsTrustedTooMuchDepletesTheParticles) {
    const std::vector<std::string> trusted = {"filter.particles=20", "observation.var_rho=2.5e-5",
                                              "observation.var_theta=5e-6"};
    const auto twenty = runs(6, {.set = {"filter.particles=20"}});
    const auto depleted = runs(6, {.set = trusted});
    auto posterior = trusted;
    posterior.emplace_back("filter.proposal=posterior");
    const auto drawn = runs(6, {.set = posterior});
    EXPECT_GT(neff(twenty), 15.0);
    EXPECT_LT(neff(depleted), 6.0);
    EXPECT_GT(neff(drawn), 15.0);
    EXPECT_GT(ate(depleted), 2.5 * ate(twenty));
    EXPECT_GT(ate(depleted), 2.0 * ate(drawn));
}

TEST_F(Lessons, MotionNoiseMustCoverWhatTheOdometryHasAndNeedsParticlesWhereItIsMore) {
    const auto right = runs(7);
    const auto small = runs(7, {.set = ratios("0.01")});
    EXPECT_GT(ate(small), 5.0 * ate(right));
    EXPECT_GT(ate(small), 0.6 * odometry_ate(small)) << "next to no better than the odometry";
    EXPECT_EQ(count(small, [](const LessonSeen& seen) { return seen.lines > 12; }), kSeeds);
    const auto large = runs(7, {.set = ratios("4")});
    EXPECT_GT(ate(large), 1.5 * ate(right));
    EXPECT_EQ(count(large, better_than_odometry), kSeeds);
    auto few = ratios("4");
    few.emplace_back("filter.particles=10");
    const auto lost = runs(7, {.set = few});
    EXPECT_GE(count(lost, [](const LessonSeen& seen) { return !better_than_odometry(seen); }),
              kSeeds - 1);
    EXPECT_LT(ate(runs(7, {.set = {"filter.particles=10"}})), 2.0 * ate(right));
}

TEST_F(Lessons, EkfIsTheBetterUntilItsGateMissesAWall) {
    const auto particles = runs(8);
    const auto ekf = runs(8, {.configuration = "ekf.cfg"});
    for (std::size_t i = 0; i < ekf.size(); ++i) {
        EXPECT_LT(ekf[i].ate_m, 0.5 * particles[i].ate_m);
        EXPECT_EQ(ekf[i].lines, 5);
        EXPECT_EQ(ekf[i].corners, 6);
    }
    // One tour, several seeds of the filter.
    const LessonSeen once = run(lesson(8), 1, {.configuration = "ekf.cfg"}, 1);
    EXPECT_EQ(map_to_text(run(lesson(8), 2, {.configuration = "ekf.cfg"}, 1).map),
              map_to_text(once.map));
    EXPECT_NE(map_to_text(run(lesson(8), 2, {}, 1).map), map_to_text(run(lesson(8), 1, {}, 1).map));
    const auto loud = ratios("0.21");
    const auto loud_particles = runs(8, {.set = loud, .world_set = {"odometry.noise=0.3"}});
    const auto loud_ekf =
        runs(8, {.set = loud, .world_set = {"odometry.noise=0.3"}, .configuration = "ekf.cfg"});
    EXPECT_GE(count(loud_ekf, [](const LessonSeen& seen) { return seen.lines > 6; }), kSeeds - 1);
    EXPECT_EQ(count(loud_particles, [](const LessonSeen& seen) { return seen.lines <= 6; }),
              kSeeds);
    const auto worst = [](const std::vector<LessonSeen>& all) {
        return std::ranges::max_element(all, {}, &LessonSeen::ate_m)->ate_m;
    };
    EXPECT_GT(worst(loud_ekf), 2.0 * worst(loud_particles));
    const auto told = runs(
        8, {.set = ratios("0.5"), .world_set = {"odometry.noise=0.3"}, .configuration = "ekf.cfg"});
    EXPECT_LT(ate(told), 0.3 * ate(loud_particles));
    EXPECT_GE(
        count(told, [](const LessonSeen& seen) { return seen.lines == 5 && seen.corners == 6; }),
        kSeeds - 4);
}

/// The loops of a run to its end, judged by the truth.
std::vector<RunLoop> loops_of(const Lesson& lesson, std::uint64_t tour_seed, const Change& change) {
    Configuracion configuration = ArchivoConfiguracion::read(lesson.configuration);
    ValueChoices choices{.assignments = change.set, .world_assignments = change.world_set};
    choices.tour_seed = tour_seed;
    choose_values(configuration, choices);
    Algoritmo run(configuration, open_tour(configuration), {.step_grid = false});
    while (run.step()) {
    }
    const Registration& registration = *run.registration();
    std::vector<RunLoop> loops =
        run_loops(registration.loops(), registration.refused_loops(), run.best_trajectory());
    judge_loops(loops, run.reader().truth().value().path, kSameStamp);
    return loops;
}

TEST_F(Lessons, AFalseLoopIsTakenOutAndTheTrueOneFound) {
    constexpr std::uint64_t kTours = 4;
    int falsely = 0;
    for (std::uint64_t tour = 1; tour <= kTours; ++tour)
        falsely += precision_of(loops_of(lesson(9), tour, {})).wrong > 0 ? 1 : 0;
    EXPECT_GE(falsely, 3);
    // The page's own tour, and the file of changes beside it.
    EXPECT_EQ(precision_of(loops_of(lesson(9), 0, {})).wrong, 1U);
    const std::string edits = ArchivoConfiguracion::read_edits(lesson(9).folder / "edits.toml");
    const LoopPrecision mended =
        precision_of(loops_of(lesson(9), 0, {.set = {"registration.edits=" + edits}}));
    EXPECT_EQ(mended.judged, 1U);
    EXPECT_EQ(mended.wrong, 0U);
    EXPECT_LT(mended.worst_m, 0.2);
    const LoopPrecision better = precision_of(loops_of(
        lesson(9), 0,
        {.set = {"registration.odometry_scale=0.2"}, .world_set = {"odometry.noise=0.2"}}));
    EXPECT_EQ(better.judged, 1U);
    EXPECT_EQ(better.wrong, 0U);
}

TEST_F(Lessons, NamesAreWorthMostWhereTheRobotKnowsLeastWhereItIs) {
    const auto worst = [](const std::vector<LessonSeen>& all) {
        return std::ranges::max(all, {}, &LessonSeen::ate_m).ate_m;
    };
    const auto right = [](const LessonSeen& seen) { return seen.corners == 8; };
    Change nameless{.set = {"association.known=off"}};
    Change loud{.set = ratios("0.71"), .world_set = {"odometry.noise=1"}};
    Change both = loud;
    both.set.emplace_back("association.known=off");
    const auto named = runs(10);
    EXPECT_EQ(count(named, right), kSeeds);
    EXPECT_LT(10.0 * ate(named), odometry_ate(named));
    const auto guessed = runs(10, nameless);
    EXPECT_GE(count(guessed, right), kSeeds - 4);
    EXPECT_LT(ate(guessed), 1.5 * ate(named));
    const auto loudly_named = runs(10, loud);
    EXPECT_EQ(count(loudly_named, right), kSeeds);
    EXPECT_LT(worst(loudly_named), 0.2);
    const auto loudly_guessed = runs(10, both);
    EXPECT_EQ(count(loudly_guessed, right), 0);
    EXPECT_GT(worst(loudly_guessed), 2.0 * worst(loudly_named));
    Change by_ekf = loud;
    by_ekf.set.emplace_back("filter.algorithm=ekf-slam");
    EXPECT_LT(ate(runs(10, by_ekf)), ate(loudly_named));
    Change few = loud;
    few.set.emplace_back("filter.particles=2");
    const auto two = runs(10, few);
    EXPECT_EQ(count(two, right), kSeeds);
    EXPECT_GT(ate(two), 3.0 * ate(loudly_named));
}

}  // namespace
}  // namespace hitos
