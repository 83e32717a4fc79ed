// SPDX-License-Identifier: GPL-3.0-or-later
// Drawings by cairo, as PDF and over pixels. Whatever several threads share in cairo and fontconfig
// these lock; surface, context and font are each drawing's own.
#include <cairo-ft.h>
#include <cairo-pdf.h>
#include <cairo.h>
#include <fmt/format.h>
#include <fontconfig/fontconfig.h>

#include <exception>
#include <filesystem>
#include <memory>
#include <opencv2/imgproc.hpp>
#include <span>
#include <system_error>
#include <vector>

#include "hitos/base/error.hpp"
#include "json_input.hpp"
#include "picture_drawing.hpp"
#include "version.hpp"

namespace hitos {
namespace {

template <auto Release>
struct Releaser {
    template <class T>
    void operator()(T* held) const {
        Release(held);
    }
};
using CairoSurface = std::unique_ptr<cairo_surface_t, Releaser<cairo_surface_destroy>>;
using CairoContext = std::unique_ptr<cairo_t, Releaser<cairo_destroy>>;
using CairoFont = std::unique_ptr<cairo_font_face_t, Releaser<cairo_font_face_destroy>>;
using FontPattern = std::unique_ptr<FcPattern, Releaser<FcPatternDestroy>>;
using Glyphs = std::unique_ptr<cairo_glyph_t, Releaser<cairo_glyph_free>>;

constexpr const char* kUsualFont = "/usr/share/fonts/truetype/dejavu/DejaVuSans.ttf";  // Debian's

const FcChar8* bytes_of(const char* text) {
    return reinterpret_cast<const FcChar8*>(text);
}

/// Without a file: cairo's own letters, for ASCII.
CairoFont font_of(const FontPattern& file) {
    return CairoFont(file ? cairo_ft_font_face_create_for_pattern(file.get())
                          : cairo_toy_font_face_create("@cairo:", CAIRO_FONT_SLANT_NORMAL,
                                                       CAIRO_FONT_WEIGHT_NORMAL));
}

/// The font that lacks the fewest of the letters. It is sought here, for cairo never forgets what
/// it is asked to seek. Without a language the user's own would choose among fonts for Chinese.
CairoFont font_with(const std::string& letters) {
    const FontPattern wish(
        FcNameParse(bytes_of("DejaVu Sans:lang=en:weight=80:slant=0:width=100")));
    const std::unique_ptr<FcCharSet, Releaser<FcCharSetDestroy>> set(FcCharSetCreate());
    FcChar32 letter = 0;
    for (int at = 0, size = static_cast<int>(letters.size()); at < size;) {
        at += FcUtf8ToUcs4(bytes_of(&letters[static_cast<std::size_t>(at)]), &letter, size - at);
        FcCharSetAddChar(set.get(), letter);
    }
    FcPatternAddCharSet(wish.get(), FC_CHARSET, set.get());
    FcResult result{};
    return font_of(FontPattern(FcFontMatch(nullptr, wish.get(), &result)));
}

/// DejaVu Sans from its file: fontconfig takes its time to start, and no refusal of memory.
CairoFont usual_font() {
    std::error_code error;
    if (!std::filesystem::exists(kUsualFont, error)) return font_with("");
    FontPattern file(FcPatternCreate());
    if (file) FcPatternAddString(file.get(), FC_FILE, bytes_of(kUsualFont));
    return font_of(file);
}

/// Words in DejaVu Sans, which the packages depend on, so that they look the same and are as wide
/// on every machine; letters that it lacks in the font that lacks the fewest of them. What no font
/// has is a box. Where DejaVu Sans is not installed fontconfig finds another one for it, and where
/// none is, cairo has letters of its own for ASCII.
class Typesetter {
  public:
    Typesetter(cairo_t* context, double letters) : context_(context) {
        cairo_set_font_size(context, letters);
    }

    double width(const std::string& text) const {
        double sum = 0.0;
        each_stretch(text, [&](const std::string& stretch) {
            cairo_text_extents_t size;
            cairo_text_extents(context_, stretch.c_str(), &size);
            sum += size.x_advance;
        });
        return sum;
    }
    /// From where the context's point is.
    void show(const std::string& text) const {
        each_stretch(
            text, [&](const std::string& stretch) { cairo_show_text(context_, stretch.c_str()); });
    }

  private:
    /// Which of the letters, one after the other, the usual font has.
    std::vector<bool> has(const std::string& text) const {
        cairo_set_font_face(context_, font_.get());
        cairo_glyph_t* glyphs = nullptr;
        int count = 0;
        cairo_scaled_font_text_to_glyphs(cairo_get_scaled_font(context_), 0.0, 0.0, text.c_str(),
                                         -1, &glyphs, &count, nullptr, nullptr, nullptr);
        const Glyphs held(glyphs);
        std::vector<bool> result;
        for (const cairo_glyph_t& glyph : std::span(glyphs, static_cast<std::size_t>(count))) {
            result.push_back(glyph.index != 0);
        }
        return result;
    }

    /// Calls `use` for one part of the text after the other, with its font in the context. A text
    /// that is no UTF-8 would end all drawing.
    template <class Use>
    void each_stretch(const std::string& text, const Use& use) const {
        const std::string all = in_utf8(text);
        const std::vector<bool> known = has(all);
        std::string stretch;
        bool ours = true;
        const auto finish = [&] {
            if (stretch.empty()) return;
            const CairoFont other = ours ? nullptr : font_with(stretch);
            cairo_set_font_face(context_, ours ? font_.get() : other.get());
            use(stretch);
            stretch.clear();
        };
        std::size_t number = 0;  // of a letter
        for (const char c : all) {
            const bool begins = (static_cast<unsigned char>(c) & 0xC0U) != 0x80U;
            const bool mine = begins ? number >= known.size() || known[number++] : ours;
            if (mine != ours) finish();
            ours = mine;
            stretch += c;
        }
        finish();
    }

    cairo_t* context_;
    CairoFont font_ = usual_font();
};

/// Letters of pixels, whatever the user's own settings: each begins with a whole one.
void sharpen_letters(cairo_t* context) {
    const std::unique_ptr<cairo_font_options_t, Releaser<cairo_font_options_destroy>> options(
        cairo_font_options_create());
    cairo_font_options_set_antialias(options.get(), CAIRO_ANTIALIAS_GRAY);
    cairo_font_options_set_hint_style(options.get(), CAIRO_HINT_STYLE_SLIGHT);
    cairo_font_options_set_hint_metrics(options.get(), CAIRO_HINT_METRICS_ON);
    cairo_set_font_options(context, options.get());
}

void set_colour(cairo_t* context, const Colour& colour) {
    cairo_set_source_rgb(context, colour.red / 255.0, colour.green / 255.0, colour.blue / 255.0);
}

/// Fills and draws what was outlined.
void paint_outline(cairo_t* context, const ShapeStyle& style) {
    if (style.fill) {
        set_colour(context, *style.fill);
        cairo_fill_preserve(context);
    }
    if (style.line) {
        set_colour(context, *style.line);
        cairo_stroke_preserve(context);
    }
    cairo_new_path(context);
}

void paint_words(cairo_t* context, const DrawnText& words, const Typesetter& letters) {
    const double share = words.anchor == Anchor::middle ? 0.5
                         : words.anchor == Anchor::end  ? 1.0
                                                        : 0.0;
    cairo_save(context);
    cairo_translate(context, words.at.x, words.at.y);
    if (words.upwards) cairo_rotate(context, -kPi / 2.0);
    cairo_move_to(context, share > 0.0 ? -share * letters.width(words.text) : 0.0, 0.0);
    letters.show(words.text);
    cairo_new_path(context);  // else the next line would begin behind the words
    cairo_restore(context);
}

void paint_layer(cairo_t* context, const DrawnLayer& layer) {
    const ShapeStyle& style = layer.style;
    const auto dashes = static_cast<int>(style.dashes.size());
    cairo_set_line_width(context, style.line_width);
    cairo_set_line_cap(context, dashes > 0 ? CAIRO_LINE_CAP_BUTT : CAIRO_LINE_CAP_ROUND);
    cairo_set_line_join(context, CAIRO_LINE_JOIN_ROUND);
    cairo_set_dash(context, style.dashes.data(), dashes, 0.0);
    for (const DrawnLine& line : layer.lines) {
        for (const Point2& point : line) cairo_line_to(context, point.x, point.y);
        if (layer.closed) cairo_close_path(context);
        paint_outline(context, style);
    }
    for (const DrawnEllipse& ellipse : layer.ellipses) {
        const auto p = bezier_of(ellipse);
        cairo_move_to(context, p[0].x, p[0].y);
        for (std::size_t i = 1; i < p.size(); i += 3) {
            cairo_curve_to(context, p.at(i).x, p.at(i).y, p.at(i + 1).x, p.at(i + 1).y,
                           p.at(i + 2).x, p.at(i + 2).y);
        }
        cairo_close_path(context);
        paint_outline(context, style);
    }
    if (layer.texts.empty() || !style.fill) return;
    set_colour(context, *style.fill);
    const Typesetter letters(context, style.letters);
    for (const DrawnText& words : layer.texts) paint_words(context, words, letters);
}

void check_drawn(cairo_status_t status) {
    if (status == CAIRO_STATUS_SUCCESS) return;
    throw Error(message(HITOS_TEXT("Errors", "the picture could not be drawn: %1"),
                        cairo_status_to_string(status)));
}

void paint_layers(cairo_t* context, const VectorDrawing& drawing) {
    const Bounds& frame = drawing.frame;
    for (const DrawnLayer& layer : drawing.layers) {
        cairo_save(context);
        if (layer.clipped) {
            cairo_rectangle(context, frame.low.x, frame.low.y, frame.high.x - frame.low.x,
                            frame.high.y - frame.low.y);
            cairo_clip(context);
        }
        paint_layer(context, layer);
        cairo_restore(context);
    }
    check_drawn(cairo_status(context));
}

cairo_status_t append_to(void* text, const unsigned char* bytes, unsigned length) {
    try {
        static_cast<std::string*>(text)->append(reinterpret_cast<const char*>(bytes), length);
    } catch (const std::exception&) {  // which cairo's C could not pass on
        return CAIRO_STATUS_NO_MEMORY;
    }
    return CAIRO_STATUS_SUCCESS;
}

}  // namespace

std::string pdf_text(const VectorDrawing& drawing) {
    constexpr double kPointsPerMm = 72.0 / 25.4;
    std::string out;
    const CairoSurface surface(cairo_pdf_surface_create_for_stream(
        append_to, &out, drawing.width * kPointsPerMm, drawing.height * kPointsPerMm));
    cairo_pdf_surface_restrict_to_version(surface.get(), CAIRO_PDF_VERSION_1_4);
    const auto tell = [&](cairo_pdf_metadata_t what, const char* words) {
        cairo_pdf_surface_set_metadata(surface.get(), what, words);
    };
    tell(CAIRO_PDF_METADATA_TITLE, in_utf8(drawing.title).c_str());
    tell(CAIRO_PDF_METADATA_CREATOR, fmt::format("Hitos {}", kVersion).c_str());
    tell(CAIRO_PDF_METADATA_CREATE_DATE, nullptr);  // else the time of writing
    {
        const CairoContext context(cairo_create(surface.get()));
        cairo_scale(context.get(), kPointsPerMm, kPointsPerMm);
        paint_layers(context.get(), drawing);
    }
    cairo_surface_finish(surface.get());
    check_drawn(cairo_surface_status(surface.get()));
    return out;
}

namespace drawing {

void paint(cv::Mat& image, const VectorDrawing& drawing, double scale, const Point2& corner) {
    // cairo's coordinates end at 2^15, and its pixels take four bytes: a piece after the other.
    constexpr int kSide = 2048;
    const bool grey = image.channels() == 1;
    cv::Mat pixels;
    for (int y = 0; y < image.rows; y += kSide) {
        for (int x = 0; x < image.cols; x += kSide) {
            cv::Mat piece = image(
                cv::Rect(x, y, std::min(kSide, image.cols - x), std::min(kSide, image.rows - y)));
            cv::cvtColor(piece, pixels, grey ? cv::COLOR_GRAY2BGRA : cv::COLOR_BGR2BGRA);
            const CairoSurface surface(
                cairo_image_surface_create_for_data(pixels.data, CAIRO_FORMAT_RGB24, pixels.cols,
                                                    pixels.rows, static_cast<int>(pixels.step)));
            const CairoContext context(cairo_create(surface.get()));
            cairo_translate(context.get(), -x - corner.x, -y - corner.y);
            cairo_scale(context.get(), scale, scale);
            sharpen_letters(context.get());
            paint_layers(context.get(), drawing);
            cairo_surface_flush(surface.get());
            cv::cvtColor(pixels, piece, grey ? cv::COLOR_BGRA2GRAY : cv::COLOR_BGRA2BGR);
        }
    }
}

double widest(std::span<const std::string> texts, double letters) {
    const CairoSurface surface(cairo_image_surface_create(CAIRO_FORMAT_A8, 1, 1));
    const CairoContext context(cairo_create(surface.get()));
    sharpen_letters(context.get());
    const Typesetter setter(context.get(), letters);
    double width = 0.0;
    for (const std::string& text : texts) width = std::max(width, setter.width(text));
    check_drawn(cairo_status(context.get()));
    return width;
}

}  // namespace drawing
}  // namespace hitos
