// SPDX-License-Identifier: GPL-3.0-or-later
// How often a tour is read: once to look at it, and once to run it, whatever comes of the run.

#include "counted_format.hpp"
#include "hitos/base/staged_folder.hpp"
#include "hitos/capture/tour_summary.hpp"
#include "hitos/services/results/optional_outputs.hpp"
#include "hitos/services/results/results.hpp"
#include "hitos/services/run/algoritmo.hpp"
#include "hitos/workbench/open_tour.hpp"
#include "hitos/workbench/source_inspection.hpp"
#include "support.hpp"

namespace hitos {
namespace {

using test::scans_made;

const bool kCounted = test::add_counted_format();
constexpr int kScans = 60;

class ReadingsOfATour : public testing::Test {
  protected:
    ReadingsOfATour() {
        EXPECT_TRUE(kCounted);
        configuration_.source.file = folder_.put("tour.txt", test::CountedConversor::log(kScans));
        configuration_.filter.particles = 5;
        scans_made = 0;
    }
    test::TempFolder folder_;
    Configuracion configuration_;
};

TEST_F(ReadingsOfATour, ToLookAtItIsOne) {
    EXPECT_EQ(inspect_source(configuration_.source).tour.report.scans, kScans);
    EXPECT_EQ(scans_made, kScans);
}

TEST_F(ReadingsOfATour, ARunWithAllThatCanBeWrittenOfItIsOne) {
    Algoritmo run(configuration_, open_tour(configuration_));
    while (run.step()) {
    }
    StagedFolder staged = results_folder(folder_ / "out");
    const RunSummary summary =
        write_results(run, {}, 1.0, staged, {}, nullptr, chosen_outputs("all", ""));
    EXPECT_TRUE(summary.not_written.empty());
    EXPECT_EQ(scans_made, kScans);
}

TEST_F(ReadingsOfATour, GoingBackIsNone) {
    AlgoritmoOptions options;
    options.go_back = true;
    Algoritmo run(configuration_, open_tour(configuration_), options);
    for (int i = 0; i < kScans / 2; ++i) run.step();
    EXPECT_TRUE(run.rewind());
    while (run.step()) {
    }
    EXPECT_EQ(scans_made, kScans);
}

}  // namespace
}  // namespace hitos
