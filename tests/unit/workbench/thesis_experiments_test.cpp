// SPDX-License-Identifier: GPL-3.0-or-later
#include "hitos/workbench/thesis_experiments.hpp"

#include <gmock/gmock.h>

#include <set>
#include <sstream>

#include "hitos/base/error.hpp"
#include "hitos/services/configuration/config_parameter.hpp"
#include "hitos/services/study/study.hpp"
#include "hitos/workbench/reproduction_maps.hpp"
#include "hitos/workbench/shipped_data.hpp"
#include "support.hpp"

namespace hitos {
namespace {

using ::testing::Contains;
using ::testing::HasSubstr;
using ::testing::Not;

std::string assignment(const ThesisExperiment& experiment) {
    std::string text = experiment.key + "=";
    for (const ThesisClaim& claim : experiment.claims) {
        if (&claim != &experiment.claims.front()) text += ',';
        text += claim.value;
    }
    return text;
}

TEST(ThesisExperiments, CoverEveryFigureThatShowsMapsOrCounts) {
    std::set<std::string> figures;
    for (const ThesisExperiment& experiment : thesis_experiments()) {
        std::istringstream names(experiment.figure);
        for (std::string name; std::getline(names, name, '/');) figures.insert(name);
    }
    for (const char* figure :
         {"10.12", "10.15", "10.18", "10.21", "10.24", "10.25", "10.29", "10.32", "10.35", "10.38",
          "10.41", "10.42", "10.45", "10.48", "10.51", "10.54", "10.57", "10.58", "10.60", "10.61",
          "10.65", "10.66", "10.67", "10.68", "10.69", "10.70", "10.75", "10.76", "10.77", "10.78",
          "10.80", "10.82", "10.86", "10.88", "10.90", "10.92", "10.94", "10.95", "10.96"}) {
        EXPECT_THAT(figures, Contains(figure));
        EXPECT_TRUE(names_experiment(figure));
    }
    EXPECT_FALSE(names_experiment("10.99"));
    EXPECT_FALSE(names_experiment("10.6"));
}

TEST(ThesisExperiments, AreStudiesThatCanBeRun) {
    std::set<std::string> stems;
    for (const ThesisExperiment& experiment : thesis_experiments()) {
        SCOPED_TRACE(experiment.stem());
        EXPECT_TRUE(stems.insert(experiment.stem()).second) << "two write the same files";
        EXPECT_TRUE(experiment.is_named(experiment.stem()));
        EXPECT_TRUE(experiment.is_named(experiment.name));
        EXPECT_TRUE(experiment.is_named(experiment.parameter));
        Study study;
        study.configuration = experiment_configuration(experiment);
        study.configuration.source.file = "any.log";
        study.parameters = {parse_study_parameter(assignment(experiment))};
        const StudyPlan plan = plan_study(study);
        EXPECT_EQ(plan.cells(), experiment.claims.size());
        if (experiment.place == ThesisExperiment::Place::world) {
            EXPECT_THAT(shipped_worlds(), Contains(experiment.name));
            EXPECT_THAT(experiment.table, HasSubstr("10."));
        }
    }
}

TEST(ThesisExperiments, FixedParametersAreThoseOfTheTables) {
    const auto of = [](const char* stem) {
        for (const ThesisExperiment& experiment : thesis_experiments()) {
            if (experiment.stem() == stem) return experiment_configuration(experiment);
        }
        ADD_FAILURE() << stem;
        return Configuracion{};
    };
    // Table 10.3.
    const Configuracion hall = of("10.25-usc-sal-dmax");
    EXPECT_EQ(hall.filter.particles, 50);
    EXPECT_EQ(hall.extraction.lines.min_points, 15);
    EXPECT_EQ(hall.extraction.lines.min_length_m, 1.5);
    // Table 10.13, of which figure 10.77 varies one number and changes another.
    const auto text = [](const Configuracion& configuration, const char* key) {
        return find_parameter(key).text(configuration);
    };
    const Configuracion laboratory = of("10.77-iusiani-sensor_theta");
    EXPECT_EQ(text(laboratory, "observation.var_rho"), "0.001");
    EXPECT_EQ(text(laboratory, "motion.sigma_x"), "0.005");
    EXPECT_EQ(text(laboratory, "motion.sigma_theta"), "0.008");
    // Table 10.15.
    const Configuracion neff = of("10.82-iusiani-neff");
    EXPECT_EQ(text(neff, "resampling.rule"), "neff");
    EXPECT_EQ(text(neff, "split_merge.min_length"), "1.8");
    EXPECT_EQ(text(neff, "motion.sigma_y"), "0.001");
    // Recorded tours have the shipped configuration.
    EXPECT_EQ(text(of("10.96-aces-p"), "motion.model"), "proportional");
}

TEST(ThesisExperiments, DocumentSaysWhatWasLeftOut) {
    ReproductionOptions options;
    options.only = {"aces"};
    const MapReproduction without = reproduce_maps(options);
    EXPECT_TRUE(without.experiments.empty());
    EXPECT_THAT(without.left_out, Contains("10.96-aces-p: no folder of recorded tours was given"));
    options.logs = "/nowhere";
    const MapReproduction missing = reproduce_maps(options);
    EXPECT_THAT(missing.left_out,
                Contains("10.96-aces-p: there is no aces.log.gz with aces.gt.tum.gz"));
    const std::string document = map_reproduction_markdown(missing, "maps");
    EXPECT_THAT(document,
                HasSubstr("* 10.25-aces-dmax: there is no aces.log.gz with aces.gt.tum.gz.\n"));
    EXPECT_THAT(document, Not(HasSubstr("## Pairs")));
}

TEST(ThesisExperiments, AreRefusedWithTheirLineWhereTheFileIsWrong) {
    const test::TempFolder folder;
    const auto message = [&](const std::string& text) {
        return test::message_of<FormatError>(
            [&] { read_thesis_experiments(folder.put("experiments.toml", text)); });
    };
    const std::string head = "[[experiment]]\nfigure = \"10.1\"\nparameter = \"p\"\n";
    const std::string good = head + "world = \"recinto\"\nclaims = [[\"5\", \"\"]]\n";
    const auto read = read_thesis_experiments(folder.put("good.toml", good + good));
    ASSERT_EQ(read.size(), 2U);
    EXPECT_EQ(read.back().key, "filter.particles") << "that of the thesis's table";
    EXPECT_EQ(read.back().table, "10.17");
    EXPECT_THAT(message(head), HasSubstr(":1: world: expected this key"));
    EXPECT_THAT(message(good + "remrak = \"\"\n"),
                HasSubstr(":6: no such key; expected one of claims, counts, figure"));
    EXPECT_THAT(message(good + "runs = 1.5\n"), HasSubstr(":6: runs: expected a whole number"));
    EXPECT_THAT(message(head + "world = \"recinto\"\nclaims = [[\"5\"]]\n"),
                HasSubstr(":5: claims: expected [[value, says]]"));
    EXPECT_THAT(message(head + "world = \"recinto\"\nclaims = []\n"),
                HasSubstr(":5: claims: expected [[value, says]]"));
    EXPECT_THAT(message("experiment = 3\n"), HasSubstr("experiment: expected a list of tables"));
    EXPECT_THAT(message(good + "[[table]]\n"), HasSubstr("experiment: expected a list of tables"));
    EXPECT_THAT(message("[[experiment\n"), HasSubstr("experiments.toml:1: "));
}

}  // namespace
}  // namespace hitos
