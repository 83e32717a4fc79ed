#include "hitos/services/drawing/picture_file.hpp"

#include <fmt/format.h>
#include <sys/mman.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cstdio>
#include <cstring>
#include <iostream>
#include <mutex>
#include <numeric>
#include <opencv2/core.hpp>
#include <opencv2/imgcodecs.hpp>
#include <opencv2/imgproc.hpp>
#include <vector>

#include "hitos/base/error.hpp"
#include "hitos/base/text_input.hpp"
#include "picture_drawing.hpp"
#include "picture_header.hpp"

namespace hitos {
namespace {

namespace fs = std::filesystem;

/// Pixels of our own maps: square kilometres at 5 cm take their cells two by two, and a few seconds
/// to write.
constexpr std::int64_t kMostOfMap = std::int64_t{1} << 27;
constexpr std::int64_t kMostForeign = 100'000'000;

cv::Mat scaled(const Grid::Picture& picture, int scale) {
    if (scale < 1 || scale > kGreatestPictureScale) {
        throw ConfigError(
            "scale", HITOS_TEXT("Errors", "%1 is out of range; allowed: integers from 1 to %2"),
            scale, kGreatestPictureScale);
    }
    if (picture.width <= 0 || picture.height <= 0) {
        throw Error(
            message(HITOS_TEXT("Errors", "the grid map is empty: there is nothing to draw")));
    }
    const std::int64_t width = std::int64_t{picture.width} * scale;
    const std::int64_t height = std::int64_t{picture.height} * scale;
    if (width > drawing::kMostPixels / height) {
        throw Error(message(
            HITOS_TEXT(
                "Errors",
                "a picture of %1 x %2 pixels is too great; use a smaller scale or coarser cells"),
            width, height));
    }
    cv::Mat cells(picture.height, picture.width, CV_8UC1);
    std::copy(picture.grey.begin(), picture.grey.end(), cells.begin<std::uint8_t>());
    cv::Mat image;
    cv::resize(cells, image, cv::Size(static_cast<int>(width), static_cast<int>(height)), 0, 0,
               cv::INTER_NEAREST);
    return image;
}

/// side x side pixels become one.
MapImage joined(MapImage large, int side) {
    if (side <= 1) return large;
    const Grid::Picture& cells = large.picture;
    MapImage image;
    image.origin = large.origin;
    image.m_per_pixel = large.m_per_pixel * side;
    image.picture.width = (cells.width + side - 1) / side;
    image.picture.height = (cells.height + side - 1) / side;
    image.picture.grey.reserve(static_cast<std::size_t>(image.picture.width) *
                               static_cast<std::size_t>(image.picture.height));
    // Of large pictures most is unknown, which says nothing in a block, and is passed over.
    std::array<std::uint8_t, 32> unknown{};
    unknown.fill(kUnknownGrey);
    const auto width = static_cast<std::size_t>(cells.width);
    const auto across = static_cast<std::size_t>(side);
    for (int row = image.picture.height; row-- > 0;) {  // counted from below, as the origin is
        const int top = std::max(cells.height - (row + 1) * side, 0);
        const int bottom = cells.height - row * side;
        std::vector<drawing::Block> blocks(static_cast<std::size_t>(image.picture.width));
        for (int y = top; y < bottom; ++y) {
            const std::uint8_t* line = &cells.grey[static_cast<std::size_t>(y) * width];
            for (std::size_t x = 0; x < width;) {
                if (width - x >= unknown.size() &&
                    std::memcmp(line + x, unknown.data(), unknown.size()) == 0) {
                    x += unknown.size();
                    continue;
                }
                const std::size_t column = x / across;
                const std::size_t end = std::min((column + 1) * across, width);
                while (x < end) blocks[column].add(line[x++]);
            }
        }
        for (const drawing::Block& block : blocks) image.picture.grey.push_back(block.grey());
    }
    return image;
}

/// While it lives, what is written to standard error is kept: the libraries of OpenCV say there,
/// past every handler, what is wrong with a picture. What others say meanwhile is passed on.
class Overheard {
  public:
    Overheard() : said_(::memfd_create("hitos-said", MFD_CLOEXEC)), others_(::dup(STDERR_FILENO)) {
        std::cerr.setstate(std::ios::failbit);  // OpenCV's own words
        if (said_ >= 0 && others_ >= 0) ::dup2(said_, STDERR_FILENO);
    }
    ~Overheard() {
        std::cerr.clear();
        if (others_ >= 0) ::dup2(others_, STDERR_FILENO);
        pass_on();
        for (const int file : {said_, others_}) {
            if (file >= 0) ::close(file);
        }
    }
    Overheard(const Overheard&) = delete;
    Overheard& operator=(const Overheard&) = delete;

    /// Whether pixels of a JPEG are guessed.
    bool damage() const { return text().find("orrupt JPEG data") != std::string::npos; }

  private:
    std::string text() const {
        std::string all(std::size_t{1} << 14, '\0');
        const ssize_t got = said_ < 0 ? 0 : ::pread(said_, all.data(), all.size(), 0);
        all.resize(got > 0 ? static_cast<std::size_t>(got) : 0);
        return all;
    }
    void pass_on() const {
        const std::string all = text();
        std::string_view rest = all;
        while (const auto line = input::next_line(rest)) {
            constexpr std::array kTheirs = {"libpng ", "JPEG", "Adobe", "SOS parameters",
                                            "progression"};
            const bool theirs = std::ranges::any_of(kTheirs, [&](const char* word) {
                return line->find(word) != std::string_view::npos;
            });
            if (!theirs) std::fprintf(stderr, "%s\n", std::string(*line).c_str());
        }
    }

    static std::mutex& one_at_a_time() {
        static std::mutex mutex;
        return mutex;
    }
    std::unique_lock<std::mutex> lock_{one_at_a_time()};
    int said_;
    int others_;
};

[[noreturn]] void refuse(const fs::path& path) {
    throw FormatError(
        path.string(), 0,
        HITOS_TEXT("Errors", "is no picture, or a damaged one; expected PNG, JPG, PGM or BMP"));
}

/// Who is told that a picture has more pixels than `most` has not made room for them.
cv::Mat decoded(const fs::path& path, int how, std::uint64_t most) {
    std::string text = input::read_text(path);
    const std::optional<PictureHeader> header = picture_header(text);
    if (!header || !header->whole) refuse(path);
    if (header->width > most / header->height) {
        throw FormatError(path.string(), 0,
                          HITOS_TEXT("Errors", "has %1 x %2 pixels; expected at most %3"),
                          header->width, header->height, most);
    }
    // The last number of a PBM, PGM or PPM in letters may end the file; OpenCV wants a blank there.
    const bool in_letters =
        text.starts_with("P1") || text.starts_with("P2") || text.starts_with("P3");
    if (in_letters) text += '\n';
    const cv::Mat bytes(1, static_cast<int>(text.size()), CV_8UC1, text.data());
    cv::Mat image;
    drawing::set_up_codecs();
    const Overheard libraries;
    try {
        image = cv::imdecode(bytes, how);
    } catch (const cv::Exception&) {
        image.release();
    }
    if (image.empty() || libraries.damage()) refuse(path);
    return image;
}

}  // namespace

MapImage map_image(const Grid& grid) {
    return {grid.picture(), grid.origin(), grid.resolution_m()};
}

MapImage shrunk(MapImage image, int longest_side) {
    const int longest = std::max(image.picture.width, image.picture.height);
    return joined(std::move(image), (longest + longest_side - 1) / longest_side);
}

MapImage fitted(MapImage image, std::string_view kind) {
    const std::int64_t width = image.picture.width;
    const std::int64_t height = image.picture.height;
    const auto fits = [&](std::int64_t side) {
        const std::int64_t columns = (width + side - 1) / side;
        const std::int64_t rows = (height + side - 1) / side;
        return std::max(columns, rows) <= drawing::longest_side(kind) &&
               columns * rows <= kMostOfMap;
    };
    int side = 1;
    while (!fits(side)) ++side;
    return joined(std::move(image), side);
}

std::string encode_picture(const MapImage& map, const PictureStyle& style, std::string_view kind) {
    cv::Mat image = scaled(map.picture, style.scale);
    const drawing::Frame frame(map.origin, style.scale / map.m_per_pixel, image.rows);
    if (!style.path.empty()) {
        cv::cvtColor(image, image, cv::COLOR_GRAY2BGR);
        constexpr int kRadius = 3;  // and a pixel for each of the scale
        drawing::draw_path(image, frame, style.path, std::max(1, style.scale / 2),
                           kRadius + style.scale, style.marks);
    }
    if (style.scale_bar) drawing::draw_scale_bar(image, frame);
    return drawing::encoded(image, kind);
}

std::string encode_picture(const Grid& grid, const PictureStyle& style, std::string_view kind) {
    return encode_picture(map_image(grid), style, kind);
}

std::string encode_picture(const Grid::Picture& picture, std::string_view kind) {
    return drawing::encoded(scaled(picture, 1), kind);
}

void write_picture(const MapImage& map, const PictureStyle& style, const fs::path& path) {
    drawing::write_encoded(
        path, [&](const std::string& kind) { return encode_picture(map, style, kind); });
}

void write_picture(const Grid& grid, const PictureStyle& style, const fs::path& path) {
    drawing::write_encoded(
        path, [&](const std::string& kind) { return encode_picture(grid, style, kind); });
}

void write_picture(const Grid::Picture& picture, const fs::path& path) {
    drawing::write_encoded(path,
                           [&](const std::string& kind) { return encode_picture(picture, kind); });
}

Grid::Picture read_grey_picture(const fs::path& path) {
    const cv::Mat image = decoded(path, cv::IMREAD_GRAYSCALE, kMostOfMap);
    return {image.cols, image.rows, {image.begin<std::uint8_t>(), image.end<std::uint8_t>()}};
}

MeanPicture read_mean_picture(const fs::path& path) {
    cv::Mat image = decoded(path, cv::IMREAD_UNCHANGED, kMostForeign);
    if (image.depth() == CV_16U) image.convertTo(image, CV_8U, 1.0 / 257.0);
    if (image.depth() != CV_8U) image = decoded(path, cv::IMREAD_COLOR, kMostForeign);
    const int channels = image.channels();
    const int colours = channels % 2 == 0 ? channels - 1 : channels;  // the last is alpha
    MeanPicture result;
    result.grey = {image.cols, image.rows, {}};
    result.grey.grey.reserve(image.total());
    for (int row = 0; row < image.rows; ++row) {
        const auto* at = image.ptr<std::uint8_t>(row);
        for (int column = 0; column < image.cols; ++column, at += channels) {
            const int sum = std::accumulate(at, at + colours, 0);
            result.grey.grey.push_back(static_cast<std::uint8_t>((sum + colours / 2) / colours));
            if (colours < channels) result.alpha.push_back(at[colours]);
        }
    }
    return result;
}

}  // namespace hitos
