// SPDX-License-Identifier: GPL-3.0-or-later
#include "hitos/services/drawing/paths_picture.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <opencv2/core.hpp>
#include <opencv2/imgcodecs.hpp>

#include "support.hpp"

namespace hitos {
namespace {

using test::content;
using test::TempFolder;
using ::testing::HasSubstr;

TEST(InFrameOfRun, MovesTheReferenceToTheRunsFirstPose) {
    // A reference that faces north at (5, 1) when the run begins, and drives 2 m on.
    const Trajectory reference = {{8.0, {5.0, -3.0, kPi / 2.0}},
                                  {10.01, {5.0, 1.0, kPi / 2.0}},
                                  {11.0, {5.0, 3.0, kPi}},
                                  {30.0, {0.0, 0.0, 0.0}}};
    const Trajectory run = {{10.0, {}}, {11.0, {}}};
    const Trajectory moved = in_frame_of_run(reference, run);
    ASSERT_EQ(moved.size(), 2U) << "what lies before and after the run is left out";
    EXPECT_NEAR(moved[0].pose.x, 0.0, 1e-12);
    EXPECT_NEAR(moved[0].pose.theta, 0.0, 1e-12);
    EXPECT_NEAR(moved[1].pose.x, 2.0, 1e-12);
    EXPECT_NEAR(moved[1].pose.y, 0.0, 1e-12);
    EXPECT_NEAR(moved[1].pose.theta, kPi / 2.0, 1e-12);
    // A run whose first scan comes after some driving.
    const Trajectory later = in_frame_of_run(reference, {{10.0, {1.0, 0.5, kPi}}, {11.0, {}}});
    EXPECT_NEAR(later[0].pose.x, 1.0, 1e-12);
    EXPECT_NEAR(later[1].pose.x, -1.0, 1e-12);
    EXPECT_NEAR(later[1].pose.y, 0.5, 1e-12);
    // A run behind another one, of which the reference does not tell.
    const Trajectory second =
        in_frame_of_run(reference, {{-9000.0, {}}, {10.0, {3.0, 0.0, 0.0}, true}, {11.0, {}}});
    ASSERT_EQ(second.size(), 2U);
    EXPECT_NEAR(second[0].pose.x, 3.0, 1e-12);
    EXPECT_TRUE(in_frame_of_run(reference, {{20.0, {}}}).empty());
    EXPECT_TRUE(in_frame_of_run({}, run).empty());
    EXPECT_TRUE(in_frame_of_run(reference, {}).empty());
}

Trajectory row(double y) {
    Trajectory path;
    for (int i = 0; i <= 20; ++i) path.push_back({0.1 * i, {0.5 * i, y, 0.0}});
    return path;
}

/// The columns and rows over which pixels of a colour (red, green, blue) reach in the picture.
cv::Rect reach(const cv::Mat& image, const cv::Vec3b& rgb) {
    cv::Mat mask;
    const cv::Scalar colour(rgb[2], rgb[1], rgb[0]);
    cv::inRange(image, colour, colour, mask);
    // The legend's sample lies below the axes.
    int left = image.cols;
    int right = -1;
    int top = image.rows;
    int bottom = -1;
    for (int y = 0; y < image.rows * 3 / 4; ++y) {
        for (int x = 0; x < image.cols; ++x) {
            if (mask.at<std::uint8_t>(y, x) == 0) continue;
            left = std::min(left, x);
            right = std::max(right, x);
            top = std::min(top, y);
            bottom = std::max(bottom, y);
        }
    }
    return right < 0 ? cv::Rect() : cv::Rect(left, top, right - left + 1, bottom - top + 1);
}

TEST(PathsPicture, ShowsTheThreePathsAndTheMapOnEqualAxes) {
    const TempFolder folder;
    PathsPicture picture;
    picture.truth = row(0.0);
    picture.odometry = row(2.0);
    picture.estimate = row(-2.0);
    picture.map = {{Recta{4.0, kPi / 2.0}}, {Esquina{5.0, 4.5}}};
    // Ten metres up and down for the scale of y; the paths are ten metres along x.
    picture.segments = {{0, {5.0, -5.0}, {5.0, 5.0}, 10}};
    const std::string failure = write_paths_picture(picture, folder.path()).english();
    if (failure.find("not installed") != std::string::npos) GTEST_SKIP() << failure;
    ASSERT_EQ(failure, "");
    const cv::Mat image = cv::imread((folder / "paths.png").string(), cv::IMREAD_COLOR);
    ASSERT_FALSE(image.empty());
    const cv::Rect truth = reach(image, {0, 0, 255});
    const cv::Rect odometry = reach(image, {255, 0, 255});
    const cv::Rect segment = reach(image, {0x1a, 0x96, 0x41});
    ASSERT_GT(truth.width, 200);
    EXPECT_LT(odometry.y, truth.y) << "y grows upwards";
    EXPECT_NEAR(truth.width, odometry.width, 4);
    EXPECT_GT(segment.height, 200);
    EXPECT_NEAR(segment.x - truth.x, truth.width / 2.0, 6.0);
    // Equal axes: two metres of y between odometry and truth against ten metres of x.
    EXPECT_NEAR(5.0 * (truth.y - odometry.y), truth.width, 0.03 * truth.width);
    const std::string script = content(folder / "paths.gp");
    for (const char* word : {"reference", "odometry", "estimated path", "segments", "corners"}) {
        EXPECT_THAT(script, HasSubstr(word));
    }
    EXPECT_THAT(script, ::testing::Not(HasSubstr("true walls")));
}

TEST(PathsPicture, IsRemovedWhereThereIsNoTruth) {
    const TempFolder folder;
    folder.put("paths.png", "old");
    EXPECT_THAT(write_paths_picture({}, folder.path()).english(),
                HasSubstr("no pose of the reference"));
    EXPECT_FALSE(std::filesystem::exists(folder / "paths.png"));
}

}  // namespace
}  // namespace hitos
