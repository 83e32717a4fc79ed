#include "hitos/services/maps/picture_file.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <cmath>
#include <opencv2/core.hpp>
#include <opencv2/imgcodecs.hpp>
#include <opencv2/imgproc.hpp>

#include "hitos/base/atomic_file.hpp"
#include "hitos/base/error.hpp"
#include "hitos/services/maps/scale_bar.hpp"

namespace hitos {
namespace {

constexpr std::int64_t kMostPixels = std::int64_t{1} << 30;  // what OpenCV reads back by default
constexpr int kLongestJpegSide = 65500;                      // the limit of libjpeg

// OpenCV's order: blue, green, red.
const cv::Scalar kRed(0, 0, 255);
const cv::Scalar kGreen(0, 160, 0);
const cv::Scalar kBlue(255, 64, 0);

std::string lower(std::string_view text) {
    std::string out(text);
    for (char& c : out) c = static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
    return out;
}

/// World coordinates to pixels of the scaled picture; row 0 is its top.
class Frame {
  public:
    Frame(const Grid& grid, int scale)
        : origin_(grid.origin()),
          pixels_per_m_(scale / grid.resolution_m()),
          height_(grid.rows() * scale) {}

    cv::Point2d pixel(const Point2& world) const {
        // A pixel's middle has whole coordinates, its borders have halves.
        return {(world.x - origin_.x) * pixels_per_m_ - 0.5,
                height_ - (world.y - origin_.y) * pixels_per_m_ - 0.5};
    }
    double pixels_per_m() const { return pixels_per_m_; }

  private:
    Point2 origin_;
    double pixels_per_m_;
    double height_;
};

cv::Mat scaled(const Grid::Picture& picture, int scale) {
    if (scale < 1 || scale > kGreatestPictureScale) {
        throw ConfigError("scale", fmt::format("{} is out of range; allowed: integers from 1 to {}",
                                               scale, kGreatestPictureScale));
    }
    if (picture.width <= 0 || picture.height <= 0) {
        throw Error("the grid map is empty: there is nothing to draw");
    }
    const std::int64_t width = std::int64_t{picture.width} * scale;
    const std::int64_t height = std::int64_t{picture.height} * scale;
    if (width > kMostPixels / height) {
        throw Error(
            fmt::format("a picture of {} x {} pixels is too great; use a smaller scale or "
                        "coarser cells",
                        width, height));
    }
    cv::Mat cells(picture.height, picture.width, CV_8UC1);
    std::copy(picture.grey.begin(), picture.grey.end(), cells.begin<std::uint8_t>());
    cv::Mat image;
    cv::resize(cells, image, cv::Size(static_cast<int>(width), static_cast<int>(height)), 0, 0,
               cv::INTER_NEAREST);
    return image;
}

void draw_path(cv::Mat& image, const Frame& frame, const std::vector<Point2>& path, int scale) {
    constexpr int kShift = 4;          // OpenCV's fixed point: sixteenths of a pixel
    constexpr double kFarthest = 1e7;  // pixels; OpenCV's integers overflow beyond
    const auto fixed = [](const cv::Point2d& pixel) {
        return cv::Point(static_cast<int>(std::lround(pixel.x * (1 << kShift))),
                         static_cast<int>(std::lround(pixel.y * (1 << kShift))));
    };
    const auto drawable = [](const cv::Point2d& pixel) {
        return std::abs(pixel.x) < kFarthest && std::abs(pixel.y) < kFarthest;
    };
    const int width = std::max(1, scale / 2);
    for (std::size_t i = 1; i < path.size(); ++i) {
        const cv::Point2d a = frame.pixel(path[i - 1]);
        const cv::Point2d b = frame.pixel(path[i]);
        if (!drawable(a) || !drawable(b)) continue;
        cv::line(image, fixed(a), fixed(b), kRed, width, cv::LINE_AA, kShift);
    }
    const int radius = (3 + scale) << kShift;
    const auto mark = [&](const Point2& world, const cv::Scalar& colour) {
        const cv::Point2d pixel = frame.pixel(world);
        if (drawable(pixel)) {
            cv::circle(image, fixed(pixel), radius, colour, cv::FILLED, cv::LINE_AA, kShift);
        }
    };
    mark(path.front(), kGreen);
    mark(path.back(), kBlue);
}

/// A black bar on white in the lower left corner; none in a picture too small for it.
void draw_scale_bar(cv::Mat& image, const Frame& frame) {
    constexpr int kMargin = 10;
    constexpr int kLeastSide = 80;
    constexpr int kThickness = 4;
    constexpr double kFontScale = 0.45;
    if (image.cols < kLeastSide || image.rows < kLeastSide) return;
    const double length_m = round_length(image.cols / 4.0 / frame.pixels_per_m());
    const int length = std::max(1, static_cast<int>(std::lround(length_m * frame.pixels_per_m())));
    const std::string words = fmt::format("{:g} m", length_m);
    const cv::Scalar black = cv::Scalar::all(0);
    const cv::Scalar white = cv::Scalar::all(255);
    int baseline = 0;
    const cv::Size text =
        cv::getTextSize(words, cv::FONT_HERSHEY_SIMPLEX, kFontScale, 1, &baseline);
    const cv::Rect bar(kMargin, image.rows - kMargin - kThickness, length, kThickness);
    const cv::Point text_at(kMargin, bar.y - baseline - 2);
    cv::rectangle(
        image,
        cv::Rect(kMargin - 4, text_at.y - text.height - 4, std::max(length, text.width) + 8,
                 image.rows - 6 - (text_at.y - text.height - 4)),
        white, cv::FILLED);
    cv::rectangle(image, bar, black, cv::FILLED);
    cv::putText(image, words, text_at, cv::FONT_HERSHEY_SIMPLEX, kFontScale, black, 1, cv::LINE_AA);
}

std::string encoded(const cv::Mat& image, std::string_view kind) {
    const std::string word = lower(kind);
    const bool jpeg = word == "jpg" || word == "jpeg";
    if (!jpeg && word != "png") {
        throw ConfigError("kind", fmt::format("\"{}\" is no kind of picture; allowed: one of png, "
                                              "jpg, jpeg",
                                              kind));
    }
    if (jpeg && std::max(image.cols, image.rows) > kLongestJpegSide) {
        throw Error(
            fmt::format("JPG holds at most {} pixels a side and the picture has {} x {}; "
                        "write PNG instead",
                        kLongestJpegSide, image.cols, image.rows));
    }
    const std::vector<int> options =
        jpeg ? std::vector<int>{cv::IMWRITE_JPEG_QUALITY, 95} : std::vector<int>{};
    std::vector<std::uint8_t> bytes;
    try {
        if (!cv::imencode(jpeg ? ".jpg" : ".png", image, bytes, options)) {
            throw Error("the picture could not be encoded");
        }
    } catch (const cv::Exception& error) {
        throw Error(fmt::format("the picture could not be encoded: {}", error.err));
    }
    return {bytes.begin(), bytes.end()};
}

std::string kind_from(const std::filesystem::path& path) {
    const std::string extension = lower(path.extension().string());
    if (extension != ".png" && extension != ".jpg" && extension != ".jpeg") {
        throw FileError(
            path.string(),
            fmt::format("found the extension \"{}\"; pictures are written as .png, .jpg "
                        "or .jpeg",
                        path.extension().string()));
    }
    return extension.substr(1);
}

void write_encoded(const std::filesystem::path& path, const auto& encode) {
    const std::string kind = kind_from(path);
    std::string bytes;
    try {
        bytes = encode(kind);
    } catch (const Error& error) {
        throw FileError(path.string(), error.what());
    }
    write_file(path, bytes);
}

}  // namespace

std::string encode_picture(const Grid& grid, const PictureStyle& style, std::string_view kind) {
    cv::Mat image = scaled(grid.picture(), style.scale);
    const Frame frame(grid, style.scale);
    if (!style.path.empty()) {
        cv::cvtColor(image, image, cv::COLOR_GRAY2BGR);
        draw_path(image, frame, style.path, style.scale);
    }
    if (style.scale_bar) draw_scale_bar(image, frame);
    return encoded(image, kind);
}

std::string encode_picture(const Grid::Picture& picture, std::string_view kind) {
    return encoded(scaled(picture, 1), kind);
}

void write_picture(const Grid& grid, const PictureStyle& style, const std::filesystem::path& path) {
    write_encoded(path, [&](const std::string& kind) { return encode_picture(grid, style, kind); });
}

void write_picture(const Grid::Picture& picture, const std::filesystem::path& path) {
    write_encoded(path, [&](const std::string& kind) { return encode_picture(picture, kind); });
}

}  // namespace hitos
