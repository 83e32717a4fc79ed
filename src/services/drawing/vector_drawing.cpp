#include "vector_drawing.hpp"

#include <fmt/format.h>

#include "vector_text.hpp"

namespace hitos {
namespace {

/// Of the letters from " " to "~", in thousandths of the size: the font's metrics that Adobe
/// publishes with the standard fourteen (Helvetica.afm).
constexpr std::array<int, 95> kHelvetica = {
    278, 278, 355, 556, 556, 889, 667, 191, 333, 333, 389, 584, 278, 333,  278, 278, 556, 556, 556,
    556, 556, 556, 556, 556, 556, 556, 278, 278, 584, 584, 584, 556, 1015, 667, 667, 722, 722, 667,
    611, 778, 722, 278, 500, 667, 556, 833, 722, 778, 667, 778, 722, 667,  611, 722, 667, 944, 667,
    667, 611, 278, 278, 278, 469, 556, 333, 556, 556, 500, 556, 556, 278,  556, 556, 222, 222, 500,
    222, 833, 556, 556, 556, 556, 333, 500, 278, 556, 500, 722, 500, 500,  500, 334, 260, 334, 584};
constexpr int kOther = 556;

}  // namespace

double text_width_mm(const std::string& text, double text_mm) {
    int thousandths = 0;
    for (const char c : text) {
        const auto code = static_cast<unsigned char>(c);
        if ((code & 0xC0U) == 0x80U) continue;  // goes on with a letter that was counted
        thousandths += code >= 0x20 && code < 0x7F ? kHelvetica.at(code - 0x20U) : kOther;
    }
    return thousandths * text_mm / 1000.0;
}

std::string short_number(double value) {
    std::string text = fmt::format("{:.{}f}", value, kMillimetreDecimals);
    text.erase(text.find_last_not_of('0') + 1);
    if (text.ends_with('.')) text.pop_back();
    return text == "-0" ? "0" : text;
}

std::array<Point2, 13> bezier_of(const DrawnEllipse& ellipse) {
    constexpr double kReach = 0.5522847498307936;  // 4/3 (sqrt(2) - 1)
    const Point2& centre = ellipse.centre;
    const Point2& first = ellipse.first;
    const Point2& second = ellipse.second;
    const auto at = [&](double u, double v) {
        return Point2{centre.x + u * first.x + v * second.x, centre.y + u * first.y + v * second.y};
    };
    return {at(1.0, 0.0),      at(1.0, kReach),  at(kReach, 1.0),  at(0.0, 1.0),
            at(-kReach, 1.0),  at(-1.0, kReach), at(-1.0, 0.0),    at(-1.0, -kReach),
            at(-kReach, -1.0), at(0.0, -1.0),    at(kReach, -1.0), at(1.0, -kReach),
            at(1.0, 0.0)};
}

}  // namespace hitos
