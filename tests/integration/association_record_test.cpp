// SPDX-License-Identifier: GPL-3.0-or-later
// What is told of the association of a scan is what the filter went by, on shipped worlds.
#include "hitos/slam/association_record.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <optional>

#include "hitos/services/configuration/archivo_configuracion.hpp"
#include "hitos/services/run/run_worker.hpp"
#include "hitos/workbench/open_tour.hpp"

namespace hitos {
namespace {

const std::filesystem::path kSource = HITOS_SOURCE_DIR;
using Outcome = Association::Outcome;
using Reason = Association::Reason;

struct Case {
    const char* name;
    const char* preset;
    void (*change)(FilterParams&);
};

Configuracion configuration_of(const Case& run) {
    Configuracion configuration = ArchivoConfiguracion::read(kSource / "config" / run.preset);
    configuration.source.file = (kSource / "data/worlds/bigloop.toml").string();
    configuration.filter.particles = 12;
    run.change(configuration.filter);
    return configuration;
}

bool is_candidate(const ComparedLandmark& compared) {
    return compared.standing == Standing::candidate;
}

/// The numbers must say what was decided.
void expect_decided_by_numbers(const RecordedFeature& feature, const AssociationRecord& record) {
    for (const ComparedLandmark& compared : feature.compared) {
        if (compared.standing == Standing::elsewhere) continue;
        const bool fits = record.gate ? compared.mahalanobis_squared <= *record.gate
                                      : compared.log_likelihood > *record.log_p0;
        EXPECT_EQ(fits, is_candidate(compared)) << "landmark " << compared.landmark;
    }
    const auto candidates = std::ranges::count_if(feature.compared, is_candidate);
    const Association& decision = feature.decision;
    switch (decision.reason) {
        case Reason::fits: {
            const auto taken =
                std::ranges::find(feature.compared, decision.landmark, &ComparedLandmark::landmark);
            ASSERT_NE(taken, feature.compared.end());
            EXPECT_TRUE(is_candidate(*taken));
            for (const ComparedLandmark& compared : feature.compared) {
                if (!is_candidate(compared)) continue;
                EXPECT_GE(record.gate ? -taken->mahalanobis_squared : taken->log_likelihood,
                          record.gate ? -compared.mahalanobis_squared : compared.log_likelihood);
            }
            break;
        }
        case Reason::ambiguous:
            EXPECT_GE(candidates, 2);
            break;
        case Reason::fits_none:
            EXPECT_EQ(candidates, 0);
            break;
        case Reason::left_over:
            EXPECT_GE(candidates, 1);
            break;
        default:
            break;
    }
}

class AssociationRecords : public testing::TestWithParam<Case> {};

TEST_P(AssociationRecords, AreTheDecisionsOfTheRunAndLeaveItAsItWas) {
    const Configuracion configuration = configuration_of(GetParam());
    AlgoritmoOptions options;
    options.go_back = true;
    RunWorker worker(configuration, open_tour(configuration), options);
    EXPECT_EQ(worker.weighed().get(), nullptr);  // before the first scan
    int matched = 0;
    int created = 0;
    for (int piece = 0; piece < 40; ++piece) {
        worker.run(piece < 10 ? 1 : 7);
        worker.wait();
        worker.request_snapshot();
        worker.wait();
        const auto snapshot = worker.latest_snapshot();
        const auto record = worker.weighed().get();
        ASSERT_NE(record, nullptr);
        const std::vector<RecordedFeature>& best = record->hypotheses.at(record->best);
        ASSERT_EQ(best.size(), snapshot->associations.size());
        // P(d^2 <= g) = 1 - exp(-g / 2).
        const double new_gate =
            -2.0 * std::log1p(-configuration.filter.association.new_probability);
        EXPECT_EQ(record->new_gate, configuration.filter.algorithm == "fastslam"
                                        ? std::nullopt
                                        : std::optional(new_gate));
        for (std::size_t i = 0; i < best.size(); ++i) {
            const Association& told = snapshot->associations[i];
            EXPECT_EQ(best[i].decision.kind, told.kind);
            EXPECT_EQ(best[i].decision.observed, told.observed);
            EXPECT_EQ(best[i].decision.outcome, told.outcome);
            EXPECT_EQ(best[i].decision.reason, told.reason);
            EXPECT_EQ(best[i].decision.landmark, told.landmark);
            matched += told.outcome == Outcome::matched ? 1 : 0;
            created += told.outcome == Outcome::created ? 1 : 0;
        }
        for (const auto& hypothesis : record->hypotheses) {
            for (const RecordedFeature& feature : hypothesis) {
                expect_decided_by_numbers(feature, *record);
            }
        }
    }
    EXPECT_GT(matched, 50);
    EXPECT_GE(created, 4);  // at least the first scan
    // Nobody asked in this one.
    Algoritmo undisturbed(configuration, open_tour(configuration));
    while (undisturbed.steps() < 220) undisturbed.step();
    worker
        .with_run([&](const Algoritmo& run) {
            EXPECT_EQ(run.steps(), undisturbed.steps());
            EXPECT_TRUE(run.best_trajectory() == undisturbed.best_trajectory());
            EXPECT_EQ(run.filter().statistics().neff, undisturbed.filter().statistics().neff);
        })
        .get();
}

INSTANTIATE_TEST_SUITE_P(
    All, AssociationRecords,
    testing::Values(Case{"fastslam", "thesis.cfg", [](FilterParams& /*filter*/) {}},
                    Case{"gated", "thesis.cfg",
                         [](FilterParams& filter) {
                             filter.association.method = AssociationMethod::gated_nearest;
                         }},
                    Case{"joint", "thesis.cfg",
                         [](FilterParams& filter) {
                             filter.association.method = AssociationMethod::joint_compatibility;
                         }},
                    Case{"reviewed", "thesis.cfg",
                         [](FilterParams& filter) {
                             filter.association.segments = true;
                             filter.association.exclusive = true;
                             filter.association.hypotheses = true;
                             filter.landmarks.vanish = true;
                             filter.landmarks.probation = 2;
                         }},
                    Case{"ekf", "ekf.cfg", [](FilterParams& /*filter*/) {}},
                    Case{"ekf_joint", "ekf.cfg",
                         [](FilterParams& filter) {
                             filter.association.method = AssociationMethod::joint_compatibility;
                         }},
                    Case{"graph", "ekf.cfg",
                         [](FilterParams& filter) { filter.algorithm = "graph-slam"; }}),
    [](const auto& test) { return std::string(test.param.name); });

}  // namespace
}  // namespace hitos
