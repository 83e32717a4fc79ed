// SPDX-License-Identifier: GPL-3.0-or-later
// Studies without a reference map, and the pictures of their grid maps.
#include <gmock/gmock.h>

#include <cmath>
#include <limits>

#include "hitos/services/drawing/picture_file.hpp"
#include "hitos/services/evaluation/grid_blur.hpp"
#include "hitos/services/grid/grid_builder.hpp"
#include "hitos/services/run/algoritmo.hpp"
#include "hitos/services/run/open_source.hpp"
#include "study_fixture.hpp"

namespace hitos {
namespace {

namespace fs = std::filesystem;

class StudyPicturesTest : public StudyTest {};

TEST_F(StudyPicturesTest, WithoutReferencePathsAndGridsAreMeasured) {
    Study study = this->study("out");
    study.reference.clear();
    study.parameters = {parse_study_parameter("p=2")};
    study.seeds = 2;
    EXPECT_EQ(run(study).records[0].figures["trajectory_error_m"], std::nullopt)
        << "nobody knows the truth";

    // The true path: 0.1 m a scan along x, told in a frame of its own.
    Trajectory truth;
    for (int i = 0; i <= 30; ++i) truth.push_back({0.1 * i, {5.0, 0.1 * i, 1.5}});
    study.reference_trajectory = truth;
    const StudyOutcome outcome = run(study);
    EXPECT_EQ(outcome.reused, 0U) << "another reference asks for other figures";
    EXPECT_FALSE(outcome.plan.has_reference());
    const StudyRecord& record = outcome.records[1];
    EXPECT_EQ(record.figures["error_m"], std::nullopt);
    EXPECT_EQ(record.figures["aligned_error_m"], std::nullopt);

    Configuracion configuration = study.configuration;
    configuration.filter.particles = 2;
    configuration.run.seed = 2;
    Algoritmo alone(configuration, open_source(configuration.source));
    while (alone.step()) {
    }
    // The best rotation is 90 degrees but for what noise has done; so by search, not by formula.
    const Trajectory path = alone.best_trajectory();
    double least = std::numeric_limits<double>::infinity();
    Point2 mean_path{0.0, 0.0};
    Point2 mean_truth{0.0, 0.0};
    for (std::size_t i = 0; i < path.size(); ++i) {
        mean_path = {mean_path.x + path[i].pose.x / 31.0, mean_path.y + path[i].pose.y / 31.0};
        mean_truth = {mean_truth.x + truth[i].pose.x / 31.0, mean_truth.y + truth[i].pose.y / 31.0};
    }
    for (int step = -4000; step <= 4000; ++step) {
        const Pose turn{0.0, 0.0, 1.5707963267948966 + 1e-4 * step};
        double squares = 0.0;
        for (std::size_t i = 0; i < path.size(); ++i) {
            const Point2 at =
                transform(turn, Point2{path[i].pose.x - mean_path.x, path[i].pose.y - mean_path.y});
            squares += std::pow(at.x - truth[i].pose.x + mean_truth.x, 2) +
                       std::pow(at.y - truth[i].pose.y + mean_truth.y, 2);
        }
        least = std::min(least, std::sqrt(squares / 31.0));
    }
    ASSERT_TRUE(record.figures["trajectory_error_m"].has_value());
    EXPECT_NEAR(*record.figures["trajectory_error_m"], least, 1e-6);
    EXPECT_NEAR(*record.figures["odometry_error_m"], 0.0, 1e-9) << "its odometry is perfect";
    EXPECT_EQ(record.figures["blur_m2"],
              grid_blur_m2(build_grid(configuration.grid, alone.reader(), path)));
    EXPECT_EQ(record.figures["lines"], alone.filter().best_count(FeatureKind::line));
    EXPECT_TRUE(fs::exists(folder_ / "out" / "blur.dat"));
    EXPECT_FALSE(fs::exists(folder_ / "out" / "contact-sheet.png"));
}

TEST_F(StudyPicturesTest, PicturesAreTheSameForAnyThreadsShardsAndStops) {
    const auto pictured = [&](const std::string& out) {
        Study study = this->study(out);
        study.pictures = StudyPictures::first;
        study.seeds = 2;
        return study;
    };
    EXPECT_EQ(run(pictured("one")).picture_problem.english(), "");
    const auto expected = files("one");
    EXPECT_EQ(expected.count("contact-sheet.png"), 1U);
    EXPECT_EQ(expected.count("pictures/dmax-0.02-p-2-s1.png"), 1U);
    EXPECT_EQ(expected.count("pictures/dmax-0.02-p-2-s2.png"), 0U) << "the first seed alone";
    const Grid::Picture sheet = read_grey_picture(folder_ / "one" / "contact-sheet.png");
    EXPECT_GT(sheet.width, 400) << "two values of p stand side by side";
    EXPECT_GT(sheet.height, 300) << "and two of dmax below each other";

    StudyOptions two_threads;
    two_threads.threads = 2;
    run(pictured("two"), two_threads);
    EXPECT_EQ(files("two"), expected);
    std::vector<StudyLayout> layouts;
    for (int i = 1; i <= 2; ++i) {
        StudyOptions shard;
        shard.shard = {i, 2};
        run(pictured("shard" + std::to_string(i)), shard);
        layouts.push_back(study_in_folder(folder_ / ("shard" + std::to_string(i))));
    }
    EXPECT_EQ(merge_study(study_in_folder(folder_ / "merged"), layouts).picture_problem.english(),
              "");
    EXPECT_EQ(files("merged"), expected);
    // Begun without pictures: then no run has drawn its grid, and all are done again.
    Study without = pictured("later");
    without.pictures = StudyPictures::none;
    run(without);
    EXPECT_EQ(run(pictured("later")).reused, 0U);
    EXPECT_EQ(files("later"), expected);
}

TEST_F(StudyPicturesTest, OnlyRunsWhosePicturesAreMissingAreDoneAgainForThem) {
    Study study = this->study("out");
    study.reference.clear();  // so that every run draws its grid anyway
    run(study);
    study.pictures = StudyPictures::first;
    EXPECT_EQ(run(study).computed, 4U);
    const auto expected = files("out");
    fs::remove(folder_ / "out" / "runs" / "dmax-0.02-p-2-s1.png");
    folder_.put("out/runs/dmax-0.05-p-2-s1.tum", "0 0 0 0 0 0 0 1\n");
    EXPECT_EQ(run(study).computed, 2U);
    EXPECT_EQ(files("out"), expected);
    study.pictures = StudyPictures::all;
    EXPECT_EQ(run(study).computed, 8U);
    EXPECT_EQ(files("out").count("pictures/dmax-0.05-p-3-s3.png"), 1U);
    study.pictures = StudyPictures::none;
    EXPECT_EQ(run(study).computed, 0U);
    EXPECT_EQ(files("out").count("contact-sheet.png"), 0U);
    EXPECT_EQ(files("out").count("pictures/dmax-0.05-p-3-s3.png"), 0U);
}

}  // namespace
}  // namespace hitos
