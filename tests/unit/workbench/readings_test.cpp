// SPDX-License-Identifier: GPL-3.0-or-later
// Readings of what the thesis leaves unsaid, and what a reproduction says of them.
#include "hitos/workbench/readings.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <set>
#include <vector>

#include "hitos/base/error.hpp"
#include "hitos/services/configuration/config_parameter.hpp"
#include "hitos/workbench/reproduction.hpp"
#include "hitos/workbench/shipped_data.hpp"
#include "reproduction/reproduction_remarks.hpp"
#include "support.hpp"

namespace hitos {
namespace {

TEST(Readings, HaveNamesOfTheirOwnAndCanBeApplied) {
    std::set<std::string> names;
    std::set<std::string> texts;
    for (const Reading& reading : readings()) {
        SCOPED_TRACE(reading.name);
        EXPECT_FALSE(reading.sentence.empty());
        names.insert(reading.name);
        texts.insert(text_of(reading));
        EXPECT_EQ(find_reading(reading.name).name, reading.name);
        for (const char* name : {"recinto", "complex"}) {
            World world = read_world(find_world(name));
            EXPECT_NO_THROW(apply(reading, world));
        }
        Configuracion configuration = thesis_configuration(find_thesis_table("p"));
        EXPECT_NO_THROW(apply(reading, configuration));
    }
    EXPECT_EQ(names.size(), readings().size());
    EXPECT_EQ(texts.size(), readings().size()) << "runs of different readings must be told apart";
    EXPECT_EQ(text_of(readings().front()), "") << "the first one changes nothing";
    EXPECT_NE(text_of(reading_as_published()), "");
    EXPECT_NE(test::message_of<ConfigError>([] {
                  find_reading("no");
              }).find("--reading: found 'no', expected one of plain, "),
              std::string::npos);
}

TEST(Readings, DrawWallsInPixelsOfTheThesissPictures) {
    Reading reading{"thick", "walls of 3 pixels"};
    reading.wall_pixels = 3.0;
    World small = read_world(find_world("recinto"));
    World large = read_world(find_world("complex"));
    apply(reading, small);
    apply(reading, large);
    EXPECT_DOUBLE_EQ(small.raster.wall_m, 0.054);
    EXPECT_DOUBLE_EQ(large.raster.wall_m, 0.096);
}

TEST(Readings, ChangeWorldsAndConfigurations) {
    Reading reading{"own", "changes of every kind"};
    reading.world = {"laser.rate=2", "raster.cell=0.02"};
    reading.settings = {"association.p0=0.25"};
    reading.variances = true;
    reading.motion_factor = 2.0;
    World world = read_world(find_world("recinto"));
    apply(reading, world);
    EXPECT_EQ(world.laser.rate_hz, 2.0);
    EXPECT_EQ(world.raster.cell_m, 0.02);
    EXPECT_EQ(world.odometry.noise_kind, OdometryNoiseKind::variance);
    Configuracion configuration = thesis_configuration(find_thesis_table("p"));
    apply(reading, configuration);
    EXPECT_DOUBLE_EQ(configuration.filter.motion.sigma_x_m, 2.0 * 0.1);
    EXPECT_DOUBLE_EQ(configuration.filter.motion.sigma_theta_rad, 2.0 * std::sqrt(0.008));
    EXPECT_EQ(find_parameter("association.p0").text(configuration), "0.25");
    reading.world = {"laser.rays=0"};
    EXPECT_THROW(apply(reading, world), ConfigError);
    reading.settings = {"no.key=1"};
    EXPECT_THROW(apply(reading, configuration), ConfigError);
}

Spread exactly(double value) {
    return {1, value, {}, value, value};
}

/// One figure of bigloop2: a row at the thesis's figures, one far below them, one with surplus
/// landmarks and one that no reading explains.
Reproduction small_reproduction(double second, double third) {
    Reproduction reproduction;
    reproduction.reading = readings().front();
    reproduction.runs = 1;
    ReproducedFigure& figure = reproduction.figures.emplace_back();
    figure.thesis.name = "10.91";
    figure.thesis.world = "bigloop2";
    figure.thesis.table = &find_thesis_table("p");
    figure.thesis.range = working_range("p", "bigloop2");
    figure.true_landmarks = 22;
    figure.tolerance = 0.5;
    const auto add = [&](const char* value, double error, double ours, double landmarks) {
        ReproducedRow& row = figure.rows.emplace_back();
        row.thesis = {value, error, 0.0, 22.0};
        row.in_range = figure.thesis.range.holds(std::stod(value));
        row.finished = 1;
        row.error_m = exactly(ours);
        row.landmarks = exactly(landmarks);
    };
    add("500", 0.12, 0.13, 22.0);
    add("200", 0.20, second, 22.0);
    add("100", 0.12, 0.12, third);
    add("5", 0.47, 0.10, 22.0);
    judge(figure);
    return reproduction;
}

TEST(Readings, AreSetAgainstEachOtherRowByRow) {
    const Reproduction plain = small_reproduction(0.10, 24.0);
    Reproduction other = small_reproduction(0.18, 24.0);
    other.reading = reading_as_published();
    const std::string alone = reproduction_markdown(plain, "plots");
    EXPECT_NE(alone.find("| `p`, in the working range | 2 of 3 | 1 below: -0.100 … -0.100 m | 1 "
                         "more: +2.0 … +2.0 |\n"),
              std::string::npos)
        << alone;
    EXPECT_EQ(alone.find("## Readings that were tried"), std::string::npos);
    const std::string both = reproduction_markdown(plain, "plots", std::span(&other, 1));
    EXPECT_NE(both.find("+2.0 … +2.0 | `" + other.reading.name + "`: 1 |"), std::string::npos)
        << both;
    EXPECT_NE(both.find("2 rows that no reading explains"), std::string::npos) << both;
    EXPECT_NE(both.find("* 10.91 bigloop2 p: **100**, 5.\n"), std::string::npos) << both;
    EXPECT_NE(both.find("**`" + other.reading.name +
                        "`** | 3 of 3 | 2 | 2 | -0.003 | 0 of 1 | 2 of "
                        "4 | 33.3 % | – | "),
              std::string::npos)
        << both;
}

TEST(Readings, ThatAreCloseToTheBestAreLookedAtMoreClosely) {
    const Reproduction plain = small_reproduction(0.10, 24.0);
    Reproduction published = small_reproduction(0.18, 24.0);
    published.reading = reading_as_published();
    Reproduction poor = small_reproduction(0.10, 24.0);
    poor.reading = find_reading("stage");
    const std::vector<Reproduction> once = {poor, published};
    const std::vector<Reading> close = close_readings(once);
    ASSERT_EQ(close.size(), 1U) << "66.7 % of the working range, and 33.3 %";
    EXPECT_EQ(close[0].name, reading_as_published().name);

    Reproduction closely = published;
    closely.runs = 4;
    std::vector<Reproduction> tried = {poor, published, closely};
    const std::string best = reproduction_markdown(plain, "plots", tried);
    EXPECT_NE(best.find("The closest, 4 runs of each:"), std::string::npos) << best;
    EXPECT_NE(best.find("No other reading has a greater score"), std::string::npos) << best;
    // One that is better counts where it was looked at as closely, and only there.
    poor.figures = small_reproduction(0.18, 22.0).figures;
    tried[0] = poor;
    EXPECT_NE(reproduction_markdown(plain, "plots", tried).find("No other reading"),
              std::string::npos);
    poor.runs = 4;
    tried.push_back(poor);
    EXPECT_NE(reproduction_markdown(plain, "plots", tried).find("`stage` has a greater score"),
              std::string::npos);
}

}  // namespace
}  // namespace hitos
