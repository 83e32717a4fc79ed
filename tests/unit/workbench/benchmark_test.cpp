// SPDX-License-Identifier: GPL-3.0-or-later
// Plans of benchmarks, and what is made of them.
#include "hitos/workbench/benchmark.hpp"

#include <fmt/format.h>
#include <gmock/gmock.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <random>

#include "hitos/base/error.hpp"
#include "hitos/workbench/shipped_data.hpp"
#include "support.hpp"

namespace hitos {
namespace {

using test::content;
using test::message_of;
using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsSupersetOf;
using HowChanged = BenchmarkChange::Verdict;

constexpr const char* kSmall = R"(title = "Small <and> quick"
runs = 2
[[tour]]
file = "recinto"
map = ")" HITOS_SOURCE_DIR R"(/data/maps/recinto.map"
set = ["source.world_set=laser.rate=0.5"]
[[algorithm]]
name = "FastSLAM"
set = ["filter.particles=10"]
[[algorithm]]
name = "EKF"
preset = "ekf"
)";

class BenchmarkTest : public ::testing::Test {
  protected:
    BenchmarkPlan plan(const std::string& text) const {
        return read_benchmark_plan(folder_.put("plan.toml", text));
    }
    std::string refusal(const std::string& text) const {
        return message_of<FormatError>([&] { plan(text); });
    }
    BenchmarkTable run(const BenchmarkPlan& plan, const char* out, int threads = 2) const {
        BenchmarkOptions options;
        options.out = folder_ / out;
        options.threads = threads;
        options.pictures = false;
        return run_benchmark(plan, options);
    }
    test::TempFolder folder_;
};

TEST_F(BenchmarkTest, ReadsAPlan) {
    folder_.put("near.log", "");
    const BenchmarkPlan read = plan(
        "[[tour]]\nfile = \"near.log\"\nnoise = 1\ndigest = \"x\"\naddress = \"https://a.b\"\n"
        "[[tour]]\nname = \"far\"\nfile = \"away/tour.log.gz\"\ntrajectory = \"/abs.tum\"\n"
        "relations = \"far.relations\"\n"
        "[[algorithm]]\nname = \"one\"\nset = [\"filter.particles=5\"]\n"
        "[[algorithm]]\nname = \"two\"\nconfig = \"my.cfg\"\n"
        "[[peer]]\nname = \"other\"\ntour = \"far\"\ntrajectory = \"other.tum\"\n");
    EXPECT_EQ(read.title, "plan");
    EXPECT_EQ(read.runs, 5);
    ASSERT_EQ(read.tours.size(), 2U);
    EXPECT_EQ(read.tours[0].name, "near");
    EXPECT_EQ(read.tours[0].file, (folder_ / "near.log").string());
    EXPECT_EQ(read.tours[0].noise, 1.0);
    EXPECT_EQ(read.tours[1].name, "far");
    EXPECT_EQ(read.tours[1].trajectory, "/abs.tum");
    EXPECT_EQ(read.tours[1].relations, (folder_ / "far.relations").string());
    ASSERT_EQ(read.algorithms.size(), 2U);
    EXPECT_EQ(read.algorithms[0].preset, "auto");
    EXPECT_EQ(read.algorithms[1].config, (folder_ / "my.cfg").string());
    ASSERT_EQ(read.peers.size(), 1U);
}

TEST_F(BenchmarkTest, LooksForFilesInTheUsersFolderFirst) {
    const test::TempFolder tours;
    tours.put("a.log", "");
    folder_.put("a.log", "");
    folder_.put("b.log", "");
    const auto path = folder_.put("plan.toml",
                                  "[[tour]]\nfile = \"a.log\"\n[[tour]]\nfile = \"b.log\"\n"
                                  "[[tour]]\nfile = \"c.log\"\n[[algorithm]]\nname = \"x\"\n");
    const BenchmarkPlan read = read_benchmark_plan(path, tours.path());
    EXPECT_EQ(read.tours[0].file, (tours / "a.log").string());
    EXPECT_EQ(read.tours[1].file, (folder_ / "b.log").string());
    EXPECT_EQ(read.tours[2].file, (tours / "c.log").string()) << "where it would belong";
}

TEST_F(BenchmarkTest, RefusesWhatIsNoPlan) {
    const std::string tour = "[[tour]]\nfile = \"recinto\"\n";
    const std::string algorithm = "[[algorithm]]\nname = \"x\"\n";
    EXPECT_THAT(refusal(algorithm), HasSubstr("one [[tour]] at least"));
    EXPECT_THAT(refusal(tour), HasSubstr("one [[algorithm]] at least"));
    EXPECT_THAT(refusal(tour + tour + algorithm), HasSubstr(":3: tour: expected a name that "
                                                            "no other has; found \"recinto\""));
    EXPECT_THAT(refusal(tour + algorithm + "preset = \"best\"\n"),
                HasSubstr(":5: preset: expected auto or one of simulated"));
    EXPECT_THAT(refusal(tour + "noise = -1\n" + algorithm), HasSubstr("noise: expected a level"));
    EXPECT_THAT(refusal(tour + "noise = nan\n" + algorithm), HasSubstr("noise: expected a level"));
    EXPECT_THAT(refusal(tour + "noise_kind = \"loud\"\n" + algorithm),
                HasSubstr("noise_kind: expected relative-sigma"));
    EXPECT_THAT(refusal(tour + "colour = 1\n" + algorithm), HasSubstr(":3: no such key"));
    EXPECT_THAT(refusal("runs = 0\n" + tour + algorithm),
                HasSubstr("runs: expected a whole number from 1 to"));
    EXPECT_THAT(refusal("speed = 1\n" + tour + algorithm), HasSubstr("no such key"));
    EXPECT_THAT(refusal("tour = 1\n" + algorithm), HasSubstr("tables, each beginning with"));
    EXPECT_THAT(refusal(tour + algorithm +
                        "[[peer]]\nname = \"p\"\ntour = \"q\"\n"
                        "trajectory = \"t\"\n"),
                HasSubstr("the name of a tour; found \"q\""));
    EXPECT_THAT(
        refusal(tour + algorithm + "[[tours]]\nfile = \"x\"\n"),
        HasSubstr(":5: no such key; expected one of algorithm, first_seed, peer, runs, title, "
                  "tour"));
    EXPECT_THAT(refusal("runs = \"five\"\n" + tour + algorithm), HasSubstr(":1: runs: expected"));
    EXPECT_THAT(refusal("runs = \n"), HasSubstr(":1: "));
}

TEST_F(BenchmarkTest, KnowsThePlansThatComeWithHitos) {
    EXPECT_THAT(shipped_benchmarks(), IsSupersetOf({"recorded", "worlds"}));
    for (const std::string& name : shipped_benchmarks())
        EXPECT_FALSE(read_benchmark_plan(find_benchmark(name)).tours.empty()) << name;
    const auto tours = [](const char* name) {
        return read_benchmark_plan(find_benchmark(name)).tours;
    };
    const std::vector<BenchmarkTour> all = tours("all-worlds");
    for (const std::string& world : shipped_worlds())
        EXPECT_EQ(std::ranges::count(all, world, &BenchmarkTour::name), 1) << world;
    for (const BenchmarkTour& tour : all) {
        EXPECT_TRUE(tour.map.empty() || std::filesystem::exists(tour.map)) << tour.map;
    }
    EXPECT_THAT(message_of<FileError>([] { find_benchmark("nothing"); }), HasSubstr("worlds"));
}

// Figures and hashes do not depend on threads, stops or what is done already.
TEST_F(BenchmarkTest, RepeatsItselfToTheLastBit) {
    const BenchmarkPlan small = plan(kSmall);
    const BenchmarkTable one = run(small, "one", 1);
    const BenchmarkTable two = run(small, "two", 2);
    const BenchmarkTable again = run(small, "one", 2);
    ASSERT_EQ(one.rows.size(), 2U);
    for (std::size_t i = 0; i < one.rows.size(); ++i) {
        const BenchmarkRow& row = one.rows[i];
        SCOPED_TRACE(row.algorithm + " " + row.problem);
        EXPECT_EQ(row.runs, 2);
        EXPECT_EQ(row.failed, 0);
        EXPECT_FALSE(row.hash.empty());
        EXPECT_EQ(row.hash, two.rows[i].hash);
        EXPECT_EQ(row.hash, again.rows[i].hash);
        EXPECT_EQ(row.reference_landmarks, 8);
        EXPECT_TRUE(row.figures["error_m"]);
        EXPECT_TRUE(row.figures["trajectory_error_m"]) << "a world knows its truth";
        ASSERT_TRUE(row.figures["pose_in_95"]);
        EXPECT_LE(row.figures["pose_in_50"]->mean, row.figures["pose_in_95"]->mean);
    }
    EXPECT_NE(one.rows[0].hash, one.rows[1].hash);
}

TEST_F(BenchmarkTest, MeasuresTheWayAndLoops) {
    BenchmarkPlan small = plan(kSmall);
    small.tours[0].settings = {"source.world_set=laser.rate=1 tour.laps=2"};
    small.algorithms[1] = {"graph", "simulated", "", {"filter.algorithm=graph-slam"}};
    const BenchmarkTable table = run(small, "out");
    ASSERT_EQ(table.rows.size(), 2U);
    const auto mean = [&](std::size_t row, const char* word) {
        const std::optional<Spread>& spread = table.rows[row].figures[word];
        return spread ? std::optional(spread->mean) : std::nullopt;
    };
    EXPECT_EQ(mean(0, "loops_closed"), std::nullopt) << "it has no registration";
    EXPECT_GE(mean(1, "loops_closed"), 1.0);
    EXPECT_EQ(mean(1, "loops_false"), 0.0);
    for (const std::size_t row : {0U, 1U}) {
        // Of errors that grow with the way one is the error of many that are shorter.
        EXPECT_GT(mean(row, "rpe_10m_m"), mean(row, "rpe_1m_m")) << row;
        EXPECT_GT(mean(row, "rpe_1m_m"), 0.0) << row;
        EXPECT_EQ(mean(row, "distance_in_95").has_value(), row == 0) << row;
    }
}

TEST_F(BenchmarkTest, ABrokenTourIsARowAndNotTheEnd) {
    const BenchmarkTable table =
        run(plan(std::string(kSmall) + "[[tour]]\nname = \"gone\"\nfile = \"gone.log\"\n"
                                       "address = \"https://example.org/gone.log\"\n"
                                       "[[tour]]\nname = \"other\"\nfile = \"plan.toml\"\n"
                                       "digest = \"0123\"\n"
                                       "[[peer]]\nname = \"peer\"\ntour = \"recinto\"\n"
                                       "trajectory = \"none.tum\"\n"),
            "out");
    ASSERT_EQ(table.rows.size(), 7U);
    EXPECT_EQ(table.rows[0].runs, 2);
    EXPECT_EQ(table.rows[2].algorithm, "peer");
    EXPECT_EQ(table.rows[2].failed, 1);
    EXPECT_THAT(table.rows[3].problem, HasSubstr("it can be had from https://example.org"));
    EXPECT_EQ(table.rows[3].failed, 2);
    EXPECT_THAT(table.rows[5].problem, HasSubstr("is another file than the plan means"));
    EXPECT_TRUE(table.rows[5].hash.empty());
}

TEST_F(BenchmarkTest, MeasuresPeersAsItMeasuresRuns) {
    std::string truth;
    std::string path;
    for (int k = 0; k < 20; ++k) {
        truth += fmt::format("{} {} 0 0 0 0 0 1\n", k, 0.1 * k * k);
        path += fmt::format("{} {} {} 0 0 0 0 1\n", k, 0.1 * k * k, k % 2 == 0 ? 0.1 : -0.1);
    }
    folder_.put("truth.tum", truth);
    folder_.put("peer.tum", path);
    BenchmarkPlan small = plan(std::string(kSmall) +
                               "[[peer]]\nname = \"peer\"\ntour = \"recinto\"\n"
                               "trajectory = \"peer.tum\"\n");
    small.algorithms.clear();
    small.tours[0].trajectory = (folder_ / "truth.tum").string();
    const BenchmarkTable table = run(small, "out");
    ASSERT_EQ(table.rows.size(), 1U);
    ASSERT_TRUE(table.rows[0].figures["trajectory_error_m"]) << table.rows[0].problem;
    EXPECT_NEAR(table.rows[0].figures["trajectory_error_m"]->mean, 0.1, 0.002);
}

// The first thing that somebody tries whose tours lie elsewhere.
TEST_F(BenchmarkTest, OfToursThatAreAllBrokenThereIsATableToo) {
    const BenchmarkTable table = run(plan("[[tour]]\nfile = \"a.log\"\n[[tour]]\nfile = \"b.log\"\n"
                                          "[[algorithm]]\nname = \"x\"\n"),
                                     "new");
    write_benchmark(table, folder_ / "new");
    EXPECT_EQ(read_benchmark(folder_ / "new").rows.size(), 2U);
    EXPECT_THAT(content(folder_ / "new/benchmark.md"), HasSubstr("a.log"));
}

TEST_F(BenchmarkTest, NoNameLeadsOutOfItsFolder) {
    std::string text = kSmall;
    text.replace(text.find("file ="), 0, "name = \"..\"\n");
    text.replace(text.find("\"EKF\""), 5, "\"..\"");
    const test::TempFolder around;
    BenchmarkOptions options;
    options.out = around / "out";
    options.pictures = false;
    const BenchmarkTable table = run_benchmark(plan(text), options);
    EXPECT_EQ(table.rows.at(1).runs, 2) << table.rows.at(1).problem;
    EXPECT_EQ(around.files(), 1U);
    std::size_t inside = 0;
    for (const auto& entry : std::filesystem::directory_iterator(around / "out")) {
        EXPECT_EQ(entry.path().filename(), "runs");
        ++inside;
    }
    EXPECT_EQ(inside, 1U);
}

// The first scans have no odometry before them: left out, the rest is still set against its own
// poses.
TEST_F(BenchmarkTest, TruthIsPairedByStamps) {
    const std::string tour = std::string(kSmall).substr(0, std::string(kSmall).find("set ="));
    const BenchmarkTable table =
        run(plan(tour + "[[algorithm]]\nname = \"kept\"\npreset = \"ekf\"\nset = "
                        "[\"source.scan_delay=-1\"]\n"
                        "[[algorithm]]\nname = \"left out\"\npreset = \"ekf\"\nset = "
                        "[\"source.scan_delay=-1\", \"source.early_scans=leave_out\"]\n"),
            "out");
    const auto nees = [&](std::size_t row) { return table.rows.at(row).figures["pose_nees"]; };
    ASSERT_TRUE(nees(0) && nees(1)) << table.rows[0].problem << table.rows[1].problem;
    EXPECT_LT(std::abs(std::log(nees(1)->mean / nees(0)->mean)), 0.7);
}

TEST_F(BenchmarkTest, PeersAreHeldToWhatRunsAreHeldTo) {
    std::string truth;
    for (int k = 0; k < 40; ++k) truth += fmt::format("{} {} 0 0 0 0 0 1\n", k, 0.1 * k);
    folder_.put("truth.tum", truth);
    folder_.put("short.tum", truth.substr(0, 50));
    BenchmarkPlan small = plan(std::string(kSmall) +
                               "[[peer]]\nname = \"peer\"\ntour = \"recinto\"\n"
                               "trajectory = \"truth.tum\"\n");
    small.algorithms.clear();
    small.tours[0].trajectory = (folder_ / "truth.tum").string();
    const std::string hash = run(small, "out").rows.at(0).hash;
    folder_.put("other.tum", truth + "40 9 9 0 0 0 0 1\n");
    small.tours[0].trajectory = (folder_ / "other.tum").string();
    EXPECT_NE(run(small, "out").rows.at(0).hash, hash) << "another figure";
    small.peers[0].trajectory = (folder_ / "short.tum").string();
    const BenchmarkRow few = run(small, "out").rows.at(0);
    EXPECT_EQ(few.failed, 1);
    EXPECT_FALSE(few.problem.empty());
    const std::string peer = "[[peer]]\nname = \"EKF\"\ntour = \"recinto\"\ntrajectory = \"t\"\n";
    EXPECT_THAT(refusal(kSmall + peer), HasSubstr("a name that no other row of the tour has"));
}

TEST_F(BenchmarkTest, WritesWhatItReads) {
    BenchmarkTable table = run(plan(kSmall), "out");
    table.rows[1].problem = "1 < 2 & \"3\"";
    table.rows[1].failed = 1;
    table.rows[1].remark = "as found";
    table.rows[1].setting = "slow";
    table.rows[1].state_bytes = 7.0;
    write_benchmark(table, folder_ / "out");
    const BenchmarkTable read = read_benchmark(folder_ / "out");
    EXPECT_EQ(benchmark_json(read), benchmark_json(table));
    EXPECT_EQ(read.rows[0].figures["error_m"]->variance,
              table.rows[0].figures["error_m"]->variance);
    const std::string html = content(folder_ / "out/benchmark.html");
    EXPECT_THAT(html, HasSubstr("<h1>Small &lt;and&gt; quick</h1>"));
    EXPECT_THAT(html, HasSubstr("1 &lt; 2 &amp; &quot;3&quot;"));
    EXPECT_THAT(html, HasSubstr("</td></tr>\n<tr><td>"));
    EXPECT_THAT(content(folder_ / "out/benchmark.md"), HasSubstr("| recinto | FastSLAM |"));
    EXPECT_THAT(content(folder_ / "out/benchmark.csv"), HasSubstr("pose_in_68"));
    EXPECT_THAT(content(folder_ / "out/benchmark.tex"), HasSubstr("tabular"));
    // Of two runs: chi-square quantiles of six, four and two degrees of freedom.
    EXPECT_THAT(content(folder_ / "out/benchmark.csv"),
                HasSubstr(",pose_nees_low,pose_nees_high,"));
    EXPECT_THAT(content(folder_ / "out/benchmark.csv"), HasSubstr(",0.618672,7.224688,0.242209,"));
    EXPECT_THAT(content(folder_ / "out/benchmark.md"), HasSubstr("| EKF | landmarks | 2 |"));
    EXPECT_THAT(content(folder_ / "out/benchmark.tex"), HasSubstr("& 3 & 0.62 to 7.22 &"));
    EXPECT_THAT(html, HasSubstr("<td>1</td><td>0.03 to 3.69</td>"));
    folder_.put("out/benchmark.json", "{\"benchmark\": 2}");
    EXPECT_THAT(message_of<FormatError>([&] { read_benchmark(folder_ / "out"); }),
                HasSubstr("is no table of a benchmark"));
    folder_.put("out/benchmark.json", "{\"benchmark\": 1}");
    EXPECT_THAT(message_of<FormatError>([&] { read_benchmark(folder_ / "out"); }),
                HasSubstr("title"));
}

BenchmarkRow row_of(const char* tour, const char* hash, const std::vector<double>& errors) {
    BenchmarkRow row;
    row.tour = tour;
    row.algorithm = "x";
    row.hash = hash;
    row.runs = static_cast<int>(errors.size());
    row.figures["error_m"] = spread_of(errors);
    return row;
}

TEST(BenchmarkChanges, TellChangesFromTheSpreadOfSeeds) {
    BenchmarkTable before;
    before.rows = {row_of("same", "a", {1.0, 2.0}), row_of("noise", "b", {1.0, 1.2, 0.8}),
                   row_of("worse", "c", {1.0, 1.01, 0.99}),
                   row_of("better", "d", {1.0, 1.01, 0.99}), row_of("gone", "e", {1.0})};
    BenchmarkTable after;
    after.rows = {row_of("same", "a", {1.0, 2.0}), row_of("noise", "B", {1.1, 1.3, 0.9}),
                  row_of("worse", "C", {1.2, 1.21, 1.19}), row_of("better", "D", {0.8, 0.81, 0.79}),
                  row_of("new", "f", {1.0})};
    std::vector<HowChanged> verdicts;
    const std::vector<BenchmarkChange> changes = compare_benchmarks(before, after);
    for (const BenchmarkChange& change : changes) verdicts.push_back(change.verdict);
    EXPECT_THAT(verdicts, ElementsAre(HowChanged::same, HowChanged::within, HowChanged::worse,
                                      HowChanged::better, HowChanged::appeared, HowChanged::gone));
    // Student's t of 24.5 with four degrees of freedom.
    EXPECT_NEAR(changes[2].chance.value(), 1.65e-5, 2e-7);
    EXPECT_EQ(changes_table(changes).rows[2].back(), "worse");
}

TEST(BenchmarkChanges, LandmarksAreToBeAsManyAsTheReferences) {
    const auto of = [](const char* hash, const std::vector<double>& landmarks) {
        BenchmarkTable table;
        table.rows.push_back(row_of("tour", hash, {1.0, 1.0, 1.0}));
        table.rows.back().figures["landmarks"] = spread_of(landmarks);
        table.rows.back().reference_landmarks = 16;
        return table;
    };
    const auto verdict = [](const BenchmarkTable& before, const BenchmarkTable& after) {
        for (const BenchmarkChange& change : compare_benchmarks(before, after))
            if (change.measure == "landmarks") return change.verdict;
        return HowChanged::gone;
    };
    const BenchmarkTable far = of("a", {30.0, 31.0, 29.0});
    const BenchmarkTable near = of("b", {20.0, 21.0, 19.0});
    EXPECT_EQ(verdict(far, near), HowChanged::better);
    EXPECT_EQ(verdict(near, far), HowChanged::worse);
}

TEST(BenchmarkChanges, ARowOfAnotherSettingIsNoneToCompareWith) {
    const auto of = [](std::optional<std::string> setting) {
        BenchmarkTable table;
        table.rows.push_back(row_of("tour", "hash", {1.0, 2.0}));
        table.rows.back().setting = std::move(setting);
        return table;
    };
    const auto verdict = [&](std::optional<std::string> before, std::optional<std::string> after) {
        return compare_benchmarks(of(std::move(before)), of(std::move(after))).at(0).verdict;
    };
    EXPECT_EQ(verdict("", "3 perturbed copies"), HowChanged::other);
    EXPECT_EQ(verdict("3 perturbed copies", "3 perturbed copies"), HowChanged::same);
    EXPECT_EQ(verdict(std::nullopt, "3 perturbed copies"), HowChanged::same);
}

// Tables of Student's distribution: 5 % lie further out.
TEST(BenchmarkChanges, TheChanceIsStudents) {
    const auto chance = [](double t, std::size_t runs) {
        // Half of them one above the mean and half one below: n / (n - 1) is the variance.
        std::vector<double> a;
        for (std::size_t i = 0; i < runs; ++i) a.push_back(i % 2 == 0 ? 1.0 : -1.0);
        const auto n = static_cast<double>(runs);
        std::vector<double> b = a;
        for (double& value : b) value += t * std::sqrt(2.0 / (n - 1.0));
        BenchmarkTable before;
        BenchmarkTable after;
        before.rows = {row_of("x", "a", a)};
        after.rows = {row_of("x", "b", b)};
        return compare_benchmarks(before, after).at(0).chance.value();
    };
    EXPECT_NEAR(chance(4.3027, 2), 0.05, 1e-4);   // 2 degrees of freedom
    EXPECT_NEAR(chance(2.4469, 4), 0.05, 1e-4);   // 6
    EXPECT_NEAR(chance(2.1009, 10), 0.05, 1e-4);  // 18
    EXPECT_NEAR(chance(2.8784, 10), 0.01, 1e-4);
}

// Of many figures some always look changed: not so many tables.
TEST(BenchmarkChanges, WhatIsDrawnFromTheSameIsSeldomJudgedToHaveChanged) {
    std::mt19937 random(3);
    std::normal_distribution<double> normal(1.0, 0.1);
    const auto table = [&](const char* hash) {
        BenchmarkTable one;
        for (int row = 0; row < 40; ++row) {
            std::vector<double> errors;
            for (int run = 0; run < 5; ++run) errors.push_back(normal(random));
            one.rows.push_back(row_of("x", hash, errors));
            one.rows.back().tour = std::to_string(row);
        }
        return one;
    };
    int alarms = 0;
    constexpr int kTables = 300;
    for (int i = 0; i < kTables; ++i) {
        const auto changes = compare_benchmarks(table("a"), table("b"));
        alarms += std::ranges::any_of(changes, [](const BenchmarkChange& change) {
            return change.verdict != HowChanged::within;
        });
    }
    EXPECT_LT(alarms, kTables / 10);
}

TEST(BenchmarkChanges, OfRowsThatDrawNothingAtRandomOnlyRoundingMayDiffer) {
    const auto verdict = [](double before, double after, std::size_t runs) {
        BenchmarkTable old;
        BenchmarkTable now;
        old.rows = {row_of("x", "a", std::vector(runs, before))};
        now.rows = {row_of("x", "b", std::vector(runs, after))};
        return compare_benchmarks(old, now).at(0).verdict;
    };
    EXPECT_EQ(verdict(0.1, 0.1 + 1e-15, 3), HowChanged::within);
    EXPECT_EQ(verdict(0.1, 0.1001, 3), HowChanged::worse);
    EXPECT_EQ(verdict(0.1, 0.0999, 3), HowChanged::better);
    EXPECT_EQ(verdict(0.1, 0.2, 1), HowChanged::unknown);
    EXPECT_EQ(verdict(0.1, 0.1, 1), HowChanged::within);
}

TEST(BenchmarkChanges, RegionsAreBetterTowardsTheirShare) {
    const auto verdict = [](const char* word, double before, double after) {
        const auto table = [&](double value, const char* hash) {
            BenchmarkTable one;
            one.rows = {row_of("x", hash, {})};
            const std::vector<double> same(3, value);
            one.rows[0].figures[word] = spread_of(same);
            return one;
        };
        return compare_benchmarks(table(before, "a"), table(after, "b")).at(0).verdict;
    };
    EXPECT_EQ(verdict("pose_in_95", 0.70, 0.94), HowChanged::better);
    EXPECT_EQ(verdict("pose_in_50", 0.52, 0.90), HowChanged::worse);
    EXPECT_EQ(verdict("landmark_in_99", 0.2, 0.98), HowChanged::better);
    EXPECT_EQ(verdict("pose_nees", 0.05, 2.9), HowChanged::better);
    EXPECT_EQ(verdict("landmark_nees", 2.1, 3.5), HowChanged::worse);
}

TEST(BenchmarkChanges, MoreLandmarksAreBetterOnlyTowardsTheirTrueNumber) {
    const auto table = [](double landmarks) {
        BenchmarkTable one;
        one.rows.emplace_back();
        one.rows[0].reference_landmarks = 8;
        one.rows[0].hash = std::to_string(landmarks);
        const std::vector<double> same(3, landmarks);
        one.rows[0].figures["landmarks"] = spread_of(same);
        return one;
    };
    const auto verdict = [&](double before, double after) {
        return compare_benchmarks(table(before), table(after)).at(0).verdict;
    };
    EXPECT_EQ(verdict(6, 8), HowChanged::better);
    EXPECT_EQ(verdict(8, 10), HowChanged::worse);
    EXPECT_EQ(verdict(12, 9), HowChanged::better);
}

}  // namespace
}  // namespace hitos
