// SPDX-License-Identifier: GPL-3.0-or-later
// What figures are made of and what is laid over pictures of grids: one value for every kind of
// file, so that whoever draws need not know which it becomes.
#pragma once

#include <array>
#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "hitos/base/geometry.hpp"

namespace hitos {

/// Of the sRGB space, without transparency.
struct Colour {
    std::uint8_t red = 0;
    std::uint8_t green = 0;
    std::uint8_t blue = 0;
};
inline constexpr Colour kBlack{0, 0, 0};
inline constexpr Colour kWhite{255, 255, 255};

/// How shapes and words look; without a line and a fill they are not seen.
struct ShapeStyle {
    std::optional<Colour> fill = {};  ///< of words too
    std::optional<Colour> line = {};
    double line_width = 0.0;
    std::vector<double> dashes = {};  ///< drawn and left out in turn; empty: a whole line
    double letters = 0.0;             ///< size of words
};
ShapeStyle line_style(const Colour& colour, double width, std::vector<double> dashes = {});
ShapeStyle word_style(const Colour& colour, double letters);

/// Where the world lies in a drawing.
struct Placement {
    Point2 world;  ///< [m], drawn at `drawn`
    Point2 drawn;
    double per_m = 1.0;  ///< the drawing's units for a metre

    Point2 at(const Point2& p) const {
        return {drawn.x + (p.x - world.x) * per_m, drawn.y - (p.y - world.y) * per_m};
    }
};

/// A line's corners.
using DrawnLine = std::vector<Point2>;
/// Of a rectangle between two corners that lie opposite, to be closed.
DrawnLine rectangle(const Point2& corner, const Point2& opposite);

/// An ellipse by its centre and the ends of two half diameters that are each other's conjugates, as
/// seen from there.
struct DrawnEllipse {
    Point2 centre;
    Point2 first;
    Point2 second;
};
DrawnEllipse disc(const Point2& centre, double radius);
/// As four Bezier curves: where it begins, then two control points and an end for each. They are
/// off the ellipse by less than 0.03 % of its half diameter.
std::array<Point2, 13> bezier_of(const DrawnEllipse& ellipse);

enum class Anchor { start, middle, end };

/// Words, and where they stand.
struct DrawnText {
    Point2 at;  ///< on its base line
    std::string text;
    Anchor anchor = Anchor::start;
    bool upwards = false;  ///< read from below to above
};

/// Shapes and words of one look, drawn in this order.
struct DrawnLayer {
    std::string name;  ///< as drawing programs show it: letters, digits and "-"
    ShapeStyle style = {};
    bool clipped = false;  ///< by the drawing's frame
    bool closed = false;   ///< whether lines end where they began
    std::vector<DrawnLine> lines = {};
    std::vector<DrawnEllipse> ellipses = {};
    std::vector<DrawnText> texts = {};
};

/// Places and sizes are millimetres of paper or pixels of a picture, from the upper left corner,
/// y downwards.
struct VectorDrawing {
    std::string title;  ///< for programs, not drawn
    double width = 0.0;
    double height = 0.0;
    Bounds frame;
    std::vector<DrawnLayer> layers;
};

/// SVG 1.1 of a drawing in millimetres: a group for each layer, words as words.
std::string svg_text(const VectorDrawing& drawing);

/// PDF 1.4 of a drawing in millimetres, one page of its size: vectors, and words that can be looked
/// for, in letters that are in the file. No date stands in it: equal drawings are equal files.
/// Throws Error where there is no memory for it.
std::string pdf_text(const VectorDrawing& drawing);

/// PNG of a drawing on white paper, `scale` pixels for each of its units. Throws Error where it
/// would have too many or there is no memory for it.
std::string png_text(const VectorDrawing& drawing, double scale);

/// Writes a drawing in pixels on white paper atomically; the path's extension (.png, .jpg, .jpeg,
/// in any case) says the kind. Throws FileError.
void write_picture(const VectorDrawing& drawing, const std::filesystem::path& path);

}  // namespace hitos
