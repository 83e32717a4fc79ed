#include "tour_picture.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <cmath>
#include <opencv2/core.hpp>
#include <opencv2/imgcodecs.hpp>
#include <opencv2/imgproc.hpp>
#include <string>
#include <vector>

#include "hitos/base/atomic_file.hpp"
#include "hitos/base/error.hpp"
#include "hitos/services/drawing/scale_bar.hpp"
#include "hitos/simulation/worlds/odometry_noise.hpp"

namespace hitos {
namespace {

constexpr double kLongestSide = 1400.0;    // pixels
constexpr double kMostPixelsPerM = 100.0;  // for small rooms
constexpr int kMargin = 30;                // pixels around everything
constexpr int kFooter = 50;                // pixels below for bar and legend
constexpr int kShift = 4;                  // OpenCV's fixed point: sixteenths of a pixel
constexpr double kFontScale = 0.45;

// OpenCV's order: blue, green, red.
const cv::Scalar kBlack(0, 0, 0);
const cv::Scalar kRed(40, 40, 220);
const cv::Scalar kGrey(170, 170, 170);
const cv::Scalar kBlue(200, 90, 20);
const cv::Scalar kGreen(0, 150, 0);

class Canvas {
  public:
    Canvas(const Point2& low, const Point2& high) : low_(low) {
        const double width = std::max(high.x - low.x, 0.1);
        const double height = std::max(high.y - low.y, 0.1);
        pixels_per_m_ = std::min(kLongestSide / std::max(width, height), kMostPixelsPerM);
        drawn_height_ = height * pixels_per_m_;
        constexpr double kLeastWidth = 560.0;  // of the legend
        image_ =
            cv::Mat(static_cast<int>(drawn_height_) + 2 * kMargin + kFooter,
                    static_cast<int>(std::max(width * pixels_per_m_, kLeastWidth)) + 2 * kMargin,
                    CV_8UC3, cv::Scalar::all(255));
    }

    cv::Mat& image() { return image_; }
    double pixels_per_m() const { return pixels_per_m_; }

    cv::Point at(const Point2& world) const {
        const double x = kMargin + (world.x - low_.x) * pixels_per_m_;
        const double y = kMargin + drawn_height_ - (world.y - low_.y) * pixels_per_m_;
        return {static_cast<int>(std::lround(x * (1 << kShift))),
                static_cast<int>(std::lround(y * (1 << kShift)))};
    }
    void line(const Point2& a, const Point2& b, const cv::Scalar& colour, int width) {
        cv::line(image_, at(a), at(b), colour, width, cv::LINE_AA, kShift);
    }
    void path(const std::vector<Point2>& points, const cv::Scalar& colour, int width) {
        for (std::size_t i = 1; i < points.size(); ++i)
            line(points[i - 1], points[i], colour, width);
    }
    void disc(const Point2& point, int radius, const cv::Scalar& colour, int thickness) {
        cv::circle(image_, at(point), radius << kShift, colour, thickness, cv::LINE_AA, kShift);
    }
    void words(const std::string& text, int x, int y, const cv::Scalar& colour) {
        cv::putText(image_, text, {x, y}, cv::FONT_HERSHEY_SIMPLEX, kFontScale, colour, 1,
                    cv::LINE_AA);
    }

  private:
    Point2 low_;
    double pixels_per_m_ = 1.0;
    double drawn_height_ = 0.0;
    cv::Mat image_;
};

std::vector<Point2> true_path(const SimulatedTour& tour) {
    std::vector<Point2> points;
    for (const Pose& pose : tour.path().poses()) points.push_back({pose.x, pose.y});
    return points;
}

std::vector<Point2> odometry_path(const SimulatedTour& tour) {
    const World& world = tour.world();
    OdometryNoise noise(world.odometry.noise, world.odometry.noise_kind, world.seed);
    std::vector<Point2> points;
    Pose pose = world.tour.start;
    for (std::uint64_t k = 0; k < tour.readings(); ++k) {
        const Odometria reading = noise(tour.true_reading(k));
        if (k > 0) pose = compose(pose, displacement(reading.twist, 1.0 / world.odometry.rate_hz));
        points.push_back({pose.x, pose.y});
    }
    return points;
}

void draw_footer(Canvas& canvas, const SimulatedTour& tour) {
    const int y = canvas.image().rows - kFooter + 10;
    // The odometry may have run off into it.
    cv::rectangle(canvas.image(), cv::Rect(0, y - 15, canvas.image().cols, kFooter + 5),
                  cv::Scalar::all(255), cv::FILLED);
    const double length_m = round_length(160.0 / canvas.pixels_per_m());
    const int length = static_cast<int>(std::lround(length_m * canvas.pixels_per_m()));
    cv::rectangle(canvas.image(), cv::Rect(kMargin, y + 10, length, 5), kBlack, cv::FILLED);
    canvas.words(fmt::format("{:g} m", length_m), kMargin, y + 4, kBlack);
    const int x = kMargin + 190;
    canvas.words(fmt::format("{}: {:.0f} m in {:.0f} s", tour.world().name, tour.path().length_m(),
                             tour.path().duration_s()),
                 x, y + 4, kBlack);
    canvas.words("true path", x, y + 24, kRed);
    canvas.words("odometry", x + 90, y + 24, kGrey * 0.8);
    canvas.words("way points", x + 180, y + 24, kBlue);
    canvas.words("start", x + 280, y + 24, kGreen);
}

void draw_way_points(Canvas& canvas, const World& world) {
    int number = 0;
    for (const WayPoint& point : world.tour.way_points) {
        ++number;
        canvas.disc(point.at, 4, kBlue, 1);
        // Way points that are passed twice stand one beside the other.
        int before = 0;
        for (int i = 0; i < number - 1; ++i) {
            const Point2& other = world.tour.way_points[static_cast<std::size_t>(i)].at;
            if (std::hypot(other.x - point.at.x, other.y - point.at.y) < 0.6) ++before;
        }
        const cv::Point at = canvas.at(point.at);
        canvas.words(std::to_string(number), (at.x >> kShift) + 6 + 20 * before,
                     (at.y >> kShift) - 6, kBlue);
    }
}

cv::Mat drawn(const SimulatedTour& tour) {
    const World& world = tour.world();
    const std::vector<Point2> truth = true_path(tour);
    const std::vector<Point2> odometry = odometry_path(tour);
    // The odometry may run far off: it is cut where walls and path end.
    Bounds bounds;
    for (const WallSegment& wall : world.walls) {
        bounds.hold(wall.a);
        bounds.hold(wall.b);
    }
    for (const Point2& point : truth) bounds.hold(point);

    Canvas canvas(bounds.low, bounds.high);
    canvas.path(odometry, kGrey, 1);
    for (const WallSegment& wall : world.walls) canvas.line(wall.a, wall.b, kBlack, 3);
    canvas.path(truth, kRed, 1);
    draw_way_points(canvas, world);
    const Pose& start = world.tour.start;
    const Point2 ahead = transform(start, Point2{25.0 / canvas.pixels_per_m(), 0.0});
    canvas.disc({start.x, start.y}, 6, kGreen, cv::FILLED);
    canvas.line({start.x, start.y}, ahead, kGreen, 3);
    draw_footer(canvas, tour);
    return canvas.image();
}

}  // namespace

void write_tour_picture(const SimulatedTour& tour, const std::filesystem::path& path) {
    std::string extension = path.extension().string();
    std::ranges::transform(extension, extension.begin(),
                           [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
    if (extension != ".png" && extension != ".jpg" && extension != ".jpeg") {
        throw FileError(
            path.string(),
            HITOS_TEXT("Errors",
                       "found the extension \"%1\"; pictures are written as .png, .jpg or .jpeg"),
            path.extension().string());
    }
    std::vector<std::uint8_t> bytes;
    if (!cv::imencode(extension, drawn(tour), bytes)) {
        throw FileError(path.string(), HITOS_TEXT("Errors", "the picture could not be encoded"));
    }
    write_file(path, std::string(bytes.begin(), bytes.end()));
}

}  // namespace hitos
