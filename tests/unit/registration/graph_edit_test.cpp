// SPDX-License-Identifier: GPL-3.0-or-later
#include "hitos/registration/graph_edit.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "hitos/base/error.hpp"
#include "ring_tour.hpp"

namespace hitos {
namespace {

using testing::HasSubstr;

std::string said_of(const std::string& text) {
    try {
        static_cast<void>(parse_graph_edits(text));
    } catch (const ConfigError& error) {
        EXPECT_EQ(error.key(), kGraphEditsKey);
        return error.what();
    }
    return {};
}

TEST(GraphEdit, ReadsWhatItWrites) {
    const std::vector<GraphEdit> edits{
        {GraphEdit::Kind::refuse, {811, 65.25, 0x9f3a1c2bU}, {39}},
        {GraphEdit::Kind::close, {899}, {36, -1.0 / 3.0}, {0.1, -1.0 / 7.0, 3.0}},
        {GraphEdit::Kind::fix, {29, 1e9 + 0.125}, {}, {1.0, 2.0, 0.0}},
        {GraphEdit::Kind::slip, {54}},
        {.kind = GraphEdit::Kind::wall,
         .scan = {0, 0.5},
         .bearing = -1.0 / 3.0,
         .left = {691000.25, 5334000.125},
         .right = {691004.0, 5334000.125}},
        {.kind = GraphEdit::Kind::point, .scan = {7}, .seen = {2.0, -0.1}, .left = {1e-3, 9.0}}};
    const std::string text = text_of(edits);
    EXPECT_EQ(parse_graph_edits(text), edits);
    EXPECT_EQ(text_of(parse_graph_edits(text)), text);
    EXPECT_THAT(text, HasSubstr("refuse 812@65.25~9f3a1c2b 40; close 900 37@"));
}

TEST(GraphEdit, LinesCommentsAndNothing) {
    EXPECT_TRUE(parse_graph_edits("").empty());
    EXPECT_TRUE(parse_graph_edits(" ;\n# refuse 3 1\n").empty());
    const auto edits = parse_graph_edits("  slip 7 # as a wheel did; refuse 9 1\n\nslip 8;slip 9;");
    ASSERT_EQ(edits.size(), 3U);
    EXPECT_EQ(edits[2], (GraphEdit{GraphEdit::Kind::slip, {8}}));
    EXPECT_EQ(edits[0].comment, "as a wheel did; refuse 9 1");
    EXPECT_EQ(parse_graph_edits(text_of(edits)), edits);
}

TEST(GraphEdit, ACommentAboveAChangeIsOfIt) {
    const auto edits = parse_graph_edits(
        "\xef\xbb\xbf# of May\r\n\r\n# two rooms that\n# look alike\nrefuse 9 1\nslip 8 # a wheel\n"
        "# and\nslip 9 # again\n# the end\n");
    ASSERT_EQ(edits.size(), 3U);
    EXPECT_EQ(edits[0].comment, "two rooms that look alike");
    EXPECT_EQ(edits[1].comment, "a wheel");
    EXPECT_EQ(edits[2].comment, "and again");
    EXPECT_EQ(parse_graph_edits(text_of(edits)), edits);
}

TEST(GraphEdit, DecimalCommasAreToldAsSuch) {
    EXPECT_THAT(said_of("fix 100 10,5 3 1"),
                HasSubstr("found \"10,5\", with a decimal comma; expected a decimal point"));
}

TEST(GraphEdit, ScansBeforeAChangeAreUntouched) {
    const std::vector<std::uint64_t> keys{0, 4, 8, 12, 20};
    const auto untouched = [&](const char* before, const char* after) {
        return untouched_scans(parse_graph_edits(before), parse_graph_edits(after), keys);
    };
    constexpr auto kAll = std::numeric_limits<std::uint64_t>::max();
    EXPECT_EQ(untouched("slip 9; refuse 13 2", "refuse 13@5.5 2; slip 9 # why"), kAll);
    EXPECT_EQ(untouched("", "slip 9"), 8U);
    EXPECT_EQ(untouched("refuse 13 2; slip 20", "slip 20"), 12U);
    EXPECT_EQ(untouched("fix 13 0 0 0", "fix 13 0 0 1"), 12U);
    // A key for its own sake stays one; a scan that becomes one is a change.
    EXPECT_EQ(untouched("", "close 13 5 0 0 0"), 12U);
    EXPECT_EQ(untouched("", "wall 13 1 0 0 4 0"), 12U);
    EXPECT_EQ(untouched("point 13 1 0 4 0", "point 13 1 0 4 1"), 12U);
    EXPECT_EQ(untouched("", "close 13 6 0 0 0"), 5U);
    EXPECT_EQ(untouched("close 13 5 0 0 0", ""), 4U) << "it may have been made one by the change";
}

TEST(GraphEdit, WhatIsNoneIsRefusedWithItsPlace) {
    for (const char* text : {"open 3 1",
                             "refuse 3",
                             "refuse 3 1 2",
                             "refuse 0 1",
                             "refuse 3.5 1",
                             "refuse -3 1",
                             "refuse 3@ 1",
                             "refuse 3@x 1",
                             "refuse 3@nan 1",
                             "refuse 1e300 1",
                             "close 3 1 0 0",
                             "close 3 1 0 0 inf",
                             "close 3 1 0 0 7",
                             "fix 3 1e7 0 0",
                             "fix 3 1,5 0 0",
                             "slip",
                             "slip @3",
                             "wall 3 1 0 0 4",
                             "wall 3 1 0 0 4 0 0",
                             "wall 3 7 0 0 4 0",
                             "wall 3 1 0 0 4 nan",
                             "wall 3 1 0 0 2e8 0",
                             "wall 3 2 1 0 0 4 0",
                             "point 3 1 2 3",
                             "point 3 1 2 3 4 5",
                             "point 3 1e7 0 0 0",
                             "point 3 1 0 x 0"}) {
        EXPECT_THAT(said_of(std::string("slip 9; ") + text), HasSubstr("change 2: found")) << text;
    }
    EXPECT_THAT(said_of("refuse 3 3"), HasSubstr("expected an earlier one"));
    EXPECT_THAT(said_of("close 3 4 0 0 0"), HasSubstr("scan 3 is said to come back to scan 4"));
    EXPECT_THAT(said_of("fix 1 0 0 0"), HasSubstr("where the map begins"));
    EXPECT_THAT(said_of("refuse 5 2; slip 3; close 5 2 0 0 0"),
                HasSubstr("change 3: is of the same scans as change 1"));
    EXPECT_THAT(said_of("slip 3; slip 3"), HasSubstr("change 1"));
    EXPECT_THAT(said_of("slip 3; wall 3 1 5 5 5.05 5"),
                HasSubstr("change 2: the wall of the drawing has no direction"));
    EXPECT_THAT(said_of("wall 3 1 0 0 4 0; wall 3 1 0 9 4 9"), HasSubstr("as change 1"));
    EXPECT_THAT(said_of("point 3 1 0 4 0; point 3 1 0 9 4"), HasSubstr("as change 1"));
    EXPECT_EQ(said_of("wall 1 1 0 0 4 0; wall 1 2 0 0 0 4; point 1 0 0 1 1; point 1 0 1 1 2"), "");
    std::string many;
    for (int i = 2; i < 1100; ++i) many += "slip " + std::to_string(i) + ";";
    EXPECT_THAT(said_of(many), HasSubstr("more than 1000"));
}

/// Rounds of the ring by an odometry that turns away.
class EditedRing : public testing::Test {
  protected:
    test::Driven driven(const std::string& edits, bool loops = true, double key_m = 0.3,
                        std::ptrdiff_t left_out = 0) const {
        RegistrationParams params;
        params.key_distance_m = key_m;
        params.edits = edits;
        params.loops = loops;
        return test::drive(test::ring_walls(), {truth_.begin(), truth_.end() - left_out}, 0.01,
                           1.03, params);
    }
    double error_of(test::Driven driven) const {
        driven.registration.finish();
        return test::greatest_path_error(driven.registration.path(), truth_);
    }
    std::string closing(std::size_t scan, std::size_t earlier) const {
        return text_of(std::vector<GraphEdit>{
            {GraphEdit::Kind::close, {scan}, {earlier}, between(truth_[earlier], truth_[scan])}});
    }

    const std::vector<Pose> truth_ = test::round_tour(test::kRing, 2);
};

TEST_F(EditedRing, ALoopThatIsRefusedStaysOpen) {
    const test::Driven plain = driven("");
    ASSERT_FALSE(plain.registration.loops().empty());
    const LoopRecord first = plain.registration.loops().front();
    const std::string edits =
        text_of(std::vector<GraphEdit>{{GraphEdit::Kind::refuse, {first.scan}, {first.earlier}}});
    const test::Driven refused = driven(edits);
    EXPECT_TRUE(refused.registration.figures().edits_unmet.empty());
    for (const LoopRecord& loop : refused.registration.loops()) {
        EXPECT_GT(loop.scan, first.scan + 20) << "the same stretch, a little later";
    }
    const auto by_hand = std::ranges::find(refused.registration.refused_loops(),
                                           LoopVerdict::by_hand, &LoopRecord::verdict);
    ASSERT_NE(by_hand, refused.registration.refused_loops().end());
    EXPECT_EQ(by_hand->scan, first.scan);
    EXPECT_EQ(by_hand->earlier, first.earlier);
    EXPECT_EQ(by_hand->move_m, 0.0);
    // Up to there nothing is otherwise.
    for (std::size_t i = 0; i < first.scan; ++i) ASSERT_EQ(refused.online[i], plain.online[i]) << i;
    EXPECT_NE(refused.online[first.scan], plain.online[first.scan]);
}

TEST_F(EditedRing, ALoopIsClosedByHand) {
    const std::size_t scan = truth_.size() - 20;
    const std::size_t earlier = truth_.size() / 2 - 20;
    const double open = error_of(driven("", false));
    test::Driven closed = driven(closing(scan, earlier), false);
    ASSERT_EQ(closed.registration.loops().size(), 1U);
    const LoopRecord& loop = closed.registration.loops().front();
    EXPECT_EQ(loop.scan, scan);
    EXPECT_EQ(loop.earlier, earlier);
    EXPECT_TRUE(loop.by_hand);
    EXPECT_EQ(loop.verdict, LoopVerdict::closed);
    EXPECT_GT(loop.score, 0.5);
    EXPECT_GT(loop.move_m, 0.0);
    EXPECT_EQ(closed.corrections, 1);
    EXPECT_LT(error_of(std::move(closed)), 0.8 * open);
}

/// What a hand lays about right is laid as the scans have it, and measured there.
TEST_F(EditedRing, ALoopLaidByEyeIsFitted) {
    const test::Driven closed = driven("");
    ASSERT_FALSE(closed.registration.loops().empty());
    const LoopRecord known = closed.registration.loops().front();
    Pose near = known.pose_earlier_scan;
    near.x += 0.3;
    near.theta += 0.05;
    const LoopRecord fitted = closed.registration.fitted_loop(known.scan, known.earlier, near);
    const Pose truth = between(truth_[known.earlier], truth_[known.scan]);
    const Pose off = between(truth, fitted.pose_earlier_scan);
    EXPECT_LT(std::hypot(off.x, off.y), 0.1);
    EXPECT_GT(fitted.score, 0.5);
    EXPECT_GT(fitted.overlap, 0.5);
    EXPECT_LT(fitted.seen_through, 0.2);
}

TEST_F(EditedRing, TheGraphGoesWhereAHandPutsIt) {
    // Far beyond what the scans say: robust weights would cut it off.
    const std::size_t scan = truth_.size() - 20;
    const Pose wrong{1.0, 0.5, 0.2};
    const test::Driven closed = driven(
        text_of(std::vector<GraphEdit>{{GraphEdit::Kind::close, {scan}, {40}, wrong}}), false);
    const std::vector<Pose> path = closed.registration.path();
    const Pose seen = between(path[40], path[scan]);
    EXPECT_NEAR(seen.x, wrong.x, 0.15);
    EXPECT_NEAR(seen.y, wrong.y, 0.15);
    EXPECT_NEAR(seen.theta, wrong.theta, 0.03);
    EXPECT_GT(closed.registration.loops().front().move_m, 0.3);
}

TEST_F(EditedRing, ScansThatAreNamedBecomeKeys) {
    std::size_t scan = truth_.size() - 20;
    const test::Driven plain = driven("", false, 1.0);
    const auto is_key = [](const test::Driven& driven, std::size_t number) {
        return std::ranges::any_of(driven.registration.keys(),
                                   [&](const KeyPose& key) { return key.scan == number; });
    };
    while (is_key(plain, scan)) ++scan;
    ASSERT_LT(scan, truth_.size());
    const test::Driven closed = driven(closing(scan, 41), false, 1.0);
    EXPECT_TRUE(is_key(closed, scan));
    EXPECT_TRUE(is_key(closed, 41));
    EXPECT_EQ(closed.registration.loops().size(), 1U);
}

TEST_F(EditedRing, AScanIsHeldWhereItIsFixed) {
    const std::size_t scan = truth_.size() / 2;
    const Pose at = compose(between(truth_.front(), truth_[scan]), Pose{0.5, 0.0, 0.0});
    test::Driven fixed =
        driven(text_of(std::vector<GraphEdit>{{GraphEdit::Kind::fix, {scan}, {}, at}}), false);
    EXPECT_EQ(fixed.corrections, 1);
    const auto off = [&] {
        const Pose now = fixed.registration.path()[scan];
        return std::hypot(now.x - at.x, now.y - at.y);
    };
    EXPECT_LT(off(), 0.02);
    EXPECT_GT(fixed.registration.figures().largest_correction_m, 0.3);
    fixed.registration.finish();
    EXPECT_LT(off(), 0.04) << "the scans pull, and lose";
}

TEST_F(EditedRing, OfSeveralThatSayWhereAScanIsTheWrongOneIsTold) {
    test::Driven plain = driven("", false);
    plain.registration.finish();
    const std::size_t scan = truth_.size() - 20;
    const Pose lies = plain.registration.path()[scan];
    const GraphEdit right{GraphEdit::Kind::fix, {scan}, {}, lies};
    GraphEdit wrong = right;
    wrong.pose.x += 3.0;
    const GraphEdit loop{GraphEdit::Kind::close, {scan}, {40}, {20.0, 9.0, 0.0}};
    const auto told = [&](const std::vector<GraphEdit>& edits) {
        return driven(text_of(edits), false).registration.figures().strained_fix;
    };
    EXPECT_EQ(told({right}), std::nullopt);
    EXPECT_EQ(told({wrong}), 0U);
    EXPECT_EQ(told({right, loop}), std::nullopt) << "it is the loop that bends the map";
    EXPECT_EQ(told({loop, right}), std::nullopt);
    EXPECT_EQ(told({loop, wrong}), 1U);
}

TEST_F(EditedRing, AStepThatSlippedSaysNothing) {
    RegistrationParams params;
    params.edits = "slip 3";
    Registration registration(params);
    const std::vector<Control> ahead{{twist_between(Pose{0.3, 0.0, 0.0}, 1.0), 1.0}};
    const auto unsure = [&](std::size_t scan) {
        const Eigen::Matrix3d covariance =
            registration.add({}, scan > 0 ? ahead : std::vector<Control>()).covariance;
        return std::pair(covariance(0, 0), covariance(2, 2));
    };
    unsure(0);
    EXPECT_LT(unsure(1).first, 0.01);
    const auto [along, turn] = unsure(2);
    EXPECT_NEAR(along, 1.0, 1e-6);
    EXPECT_NEAR(turn, 1.0, 1e-6);
    EXPECT_LT(unsure(3).first, 0.01);
    EXPECT_TRUE(registration.figures().edits_unmet.empty());
}

TEST_F(EditedRing, ARobotThatStandsMayBePushed) {
    RegistrationParams params;
    params.edits = "slip 30";
    Registration registration(params);
    std::vector<Pose> path;
    for (std::size_t i = 0; i < 40; ++i) {
        // From the 30th scan on half a metre aside, of which the wheels say nothing.
        const Pose at{0.35 * static_cast<double>(std::min<std::size_t>(i, 28)), i < 29 ? 0.0 : 0.5,
                      0.0};
        std::vector<Control> controls;
        if (i > 0 && i < 29) controls.push_back({twist_between(Pose{0.35, 0.0, 0.0}, 1.0), 1.0});
        registration.add(test::drawn_scan(test::ring_walls(), at), controls);
        path = registration.path();
    }
    EXPECT_NEAR(path[28].y, 0.0, 0.03);
    EXPECT_NEAR(path[29].y, 0.5, 0.05);
    EXPECT_NEAR(path[39].y, 0.5, 0.05);
    EXPECT_TRUE(registration.figures().edits_unmet.empty());
}

TEST_F(EditedRing, AScanThatHasNotComeIsTold) {
    test::Driven driven = this->driven("slip 60; fix 99998 0 0 0", false);
    try {
        driven.registration.finish();
        ADD_FAILURE();
    } catch (const ConfigError& error) {
        EXPECT_THAT(error.what(), HasSubstr("change 2 is of another tour: it names scan 99998"));
    }
}

TEST_F(EditedRing, IsTheSameTwiceAndFromACopy) {
    const std::string edits = closing(truth_.size() - 30, 40) + "; slip 60; fix 70 4 0 0";
    test::Driven first = driven(edits);
    test::Driven second = driven(edits);
    Registration copy(first.registration);
    EXPECT_EQ(first.online, second.online);
    first.registration.finish();
    second.registration.finish();
    copy.finish();
    EXPECT_EQ(first.registration.path(), second.registration.path());
    EXPECT_EQ(first.registration.path(), copy.path());
}

TEST_F(EditedRing, WhatAChangeMakesOfTheGraphIsForeseen) {
    const auto finished = [&](const std::string& edits, bool loops) {
        test::Driven driven = this->driven(edits, loops);
        driven.registration.finish();
        return std::move(driven.registration);
    };
    // Far beyond what the scans say, so that it is known where the path goes, and goes back.
    const std::size_t scan = truth_.size() - 20;
    const Pose wrong{1.0, 0.5, 0.2};
    const std::string close =
        text_of(std::vector<GraphEdit>{{GraphEdit::Kind::close, {scan}, {40}, wrong}});
    Registration closed = finished("", false);
    const std::vector<Pose> before = closed.path();
    ASSERT_TRUE(closed.foresee(close));
    const Pose seen = between(closed.path()[40], closed.path()[scan]);
    EXPECT_NEAR(seen.x, wrong.x, 0.15);
    EXPECT_NEAR(seen.y, wrong.y, 0.15);
    ASSERT_EQ(closed.loops().size(), 1U);
    EXPECT_TRUE(closed.loops().front().by_hand);
    const std::optional<PathCorrection> correction = closed.correction();
    ASSERT_TRUE(correction);
    for (std::size_t i = 0; i < before.size(); ++i) {
        const Pose moved = compose(correction->by_scan[i], before[i]);
        EXPECT_NEAR(moved.x, closed.path()[i].x, 1e-9);
        EXPECT_NEAR(moved.y, closed.path()[i].y, 1e-9);
    }

    const std::size_t middle = truth_.size() / 2;
    Pose there = before[middle];
    there.y += 0.5;
    Registration fixed = finished("", false);
    const std::string fix =
        text_of(std::vector<GraphEdit>{{GraphEdit::Kind::fix, {middle}, {}, there}});
    ASSERT_TRUE(fixed.foresee(fix));
    EXPECT_NEAR(fixed.path()[middle].x, there.x, 0.05);
    EXPECT_NEAR(fixed.path()[middle].y, there.y, 0.05);
    const Registration made = finished(fix, false);
    EXPECT_LT(test::greatest_path_error(fixed.path(), made.path()),
              0.5 * test::greatest_path_error(before, made.path()));
}

TEST_F(EditedRing, ALoopThatIsRefusedIsForeseenOpen) {
    test::Driven plain = driven("");
    plain.registration.finish();
    const LoopRecord loop = plain.registration.loops().front();
    const auto joints = [](const Registration& registration) {
        return std::ranges::count(registration.edges(), EdgeKind::loop, &PoseEdge::kind);
    };
    const auto all = joints(plain.registration);
    const std::string refuse =
        text_of(std::vector<GraphEdit>{{GraphEdit::Kind::refuse, {loop.scan}, {loop.earlier}}});
    Registration open(plain.registration);
    ASSERT_TRUE(open.foresee(refuse));
    EXPECT_LT(joints(open), all / 2) << "the second round along the first";
    EXPECT_FALSE(std::ranges::any_of(open.loops(),
                                     [&](const LoopRecord& one) { return one.scan == loop.scan; }));
    EXPECT_TRUE(std::ranges::any_of(open.refused_loops(), [&](const LoopRecord& one) {
        return one.scan == loop.scan && one.verdict == LoopVerdict::by_hand;
    }));
    // Taken back, it is among the loops again.
    test::Driven refused = driven(refuse);
    refused.registration.finish();
    ASSERT_TRUE(refused.registration.foresee(""));
    EXPECT_TRUE(std::ranges::any_of(refused.registration.loops(), [&](const LoopRecord& one) {
        return one.scan == loop.scan && one.verdict == LoopVerdict::closed;
    }));
    // They are in the order of their scans, as those of a run are.
    for (const Registration* one : {&open, &refused.registration}) {
        EXPECT_TRUE(std::ranges::is_sorted(one->loops(), {}, &LoopRecord::scan));
        EXPECT_TRUE(std::ranges::is_sorted(one->refused_loops(), {}, &LoopRecord::scan));
    }
    // Another refusal of the same scan has kept out none of them.
    const GraphEdit other{GraphEdit::Kind::refuse, {loop.scan}, {loop.earlier + 60}};
    test::Driven two = driven(refuse + "; " + text_of(std::vector<GraphEdit>{other}));
    two.registration.finish();
    ASSERT_TRUE(two.registration.foresee(refuse));
    EXPECT_FALSE(std::ranges::any_of(two.registration.loops(),
                                     [&](const LoopRecord& one) { return one.scan == loop.scan; }));
    // Of scans that have not come nothing is foreseen, nor before there is a tour.
    const std::vector<Pose> path = plain.registration.path();
    EXPECT_FALSE(plain.registration.foresee("fix 99998 0 0 0"));
    EXPECT_EQ(plain.registration.path(), path);
    test::Driven early = driven("fix 99998 0 0 0; close 99990 3 0 0 0", false);
    EXPECT_FALSE(early.registration.foresee(""));
    EXPECT_FALSE(Registration(RegistrationParams{}).foresee("slip 3"));
    EXPECT_THROW(plain.registration.foresee("open 3"), ConfigError);
}

TEST_F(EditedRing, WhatMeetsNothingIsTold) {
    const test::Driven plain = driven("refuse 90 3; slip 60; slip 99999; fix 99998 0 0 0", false);
    EXPECT_THAT(plain.registration.figures().edits_unmet, testing::ElementsAre(0, 2, 3));
}

TEST_F(EditedRing, WhatAnotherRefusalCoversIsTold) {
    const auto refuse = [](std::uint64_t scan, std::uint64_t earlier) {
        return GraphEdit{GraphEdit::Kind::refuse, {scan}, {earlier}};
    };
    // The last find of the refused stretch is some scans before the end.
    const auto driven = [this](std::span<const GraphEdit> edits) {
        return this->driven(text_of(edits), true, 0.3, 4);
    };
    const LoopRecord first = driven({}).registration.loops().front();
    std::vector<GraphEdit> edits{refuse(first.scan, first.earlier)};
    const test::Driven alone = driven(edits);
    EXPECT_TRUE(alone.registration.figures().edits_covered.empty());
    const std::vector<LoopRecord>& refused = alone.registration.refused_loops();
    const auto last = std::ranges::find(refused.rbegin(), refused.rend(), LoopVerdict::by_hand,
                                        &LoopRecord::verdict);
    ASSERT_LT(last->scan + 1, truth_.size() - 4);
    // Where it would go on, and where there never was anything.
    edits.insert(edits.begin(), refuse(last->scan + 1, last->earlier + 1));
    edits.push_back(refuse(last->scan + 1, last->earlier + 40));
    const RegistrationFigures told = driven(edits).registration.figures();
    EXPECT_THAT(told.edits_unmet, testing::ElementsAre(0, 2));
    EXPECT_THAT(told.edits_covered, testing::ElementsAre(CoveredRefusal{0, 1}));
    EXPECT_EQ(told.by_hand->refused, 1U);
    EXPECT_EQ(told.by_hand->met_nothing, 2U);
}

TEST(GraphEdits, AnotherTourIsToldByItsStamps) {
    const auto took = [](const std::string& edits) {
        RegistrationParams params;
        params.edits = edits;
        Registration registration(params);
        const std::vector<Control> ahead{{twist_between(Pose{0.3, 0.0, 0.0}, 1.0), 1.0}};
        for (int i = 0; i < 5; ++i) {
            Scan scan = test::drawn_scan(test::ring_walls(), {0.3 * i, 0.0, 0.0});
            scan.time_s = 100.0 + i;
            registration.add(scan, i > 0 ? ahead : std::vector<Control>());
        }
    };
    took("slip 3@102; refuse 5@104.0005 2@101");
    for (const char* edits : {"slip 3@102.1", "refuse 9@200 2@101.5", "slip 2; slip 4@102"}) {
        try {
            took(edits);
            ADD_FAILURE() << edits;
        } catch (const ConfigError& error) {
            EXPECT_THAT(error.what(), HasSubstr("is of another tour")) << edits;
        }
    }
}

TEST(GraphEdits, NoneAreNoRegistration) {
    RegistrationParams params;
    params.edits = "open 3";
    EXPECT_THROW(Registration{params}, ConfigError);
}

}  // namespace
}  // namespace hitos
