// SPDX-License-Identifier: GPL-3.0-or-later
#include "hitos/services/evaluation/quality.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <random>
#include <string>
#include <string_view>
#include <vector>

#include "hitos/capture/tour_reader.hpp"

namespace hitos {
namespace {

/// A tour of given scans that says of itself what the test says.
class JudgedTour final : public TourReader {
  public:
    std::vector<Scan> scans;
    ReadReport read;

    std::optional<Scan> next_scan() override {
        return next_ < scans.size() ? std::optional(scans[next_++]) : std::nullopt;
    }
    std::optional<Odometria> next_odometry() override { return std::nullopt; }
    void restart() override { next_ = 0; }
    std::unique_ptr<TourReader> reopen() const override {
        auto tour = std::make_unique<JudgedTour>(*this);
        tour->restart();
        return tour;
    }
    const ReadReport& report() const override { return read; }
    std::optional<double> progress() const override { return std::nullopt; }
    std::string name() const override { return "judged"; }
    std::string format() const override { return "given"; }
    ReadOptions options() const override { return {}; }

  private:
    std::size_t next_ = 0;
};

Walls judged_ring(const std::vector<Point2>& corners) {
    Walls walls;
    for (std::size_t i = 0; i < corners.size(); ++i) {
        walls.emplace_back(corners[i], corners[(i + 1) % corners.size()]);
    }
    return walls;
}

/// A hall of 30 m x 12 m that is unlike itself wherever it is shifted or turned.
Walls judged_hall() {
    return judged_ring({{-4, -5}, {2, -5},  {2, -4},  {5, -4}, {5, -5}, {17, -5}, {17, -3},
                        {21, -3}, {21, -5}, {26, -5}, {26, 3}, {24, 7}, {11, 7},  {11, 5.5},
                        {9, 5.5}, {9, 7},   {1, 7},   {1, 4},  {-2, 4}, {-2, 7},  {-4, 7}});
}

/// 121 rays over half a turn, of 5 mm noise.
Scan judged_scan(const Walls& walls, const Pose& pose, std::mt19937& engine) {
    std::normal_distribution<double> noise(0.0, 0.005);
    Scan scan;
    scan.fan = {-kPi / 2.0, kPi / 2.0, 121, 40.0, {}};
    scan.run_starts = {0};
    for (std::uint32_t ray = 0; ray < scan.fan.count; ++ray) {
        const double angle = scan.fan.angle_rad(ray);
        const double c = std::cos(pose.theta + angle);
        const double s = std::sin(pose.theta + angle);
        double nearest = scan.fan.max_range_m;
        for (const auto& [a, b] : walls) {
            const double det = s * (b.x - a.x) - c * (b.y - a.y);
            const double t = ((a.y - pose.y) * (b.x - a.x) - (a.x - pose.x) * (b.y - a.y)) / det;
            const double u = (c * (a.y - pose.y) - s * (a.x - pose.x)) / det;
            if (t > 0.0 && u >= 0.0 && u <= 1.0) nearest = std::min(nearest, t);
        }
        if (nearest == scan.fan.max_range_m) continue;
        const double range = nearest + noise(engine);
        scan.points.push_back({range * std::cos(angle), range * std::sin(angle)});
        scan.rays.push_back(ray);
    }
    return scan;
}

/// A run as far as it is judged.
class JudgedRun {
  public:
    explicit JudgedRun(const RegistrationParams& params = {}) : registration(params) {}

    /// A scan from `truth`, or a blind one, after a step as the odometry has it.
    void add(const Walls& walls, const Pose& truth, const Pose& step, bool blind = false) {
        add(blind ? Scan{} : judged_scan(walls, truth, engine), step);
    }
    void add(Scan scan, const Pose& step) {
        at_ = compose(at_, step);
        scan.time_s = static_cast<double>(tour.scans.size());
        odometry.push_back({scan.time_s, at_});
        registration.add(scan, std::vector<Control>{{twist_between(step, 1.0), 1.0}});
        tour.scans.push_back(std::move(scan));
    }
    /// Straight on from `from`, half a metre a step.
    void ahead(const Walls& walls, const Pose& from, int steps) {
        for (int i = 0; i < steps; ++i) add(walls, compose(from, {0.5 * i, 0.0, 0.0}), kHalf);
    }
    /// That the odometry's own path is so many times as long.
    void stretch(double scale) {
        for (StampedPose& pose : odometry)
            pose.pose = {scale * pose.pose.x, scale * pose.pose.y, 0.0};
    }
    RunEvidence evidence(bool registered = true) const {
        return {configuration, tour, odometry, registered ? &registration : nullptr};
    }

    static constexpr Pose kHalf{0.5, 0.0, 0.0};
    Configuracion configuration;
    JudgedTour tour;
    Trajectory odometry;
    Registration registration;
    std::mt19937 engine{5};

  private:
    Pose at_;
};

/// The figure of the warning with these words; nothing where there is none.
std::optional<std::string> told_figure(const std::vector<Advice>& told, std::string_view words) {
    const auto found = std::ranges::find_if(told, [words](const Advice& advice) {
        return advice.text.find(words) != std::string_view::npos;
    });
    return found == told.end() ? std::nullopt : std::optional(found->figure);
}

std::optional<std::string> told_figure(const JudgedRun& run, std::string_view words) {
    return told_figure(warnings(run.evidence()), words);
}

constexpr std::string_view kEarly = "before the first odometry reading";
constexpr std::string_view kNeverMoves = "never moves";
constexpr std::string_view kJumps = "jumps from one scan to the next";
constexpr std::string_view kScale = "its scale is wrong";
constexpr std::string_view kUnmatched = "fitted nothing that was seen before";
constexpr std::string_view kBreak = "does not follow on what was seen just before";
constexpr std::string_view kBadly = "lie badly on each other";
constexpr std::string_view kMoved = "A loop moved the path";
constexpr std::string_view kNoLoop = "No loop was closed";
constexpr std::string_view kCrisp = "less crisp";

TEST(QualityWarnings, AGoodTourHasNone) {
    JudgedRun run;
    run.ahead(judged_hall(), {}, 25);
    EXPECT_TRUE(warnings(run.evidence()).empty());
}

TEST(QualityWarnings, OfTwoScansBeforeTheOdometryAndNotOfOne) {
    JudgedRun run;
    run.tour.read.early_scans = 1;
    EXPECT_FALSE(told_figure(run, kEarly));
    run.tour.read.early_scans = 2;
    EXPECT_EQ(told_figure(run, kEarly), "2");
}

TEST(QualityWarnings, OfOdometryThatNeverMovesWhereItIsRead) {
    JudgedRun run;
    run.odometry = {{0.0, {}}, {1.0, {}}, {2.0, {}}};
    EXPECT_EQ(told_figure(run, kNeverMoves), "3");
    run.configuration.filter.motion.model = "no-odometry";
    EXPECT_FALSE(told_figure(run, kNeverMoves));
    run.configuration.filter.motion.model = "odometry";
    run.odometry[2].pose.theta = 0.1;
    EXPECT_FALSE(told_figure(run, kNeverMoves));
    run.odometry.resize(1);
    EXPECT_FALSE(told_figure(run, kNeverMoves));
}

TEST(QualityWarnings, OfTheLongestJumpOfTheOdometry) {
    JudgedRun run;
    run.odometry = {{0.0, {}}, {1.0, {11.0, 0.0, 0.0}}, {2.0, {11.0, -12.0, 0.0}}, {3.0, {}}};
    run.odometry[3].pose = {11.0, -13.0, 0.0};
    EXPECT_EQ(told_figure(run, kJumps), "2 → 3, 12 m");
    run.odometry = {{0.0, {}}, {1.0, {9.9, 0.0, 0.0}}};
    EXPECT_FALSE(told_figure(run, kJumps));
}

TEST(QualityWarnings, OfAnOdometryThatIsTooLongOrTooShort) {
    JudgedRun run;
    run.ahead(judged_hall(), {}, 25);
    const Trajectory right = run.odometry;
    const auto told_of = [&](double scale) {
        run.odometry = right;
        run.stretch(scale);
        return told_figure(run, kScale);
    };
    EXPECT_EQ(told_of(1.3), "1.30");
    EXPECT_EQ(told_of(0.7), "0.70");
    EXPECT_FALSE(told_of(1.1));
    EXPECT_FALSE(told_of(0.9));
    EXPECT_FALSE(told_of(0.0)) << "that it never moves says it all";
}

TEST(QualityWarnings, AFewMetresHaveNoScale) {
    JudgedRun run;
    run.ahead(judged_hall(), {}, 18);
    run.stretch(1.3);
    EXPECT_FALSE(told_figure(run, kScale));
}

TEST(QualityWarnings, OfManyScansThatFitNothingElseOfThePlaceOfOne) {
    const Walls hall = judged_hall();
    const auto with_blind = [&](int blind, int scans) {
        JudgedRun run;
        for (int i = 0; i < scans; ++i) {
            run.add(hall, {0.2 * i, 0.0, 0.0}, {0.2, 0.0, 0.0}, i == blind);
        }
        return warnings(run.evidence());
    };
    const std::vector<Advice> many = with_blind(12, 31);  // the first is matched with nothing
    EXPECT_EQ(told_figure(many, kUnmatched), "3 %");
    EXPECT_FALSE(told_figure(many, kBreak)) << "said already";
    const std::vector<Advice> one = with_blind(12, 71);
    EXPECT_FALSE(told_figure(one, kUnmatched));
    EXPECT_EQ(told_figure(one, kBreak), "13");
    const std::vector<Advice> none = with_blind(-1, 31);
    EXPECT_FALSE(told_figure(none, kUnmatched));
    EXPECT_FALSE(told_figure(none, kBreak));
}

TEST(QualityWarnings, OfScansThatLieBadlyOnEachOther) {
    // Of `stray` tenths of the rays each scan tells another range.
    const auto with_strays = [](int stray) {
        RegistrationParams params;
        params.key_scans = 2;  // of many strays some are always near
        JudgedRun run(params);
        std::uniform_real_distribution<double> factor(0.2, 0.8);
        for (int i = 0; i < 20; ++i) {
            Scan scan = judged_scan(judged_hall(), {0.4 * i, 0.0, 0.0}, run.engine);
            for (std::size_t k = 0; k < scan.points.size(); ++k) {
                if (static_cast<int>(k % 10) >= stray) continue;
                const double f = factor(run.engine);
                scan.points[k] = {f * scan.points[k].x, f * scan.points[k].y};
            }
            run.add(scan, {0.4, 0.0, 0.0});
        }
        return told_figure(run, kBadly);
    };
    EXPECT_TRUE(with_strays(7));
    EXPECT_FALSE(with_strays(2));
}

/// Halfway the robot is carried back to where it began, unseen; the odometry makes `off` metres of
/// it. Then it drives the hall once more.
std::optional<std::string> told_of_carried(double off) {
    RegistrationParams params;
    params.odometry_scale = 6.0;  // unsure enough for the loop to be looked for
    JudgedRun run(params);
    const Walls hall = judged_hall();
    run.ahead(hall, {}, 20);
    const double back = (9.5 - off) / 16.0;
    for (int i = 0; i < 16; ++i) run.add(hall, {}, {0.5, 0.0, 0.0}, true);
    for (int i = 0; i < 16; ++i) run.add(hall, {}, {-0.5 - back, 0.0, 0.0}, true);
    run.ahead(hall, {0.5, 0.0, 0.0}, 24);
    EXPECT_FALSE(run.registration.loops().empty()) << off;
    return told_figure(run, kMoved);
}

TEST(QualityWarnings, OfALoopThatMovedThePathFar) {
    EXPECT_TRUE(told_of_carried(6.5));
    EXPECT_FALSE(told_of_carried(3.0));
}

/// Of so many scans in a hall, whose graph somebody has changed.
std::optional<std::string> told_of_edits(const char* edits, int scans, std::string_view words) {
    RegistrationParams params;
    params.edits = edits;
    JudgedRun run(params);
    run.ahead(judged_hall(), {}, scans);
    return told_figure(run, words);
}

TEST(QualityWarnings, OfAnchorsThatContradictOrSayNothing) {
    const auto told = [](const char* edits, std::string_view words) {
        return told_of_edits(edits, 10, words);
    };
    constexpr std::string_view kLoose = "do not say where the drawing lies";
    constexpr std::string_view kOff = "contradict each other";
    EXPECT_EQ(told("slip 3; point 5 1 0 7 7", kLoose), "2");
    const char* good = "point 5 1 0 7 7; point 5 2 0 8 7";
    EXPECT_FALSE(told(good, kLoose));
    EXPECT_FALSE(told(good, kOff));
    EXPECT_EQ(told("point 5 1 0 7 7; point 5 2 0 10 7", kOff), "1, 2");
}

TEST(QualityWarnings, OfPlacesThatWereFixedWrongly) {
    const auto told_of = [](const char* edits, std::string_view words) {
        return told_of_edits(edits, 40, words);
    };
    constexpr std::string_view kFixed = "A place fixed by hand bends the map";
    EXPECT_FALSE(told_of("slip 3; fix 11 5 0 0", kFixed)) << "where it was";
    EXPECT_EQ(told_of("slip 3; fix 11 9 0 0", kFixed), "2");
    EXPECT_EQ(told_of("fix 11 5 0 0; fix 21 10 0 1", kFixed), "2");
    EXPECT_EQ(told_of("fix 11 9 0 0; fix 21 10 0 0", kFixed), "1") << "which pulls the other off";
    EXPECT_EQ(told_of("fix 40 40 0 0", kFixed), "1");
    EXPECT_FALSE(told_of("fix 40 40 0 0", kScale)) << "the odometry bent nothing";
}

/// 2.3 times round a ring of corridors, 48 m each time; one scan is blind.
std::vector<Advice> told_of_ring(bool loops) {
    Walls walls = judged_ring({{-1, -1},
                               {4, -1},
                               {4, -2},
                               {6, -2},
                               {6, -1},
                               {15, -1},
                               {15, 4},
                               {16.5, 4},
                               {16.5, 5},
                               {15, 5},
                               {15, 11},
                               {3, 11},
                               {3, 11.8},
                               {2, 11.8},
                               {2, 11},
                               {-1, 11}});
    const Walls block = judged_ring({{1, 1},
                                     {13, 1},
                                     {13, 3},
                                     {12.2, 3},
                                     {12.2, 5},
                                     {13, 5},
                                     {13, 9},
                                     {1, 9},
                                     {1, 6},
                                     {1.7, 6},
                                     {1.7, 5},
                                     {1, 5}});
    walls.insert(walls.end(), block.begin(), block.end());
    RegistrationParams params;
    params.loops = loops;
    JudgedRun run(params);
    Pose at;
    for (int leg = 0; leg < 10; ++leg) {
        const int steps = leg % 2 == 0 ? 28 : 20;
        for (int i = 0; i < steps + 5; ++i) {
            const Pose step = i < steps ? Pose{0.5, 0.0, 0.0} : Pose{0.0, 0.0, kPi / 10.0};
            at = compose(at, step);
            run.add(walls, at, step, leg == 0 && i == 20);
        }
    }
    return warnings(run.evidence());
}

TEST(QualityWarnings, ALoopTellsWhetherALongPathIsBentAndJoinsWhatABreakParted) {
    const std::vector<Advice> open = told_of_ring(false);
    EXPECT_EQ(told_figure(open, kNoLoop), "120 m");
    EXPECT_EQ(told_figure(open, kBreak), "21");
    const std::vector<Advice> closed = told_of_ring(true);
    EXPECT_FALSE(told_figure(closed, kNoLoop));
    EXPECT_FALSE(told_figure(closed, kBreak));
}

TEST(Quality, WhatNobodyWaitedForIsNotKnown) {
    JudgedRun run;
    run.ahead(judged_hall(), {}, 20);
    const RunEvidence evidence = run.evidence(false);
    const RunQuality whole = judge(evidence, run.odometry);
    EXPECT_GT(whole.cells_per_point.value_or(0.0), 0.0);
    EXPECT_FALSE(whole.findings) << "nothing examined it";
    const RunQuality cut = judge(evidence, run.odometry, [] { return true; });
    EXPECT_FALSE(cut.cells_per_point || cut.odometry_cells_per_point);
}

TEST(Quality, NobodyIsToldToDoWhatTheRunDoes) {
    TourFinding finding;
    finding.remedies.resize(2);
    finding.remedies.front().registration = true;
    RunQuality plain;
    take_findings({finding}, plain);
    EXPECT_EQ(plain.findings.value().front().remedies.size(), 2U);
    RunQuality registered;
    registered.registration.emplace();
    take_findings({finding}, registered);
    EXPECT_EQ(registered.findings.value().front().remedies.size(), 1U);
}

TEST(Quality, OfAMapThatIsLessCrispThanTheOdometrys) {
    JudgedRun run;
    run.ahead(judged_hall(), {}, 20);
    const auto told_of = [&](const Trajectory& path, bool registered) {
        return judge(run.evidence(registered), path).warnings;
    };
    Trajectory bent = run.odometry;
    for (StampedPose& pose : bent) {
        pose.pose.theta = (static_cast<int>(pose.time_s) % 2 == 0 ? 0.05 : -0.05);
    }
    const std::vector<Advice> told = told_of(bent, false);
    ASSERT_TRUE(told_figure(told, kCrisp));
    EXPECT_GT(std::stod(*told_figure(told, kCrisp)), 1.05);
    EXPECT_EQ(told.back().preset, "recorded");
    EXPECT_EQ(told_of(bent, true).back().preset, "") << "it is with registration already";
    EXPECT_FALSE(told_figure(told_of(run.odometry, false), kCrisp));
    // Beside the right odometry by centimetres it is less crisp too, and no worse.
    Trajectory beside = run.odometry;
    for (StampedPose& pose : beside)
        pose.pose.y += static_cast<int>(pose.time_s) % 2 == 0 ? 0.06 : -0.06;
    const RunQuality quality = judge(run.evidence(false), beside);
    EXPECT_GT(*quality.cells_per_point, 1.05 * *quality.odometry_cells_per_point);
    EXPECT_FALSE(told_figure(quality.warnings, kCrisp));
    // Where the odometry is the bent one.
    std::swap(run.odometry, bent);
    EXPECT_FALSE(told_figure(told_of(bent, false), kCrisp));
}

}  // namespace
}  // namespace hitos
