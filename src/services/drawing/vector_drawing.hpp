// A drawing on paper, and the vector files that it can be written as.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "hitos/base/geometry.hpp"

namespace hitos {

struct Colour {
    std::uint8_t red = 0;
    std::uint8_t green = 0;
    std::uint8_t blue = 0;
};

/// How shapes look; without a line and a fill they are not seen.
struct ShapeStyle {
    std::optional<Colour> fill = {};
    std::optional<Colour> line = {};
    double line_mm = 0.0;
    std::vector<double> dashes_mm = {};  ///< drawn and left out in turn; empty: a whole line
};

/// An ellipse by its centre and the ends of two half diameters that are each other's conjugates, as
/// seen from there.
struct DrawnEllipse {
    Point2 centre;
    Point2 first;
    Point2 second;
};

enum class Anchor { start, middle, end };

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
    std::vector<std::vector<Point2>> lines = {};
    std::vector<DrawnEllipse> ellipses = {};
    std::vector<DrawnText> texts = {};
};

/// Places are in millimetres from the upper left corner of the paper, y downwards.
struct VectorDrawing {
    std::string title;  ///< for programs, not drawn
    double width_mm = 0.0;
    double height_mm = 0.0;
    double text_mm = 2.5;  ///< size of the letters
    Bounds frame;
    std::vector<DrawnLayer> layers;
};

/// The width [mm] of a text in Helvetica of that size; letters out of ASCII count as "n".
double text_width_mm(const std::string& text, double text_mm);

/// SVG 1.1: a group for each layer, words as words.
std::string svg_text(const VectorDrawing& drawing);

/// PDF 1.4, one page of the drawing's size: vectors, and words in Helvetica, which every reader has
/// and which therefore is not in the file. No date stands in it: equal drawings are equal files.
std::string pdf_text(const VectorDrawing& drawing);

}  // namespace hitos
