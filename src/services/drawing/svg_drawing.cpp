// SPDX-License-Identifier: GPL-3.0-or-later
// Drawings as SVG 1.1 (W3C Recommendation, 16 August 2011). cairo's own are no help to who wants to
// edit them: letters are outlines there, layers have no names, and what it numbers goes on counting
// from one file of a process to the next.
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <iterator>
#include <span>

#include "files/xml_text.hpp"
#include "hitos/services/drawing/vector_drawing.hpp"

namespace hitos {
namespace {

/// In micrometres, finer than any printer, without decimals that say nothing, whatever the locale.
std::string short_number(double value) {
    std::string text = fmt::format("{:.3f}", value);
    text.erase(text.find_last_not_of('0') + 1);
    if (text.ends_with('.')) text.pop_back();
    return text == "-0" ? "0" : text;
}

std::string hex(const Colour& colour) {
    return fmt::format("#{:02x}{:02x}{:02x}", colour.red, colour.green, colour.blue);
}

std::string style_of(const DrawnLayer& layer) {
    const ShapeStyle& style = layer.style;
    std::string text = fmt::format(R"( fill="{}")", style.fill ? hex(*style.fill) : "none");
    if (style.line) {
        text += fmt::format(
            R"( stroke="{}" stroke-width="{}" stroke-linecap="{}" stroke-linejoin="round")",
            hex(*style.line), short_number(style.line_width),
            style.dashes.empty() ? "round" : "butt");
    }
    if (!style.dashes.empty()) {
        text += fmt::format(R"( stroke-dasharray="{}")", fmt::join(style.dashes, " "));
    }
    if (style.letters > 0.0) {
        text += fmt::format(R"( font-size="{}")", short_number(style.letters));
    }
    if (layer.clipped) text += " clip-path=\"url(#frame)\"";
    return text;
}

std::string pairs(std::span<const Point2> points) {
    std::string text;
    for (const Point2& point : points) {
        if (!text.empty()) text += ' ';
        text += short_number(point.x) + ',' + short_number(point.y);
    }
    return text;
}

std::string line_text(const DrawnLine& line, bool closed) {
    return fmt::format("<{} points=\"{}\"/>\n", closed ? "polygon" : "polyline", pairs(line));
}

std::string ellipse_text(const DrawnEllipse& ellipse) {
    const auto points = bezier_of(ellipse);
    const std::span all(points);
    return fmt::format("<path d=\"M{}C{}Z\"/>\n", pairs(all.first(1)), pairs(all.subspan(1)));
}

std::string words_text(const DrawnText& words) {
    const std::string x = short_number(words.at.x);
    const std::string y = short_number(words.at.y);
    std::string text = fmt::format(R"(<text x="{}" y="{}")", x, y);
    if (words.anchor == Anchor::middle) text += R"( text-anchor="middle")";
    if (words.anchor == Anchor::end) text += R"( text-anchor="end")";
    if (words.upwards) text += fmt::format(" transform=\"rotate(-90 {} {})\"", x, y);
    return text + fmt::format(">{}</text>\n", xml_escaped(words.text));
}

}  // namespace

std::string svg_text(const VectorDrawing& drawing) {
    const Bounds& frame = drawing.frame;
    // Verdana is as wide as the font of the PDF, where that is not installed.
    std::string out = fmt::format(
        R"(<?xml version="1.0" encoding="UTF-8"?>)"
        "\n"
        R"(<svg xmlns="http://www.w3.org/2000/svg" version="1.1" width="{0}mm" height="{1}mm" )"
        R"(viewBox="0 0 {0} {1}" font-family="DejaVu Sans, Verdana, sans-serif">)"
        "\n<title>{2}</title>\n"
        R"(<clipPath id="frame"><rect x="{3}" y="{4}" width="{5}" height="{6}"/></clipPath>)"
        "\n",
        short_number(drawing.width), short_number(drawing.height), xml_escaped(drawing.title),
        short_number(frame.low.x), short_number(frame.low.y),
        short_number(frame.high.x - frame.low.x), short_number(frame.high.y - frame.low.y));
    for (const DrawnLayer& layer : drawing.layers) {
        out += fmt::format("<g id=\"{}\"{}>\n", layer.name, style_of(layer));
        for (const DrawnLine& line : layer.lines) out += line_text(line, layer.closed);
        for (const DrawnEllipse& ellipse : layer.ellipses) out += ellipse_text(ellipse);
        for (const DrawnText& words : layer.texts) out += words_text(words);
        out += "</g>\n";
    }
    return out + "</svg>\n";
}

}  // namespace hitos
