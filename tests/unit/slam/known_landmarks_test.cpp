// SPDX-License-Identifier: GPL-3.0-or-later
// Landmarks whose identities a sensor tells, in every algorithm.
#include <gtest/gtest.h>

#include <algorithm>
#include <cstdint>
#include <functional>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "graph/graph_merging.hpp"
#include "graph_tour.hpp"
#include "hitos/slam/filters.hpp"
#include "room_tour.hpp"

namespace hitos {
namespace {

struct Seen {
    Point2 at;  ///< in the robot's frame
    std::int32_t identity = kNameless;
};

Observation observed(const std::vector<Seen>& all) {
    Observation observation;
    for (const Seen& one : all) {
        observation.corners.push_back({one.at.x, one.at.y});
        observation.identities.push_back(one.identity);
    }
    return observation;
}

struct Case {
    std::string name;
    std::function<void(FilterParams&)> set;
};

class KnownLandmarks : public ::testing::TestWithParam<Case> {
  protected:
    KnownLandmarks() {
        params_.particles = 4;
        GetParam().set(params_);
    }

    /// A robot at rest, which sees these one after the other.
    std::unique_ptr<SlamFilter> fed(const std::vector<std::vector<Seen>>& scans) const {
        auto filter = make_filter(params_, 1, 1);
        SimRegistration registration({}, 1);
        for (const std::vector<Seen>& seen : scans) {
            const RegisteredStep step = registration.add({});
            const Scan scan;
            const std::vector<Control> controls;
            const Observation observation = observed(seen);
            filter->step({scan, controls, observation, &step});
        }
        return filter;
    }

    FilterParams params_;
};

/// In their order.
std::vector<std::int32_t> identities(const SlamFilter& filter) {
    std::vector<std::int32_t> all;
    for (const ICaracteristica& landmark : filter.best_map()) all.push_back(landmark.identity);
    std::ranges::sort(all);
    return all;
}

TEST_P(KnownLandmarks, AreWhatTheySayHoweverFarFromWhereTheyWere) {
    const auto filter = fed({{{{3.0, 0.0}, 5}}, {{{3.0, 2.5}, 5}}});
    EXPECT_EQ(identities(*filter), std::vector{5});
    ASSERT_EQ(filter->associations().size(), 1U);
    EXPECT_EQ(filter->associations()[0].outcome, Association::Outcome::matched);
    EXPECT_EQ(filter->best_map()[0].observations, 2);
}

TEST_P(KnownLandmarks, AreNoneElseHoweverNear) {
    const auto filter = fed({{{{3.0, 0.0}, 5}}, {{{3.01, 0.0}, 6}}, {{{3.0, 0.01}, 5}}});
    EXPECT_EQ(identities(*filter), (std::vector{5, 6}));
    const Association& last = filter->associations()[0];
    ASSERT_EQ(last.outcome, Association::Outcome::matched);
    EXPECT_EQ(filter->best_map()[static_cast<std::size_t>(last.landmark)].identity, 5);
}

TEST_P(KnownLandmarks, SeenTwiceInOneScanAreOne) {
    const auto filter =
        fed({{{{3.0, 0.0}, 5}, {{3.4, 0.0}, 5}, {{3.2, 0.0}, 6}}, {{{3.0, 0.0}, 5}}});
    EXPECT_EQ(identities(*filter), (std::vector{5, 6}));
}

TEST_P(KnownLandmarks, BeyondAllReckoningAreNotMadeAgain) {
    const std::vector<Seen> far{{{1e11, 1e10}, 5}};
    const auto filter = fed({far, far, far});
    EXPECT_EQ(identities(*filter), std::vector{5});
}

TEST_P(KnownLandmarks, AThousandOfOneNameInAScanTakeNoLongerThanAThousandOfMany) {
    const auto filter = fed({std::vector<Seen>(1000, {{3.0, 0.0}, 5})});
    EXPECT_EQ(identities(*filter), std::vector{5});
}

TEST_P(KnownLandmarks, AreAssociatedByPlaceWhereNobodyBelievesThem) {
    params_.association.known = false;
    const auto filter = fed({{{{3.0, 0.0}, 5}}, {{{3.01, 0.0}, 6}}, {{{3.0, 4.0}, 5}}});
    EXPECT_EQ(identities(*filter), (std::vector{kNameless, kNameless}));
}

TEST_P(KnownLandmarks, ANamelessSightingIsOfWhateverLiesThere) {
    const auto filter = fed({{{{3.0, 0.0}, 5}, {{0.0, 3.0}, 6}}, {{{0.01, 3.0}}}});
    EXPECT_EQ(identities(*filter), (std::vector{5, 6}));
    const Association& last = filter->associations()[0];
    ASSERT_EQ(last.outcome, Association::Outcome::matched);
    EXPECT_EQ(filter->best_map()[static_cast<std::size_t>(last.landmark)].identity, 6);
}

TEST_P(KnownLandmarks, ANamelessOneTakesTheNameThatItIsToldLater) {
    const auto filter =
        fed({{{{3.0, 0.0}}, {{0.0, 3.0}, 6}}, {{{3.01, 0.0}, 5}}, {{{3.0, 2.5}, 5}}});
    EXPECT_EQ(identities(*filter), (std::vector{5, 6}));
    EXPECT_EQ(filter->associations()[0].reason, Association::Reason::known);
    for (const ICaracteristica& landmark : filter->best_map())
        EXPECT_EQ(landmark.observations, landmark.identity == 5 ? 3 : 1);
}

TEST_P(KnownLandmarks, AreNotTakenByANamelessSightingOfTheSameScan) {
    params_.association.exclusive = true;  // as joint compatibility is by itself
    const auto filter = fed({{{{3.0, 0.0}, 5}}, {{{3.6, 0.6}, 5}, {{3.0, 0.0}}}});
    ASSERT_EQ(filter->associations().size(), 2U);
    const Association& known = filter->associations()[0];
    EXPECT_EQ(known.outcome, Association::Outcome::matched);
    EXPECT_EQ(known.reason, Association::Reason::known);
    const bool one_each = params_.algorithm == "fastslam" ||
                          params_.association.method == AssociationMethod::joint_compatibility;
    if (one_each) {
        EXPECT_NE(filter->associations()[1].outcome, Association::Outcome::matched);
    }
}

TEST_P(KnownLandmarks, WhatIsRecordedIsWhatWasDone) {
    auto filter = make_filter(params_, 1, 1);
    SimRegistration registration({}, 1);
    AssociationRecord record;
    for (const Point2& at : {Point2{3.0, 0.0}, Point2{3.0, 2.0}}) {
        const RegisteredStep step = registration.add({});
        const Scan scan;
        const Observation observation = observed({{at, 5}});
        filter->step({scan, {}, observation, &step, &record});
    }
    const RecordedFeature& feature = record.hypotheses.at(record.best).at(0);
    EXPECT_EQ(feature.decision.outcome, Association::Outcome::matched);
    ASSERT_EQ(feature.compared.size(), 1U);
    EXPECT_EQ(feature.compared[0].standing, Standing::candidate);
}

TEST(GraphMerging, ANamelessLandmarkTakesInOneNameAndNoOther) {
    LandmarkGraph graph;
    graph.add_landmark(FeatureKind::corner, {{0.0, 0.0}, 0.0});
    graph.add_landmark(FeatureKind::corner, {{0.01, 0.0}, 0.0}, 5);
    graph.add_landmark(FeatureKind::corner, {{0.02, 0.0}, 0.0}, 6);
    graph.add_landmark(FeatureKind::corner, {{0.0, 0.01}, 0.0});
    const auto sure = [](std::size_t, const Matrix2&, std::size_t, const Matrix2&) {
        return Matrix2(1e-6 * Matrix2::Identity());
    };
    const auto leader = find_duplicates(graph, chi_square_gate(0.95), sure);
    ASSERT_TRUE(leader);
    EXPECT_EQ(*leader, (std::vector<std::uint32_t>{0, 0, 2, 0}));
}

INSTANTIATE_TEST_SUITE_P(
    , KnownLandmarks,
    ::testing::Values(Case{"fastslam", [](FilterParams& /*params*/) {}},
                      Case{"fastslam_gated",
                           [](FilterParams& p) {
                               p.association.method = AssociationMethod::gated_nearest;
                           }},
                      Case{"fastslam_jcbb",
                           [](FilterParams& p) {
                               p.association.method = AssociationMethod::joint_compatibility;
                           }},
                      Case{"fastslam2", [](FilterParams& p) { p.proposal = "posterior"; }},
                      Case{"ekf", [](FilterParams& p) { p.algorithm = "ekf-slam"; }},
                      Case{"ekf_jcbb",
                           [](FilterParams& p) {
                               p.algorithm = "ekf-slam";
                               p.association.method = AssociationMethod::joint_compatibility;
                           }},
                      Case{"graph", [](FilterParams& p) { p.algorithm = "graph-slam"; }}),
    [](const auto& tested) { return tested.param.name; });

}  // namespace
}  // namespace hitos
