// SPDX-License-Identifier: GPL-3.0-or-later
#include <gmock/gmock.h>

#include <cmath>
#include <filesystem>
#include <random>

#include "hitos/services/study/study_result.hpp"
#include "study/study_plot.hpp"
#include "support.hpp"

namespace hitos {
namespace {

using test::content;
using test::TempFolder;
using ::testing::HasSubstr;
using ::testing::Not;

StudyPlan plan_of(std::vector<StudyPlan::Axis> axes, int seeds) {
    StudyPlan plan;
    plan.axes = std::move(axes);
    plan.seeds = seeds;
    plan.reference_lines = 4;
    plan.reference_corners = 4;
    return plan;
}

StudyPlan::Axis dmax_axis() {
    return {"dmax", {"split_merge.dmax"}, {"m"}, {{"0.01"}, {"0.1"}}};
}

StudyRecord run(double error, int lines, int corners) {
    StudyRecord record;
    record.ok = true;
    record.figures["error_m"] = error;
    record.figures["aligned_error_m"] = error / 2.0;
    record.figures["landmarks"] = lines + corners;
    record.figures["lines"] = lines;
    record.figures["corners"] = corners;
    record.scans = 100;
    record.seconds = 0.5;
    record.cpu_seconds = 0.25;
    return record;
}

StudyRecord failure(const std::string& problem) {
    StudyRecord record;
    record.problem = verbatim(problem);
    return record;
}

TEST(StudyTables, MeanAndVarianceAgreeWithTheSumOverAllPairs) {
    std::mt19937_64 random(7);
    std::normal_distribution<double> normal(0.15, 0.02);
    for (const std::size_t n : {std::size_t{2}, std::size_t{5}, std::size_t{200}}) {
        std::vector<double> values;
        for (std::size_t i = 0; i < n; ++i) values.push_back(normal(random));
        // In long double and by differences of pairs, which needs no mean.
        long double sum = 0.0L;
        long double pairs = 0.0L;
        for (const double a : values) {
            sum += static_cast<long double>(a);
            for (const double b : values) {
                const long double difference =
                    static_cast<long double>(a) - static_cast<long double>(b);
                pairs += difference * difference;
            }
        }
        const auto count = static_cast<long double>(n);
        const auto spread = spread_of(values);
        ASSERT_TRUE(spread && spread->variance);
        EXPECT_NEAR(spread->mean, static_cast<double>(sum / count), 1e-15);
        EXPECT_NEAR(*spread->variance, static_cast<double>(pairs / (2.0L * count * (count - 1.0L))),
                    1e-16);
        EXPECT_EQ(spread->count, static_cast<int>(n));
        EXPECT_LE(spread->minimum, spread->mean);
        EXPECT_GE(spread->maximum, spread->mean);
    }
}

TEST(StudyTables, OneValueHasNoVarianceAndNoneHasNoMean) {
    const std::vector<double> one{0.25};
    EXPECT_EQ(spread_of(one)->mean, 0.25);
    EXPECT_EQ(spread_of(one)->variance, std::nullopt);
    EXPECT_FALSE(spread_of({}).has_value());
}

TEST(StudyTables, FailedRunsAreListedAndCountedButNotInTheMeans) {
    const StudyPlan plan = plan_of({dmax_axis()}, 2);
    const std::vector<StudyRecord> records{run(0.1, 4, 4), run(0.2, 4, 2),
                                           failure("bad, \"quoted\"\nthing"), run(0.5, 6, 4)};
    EXPECT_EQ(quality_csv(study_beside("out/q.csv"), plan, records),
              "split_merge.dmax,seed,status,error_m,aligned_error_m,landmarks,lines,corners,"
              "reference_found,reference_landmarks,scans,trajectory_error_m,odometry_error_m,"
              "blur_m2,map,problem,skipped_lines,stamps_backwards,duplicate_scans,first_damage\n"
              "0.01,1,ok,0.1,0.05,8,4,4,0,8,100,,,,q-maps/dmax-0.01-s1.map,,0,0,0,\n"
              "0.01,2,ok,0.2,0.1,6,4,2,0,8,100,,,,q-maps/dmax-0.01-s2.map,,0,0,0,\n"
              "0.1,1,failed,,,,,,,,,,,,,\"bad, \"\"quoted\"\" thing\",,,,\n"
              "0.1,2,ok,0.5,0.25,10,6,4,0,8,100,,,,q-maps/dmax-0.1-s2.map,,0,0,0,\n");
    const std::vector<StudyCell> cells = summarize(plan, records);
    ASSERT_EQ(cells.size(), 2U);
    EXPECT_EQ(cells[1].finished, 1);
    EXPECT_EQ(cells[1].failed, 1);
    EXPECT_EQ(cells[1].figures["error_m"]->mean, 0.5);
    EXPECT_EQ(summary_markdown(plan, cells),
              "| dmax (m) | runs | error (m) | variance (m²) | aligned error (m) | landmarks | "
              "lines | corners |\n|---:|---:|---:|---:|---:|---:|---:|---:|\n"
              "| 0.01 | 2 | 0.150 | 0.0050 | 0.075 | 7.0 | 4.0 | 3.0 |\n"
              "| 0.1 | 1 of 2 | 0.500 | – | 0.250 | 10.0 | 6.0 | 4.0 |\n\n"
              "8 landmarks in the reference: 4 lines, 4 corners.\n");
    EXPECT_THAT(summary_latex(plan, cells), HasSubstr("0.1 & 1 of 2 & 0.500 & -- & 0.250"));
    EXPECT_THAT(summary_latex(plan, cells), HasSubstr("& variance (m$^2$) & aligned (m) &"));
    EXPECT_THAT(summary_csv(plan, cells),
                HasSubstr("\n0.1,1,1,1,0.5,,0.5,0.5,0.25,,10,,6,,4,,8,,,,,,,0,0\n"));
    EXPECT_THAT(timing_csv(plan, records), HasSubstr("\n0.01,1,0.500000,200.0,0.250000\n"));
}

TEST(StudyTables, ARunWithoutComparableLandmarksCountsAsRunOnly) {
    const StudyPlan plan = plan_of({}, 2);
    StudyRecord blind = run(0.0, 0, 0);
    blind.figures["error_m"].reset();
    blind.figures["aligned_error_m"].reset();
    const std::vector<StudyRecord> records{blind, run(0.3, 4, 4)};
    const std::vector<StudyCell> cells = summarize(plan, records);
    EXPECT_EQ(cells[0].finished, 2);
    EXPECT_EQ(cells[0].figures["error_m"]->count, 1);
    EXPECT_EQ(cells[0].figures["error_m"]->mean, 0.3);
    EXPECT_EQ(cells[0].figures["landmarks"]->mean, 4.0);
    EXPECT_THAT(quality_csv(study_in_folder("out"), plan, records),
                HasSubstr("\n1,ok,,,0,0,0,0,8,100,,,,"));
}

TEST(StudyTables, WithoutReferencePathsAndBlurStandInItsPlace) {
    StudyPlan plan = plan_of({dmax_axis()}, 2);
    plan.reference_lines = 0;
    plan.reference_corners = 0;
    const auto measured = [](std::optional<double> ate, double blur) {
        StudyRecord record = run(0.0, 5, 2);
        record.figures["error_m"].reset();
        record.figures["aligned_error_m"].reset();
        record.figures["trajectory_error_m"] = ate;
        if (ate) record.figures["odometry_error_m"] = 2.5;
        record.figures["blur_m2"] = blur;
        return record;
    };
    const std::vector<StudyRecord> records{measured(0.25, 0.5), measured(0.75, 0.25),
                                           measured(1.5, 0.125), failure("x")};
    EXPECT_THAT(
        quality_csv(study_in_folder("out"), plan, records),
        HasSubstr("\n0.01,1,ok,,,7,5,2,,,100,0.25,2.5,0.5,maps/dmax-0.01-s1.map,,0,0,0,\n"));
    EXPECT_EQ(summary_markdown(plan, summarize(plan, records)),
              "| dmax (m) | runs | ATE (m) | odometry's ATE (m) | blur (m²) | landmarks | lines | "
              "corners |\n|---:|---:|---:|---:|---:|---:|---:|---:|\n"
              "| 0.01 | 2 | 0.500 | 2.500 | 0.38 | 7.0 | 5.0 | 2.0 |\n"
              "| 0.1 | 1 of 2 | 1.500 | 2.500 | 0.12 | 7.0 | 5.0 | 2.0 |\n\n"
              "Without a reference map. ATE: error of the path. Blur: undecided area of the "
              "grid map; lower is crisper.\n");
    EXPECT_THAT(summary_csv(plan, summarize(plan, records)),
                HasSubstr("\n0.01,2,0,0,,,,,,,7,0,5,0,2,0,,0.5,0.125,2.5,0,0.375,0.03125,0,0\n"));
    const TempFolder folder;
    study::write_plots(study_in_folder(folder.path()), plan, summarize(plan, records));
    EXPECT_THAT(content(folder / "trajectory-error.dat"), HasSubstr("\n0.01 0.5 "));
    EXPECT_THAT(content(folder / "blur.dat"), HasSubstr("\n0.01 0.375 "));
    EXPECT_THAT(content(folder / "landmarks.gp"), Not(HasSubstr("in the reference")));
    EXPECT_FALSE(std::filesystem::exists(folder / "error.dat"));
    // A log without a true path has only its grid.
    const std::vector<StudyRecord> blind(4, measured(std::nullopt, 0.5));
    EXPECT_THAT(summary_latex(plan, summarize(plan, blind)), Not(HasSubstr("ATE")));
    const TempFolder other;
    study::write_plots(study_in_folder(other.path()), plan, summarize(plan, blind));
    EXPECT_FALSE(std::filesystem::exists(other / "trajectory-error.dat"));
}

TEST(StudyTables, LinesOfTheCalibrationPlotAreToldApart) {
    StudyPlan::Axis axis = dmax_axis();
    axis.values.clear();
    for (int i = 1; i <= 17; ++i) axis.values.push_back({std::to_string(i)});
    const StudyPlan plan = plan_of({axis}, 1);
    std::vector<StudyRecord> records(17, run(0.1, 4, 4));
    for (StudyRecord& record : records) {
        for (const char* word : {"pose_in_50", "pose_in_68", "pose_in_95", "pose_in_99"})
            record.figures[word] = 0.0;
    }
    const TempFolder folder;
    study::write_plots(study_in_folder(folder.path()), plan, summarize(plan, records));
    const std::string script = content(folder / "calibration.gp");
    // gnuplot has eight colours.
    EXPECT_THAT(script, HasSubstr("dashtype 1 pointtype 7 pointsize 0.7 linecolor 8 title"));
    EXPECT_THAT(script, HasSubstr("dashtype 3 pointtype 5 pointsize 0.7 linecolor 9 title"));
    EXPECT_THAT(script, HasSubstr("dashtype 4 pointtype 9 pointsize 0.7 linecolor 17 title"));
    EXPECT_THAT(script, HasSubstr("set yrange [-0.04:1.04]"));  // whole points at the ends
}

TEST(StudyTables, CalibrationHasATableWithTheIntervalOfItsRuns) {
    const StudyPlan plan = plan_of({dmax_axis()}, 2);
    std::vector<StudyRecord> records(4, run(0.1, 4, 4));
    EXPECT_THAT(summary_markdown(plan, summarize(plan, records)), Not(HasSubstr("NEES")));
    EXPECT_THAT(summary_csv(plan, summarize(plan, records)), Not(HasSubstr("nees")));
    const auto told = [](StudyRecord& record, double nees) {
        for (const char* word : {"pose_in_50", "pose_in_68", "pose_in_95", "pose_in_99"})
            record.figures[word] = 0.5;
        record.figures["pose_nees"] = nees;
    };
    told(records[0], 2.0);
    told(records[1], 4.5);
    told(records[2], 9.5);  // of the other run nothing is known
    const std::vector<StudyCell> cells = summarize(plan, records);
    // The chi-square quantiles of six and three degrees of freedom: 1.237, 14.449; 0.216, 9.348.
    const std::string table = summary_markdown(plan, cells);
    EXPECT_THAT(table, HasSubstr("\n| dmax (m) | of | runs | in 50 % | in 68 % | in 95 % | in 99 % "
                                 "| NEES | ought to be | limits of 95 % | verdict |\n"));
    EXPECT_THAT(table, HasSubstr("\n| 0.01 | poses | 2 | 0.500 | 0.500 | 0.500 | 0.500 | 3.25 | 3 "
                                 "| 0.62 to 7.22 | within |\n"
                                 "| 0.1 | poses | 1 | 0.500 | 0.500 | 0.500 | 0.500 | 9.50 | 3 | "
                                 "0.22 to 9.35 | too sure |\n"));
    EXPECT_THAT(table, Not(HasSubstr("| distances |")));
    EXPECT_THAT(summary_latex(plan, cells), HasSubstr("0.62 to 7.22 & within"));
    const std::string csv = summary_csv(plan, cells);
    EXPECT_THAT(csv, HasSubstr(",stamps_backwards,pose_nees_low,pose_nees_high\n"));
    EXPECT_THAT(csv, HasSubstr(",0.618672,7.224688\n"));
    records[0].figures["pose_nees"] = records[1].figures["pose_nees"] = 0.6;
    EXPECT_THAT(summary_markdown(plan, summarize(plan, records)), HasSubstr("| too careful |"));
}

TEST(StudyTables, DamageOfTheLogStandsInEveryTable) {
    const StudyPlan plan = plan_of({dmax_axis()}, 2);
    std::vector<StudyRecord> records(4, run(0.1, 4, 4));
    EXPECT_EQ(most_damaged(records), nullptr);
    records[1].report.stamps_backwards = 7;
    records[2].report.skipped = 3;
    records[2].report.examples = {{17, verbatim("expected 4 fields, found 2")},
                                  {19, verbatim("x")}};
    EXPECT_EQ(most_damaged(records), &records[2]);
    const std::string quality = quality_csv(study_in_folder("out"), plan, records);
    EXPECT_THAT(quality, HasSubstr(",,0,7,0,\n"));
    EXPECT_THAT(quality, HasSubstr(",,3,0,0,\"line 17: expected 4 fields, found 2\"\n"));
    const std::vector<StudyCell> cells = summarize(plan, records);
    EXPECT_THAT(summary_csv(plan, cells), HasSubstr(",0,7\n"));
    EXPECT_THAT(summary_csv(plan, cells), HasSubstr(",3,0\n"));
    const std::string sentence =
        "The log is damaged: 3 lines skipped, 7 stamps that did not advance";
    EXPECT_THAT(summary_markdown(plan, cells), HasSubstr(sentence));
    EXPECT_THAT(summary_latex(plan, cells), HasSubstr(sentence));
}

TEST(StudyTables, PlotsDrawOneCurveForEachSecondValue) {
    const TempFolder folder;
    const StudyPlan plan = plan_of(
        {dmax_axis(), {"sensor", {"a", "b"}, {"m^2", "rad^2"}, {{"1", "2"}, {"3", "4"}}}}, 1);
    const std::vector<StudyRecord> records{run(0.1, 4, 4), run(0.2, 4, 4), failure("x"),
                                           run(0.4, 4, 4)};
    const std::string problem =
        study::write_plots(study_in_folder(folder.path()), plan, summarize(plan, records))
            .english();
    EXPECT_EQ(content(folder / "error.dat"),
              "# x mean standard_deviation minimum maximum runs\n# sensor = 1/2\n"
              "0.01 0.1 0 0.1 0.1 1\n0.1 NaN NaN NaN NaN 0\n\n\n# sensor = 3/4\n"
              "0.01 0.2 0 0.2 0.2 1\n0.1 0.4 0 0.4 0.4 1\n");
    const std::string script = content(folder / "landmarks.gp");
    EXPECT_THAT(script, HasSubstr("index 1 using 1:2:3 with yerrorlines"));
    EXPECT_THAT(script, HasSubstr("title 'sensor = 3/4'"));
    EXPECT_THAT(script, HasSubstr("     8 with lines"));
    EXPECT_THAT(script, Not(HasSubstr("logscale")));
    if (!problem.empty()) GTEST_SKIP() << problem;
    EXPECT_EQ(content(folder / "error.png").substr(1, 3), "PNG");
    EXPECT_THAT(content(folder / "error.svg"), HasSubstr("</svg>"));
    EXPECT_EQ(folder.files(), 8U) << "nothing but scripts, data and pictures";
}

TEST(StudyTables, ValuesThatAreNoNumbersStandAsWordsAndWideOnesOnALogarithmicAxis) {
    const TempFolder folder;
    const std::vector<StudyRecord> records{run(0.1, 4, 4), run(0.2, 4, 4)};
    StudyPlan words = plan_of({{"fit", {"split_merge.fit"}, {""}, {{"it's"}, {"b_c"}}}}, 1);
    study::write_plots(study_in_folder(folder.path()), words, summarize(words, records));
    EXPECT_THAT(content(folder / "error.gp"), HasSubstr("set xtics ('it''s' 1, 'b_c' 2)"));
    StudyPlan wide = plan_of({{"p", {"filter.particles"}, {""}, {{"500"}, {"5"}}}}, 1);
    study::write_plots(study_in_folder(folder.path()), wide, summarize(wide, records));
    EXPECT_THAT(content(folder / "error.gp"), HasSubstr("set logscale x"));
    EXPECT_THAT(content(folder / "error.dat"), HasSubstr("runs\n5 0.2 0 0.2 0.2 1\n500 0.1"));
}

}  // namespace
}  // namespace hitos
