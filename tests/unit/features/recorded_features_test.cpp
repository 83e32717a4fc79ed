// SPDX-License-Identifier: GPL-3.0-or-later
#include "hitos/features/recorded_features.hpp"

#include "hitos/features/line_methods.hpp"
#include "wall_scan.hpp"

namespace hitos {
namespace {

bool same(const Observation& a, const Observation& b) {
    if (a.lines.size() != b.lines.size()) return false;
    for (std::size_t i = 0; i < a.lines.size(); ++i) {
        const bool same_line = a.lines[i].recta == b.lines[i].recta &&
                               a.lines[i].first == b.lines[i].first &&
                               a.lines[i].count == b.lines[i].count;
        if (!same_line) return false;
    }
    return a.time_s == b.time_s && a.corners == b.corners && a.support == b.support &&
           a.line_covariances == b.line_covariances && a.corner_covariances == b.corner_covariances;
}

RecordedTour small_tour() {
    RecordedTour tour;
    for (int i = 0; i < 5; ++i) {
        const double x = 3.0 - 0.2 * i;
        Scan scan =
            scan_of({joined(wall({x, -2.0}, {x, 2.0}, 40), wall({x, 2.0}, {-1.0, 2.0}, 40))}, 0.01,
                    static_cast<unsigned>(i));
        scan.time_s = i;
        tour.scans.items.push_back(std::move(scan));
    }
    return tour;
}

ExtractionParams random_lines() {
    ExtractionParams params;
    params.method = "ransac";
    params.covariance = ObservationCovariance::points;
    return params;
}

TEST(RecordedFeatures, AreThoseOfTheExtractorScanByScan) {
    const RecordedTour tour = small_tour();
    for (const ExtractionParams& params : {ExtractionParams{}, random_lines()}) {
        const auto extractor = make_extractor(params, 7);
        const auto features =
            record_features(tour, *make_extractor(params, 7), [](std::size_t) { return true; });
        ASSERT_TRUE(features);
        RecordedExtractor recorded(features);
        Observation expected;
        Observation seen;
        for (const std::size_t scan : {0U, 1U, 2U, 3U, 4U, 2U, 0U}) {  // runs go back
            extractor->go_to(scan);
            extractor->extract(tour.scans.items[scan], expected);
            recorded.go_to(scan);
            recorded.extract(tour.scans.items[scan], seen);
            EXPECT_FALSE(seen.empty());
            EXPECT_TRUE(same(seen, expected)) << scan;
        }
        EXPECT_THROW(recorded.extract(tour.scans.items[4], seen), std::logic_error);
    }
}

TEST(RecordedFeatures, AreNotMadeWhereTheyMayNotGrow) {
    const RecordedTour tour = small_tour();
    std::size_t all = 0;
    record_features(tour, *make_extractor({}),
                    [&](std::size_t bytes) { return (all += bytes) > 0; });
    EXPECT_GT(all, tour.scans.items.size() * sizeof(Observation));
    std::size_t taken = 0;
    EXPECT_FALSE(record_features(tour, *make_extractor({}),
                                 [&](std::size_t bytes) { return (taken += bytes) < all; }));
}

// What does not draw is never given a seed, so that what it finds cannot depend on one.
TEST(RecordedFeatures, OnlyAMethodThatDrawsDependsOnTheSeed) {
    EXPECT_FALSE(draws_at_random({}));
    EXPECT_TRUE(draws_at_random(random_lines()));
    EXPECT_TRUE(LineMethodEntry{}.random) << "who does not say so may draw";
}

}  // namespace
}  // namespace hitos
