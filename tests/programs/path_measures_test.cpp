// SPDX-License-Identifier: GPL-3.0-or-later
// What hitos-cli says of paths: relations, relative errors, crispness; and that it agrees with evo.
#include <fmt/format.h>
#include <gmock/gmock.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <nlohmann/json.hpp>
#include <sstream>
#include <string>
#include <utility>
#include <vector>

#include "hitos/services/files/trajectory_file.hpp"
#include "program.hpp"

namespace hitos {
namespace {

using test::content;
using test::Outcome;
using test::shell;
using ::testing::HasSubstr;
using ::testing::Not;

using Figures = std::map<std::string, double>;

/// The lines of a name and a number.
Figures figures(const Outcome& outcome) {
    EXPECT_EQ(outcome.status, 0) << outcome.output;
    Figures found;
    std::istringstream lines(outcome.output);
    std::string name;
    double value = 0.0;
    while (lines >> name >> value) found[name] = value;
    return found;
}

class PathMeasures : public test::ProgramTest {
  protected:
    /// A winding way with a stop, and what a drifting robot makes of it, in another frame.
    void SetUp() override {
        Trajectory truth;
        Trajectory estimate;
        const Pose frame{3.0, -2.0, 0.7};
        for (int i = 0; i < 80; ++i) {
            const double s = i < 40 ? 0.23 * i : 0.23 * std::max(40, i - 6);
            const Pose pose{4.0 * std::sin(0.5 * s), s, 0.4 * std::cos(1.3 * s)};
            const Pose drift{0.03 * std::sin(2.1 * s) + 0.004 * s, 0.02 * std::cos(1.7 * s),
                             0.02 * std::sin(0.9 * s) - 0.003 * s};
            const double t = 1.7e9 + 0.25 * i;
            truth.push_back({t, pose});
            estimate.push_back({t, compose(frame, compose(pose, drift))});
        }
        write_trajectory(truth, truth_);
        write_trajectory(estimate, estimate_);
    }

    /// What we say of the two, by the names of evo_formulas.py.
    Figures ours() const {
        Figures ours;
        const auto take = [&ours](const Figures& all, const std::string& from,
                                  const std::string& to) {
            ours[to + "_pairs"] = all.at(from + "_pairs");
            for (const auto& [part, unit] :
                 {std::pair("_translation", "_m"), {"_rotation", "_rad"}}) {
                for (const char* figure : {"_rmse", "_mean", "_median", "_deviation", "_maximum"}) {
                    ours[to + part + figure] = all.at(from + part + figure + unit);
                }
            }
        };
        const Figures all = figures(shell(both_ + " --rpe-distance 1"));
        take(all, "rpe_distance", "all");
        take(figures(shell(both_ + " --rpe-distance 1 --rpe-consecutive")), "rpe_distance",
             "chain");
        for (const std::string figure : {"rmse", "mean", "maximum"}) {
            ours["ate_" + figure] = all.at("ate_" + figure + "_m");
        }
        return ours;
    }

    const std::string truth_ = path("truth.tum");
    const std::string estimate_ = path("estimate.tum");
    const std::string short_log_ = test::kSource + "/data/logs/normalized.log.gz";
    const std::string both_ =
        cli_ + " evaluate --trajectory " + estimate_ + " --reference-trajectory " + truth_;
};

TEST_F(PathMeasures, AreWhatTheFormulasOfEvoSaid) {
    const Figures all = ours();
    // evo_formulas.py said so of these files.
    const Figures golden{{"ate_rmse", 0.028918688},
                         {"ate_mean", 0.026937497},
                         {"ate_maximum", 0.047991204},
                         {"all_pairs", 56},
                         {"all_translation_rmse", 0.042921327},
                         {"all_translation_mean", 0.038321501},
                         {"all_translation_median", 0.031124587},
                         {"all_translation_deviation", 0.019331395},
                         {"all_translation_maximum", 0.087064382},
                         {"all_rotation_rmse", 0.009676435},
                         {"all_rotation_mean", 0.008027643},
                         {"all_rotation_median", 0.006350589},
                         {"all_rotation_deviation", 0.005402809},
                         {"all_rotation_maximum", 0.018840213},
                         {"chain_pairs", 21},
                         {"chain_translation_rmse", 0.054389656},
                         {"chain_translation_mean", 0.049342196},
                         {"chain_translation_median", 0.043344108},
                         {"chain_translation_deviation", 0.022881923},
                         {"chain_translation_maximum", 0.122387017},
                         {"chain_rotation_rmse", 0.009734879},
                         {"chain_rotation_mean", 0.007890966},
                         {"chain_rotation_median", 0.007081756},
                         {"chain_rotation_deviation", 0.005700923},
                         {"chain_rotation_maximum", 0.023044496}};
    for (const auto& [name, value] : golden) EXPECT_NEAR(all.at(name), value, 1e-6) << name;
}

TEST_F(PathMeasures, AreWhatTheFormulasOfEvoSay) {
    const std::string python = HITOS_PYTHON_PROGRAM;
    if (shell(python + " -c 'import numpy'").status != 0) {
        GTEST_SKIP() << python << " has no numpy";
    }
    const Figures now =
        figures(shell(python + " " + test::kSource + "/tests/programs/evo_formulas.py " +
                      estimate_ + " " + truth_ + " 1"));
    for (const auto& [name, value] : ours()) EXPECT_NEAR(now.at(name), value, 1e-6) << name;
}

TEST_F(PathMeasures, RelationsOfAPathAreZeroOnItInAnyFrame) {
    for (const std::string how :
         {"", "--distance 2.5", "--time 1", "--time 1 --consecutive", "--distance 1 --slack 0.4"}) {
        const std::string relations = path("truth.relations");
        std::string make = cli_;
        make.append(" relations ").append(truth_).append(" --out ").append(relations);
        const Outcome made = shell(make.append(" ").append(how));
        ASSERT_EQ(made.status, 0) << made.output;
        EXPECT_THAT(made.output, HasSubstr(" relations of 80 poses in "));
        const std::string by = " --relations " + relations;
        const Figures same = figures(shell(cli_ + " evaluate --trajectory " + truth_ + by));
        EXPECT_GT(same.at("relations"), 10.0) << how;
        EXPECT_EQ(same.at("relations_used"), same.at("relations"));
        EXPECT_EQ(same.at("relation_translation_maximum_m"), 0.0) << how;
        EXPECT_EQ(same.at("relation_rotation_maximum_deg"), 0.0) << how;
        const Figures off = figures(shell(cli_ + " evaluate --trajectory " + estimate_ + by));
        EXPECT_GT(off.at("relation_translation_mean_m"), 1e-3) << how;
        EXPECT_NEAR(off.at("relation_translation_squared_mean_m2"),
                    std::pow(off.at("relation_translation_rmse_m"), 2), 1e-8);
    }
}

TEST_F(PathMeasures, TellEachRelationAndWhyOneIsNotUsed) {
    const std::string estimate =
        file("e.tum", "1 0 0 0 0 0 0 1\n2 1 0 0 0 0 0 1\n3 2 0 0 0 0 0.70710678 0.70710678\n");
    const std::string relations =
        file("r.relations",
             "# made by hand\n1 2 1.3 0.4 0 0 0 0\n\n2 3 1 0 0 0 0 0 # turned\n"
             "0 2 0 0 0 0 0 0\n2 9 0 0 0 0 0 0\n8 9 0 0 0 0 0 0\n");
    const std::string evaluate =
        cli_ + " evaluate --trajectory " + estimate + " --relations " + relations;
    const Figures told = figures(shell(evaluate + " --out " + path("out")));
    EXPECT_EQ(told.at("relations"), 5.0);
    EXPECT_EQ(told.at("relations_used"), 2.0);
    EXPECT_EQ(told.at("relations_without_pose_at_t1"), 1.0);
    EXPECT_EQ(told.at("relations_without_pose_at_t2"), 1.0);
    EXPECT_EQ(told.at("relations_without_both_poses"), 1.0);
    EXPECT_NEAR(told.at("relation_translation_mean_m"), 0.25, 1e-9);
    EXPECT_NEAR(told.at("relation_translation_deviation_m"), 0.25, 1e-9);
    EXPECT_NEAR(told.at("relation_translation_maximum_m"), 0.5, 1e-9);
    EXPECT_NEAR(told.at("relation_rotation_mean_deg"), 45.0, 1e-6);
    EXPECT_NEAR(told.at("relation_rotation_maximum_rad"), kPi / 2.0, 1e-8);
    const std::string csv = content(path("out/relations.csv"));
    EXPECT_THAT(csv, HasSubstr("\n1,2,1.300000000,0.400000000,0.000000000,1.000000000,"
                               "0.000000000,0.000000000,0.500000000,0.000000000,\n"));
    EXPECT_THAT(csv, HasSubstr("\n2,9,0.000000000,0.000000000,0.000000000,,,,,,no pose at t2\n"));
    EXPECT_EQ(std::count(csv.begin(), csv.end(), '\n'), 6);
    // Within the tolerance that is stated, the pose at 1 s stands for 0 s.
    EXPECT_EQ(figures(shell(evaluate + " --tolerance 1")).at("relations_used"), 3.0);
}

TEST_F(PathMeasures, AMapBesideExactOdometryIsNotDoubted) {
    const auto said = [this](const std::string& more) {
        return shell(cli_ + " run corridor --replace --out " + path("run") + " " + more).output;
    };
    // No map is crisper than that of odometry without noise; this one is right to 8 cm.
    EXPECT_THAT(said("--world-set odometry.noise=0"), Not(HasSubstr("do not trust it")));
    // One that is blurred by its own path is.
    EXPECT_THAT(said("--preset thesis --set filter.particles=3 --set motion.sigma_x=0.3 --set "
                     "motion.sigma_y=0.3"),
                HasSubstr("do not trust it"));
    // By headings alone too.
    EXPECT_THAT(said("--preset thesis --set filter.particles=5 --set motion.sigma_theta=0.1"),
                HasSubstr("do not trust it"));
}

TEST_F(PathMeasures, OfAFinishedRunNeedNoTruth) {
    const std::string run = path("run");
    ASSERT_EQ(shell(cli_ + " run " + log_ + " --config " + config_ +
                    " --set filter.particles=5 --out " + run)
                  .status,
              0);
    const Figures told = figures(shell(cli_ + " evaluate " + run));
    const std::string summary = content(run + "/summary.json");
    const auto in_summary = [&summary](const std::string& key) {
        const std::string mark = '"' + key + "\": ";
        return std::stod(summary.substr(summary.find(mark) + mark.size()));
    };
    EXPECT_NEAR(told.at("cells_per_point"), in_summary("cells_per_point"), 1e-5);
    EXPECT_NEAR(told.at("odometry_cells_per_point"), in_summary("odometry_cells_per_point"), 1e-5);
    EXPECT_GT(told.at("grid_blur_m2"), 0.0);
    EXPECT_NEAR(told.at("grid_entropy_bits"), told.at("grid_blur_m2") / (0.05 * 0.05), 1.0);
    // Its own map and path are taken where no others are named.
    const Figures own =
        figures(shell(cli_ + " evaluate " + run + " --reference " + run +
                      "/map.txt --reference-trajectory " + run + "/trajectory.tum --rpe-time 2"));
    EXPECT_EQ(own.at("map_error_m"), 0.0);
    EXPECT_EQ(own.at("ate_rmse_m"), 0.0);
    EXPECT_EQ(own.at("rpe_time_translation_maximum_m"), 0.0);
    EXPECT_THAT(shell(cli_ + " evaluate " + path("none")).output, HasSubstr("none"));
}

TEST_F(PathMeasures, RefuseNumbersThatAreNone) {
    for (const char* wrong : {"--rpe-distance nan", "--rpe-distance 0", "--rpe-time inf",
                              "--tolerance -1", "--rpe-slack x --rpe-time 1"}) {
        const Outcome outcome = shell(both_ + " " + wrong);
        EXPECT_EQ(outcome.status, 64) << wrong;
        EXPECT_THAT(outcome.output, HasSubstr(", expected a number")) << wrong;
    }
}

TEST_F(PathMeasures, RefuseOptionsOfWhatIsNotMeasured) {
    for (const char* wrong : {"--rpe-consecutive", "--rpe-slack 0.2"}) {
        const Outcome outcome = shell(both_ + " " + wrong);
        EXPECT_EQ(outcome.status, 1) << wrong;
        EXPECT_THAT(outcome.output, HasSubstr("are of the pairs of --rpe-distance and --rpe-time"))
            << wrong;
    }
    const Outcome outcome =
        shell(cli_ + " evaluate --map " + map_ + " --reference " + map_ + " --tolerance 1");
    EXPECT_EQ(outcome.status, 1);
    EXPECT_THAT(outcome.output, HasSubstr("--tolerance is of the stamps of "));
}

TEST_F(PathMeasures, AndComparisonsNeverTakeThePlaceOfAnInput) {
    const std::string relations = path("relations.csv");
    ASSERT_EQ(shell(fmt::format("{} relations {} --out {}", cli_, truth_, relations)).status, 0);
    const std::string before = content(relations);
    const Outcome outcome = shell(fmt::format("{} evaluate --trajectory {} --relations {} --out {}",
                                              cli_, estimate_, relations, path(".")));
    EXPECT_EQ(outcome.status, 1);
    EXPECT_THAT(outcome.output, HasSubstr("relations.csv"));
    EXPECT_EQ(content(relations), before);
    const std::string run = path("run");
    ASSERT_EQ(shell(cli_ + " run " + log_ + " --config " + config_ +
                    " --set filter.particles=5 --out " + run)
                  .status,
              0);
    const Outcome comparison =
        shell(fmt::format("{} compare {} --out {}/summary.json", cli_, run, run));
    EXPECT_EQ(comparison.status, 1);
    EXPECT_THAT(comparison.output, HasSubstr("summary.json"));
    EXPECT_EQ(shell(fmt::format("{} verify {}", cli_, run)).status, 0);
}

TEST_F(PathMeasures, RefuseWhatCannotBeMeasured) {
    const auto error = [](const std::string& command) {
        const Outcome outcome = shell(command);
        EXPECT_NE(outcome.status, 0) << outcome.output;
        return outcome.output;
    };
    const std::string evaluate = cli_ + " evaluate --trajectory " + estimate_;
    EXPECT_THAT(error(evaluate), HasSubstr("--relations"));
    EXPECT_THAT(error(evaluate + " --rpe-time 1"), HasSubstr("need --reference-trajectory"));
    EXPECT_THAT(error(cli_ + " evaluate --relations " + truth_), HasSubstr("need --trajectory"));
    EXPECT_THAT(error(both_ + " --rpe-distance 0"), HasSubstr("--rpe-distance"));
    EXPECT_THAT(error(both_ + " --rpe-distance 5000"), HasSubstr("5000 m of way apart"));
    EXPECT_THAT(error(both_ + " --rpe-time nan"), HasSubstr("--rpe-time"));
    const std::string bad = file("bad.relations", "1 2 0 0 0 0 0 0\n1 2 0 0 zero 0 0 0\n");
    EXPECT_THAT(error(evaluate + " --relations " + bad), HasSubstr("bad.relations:2: "));
    const std::string early = file("early.relations", "1 2 0 0 0 0 0 0\n");
    EXPECT_THAT(error(evaluate + " --relations " + early), HasSubstr("are the clocks the same?"));
    const std::string one = file("one.tum", "1 0 0 0 0 0 0 1\n");
    EXPECT_THAT(error(cli_ + " relations " + one + " --out " + path("r")),
                HasSubstr("no two poses"));
    EXPECT_FALSE(test::fs::exists(path("r")));
    EXPECT_THAT(error(cli_ + " relations " + one + " --out " + one),
                Not(HasSubstr("relations of")));
    EXPECT_THAT(error(cli_ + " relations " + truth_ + " --time 1 --distance 1 --out " + path("r")),
                HasSubstr("--distance"));
}

/// The poses at every n-th stamp.
Trajectory thinned(const Trajectory& all, std::size_t n) {
    Trajectory some;
    for (std::size_t i = 0; i < all.size(); i += n) some.push_back(all[i]);
    return some;
}

TEST_F(PathMeasures, OfARunAreThoseOfEvaluateWhateverTheRateOfTheReference) {
    const std::string run = cli_ + " run " + short_log_ + " --out " + path("run");
    ASSERT_EQ(shell(run).status, 0);
    const Trajectory own = read_trajectory(path("run/trajectory.tum"));
    ASSERT_GT(own.size(), 40U);
    const double step_s =
        (own.back().time_s - own.front().time_s) / static_cast<double>(own.size() - 1);
    const auto every = static_cast<std::size_t>(0.45 / step_s);  // dense enough to interpolate
    ASSERT_GE(every, 2U);
    const std::string reference = path("reference.tum");
    const std::string measured = " --reference-trajectory " + reference;
    const auto compared = [&](const std::string& more) {
        const Outcome said = shell(run + measured + more);
        EXPECT_EQ(said.status, 0) << said.output;
        const Figures by_evaluate =
            figures(shell(cli_ + " evaluate " + path("run") + measured + more));
        const auto summary = nlohmann::json::parse(content(path("run/summary.json")));
        EXPECT_NEAR(summary.at("/trajectory_error/ate_rmse_m"_json_pointer).get<double>(),
                    by_evaluate.at("ate_rmse_m"), 1e-5);
        EXPECT_EQ(summary.at("/trajectory_error/poses"_json_pointer).get<double>(),
                  by_evaluate.at("poses"));
        return static_cast<std::size_t>(by_evaluate.at("poses"));
    };
    write_trajectory(thinned(own, every), reference);
    const std::size_t last = (own.size() - 1) / every * every;
    EXPECT_EQ(compared(""), last + 1);
    // One every few seconds is too slow to drive straight on between, unless the user says so.
    const auto slow = static_cast<std::size_t>(3.0 / step_s);
    write_trajectory(thinned(own, slow), reference);
    EXPECT_EQ(compared(""), (own.size() - 1) / slow + 1);
    EXPECT_EQ(compared(" --tolerance 2"), (own.size() - 1) / slow * slow + 1);
    // Of another clock there is none, and the option is named.
    write_trajectory({{1e6, {}}, {1e6 + 1.0, {}}}, reference);
    const Outcome refused = shell(run + measured);
    EXPECT_EQ(refused.status, 1);
    EXPECT_THAT(refused.output, HasSubstr("--tolerance"));
    EXPECT_THAT(shell(cli_ + " evaluate " + path("run") + measured).output,
                HasSubstr("--tolerance"));
}

TEST_F(PathMeasures, TellOfAReferenceThatIsNotOneOfTheRun) {
    const std::string run = cli_ + " run " + short_log_ + " --out " + path("run");
    ASSERT_EQ(shell(run).status, 0);
    const Trajectory own = read_trajectory(path("run/trajectory.tum"));
    const std::string part = path("part.map");  // whatever its name
    write_trajectory(Trajectory(own.begin(), own.begin() + 20), part);
    const Outcome doubted = shell(run + " --reference " + part);
    EXPECT_EQ(doubted.status, 0) << doubted.output;
    EXPECT_THAT(doubted.output, HasSubstr("part.map is the reference trajectory"));
    EXPECT_THAT(doubted.output, HasSubstr("warning: The reference trajectory tells of less than"));
    EXPECT_THAT(shell(cli_ + " compare " + path("run")).output,
                HasSubstr("| poses compared | 20 |"));
    EXPECT_THAT(shell(cli_ + " evaluate " + path("run") + " --reference " + part).output,
                HasSubstr("(20/50)"));
    Trajectory later = own;
    for (StampedPose& pose : later) pose.time_s += 7200.0;
    const std::string other = path("other.tum");
    write_trajectory(later, other);
    for (const std::string& command :
         {run + "2", cli_ + " study " + short_log_ + " --vary p=3 --out " + path("study"),
          cli_ + " evaluate " + path("run")}) {
        const Outcome refused = shell(fmt::format("{} --reference-trajectory {}", command, other));
        EXPECT_EQ(refused.status, 1) << command;
        EXPECT_THAT(refused.output, HasSubstr("is not one of this tour: 0 of 50 poses")) << command;
    }
    EXPECT_FALSE(test::fs::exists(path("run2")));
    // A map of another place.
    const std::string map = file("far.tum", "x: 900 y: 900\nrho: 900 theta: 10\n");
    EXPECT_THAT(shell(run + " --reference-trajectory " + map).output,
                HasSubstr("lie within a metre of one of the reference map (0/"));
}

TEST_F(PathMeasures, ScansKeepTheirStampsWhateverIsAddedToTheirTimes) {
    const auto stamps = [&](const std::string& more) {
        EXPECT_EQ(
            shell(cli_ + " run " + short_log_ + " --replace --out " + path("run") + more).status,
            0);
        std::vector<double> all;
        for (const char* name : {"trajectory", "trajectory_online", "odometry"}) {
            for (const StampedPose& pose :
                 read_trajectory(path("run/" + std::string(name) + ".tum")))
                all.push_back(pose.time_s);
        }
        return all;
    };
    const std::vector<double> as_logged = stamps("");
    EXPECT_THAT(stamps(" --scan-delay 0.37"),
                ::testing::Pointwise(::testing::DoubleNear(1e-6), as_logged));
    // The log is found again by these stamps.
    EXPECT_EQ(shell(cli_ + " evaluate " + path("run")).status, 0);
}

}  // namespace
}  // namespace hitos
