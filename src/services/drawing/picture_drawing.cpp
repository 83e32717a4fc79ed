#include "picture_drawing.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <cmath>
#include <opencv2/core/utility.hpp>
#include <opencv2/imgproc.hpp>

#include "hitos/base/atomic_file.hpp"
#include "hitos/base/error.hpp"
#include "hitos/services/drawing/scale_bar.hpp"
#include "picture_codecs.hpp"

namespace hitos::drawing {
namespace {

// OpenCV's own threads gain nothing here, and where the system cannot start one it waits for it
// without end (4.6).
[[maybe_unused]] const bool kWithoutItsThreads = [] {
    cv::setNumThreads(1);
    return true;
}();

constexpr int kShift = 4;          // OpenCV's fixed point: sixteenths of a pixel
constexpr double kFarthest = 1e7;  // pixels; OpenCV's integers overflow beyond

// OpenCV's order: blue, green, red.
const cv::Scalar kRedScalar(0, 0, 255);
const cv::Scalar kGreenScalar(0, 160, 0);
const cv::Scalar kBlueScalar(255, 64, 0);

std::string lower(std::string_view text) {
    std::string out(text);
    for (char& c : out) c = static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
    return out;
}

cv::Point fixed(const cv::Point2d& pixel) {
    return {static_cast<int>(std::lround(pixel.x * (1 << kShift))),
            static_cast<int>(std::lround(pixel.y * (1 << kShift)))};
}

bool fits_a_picture(const cv::Point2d& pixel) {
    return std::abs(pixel.x) < kFarthest && std::abs(pixel.y) < kFarthest;
}

void mark(cv::Mat& image, const cv::Point2d& pixel, int radius, PathMarks marks, bool start) {
    if (!fits_a_picture(pixel)) return;
    const cv::Scalar colour = start ? kGreenScalar : kBlueScalar;
    if (marks == PathMarks::discs) {
        cv::circle(image, fixed(pixel), radius << kShift, colour, cv::FILLED, cv::LINE_AA, kShift);
        return;
    }
    constexpr int kWidth = 2;
    if (!start) {
        cv::circle(image, fixed(pixel), radius << kShift, colour, kWidth, cv::LINE_AA, kShift);
        return;
    }
    const cv::Point2d arm(radius, radius);
    const cv::Point2d other(radius, -radius);
    cv::line(image, fixed(pixel - arm), fixed(pixel + arm), colour, kWidth, cv::LINE_AA, kShift);
    cv::line(image, fixed(pixel - other), fixed(pixel + other), colour, kWidth, cv::LINE_AA,
             kShift);
}

std::string kind_from(const std::filesystem::path& path) {
    const std::string extension = lower(path.extension().string());
    if (extension != ".png" && extension != ".jpg" && extension != ".jpeg") {
        throw FileError(
            path.string(),
            HITOS_TEXT("Errors",
                       "found the extension \"%1\"; pictures are written as .png, .jpg or .jpeg"),
            path.extension().string());
    }
    return extension.substr(1);
}

bool is_jpeg(const std::string& word) {
    return word == "jpg" || word == "jpeg";
}

}  // namespace

int longest_side(std::string_view kind) {
    constexpr int kOfJpeg = 65500;   // the limit of libjpeg
    constexpr int kOfPng = 1000000;  // the limit of libpng, unless it is told another
    return is_jpeg(lower(kind)) ? kOfJpeg : kOfPng;
}

void draw_path(cv::Mat& image, const Frame& frame, const std::vector<Point2>& path, int width,
               int radius, PathMarks marks) {
    if (path.empty()) return;
    for (std::size_t i = 1; i < path.size(); ++i) {
        const cv::Point2d a = frame.pixel(path[i - 1]);
        const cv::Point2d b = frame.pixel(path[i]);
        if (!fits_a_picture(a) || !fits_a_picture(b)) continue;
        cv::line(image, fixed(a), fixed(b), kRedScalar, width, cv::LINE_AA, kShift);
    }
    mark(image, frame.pixel(path.front()), radius, marks, true);
    mark(image, frame.pixel(path.back()), radius, marks, false);
}

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

void draw_words(cv::Mat& image, const std::string& words, const cv::Point& at, double size) {
    cv::putText(image, words, at, cv::FONT_HERSHEY_SIMPLEX, size, cv::Scalar::all(0), 1,
                cv::LINE_AA);
}

cv::Size size_of_words(const std::string& words, double size) {
    int baseline = 0;
    const cv::Size text = cv::getTextSize(words, cv::FONT_HERSHEY_SIMPLEX, size, 1, &baseline);
    return {text.width, text.height + baseline};
}

std::string encoded(const cv::Mat& image, std::string_view kind, std::optional<int> compression) {
    const std::string word = lower(kind);
    const bool jpeg = is_jpeg(word);
    if (!jpeg && word != "png") {
        throw ConfigError(
            "kind",
            HITOS_TEXT("Errors", "\"%1\" is no kind of picture; allowed: one of png, jpg, jpeg"),
            kind);
    }
    if (jpeg && std::max(image.cols, image.rows) > longest_side(word)) {
        throw Error(message(HITOS_TEXT("Errors",
                                       "JPG holds at most %1 pixels a side and the picture has %2 "
                                       "x %3; write PNG instead"),
                            longest_side(word), image.cols, image.rows));
    }
    return jpeg ? jpeg_of(image) : png_of(image, compression);
}

void write_encoded(const std::filesystem::path& path,
                   const std::function<std::string(const std::string& kind)>& encode) {
    const std::string kind = kind_from(path);
    std::string bytes;
    try {
        bytes = encode(kind);
    } catch (const Error& error) {
        throw FileError(path.string(), error.message());
    }
    write_file(path, bytes);
}

}  // namespace hitos::drawing
