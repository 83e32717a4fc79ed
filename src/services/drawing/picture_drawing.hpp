// What the writers of pictures share: paths, marks, scale bars and the encoding.
#pragma once

#include <algorithm>
#include <cstdint>
#include <filesystem>
#include <functional>
#include <opencv2/core.hpp>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "hitos/base/geometry.hpp"
#include "hitos/services/drawing/picture_file.hpp"

namespace hitos::drawing {

/// Greatest number of pixels of a picture: what OpenCV reads back by default.
constexpr std::int64_t kMostPixels = std::int64_t{1} << 30;

/// Greatest number of pixels of a side in a file of the kind.
int longest_side(std::string_view kind);

/// Cells of a picture that become one pixel: black where one is occupied, for a thin wall must not
/// fade, else the mean of what is known.
class Block {
  public:
    void add(std::uint8_t grey) {
        darkest_ = std::min(darkest_, grey);
        if (grey == kUnknownGrey) return;
        sum_ += grey;
        ++known_;
    }
    std::uint8_t grey() const {
        constexpr std::uint8_t kOccupied = 102;  // likelier than 0.6
        if (darkest_ < kOccupied) return darkest_;
        if (known_ == 0) return kUnknownGrey;
        return static_cast<std::uint8_t>((sum_ + known_ / 2) / known_);
    }

  private:
    std::uint8_t darkest_ = 255;
    std::uint32_t sum_ = 0;
    std::uint32_t known_ = 0;
};

/// World coordinates to pixels; row 0 is the top.
class Frame {
  public:
    /// `origin` is the world's point at the lower left corner of a picture of that height [pixels].
    Frame(const Point2& origin, double pixels_per_m, double height)
        : origin_(origin), pixels_per_m_(pixels_per_m), height_(height) {}

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

/// The path in red, start and end marked; nothing where it is empty. Sizes in pixels.
void draw_path(cv::Mat& image, const Frame& frame, const std::vector<Point2>& path, int width,
               int radius, PathMarks marks);

/// A black bar on white in the lower left corner; none in a picture too small for it.
void draw_scale_bar(cv::Mat& image, const Frame& frame);

/// Letters that the picture's font has: ASCII; others become question marks.
void draw_words(cv::Mat& image, const std::string& words, const cv::Point& at, double size);
/// How wide and high (with what hangs below the line) the words are [pixels].
cv::Size size_of_words(const std::string& words, double size);

/// "png", "jpg" or "jpeg". Throws ConfigError for another kind and Error where it cannot be.
/// `compression` is PNG's, 0 to 9; nothing: what is fast.
std::string encoded(const cv::Mat& image, std::string_view kind,
                    std::optional<int> compression = std::nullopt);

/// Writes what `encode` gives for the kind that the path's extension says. Throws FileError.
void write_encoded(const std::filesystem::path& path,
                   const std::function<std::string(const std::string& kind)>& encode);

}  // namespace hitos::drawing
