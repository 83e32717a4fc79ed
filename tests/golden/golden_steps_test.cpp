// SPDX-License-Identifier: GPL-3.0-or-later
// The determinism contract (docs/determinism.md): the state after every scan of short tours is the
// same to the last bit as it was when tests/golden was made, whatever compiled this program, on any
// number of threads and with any vectors. Whoever means to change bits makes them anew by
// HITOS_RENEW_GOLDEN=1 tests/test_golden.
#include <gtest/gtest.h>

#include <cstdint>
#include <cstdlib>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "hitos/base/atomic_file.hpp"
#include "hitos/base/error.hpp"
#include "hitos/base/text_input.hpp"
#include "hitos/base/vectorised.hpp"
#include "hitos/services/configuration/archivo_configuracion.hpp"
#include "hitos/services/run/step_hashes.hpp"
#include "hitos/workbench/open_tour.hpp"

namespace hitos {
namespace {

const std::string kSource = HITOS_SOURCE_DIR;
constexpr std::uint64_t kScans = 161;  // of each tour, at most

struct GoldenRun {
    const char* name;
    const char* tour;
    const char* configuration;
    std::vector<std::string> set = {};
};

std::vector<GoldenRun> golden_runs() {
    return {
        {"corridor-fastslam", "worlds/corridor.toml", "simulated"},
        {"corridor-fastslam2",
         "worlds/corridor.toml",
         "simulated",
         {"filter.proposal=posterior", "filter.particles=100"}},
        {"bigloop-thesis", "bigloop.log.gz", "thesis"},
        {"bigloop-ekf", "worlds/bigloop.toml", "ekf"},
        {"bigloop-graph", "worlds/bigloop.toml", "recorded", {"filter.algorithm=graph-slam"}},
        {"loop-recorded",
         "lessons/04-loop/world.toml",
         "recorded",
         {"filter.particles=20", "source.world_set=laser.rate=2"}},
        {"posts-landmarks", "worlds/posts.toml", "landmarks"},
        {"orchard-trees", "worlds/orchard.toml", "trees", {"filter.particles=20"}},
        {"carmen-recorded", "logs/carmen-flaser.log.gz", "recorded"},
    };
}

Configuracion configuration_of(const GoldenRun& golden) {
    Configuracion configuration =
        ArchivoConfiguracion::read(kSource + "/config/" + golden.configuration + ".cfg");
    configuration.source.file = kSource + "/data/" + golden.tour;
    for (const std::string& assignment : golden.set) set_parameter(configuration, assignment);
    return configuration;
}

std::string hashes_of(Configuracion configuration, int threads) {
    configuration.run.threads = threads;
    StepHashes hashes;
    AlgoritmoOptions options;
    options.step_grid = false;
    options.stepped = [&hashes](const Algoritmo& run) { hashes.note(run); };
    Algoritmo run(configuration, open_tour(configuration), options);
    while (run.steps() < kScans && run.step()) {
    }
    return hashes.csv();
}

std::string words_of(const StepDifference& difference) {
    return "scan " + difference.scan + ", first in: " + difference.part;
}

bool renews() {
    return std::getenv("HITOS_RENEW_GOLDEN") != nullptr;  // NOLINT(concurrency-mt-unsafe)
}

class GoldenSteps : public ::testing::TestWithParam<GoldenRun> {
  protected:
    void TearDown() override { use_vectors(widest_vectors()); }
};

TEST_P(GoldenSteps, AreTheSameBits) {
#if defined(__x86_64__)
    if (!__builtin_cpu_supports("fma")) GTEST_SKIP() << "the C library rounds otherwise here";
#else
    GTEST_SKIP() << "the hashes are of x86-64";
#endif
    const Configuracion configuration = configuration_of(GetParam());
    const std::string golden = kSource + "/tests/golden/" + GetParam().name + ".csv";
    if (renews()) write_file(golden, hashes_of(configuration, 1));
    const std::string expected = input::read_text(golden);
    for (const VectorTarget target :
         {VectorTarget::sse2, VectorTarget::avx2, VectorTarget::avx512}) {
        if (use_vectors(target) != target) continue;  // this machine has none
        for (const int threads : {1, 2, 7}) {
            const auto found =
                first_difference(expected, golden, hashes_of(configuration, threads), "this run");
            EXPECT_FALSE(found) << words_of(*found) << "; vectors " << static_cast<int>(target)
                                << ", threads " << threads;
        }
    }
}

INSTANTIATE_TEST_SUITE_P(Tours, GoldenSteps, ::testing::ValuesIn(golden_runs()),
                         [](const auto& golden) {
                             std::string name = golden.param.name;
                             std::erase(name, '-');
                             return name;
                         });

TEST(StepHashes, NameTheFirstScanAndPartThatDiffer) {
    const std::string table = input::read_text(kSource + "/tests/golden/corridor-fastslam.csv");
    EXPECT_FALSE(first_difference(table, "a", table, "b"));
    // Another seed draws other noise of the tour and of the particles.
    Configuracion configuration = configuration_of(golden_runs().front());
    configuration.source.tour_seed = 1;
    const std::string one = hashes_of(configuration, 1);
    configuration.run.seed = 2;
    const std::optional<StepDifference> particles =
        first_difference(one, "a", hashes_of(configuration, 1), "b");
    ASSERT_TRUE(particles);
    EXPECT_EQ(particles->part, "hypotheses");
    // A cell of the fifth scan.
    std::string changed = table;
    std::size_t line = 0;
    for (int scan = 0; scan < 5; ++scan) line = changed.find('\n', line) + 1;
    const std::size_t cell = changed.find(',', changed.find(',', changed.find(',', line) + 1) + 1);
    changed[cell + 1] = changed[cell + 1] == '0' ? '1' : '0';
    const std::optional<StepDifference> fifth = first_difference(table, "a", changed, "b");
    ASSERT_TRUE(fifth);
    EXPECT_EQ(fifth->scan, "5");
    EXPECT_EQ(fifth->part, "features");
    // Its end.
    const std::optional<StepDifference> shorter =
        first_difference(table, "a", table.substr(0, line), "b");
    ASSERT_TRUE(shorter);
    EXPECT_EQ(shorter->scan, "5");
    EXPECT_EQ(shorter->part, "scan");
}

TEST(StepHashes, WhatIsNoneIsRefused) {
    const std::string table = input::read_text(kSource + "/tests/golden/corridor-fastslam.csv");
    for (const std::string& none : {std::string(), std::string("scan,stamp_s\n1,2\n"),
                                    table.substr(0, table.size() - 5), table + "3,4\n"}) {
        EXPECT_THROW(static_cast<void>(first_difference(none, "none", none, "none")), FormatError);
    }
}

}  // namespace
}  // namespace hitos
