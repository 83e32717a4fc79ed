// Drawings as PDF 1.4 (PDF Reference, third edition, Adobe 2001).
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <iterator>

#include "json_input.hpp"
#include "vector_text.hpp"
#include "version.hpp"

namespace hitos {
namespace {

constexpr double kPointsPerMm = 72.0 / 25.4;

void put_point(std::string& out, const Point2& point) {
    out += short_number(point.x);
    out += ' ';
    out += short_number(point.y);
}

void put_colour(std::string& out, const Colour& colour, const char* word) {
    for (const std::uint8_t part : {colour.red, colour.green, colour.blue}) {
        out += short_number(part / 255.0);
        out += ' ';
    }
    out += word;
    out += '\n';
}

/// The operator that paints what was outlined.
const char* painting(const DrawnLayer& layer) {
    const ShapeStyle& style = layer.style;
    if (style.fill && style.line) return "B";
    if (style.fill) return "f";
    return style.line ? "S" : "n";
}

void put_path_line(std::string& out, const std::vector<Point2>& line, bool closed,
                   const char* paint) {
    if (line.empty()) return;
    for (std::size_t i = 0; i < line.size(); ++i) {
        put_point(out, line[i]);
        out += i == 0 ? " m\n" : " l\n";
    }
    if (closed) out += "h ";
    out += paint;
    out += '\n';
}

void put_path_ellipse(std::string& out, const DrawnEllipse& ellipse, const char* paint) {
    const auto points = bezier_of(ellipse);
    put_point(out, points[0]);
    out += " m\n";
    for (std::size_t i = 1; i < points.size(); i += 3) {
        for (std::size_t j = i; j < i + 3; ++j) {
            put_point(out, points[j]);
            out += ' ';
        }
        out += "c\n";
    }
    out += "h ";
    out += paint;
    out += '\n';
}

/// A string of the page, in the letters of WinAnsiEncoding that are ASCII too.
std::string literal(const std::string& text) {
    std::string out = "(";
    for (const char c : text) {
        const auto code = static_cast<unsigned char>(c);
        if (c == '(' || c == ')' || c == '\\') out += '\\';
        if ((code & 0xC0U) == 0x80U) continue;  // goes on with a letter that was marked
        out += code >= 0x20 && code < 0x7F ? c : '?';
    }
    return out + ')';
}

/// The code points of UTF-8 that is known to be right.
std::u32string code_points(const std::string& text) {
    std::u32string points;
    for (const char c : text) {
        const auto byte = static_cast<unsigned char>(c);
        if ((byte & 0xC0U) == 0x80U) {
            points.back() = (points.back() << 6U) | (byte & 0x3FU);
        } else if (byte < 0x80U) {
            points.push_back(byte);
        } else {
            points.push_back(byte & (byte < 0xE0U ? 0x1FU : byte < 0xF0U ? 0x0FU : 0x07U));
        }
    }
    return points;
}

/// A string of the document's facts, in UTF-16 with its mark.
std::string utf16(const std::string& text) {
    std::string out = "<FEFF";
    for (char32_t point : code_points(in_utf8(text))) {
        if (point >= 0x10000U) {
            point -= 0x10000U;
            fmt::format_to(std::back_inserter(out), "{:04X}", 0xD800U + (point >> 10U));
            point = 0xDC00U + (point & 0x3FFU);
        }
        fmt::format_to(std::back_inserter(out), "{:04X}", static_cast<std::uint32_t>(point));
    }
    return out + '>';
}

/// The page's y grows downwards, letters stand upright: their axes are turned back.
void put_text(std::string& out, const DrawnText& words, double text_mm) {
    const double share = words.anchor == Anchor::middle ? 0.5
                         : words.anchor == Anchor::end  ? 1.0
                                                        : 0.0;
    const double back = share * text_width_mm(words.text, text_mm);
    const Point2 at = words.upwards ? Point2{words.at.x, words.at.y + back}
                                    : Point2{words.at.x - back, words.at.y};
    out += words.upwards ? "BT 0 -1 -1 0 " : "BT 1 0 0 -1 ";
    put_point(out, at);
    fmt::format_to(std::back_inserter(out), " Tm /F1 {} Tf {} Tj ET\n", short_number(text_mm),
                   literal(words.text));
}

std::string page_of(const VectorDrawing& drawing) {
    std::string out = fmt::format("{0:.6f} 0 0 {1:.6f} 0 {2:.6f} cm\n1 j\n", kPointsPerMm,
                                  -kPointsPerMm, drawing.height_mm * kPointsPerMm);
    const Point2 size{drawing.frame.high.x - drawing.frame.low.x,
                      drawing.frame.high.y - drawing.frame.low.y};
    for (const DrawnLayer& layer : drawing.layers) {
        const ShapeStyle& style = layer.style;
        out += "q\n";
        if (layer.clipped) {
            put_point(out, drawing.frame.low);
            out += ' ';
            put_point(out, size);
            out += " re W n\n";
        }
        if (style.fill) put_colour(out, *style.fill, "rg");
        if (style.line) put_colour(out, *style.line, "RG");
        out += style.dashes_mm.empty() ? "1 J [" : "0 J [";
        for (const double dash : style.dashes_mm) {
            out += short_number(dash);
            out += ' ';
        }
        fmt::format_to(std::back_inserter(out), "] 0 d {} w\n", short_number(style.line_mm));
        for (const auto& line : layer.lines)
            put_path_line(out, line, layer.closed, painting(layer));
        for (const DrawnEllipse& ellipse : layer.ellipses) {
            put_path_ellipse(out, ellipse, painting(layer));
        }
        for (const DrawnText& words : layer.texts) put_text(out, words, drawing.text_mm);
        out += "Q\n";
    }
    return out;
}

}  // namespace

std::string pdf_text(const VectorDrawing& drawing) {
    const std::string page = page_of(drawing);
    const std::vector<std::string> objects = {
        "<< /Type /Catalog /Pages 2 0 R >>",
        "<< /Type /Pages /Kids [3 0 R] /Count 1 >>",
        fmt::format("<< /Type /Page /Parent 2 0 R /MediaBox [0 0 {} {}] /Contents 4 0 R\n"
                    "   /Resources << /ProcSet [/PDF /Text] /Font << /F1 5 0 R >> >> >>",
                    short_number(drawing.width_mm * kPointsPerMm),
                    short_number(drawing.height_mm * kPointsPerMm)),
        fmt::format("<< /Length {} >>\nstream\n{}endstream", page.size(), page),
        "<< /Type /Font /Subtype /Type1 /BaseFont /Helvetica /Encoding /WinAnsiEncoding >>",
        fmt::format("<< /Title {} /Producer (Hitos {}) >>", utf16(drawing.title), kVersion),
    };
    std::string out = "%PDF-1.4\n";
    std::vector<std::size_t> places;
    for (const std::string& object : objects) {
        places.push_back(out.size());
        fmt::format_to(std::back_inserter(out), "{} 0 obj\n{}\nendobj\n", places.size(), object);
    }
    const std::size_t table = out.size();
    fmt::format_to(std::back_inserter(out), "xref\n0 {}\n0000000000 65535 f \n",
                   objects.size() + 1);
    for (const std::size_t place : places) {
        fmt::format_to(std::back_inserter(out), "{:010} 00000 n \n", place);
    }
    fmt::format_to(std::back_inserter(out),
                   "trailer\n<< /Size {} /Root 1 0 R /Info 6 0 R >>\nstartxref\n{}\n%%EOF\n",
                   objects.size() + 1, table);
    return out;
}

}  // namespace hitos
