// SPDX-License-Identifier: GPL-3.0-or-later
// The figures of the thesis's chapter 10, their fixed parameters and what is asked of them.
#include "hitos/workbench/thesis_figures.hpp"

#include <gtest/gtest.h>

#include <filesystem>
#include <map>
#include <set>

#include "hitos/base/error.hpp"
#include "hitos/services/configuration/config_parameter.hpp"
#include "hitos/simulation/worlds/reference_map.hpp"
#include "hitos/workbench/reproduction.hpp"
#include "hitos/workbench/shipped_data.hpp"
#include "support.hpp"

namespace hitos {
namespace {

const std::string kHeader = "figure,map,parameter,value,error_m,error_variance,landmarks\n";

std::vector<ThesisFigure> shipped_figures() {
    return read_thesis_figures(needed_file("data/results.csv"));
}

TEST(ThesisFigures, HasEveryRowOfTheChapter) {
    const auto figures = shipped_figures();
    EXPECT_EQ(figures.size(), 24U);
    std::size_t rows = 0;
    std::set<std::string> stems;
    for (const ThesisFigure& figure : figures) {
        rows += figure.rows.size();
        stems.insert(figure.stem());
    }
    EXPECT_EQ(rows, 183U);
    EXPECT_EQ(stems.size(), 24U);
    EXPECT_EQ(figures.front().stem(), "10.10-recinto-dmax");
    EXPECT_EQ(figures.front().rows.front().value, "0.001");
    EXPECT_EQ(figures.front().rows.front().error_m, 0.308);
    EXPECT_EQ(figures.back().stem(), "10.93-complex-p");
    EXPECT_EQ(figures.back().rows.back().landmarks, 25.6);
    EXPECT_FALSE(figures[6].rows.back().error_m) << "lineamedia, mlon 10: no landmark, so infinite";
}

/// The tables as the thesis prints them, column by column.
struct Printed {
    const char* parameter;
    const char* table;
    double p0, particles, min_points, dmax, min_length, var_rho, var_theta, sigma_xy;
};

TEST(ThesisFigures, HasTheFixedParametersOfEveryTable) {
    constexpr double kVaried = -1.0;
    const std::vector<Printed> printed{
        {"dmax", "10.2", 0.005, 100, 9, kVaried, 0.4, 0.04, 0.00122, 0.007},
        {"mlon", "10.4", 0.005, 100, 15, 0.02, kVaried, 0.04, 0.00122, 0.01},
        {"mpuntos", "10.6", 0.005, 100, kVaried, 0.02, 0.4, 0.04, 0.00122, 0.01},
        {"es", "10.10", 0.005, 100, 9, 0.02, 0.4, 0.04, 0.00122, 0.007},
        {"sensor_rho", "10.12", 0.005, 100, 9, 0.02, 0.4, kVaried, 0.001224, 0.007},
        {"sensor_theta", "10.12", 0.005, 100, 9, 0.02, 0.4, 0.08, kVaried, 0.007},
        {"p0", "10.16", kVaried, 100, 9, 0.02, 0.4, 0.04, 0.00122, 0.007},
        {"p", "10.17", 0.005, kVaried, 9, 0.02, 0.4, 0.04, 0.00122, 0.01},
    };
    ASSERT_EQ(thesis_tables().size(), printed.size());
    for (const Printed& row : printed) {
        SCOPED_TRACE(row.parameter);
        const ThesisTable& table = find_thesis_table(row.parameter);
        EXPECT_EQ(table.table, row.table);
        const Configuracion configuration = thesis_configuration(table);
        const std::map<std::string, double> expected{
            {"association.p0", row.p0},
            {"filter.particles", row.particles},
            {"split_merge.min_points", row.min_points},
            {"split_merge.dmax", row.dmax},
            {"split_merge.min_length", row.min_length},
            {"observation.var_rho", row.var_rho},
            {"observation.var_theta", row.var_theta},
            {"motion.sigma_x", row.sigma_xy},
            {"motion.sigma_y", row.sigma_xy},
            {"motion.sigma_theta", 0.008},
        };
        for (const auto& [key, value] : expected) {
            if (value == kVaried) {
                EXPECT_EQ(table.key, key);
            } else {
                EXPECT_EQ(std::stod(find_parameter(key).text(configuration)), value) << key;
            }
        }
        EXPECT_EQ(find_parameter("resampling.rule").text(configuration), "always");
        EXPECT_EQ(find_parameter("motion.model").text(configuration), "odometry");
    }
}

TEST(ThesisFigures, EveryWorkingRangeHoldsValuesOfItsFigure) {
    for (const ThesisFigure& figure : shipped_figures()) {
        std::size_t inside = 0;
        for (const ThesisRow& row : figure.rows)
            inside += figure.range.holds(std::stod(row.value)) ? 1U : 0U;
        EXPECT_GE(inside, 2U) << figure.stem();
    }
    EXPECT_TRUE(working_range("dmax", "lineamedia").holds(0.02));
    EXPECT_FALSE(working_range("dmax", "lineamedia").holds(0.03));
    EXPECT_FALSE(working_range("p", "complex").holds(50));
    EXPECT_TRUE(working_range("p", "recinto").holds(50));
    // As the text has them: [T 10.5.2], [T 10.6.2], [T 10.6.3].
    EXPECT_FALSE(working_range("p", "lineamedia").holds(50));
    EXPECT_FALSE(working_range("p0", "bigloop2").holds(0.0001));
    EXPECT_FALSE(working_range("sensor_theta", "bigloop2").holds(0.0005));
    EXPECT_FALSE(working_range("sensor_theta", "bigloop2").holds(0.005));
    EXPECT_TRUE(working_range("sensor_theta", "bigloop2").holds(0.001224));
}

TEST(ThesisFigures, WorldsHaveTheTrueNumberOfLandmarks) {
    const std::map<std::string, std::size_t> counts{
        {"recinto", 8}, {"lineamedia", 9}, {"bigloop", 16}, {"bigloop2", 22}, {"complex", 26}};
    for (const auto& [name, count] : counts)
        EXPECT_EQ(reference_map(read_world(find_world(name))).size(), count) << name;
}

TEST(ThesisFigures, RefusesWhatIsNoTableOfResults) {
    const test::TempFolder folder;
    const auto message = [&](const std::string& text) {
        return test::message_of<FormatError>(
            [&] { read_thesis_figures(folder.put("results.csv", text)); });
    };
    EXPECT_NE(message("a,b\n").find(":1: "), std::string::npos);
    EXPECT_NE(message(kHeader + "10.85,recinto,p,5,0.2\n").find("5 columns"), std::string::npos);
    EXPECT_NE(message(kHeader + "10.85,recinto,p,5,x,0,8\n").find("error_m is \"x\""),
              std::string::npos);
    EXPECT_NE(message(kHeader + "10.85,recinto,p,inf,1,0,8\n").find("value is \"inf\""),
              std::string::npos);
    EXPECT_NE(message(kHeader + "10.85,recinto,p,5,1,0,-8\n").find("landmarks is -8"),
              std::string::npos);
    EXPECT_NE(message(kHeader + "10.85,recinto,speed,5,1,0,8\n").find("speed"), std::string::npos);
    EXPECT_NE(message(kHeader + "10.85,recinto,p,5,1,0,8\n10.85,complex,p,5,1,0,8\n").find(":3: "),
              std::string::npos);
    EXPECT_THROW(read_thesis_figures(folder / "missing.csv"), FileError);
}

TEST(SelectFigures, TakesNumbersWorldsAndParameters) {
    const auto figures = shipped_figures();
    EXPECT_EQ(select_figures(figures, {}).size(), 24U);
    EXPECT_EQ(select_figures(figures, {"10.11"}).front().name, "10.10/10.11");
    EXPECT_EQ(select_figures(figures, {"complex"}).size(), 4U);
    EXPECT_EQ(select_figures(figures, {"complex", "p"}).size(), 8U);
    EXPECT_THROW(select_figures(figures, {"10.99"}), ConfigError);
}

ReproducedRow row_of(double thesis, double ours, double landmarks, bool in_range) {
    ReproducedRow row;
    row.thesis = {"1", thesis, 0.0, 8.0};
    row.in_range = in_range;
    row.finished = 1;
    row.error_m = Spread{1, ours, {}, ours, ours};
    row.landmarks = Spread{1, landmarks, {}, landmarks, landmarks};
    return row;
}

TEST(Judge, AsksForErrorAndNumberInsideAndForTheTendencyOutside) {
    ReproducedFigure figure;
    figure.true_landmarks = 8;
    figure.tolerance = 0.5;
    figure.rows = {row_of(0.15, 0.20, 8.4, true), row_of(0.15, 0.22, 8.0, true),
                   row_of(0.15, 0.10, 9.0, true), row_of(0.90, 0.95, 8.0, false),
                   row_of(0.90, 0.15, 8.0, false)};
    figure.rows[0].thesis.landmarks = 8.0;
    judge(figure);
    EXPECT_EQ(figure.rows[0].verdict.words, "met");
    EXPECT_EQ(figure.rows[1].verdict.words, "error 0.020 m too high");
    EXPECT_EQ(figure.rows[2].verdict.words, "landmarks +1.0 from the true number");
    EXPECT_TRUE(figure.rows[3].verdict.same_tendency);
    EXPECT_EQ(figure.rows[4].verdict.words, "harms the thesis, not us");
}

TEST(Judge, AsksForTheThesissFiguresFromBothSides) {
    ReproducedFigure figure;
    figure.true_landmarks = 22;
    figure.tolerance = 0.5;
    figure.rows = {row_of(0.15, 0.20, 9.0, true), row_of(0.15, 0.099, 6.9, true),
                   row_of(0.15, 0.201, 8.0, false)};
    judge(figure);
    // The truth is 22: the thesis's 8 landmarks are the measure all the same.
    EXPECT_TRUE(figure.rows[0].verdict.error_near);
    EXPECT_TRUE(figure.rows[0].verdict.landmarks_near);
    EXPECT_FALSE(figure.rows[0].verdict.thesis_landmarks_met);
    EXPECT_EQ(figure.rows[0].verdict.difference, "as the thesis");
    EXPECT_FALSE(figure.rows[1].verdict.error_near) << "too good is no agreement";
    EXPECT_TRUE(figure.rows[1].verdict.error_met);
    EXPECT_EQ(figure.rows[1].verdict.difference, "error -0.051 m; landmarks -1.1");
    EXPECT_FALSE(figure.rows[2].verdict.error_near);
    EXPECT_FALSE(figure.rows[2].verdict.error_met);
}

TEST(Judge, NoLandmarksOnBothSidesIsTheSameTendency) {
    ReproducedFigure figure;
    figure.true_landmarks = 8;
    figure.rows = {row_of(0.1, 0.1, 8.0, true), row_of(0.1, 0.1, 0.0, false)};
    figure.rows[1].thesis.error_m.reset();
    figure.rows[1].error_m.reset();
    judge(figure);
    EXPECT_TRUE(figure.rows[1].verdict.same_tendency);
    EXPECT_TRUE(figure.rows[1].verdict.error_near);
    EXPECT_EQ(figure.rows[1].verdict.difference, "landmarks -8.0") << "the thesis's row says 8";
}

}  // namespace
}  // namespace hitos
