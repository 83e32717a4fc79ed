// SPDX-License-Identifier: GPL-3.0-or-later
// What the writers of pictures share: paths, marks, scale bars and the encoding.
#pragma once

#include <algorithm>
#include <cstdint>
#include <filesystem>
#include <functional>
#include <opencv2/core.hpp>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "hitos/base/geometry.hpp"
#include "hitos/services/drawing/picture_file.hpp"
#include "hitos/services/drawing/vector_drawing.hpp"

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
        constexpr std::uint8_t kOccupied = 164;  // likelier than 0.6
        if (darkest_ < kOccupied) return darkest_;
        if (known_ == 0) return kUnknownGrey;
        return static_cast<std::uint8_t>((sum_ + known_ / 2) / known_);
    }

  private:
    std::uint8_t darkest_ = 255;
    std::uint32_t sum_ = 0;
    std::uint32_t known_ = 0;
};

/// The lines of a path, none of them empty, in red, in few colours, its start and end marked;
/// nothing where there are none. Sizes in pixels.
void draw_paths(cv::Mat& image, const Placement& placement,
                const std::vector<std::vector<Point2>>& paths, double width, double radius,
                PathMarks marks);

/// A black bar on white in the lower left corner; none in a picture too small for it.
void draw_scale_bar(cv::Mat& image, double pixels_per_m);

/// Lays a drawing in pixels over the picture, of one channel (grey) or three (blue, green, red).
/// Throws Error where there is no memory for it. `scale`: pixels for each of its units; `corner`:
/// the drawing's pixel that lies in the picture's first one.
void paint(cv::Mat& image, const VectorDrawing& drawing, double scale = 1.0,
           const Point2& corner = {});
/// How wide the widest of the texts is [pixels].
double widest(std::span<const std::string> texts, double letters);

/// "png", "jpg" or "jpeg". Throws ConfigError for another kind and Error where it cannot be.
/// `compression` is PNG's, 0 to 9; nothing: what is fast.
std::string encoded(const cv::Mat& image, std::string_view kind,
                    std::optional<int> compression = std::nullopt);

/// Writes what `encode` gives for the kind that the path's extension says. Throws FileError.
void write_encoded(const std::filesystem::path& path,
                   const std::function<std::string(const std::string& kind)>& encode);

}  // namespace hitos::drawing
