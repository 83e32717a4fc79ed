#include "hitos/simulation/dxf_walls.hpp"

#include <dl_creationadapter.h>
#include <dl_dxf.h>
#include <fmt/format.h>

#include <cmath>
#include <new>
#include <sstream>
#include <string>
#include <string_view>

#include "hitos/base/error.hpp"
#include "hitos/base/text_input.hpp"

namespace hitos {
namespace {

constexpr int kClosed = 1;           // group code 70 of a polyline
constexpr int kMesh = 16 | 64;       // polygon mesh, polyface mesh
constexpr int kCurveFitted = 2 | 4;  // the vertices only steer a curve

/// Metres per unit for the values of $INSUNITS that rooms are drawn in; nothing for others.
std::optional<double> unit_of(int insunits) {
    switch (insunits) {
        case 1:
            return 0.0254;
        case 2:
            return 0.3048;
        case 4:
            return 1e-3;
        case 5:
            return 1e-2;
        case 6:
            return 1.0;
        case 14:
            return 0.1;
        default:
            return std::nullopt;
    }
}

/// Gathers what dxflib calls out, in drawing units.
class Collector final : public DL_CreationAdapter {
  public:
    explicit Collector(std::string layer) : layer_(std::move(layer)) {}

    std::vector<std::vector<Point2>> walls;
    std::optional<double> unit_m;
    Message refused;  ///< the first entity that cannot be a wall and must not be passed over

    /// Closes the polyline under way; dxflib ends the two kinds of it in different ways.
    void finish() {
        if (open_ && closed_ && polyline_.size() > 1 && polyline_.front() != polyline_.back()) {
            polyline_.push_back(polyline_.front());
        }
        if (open_) walls.push_back(std::move(polyline_));
        polyline_.clear();
        open_ = false;
    }

    void addBlock(const DL_BlockData& /*data*/) override { in_block_ = true; }
    void endBlock() override {
        finish();
        in_block_ = false;
    }
    void setVariableInt(const std::string& key, int value, int /*code*/) override {
        if (key == "$INSUNITS") unit_m = unit_of(value);
    }
    void addLine(const DL_LineData& data) override {
        finish();
        if (wanted()) walls.push_back({{data.x1, data.y1}, {data.x2, data.y2}});
    }
    void addPolyline(const DL_PolylineData& data) override {
        finish();
        if (!wanted()) return;
        if ((data.flags & kMesh) != 0) refuse(HITOS_TEXT("Errors", "a mesh"));
        if ((data.flags & kCurveFitted) != 0) {
            refuse(HITOS_TEXT("Errors", "a polyline fitted to a curve"));
        }
        open_ = true;
        closed_ = (data.flags & kClosed) != 0;
    }
    void addVertex(const DL_VertexData& data) override {
        if (!open_) return;
        if (data.bulge != 0.0) refuse(HITOS_TEXT("Errors", "a polyline with arcs (bulges)"));
        polyline_.push_back({data.x, data.y});
    }
    void addArc(const DL_ArcData& /*data*/) override {
        refuse_if_wanted(HITOS_TEXT("Errors", "an ARC"));
    }
    void addCircle(const DL_CircleData& /*data*/) override {
        refuse_if_wanted(HITOS_TEXT("Errors", "a CIRCLE"));
    }
    void addEllipse(const DL_EllipseData& /*data*/) override {
        refuse_if_wanted(HITOS_TEXT("Errors", "an ELLIPSE"));
    }
    void addSpline(const DL_SplineData& /*data*/) override {
        refuse_if_wanted(HITOS_TEXT("Errors", "a SPLINE"));
    }
    void addInsert(const DL_InsertData& /*data*/) override {
        refuse_if_wanted(HITOS_TEXT("Errors", "an inserted block (INSERT)"));
    }

  private:
    /// Entities inside a block's definition are drawn only where the block is inserted.
    bool wanted() { return !in_block_ && (layer_.empty() || attributes.getLayer() == layer_); }
    void refuse(const char* what) {
        if (refused.empty()) refused = marked(what);
    }
    void refuse_if_wanted(const char* what) {
        finish();
        if (wanted()) refuse(what);
    }

    std::string layer_;
    std::vector<Point2> polyline_;
    bool open_ = false;
    bool closed_ = false;
    bool in_block_ = false;
};

constexpr std::size_t kLargestDrawing = std::size_t{1} << 28;

/// The pairs of lines, group code and value, that dxflib reads without harm: it reads a line of
/// 1,024 characters for ever, and takes a comment (999) that begins with its own name apart. What
/// is cut so long is no number, and comments are no walls.
std::string as_dxflib_bears_it(std::string_view text) {
    constexpr std::size_t kLongest = 1000;
    std::string borne;
    borne.reserve(text.size());
    while (const auto code = input::next_line(text)) {
        const auto value = input::next_line(text);
        const bool comment = input::trimmed(*code) == "999";
        if (!comment) borne.append(code->substr(0, kLongest)) += '\n';
        if (value && !comment) borne.append(value->substr(0, kLongest)) += '\n';
    }
    return borne;
}

}  // namespace

std::vector<std::vector<Point2>> read_dxf_walls(const std::filesystem::path& path,
                                                const DxfOptions& options) {
    std::error_code problem;
    if (std::filesystem::is_directory(path, problem)) {
        throw FileError(path.string(),
                        message(HITOS_TEXT("Errors", "is a directory; expected a DXF drawing")));
    }
    std::istringstream text(as_dxflib_bears_it(input::read_text(path, kLargestDrawing)));
    Collector collector(options.layer);
    DL_Dxf reader;
    try {
        reader.in(text, &collector);
    } catch (const std::bad_alloc&) {
        throw;
    } catch (...) {  // its exceptions are of no common type
        throw FormatError(path.string(), 0,
                          message(HITOS_TEXT("Errors",
                                             "cannot be read as a DXF drawing: save it as ASCII "
                                             "DXF, of AutoCAD 2000 or 2004, and try again")));
    }
    collector.finish();
    const Message place = options.layer.empty()
                              ? message(HITOS_TEXT("Errors", "the drawing"))
                              : message(HITOS_TEXT("Errors", "layer \"%1\""), options.layer);
    if (!collector.refused.empty()) {
        throw FormatError(
            path.string(), 0,
            message(HITOS_TEXT(
                        "Errors",
                        "%1 holds %2; walls are straight: expected LINE, LWPOLYLINE and POLYLINE "
                        "(explode blocks, draw arcs as polylines, or name the walls' layer)"),
                    place, collector.refused));
    }
    if (collector.walls.empty()) {
        throw FormatError(path.string(), 0,
                          message(HITOS_TEXT("Errors",
                                             "%1 holds no wall; expected LINE, LWPOLYLINE or "
                                             "POLYLINE entities of an ASCII DXF drawing"),
                                  place));
    }
    const double unit_m = options.unit_m.value_or(collector.unit_m.value_or(1.0));
    for (std::vector<Point2>& wall : collector.walls) {
        if (wall.size() < 2) {
            throw FormatError(
                path.string(), 0,
                message(HITOS_TEXT("Errors", "%1 holds a polyline of one point; a wall needs two"),
                        place));
        }
        for (Point2& point : wall) {
            point = {point.x * unit_m, point.y * unit_m};
            if (!std::isfinite(point.x) || !std::isfinite(point.y)) {
                throw FormatError(
                    path.string(), 0,
                    message(HITOS_TEXT("Errors", "holds a point that is not finite")));
            }
        }
    }
    return std::move(collector.walls);
}

}  // namespace hitos
