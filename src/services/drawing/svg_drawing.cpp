// Drawings as SVG 1.1 (W3C Recommendation, 16 August 2011).
#include <fmt/format.h>

#include <cmath>
#include <iterator>

#include "files/xml_text.hpp"
#include "vector_text.hpp"

namespace hitos {
namespace {

std::string hex(const Colour& colour) {
    return fmt::format("#{:02x}{:02x}{:02x}", colour.red, colour.green, colour.blue);
}

std::string style_of(const DrawnLayer& layer) {
    const ShapeStyle& style = layer.style;
    std::string text = fmt::format(R"( fill="{}")", style.fill ? hex(*style.fill) : "none");
    if (style.line) {
        text += fmt::format(
            R"( stroke="{}" stroke-width="{}" stroke-linecap="{}" stroke-linejoin="round")",
            hex(*style.line), short_number(style.line_mm),
            style.dashes_mm.empty() ? "round" : "butt");
    }
    if (!style.dashes_mm.empty()) {
        text += R"( stroke-dasharray=")";
        for (std::size_t i = 0; i < style.dashes_mm.size(); ++i) {
            if (i > 0) text += ' ';
            text += short_number(style.dashes_mm[i]);
        }
        text += '"';
    }
    if (layer.clipped) text += " clip-path=\"url(#frame)\"";
    return text;
}

void put_pair(std::string& out, const Point2& point) {
    fmt::format_to(std::back_inserter(out), "{},{}", short_number(point.x), short_number(point.y));
}

void put_line(std::string& out, const std::vector<Point2>& line, bool closed) {
    out += closed ? R"(<polygon points=")" : R"(<polyline points=")";
    for (std::size_t i = 0; i < line.size(); ++i) {
        if (i > 0) out += ' ';
        put_pair(out, line[i]);
    }
    out += "\"/>\n";
}

void put_ellipse(std::string& out, const DrawnEllipse& ellipse) {
    const auto points = bezier_of(ellipse);
    out += R"(<path d="M)";
    put_pair(out, points[0]);
    for (std::size_t i = 1; i < points.size(); ++i) {
        out += i % 3 == 1 ? 'C' : ' ';
        put_pair(out, points[i]);
    }
    out += "Z\"/>\n";
}

void put_text(std::string& out, const DrawnText& words) {
    const std::string x = short_number(words.at.x);
    const std::string y = short_number(words.at.y);
    fmt::format_to(std::back_inserter(out), R"(<text x="{}" y="{}")", x, y);
    if (words.anchor == Anchor::middle) out += R"( text-anchor="middle")";
    if (words.anchor == Anchor::end) out += R"( text-anchor="end")";
    if (words.upwards) {
        fmt::format_to(std::back_inserter(out), " transform=\"rotate(-90 {} {})\"", x, y);
    }
    fmt::format_to(std::back_inserter(out), ">{}</text>\n", xml_escaped(words.text));
}

}  // namespace

std::string svg_text(const VectorDrawing& drawing) {
    const std::string width = short_number(drawing.width_mm);
    const std::string height = short_number(drawing.height_mm);
    std::string out = "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n";
    fmt::format_to(std::back_inserter(out),
                   R"(<svg xmlns="http://www.w3.org/2000/svg" version="1.1" width="{0}mm" )"
                   R"(height="{1}mm" viewBox="0 0 {0} {1}" )"
                   R"(font-family="Helvetica, Arial, sans-serif" font-size="{2}">)"
                   "\n<title>{3}</title>\n",
                   width, height, short_number(drawing.text_mm), xml_escaped(drawing.title));
    const Bounds& frame = drawing.frame;
    fmt::format_to(std::back_inserter(out),
                   R"(<clipPath id="frame"><rect x="{}" y="{}" width="{}" height="{}"/></clipPath>)"
                   "\n",
                   short_number(frame.low.x), short_number(frame.low.y),
                   short_number(frame.high.x - frame.low.x),
                   short_number(frame.high.y - frame.low.y));
    for (const DrawnLayer& layer : drawing.layers) {
        fmt::format_to(std::back_inserter(out), "<g id=\"{}\"{}>\n", layer.name, style_of(layer));
        for (const auto& line : layer.lines) put_line(out, line, layer.closed);
        for (const DrawnEllipse& ellipse : layer.ellipses) put_ellipse(out, ellipse);
        for (const DrawnText& words : layer.texts) put_text(out, words);
        out += "</g>\n";
    }
    return out + "</svg>\n";
}

}  // namespace hitos
