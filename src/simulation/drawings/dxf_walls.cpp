// SPDX-License-Identifier: GPL-3.0-or-later
#include "hitos/simulation/drawings/dxf_walls.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <map>
#include <set>
#include <string_view>
#include <utility>

#include "dxf_placing.hpp"
#include "dxf_shapes.hpp"
#include "hitos/base/error.hpp"
#include "hitos/base/text_input.hpp"

namespace hitos {
namespace {

constexpr double kChord = 0.005;  // m, how far a chord may lie from its curve
constexpr std::size_t kLargestDrawing = std::size_t{1} << 28;
// Entities and insertions, each as often as drawn, long ones by the length of their text.
constexpr std::size_t kMostDrawn = 2'000'000;
constexpr std::size_t kLongText = 64;
constexpr std::size_t kDeepest = 100;  // blocks in blocks

/// How many there are of each name.
using Counts = std::map<std::string, std::size_t>;

std::string listed(const Counts& counts) {
    constexpr std::size_t kMost = 12;
    std::vector<std::string> parts;
    for (const auto& [name, count] : counts) {
        if (parts.size() == kMost) {
            parts.emplace_back("...");
            break;
        }
        parts.push_back(fmt::format("{} {}", count, name));
    }
    return fmt::format("{}", fmt::join(parts, ", "));
}

/// What says something about a drawing and never is a wall.
bool is_annotation(std::string_view type) {
    constexpr std::array kTypes = {"TEXT",      "MTEXT",         "ATTRIB",
                                   "ATTDEF",    "RTEXT",         "ARCALIGNEDTEXT",
                                   "DIMENSION", "ARC_DIMENSION", "LARGE_RADIAL_DIMENSION",
                                   "LEADER",    "MLEADER",       "MULTILEADER",
                                   "TOLERANCE", "ACAD_TABLE",    "POINT",
                                   "XLINE",     "RAY",           "VIEWPORT",
                                   "WIPEOUT",   "LIGHT",         "SUN",
                                   "CAMERA",    "SECTIONOBJECT", "GEOPOSITIONMARKER"};
    return std::ranges::find(kTypes, type) != kTypes.end();
}

/// Draws what the entities show, seen from above, in drawing units, and keeps count.
class Draughtsman {
  public:
    Draughtsman(const dxf::Drawing& drawing, std::string path, const std::string& layers,
                double unit_m)
        : drawing_(drawing), path_(std::move(path)), unit_m_(unit_m) {
        std::string_view rest = layers;
        while (!rest.empty()) {
            const std::size_t comma = rest.find(',');
            chosen_.insert(dxf::key_of(rest.substr(0, comma)));
            rest.remove_prefix(comma == std::string_view::npos ? rest.size() : comma + 1);
        }
    }

    void draw() { draw(drawing_.entities, Eigen::Affine3d::Identity(), {}); }

    std::vector<dxf::Wall> walls;
    Counts drawn;       ///< by type
    Counts curved;      ///< of those, by type
    Counts elsewhere;   ///< by layer: what would be walls, had their layer been chosen
    Counts hidden;      ///< by layer
    Counts on_sheets;   ///< by type
    Counts invisible;   ///< by type
    Counts annotation;  ///< by type
    Counts unread;      ///< by type
    Counts missing;     ///< by block or file: inserted, but not there
    std::size_t wide = 0;
    std::size_t flat = 0;  ///< of no length

  private:
    const dxf::Layer* layer_of(const std::string& key) const {
        const auto found = drawing_.layers.find(key);
        return found == drawing_.layers.end() ? nullptr : &found->second;
    }

    void spend(std::size_t& budget, std::size_t most, std::size_t amount = 1) const {
        budget += amount;
        if (budget <= most) return;
        throw FormatError(path_, 0,
                          HITOS_TEXT("Errors",
                                     "shows more than %1 pieces, blocks as often as they are "
                                     "inserted; name the layer of the walls"),
                          most);
    }

    /// `on` is the layer that stands for 0 in a block.
    void draw(const std::vector<dxf::Entity>& entities, const Eigen::Affine3d& placed,
              std::string_view on) {
        for (std::size_t i = 0; i < entities.size(); ++i) {
            const dxf::Entity& entity = entities[i];
            spend(steps_, kMostDrawn, 1 + entity.text.size() / kLongText);
            if (entity.type == "VERTEX" || entity.type == "SEQEND") continue;
            const std::string type(entity.type);
            const bool is_insert = type == "INSERT";
            if (is_annotation(type)) {
                ++annotation[type];
                continue;
            }
            if (entity.paper || entity.invisible) {
                ++(entity.paper ? on_sheets : invisible)[type];
                continue;
            }
            const bool inherits = !on.empty() && entity.layer == "0";
            const std::string_view layer = inherits ? on : entity.layer;
            const std::string key = dxf::key_of(layer);
            const bool chosen = chosen_.contains(key);
            const dxf::Layer* its = layer_of(key);
            if (!chosen && its != nullptr &&
                (is_insert ? its->frozen : chosen_.empty() && its->hidden)) {
                ++hidden[dxf::name_of(layer)];
            } else if (is_insert) {
                insert(entity, placed, layer);
            } else if (!chosen && !chosen_.empty()) {
                ++elsewhere[dxf::name_of(layer)];
            } else if (!dxf::has_shape(type)) {
                ++unread[type];
            } else {
                std::size_t end = i + 1;
                while (end < entities.size() && entities[end].type == "VERTEX") ++end;
                draw(entity, {entities.data() + i + 1, end - i - 1}, placed, dxf::name_of(layer));
            }
        }
    }

    void draw(const dxf::Entity& entity, std::span<const dxf::Entity> vertices,
              const Eigen::Affine3d& placed, const std::string& layer) {
        constexpr double kLeastScale = 1e-12;
        const double scale = placed.linear().colwise().norm().maxCoeff();
        const double chord = kChord / (unit_m_ * std::max(scale, kLeastScale));
        const dxf::Shape shape = dxf::shape_of(drawing_, entity, vertices, chord);
        const std::string type(entity.type);
        if (!shape.readable || shape.fill) {
            ++(shape.fill ? annotation : unread)[shape.fill ? type + " (pattern)" : type];
            return;
        }
        bool seen = false;
        for (const dxf::Curve& curve : shape.curves) {
            std::vector<Point2> wall;
            for (const Eigen::Vector3d& point : curve) {
                const Eigen::Vector3d at = placed * point;
                const Point2 next{at.x() * unit_m_, at.y() * unit_m_};
                if (wall.empty() || wall.back() != next) wall.push_back(next);
                spend(points_, dxf::kMostPoints);
            }
            if (wall.size() < 2) continue;
            seen = true;
            walls.push_back({std::move(wall), type, layer});
        }
        if (!seen) {
            ++flat;
            return;
        }
        ++drawn[type];
        if (shape.curved) ++curved[type];
        if (shape.wide) ++wide;
    }

    void insert(const dxf::Entity& entity, const Eigen::Affine3d& placed, std::string_view layer) {
        const dxf::Fields fields(drawing_, entity);
        const std::string key = dxf::key_of(fields.word(2));
        const auto found = drawing_.blocks.find(key);
        const std::string name = dxf::name_of(fields.word(2));
        if (found == drawing_.blocks.end() ||
            (found->second.entities.empty() && !found->second.external.empty())) {
            ++missing[found == drawing_.blocks.end() ? name : found->second.external];
            return;
        }
        if (open_.contains(key) || open_.size() >= kDeepest) {
            ++unread["INSERT"];
            return;
        }
        const auto vector = [&](int code, double otherwise) {
            return Eigen::Vector3d(fields.number(code, otherwise),
                                   fields.number(code + 10, otherwise),
                                   fields.number(code + 20, otherwise));
        };
        Eigen::Vector3d extrusion = vector(210, 0.0);
        if (extrusion.isZero(0.0)) extrusion = Eigen::Vector3d::UnitZ();
        const Eigen::Vector3d scale(fields.number(41, 1.0), fields.number(42, 1.0),
                                    fields.number(43, 1.0));
        const Eigen::Map<const Eigen::Vector3d> base(found->second.base.data());
        const int columns = std::max(1, fields.integer(70, 1));
        const int rows = std::max(1, fields.integer(71, 1));
        const Eigen::Affine3d at =
            placed * Eigen::Affine3d(dxf::axes_of(extrusion)) *
            Eigen::Translation3d(vector(10, 0.0)) *
            Eigen::AngleAxisd(fields.number(50, 0.0) * kRadiansPerDegree, Eigen::Vector3d::UnitZ());
        open_.insert(key);
        for (int column = 0; column < columns; ++column) {
            for (int row = 0; row < rows; ++row) {
                spend(steps_, kMostDrawn);
                const Eigen::Vector3d cell(column * fields.number(44, 0.0),
                                           row * fields.number(45, 0.0), 0.0);
                draw(found->second.entities,
                     at * Eigen::Translation3d(cell) * Eigen::Scaling(scale) *
                         Eigen::Translation3d(-base),
                     layer);
            }
        }
        open_.erase(key);
        ++drawn["INSERT"];
    }

    const dxf::Drawing& drawing_;
    std::string path_;
    double unit_m_;
    std::set<std::string> chosen_;  ///< layers; none: all
    std::set<std::string> open_;    ///< blocks that are being drawn
    std::size_t steps_ = 0;
    std::size_t points_ = 0;
};

void tell_what_was_drawn(const Draughtsman& by, DxfWalls& result) {
    const auto note = [&](const Counts& counts, MessageText<1> text) {
        if (!counts.empty()) result.notes.push_back(message(text, listed(counts)));
    };
    const auto warn = [&](const Counts& counts, MessageText<1> text) {
        if (!counts.empty()) result.warnings.push_back(message(text, listed(counts)));
    };
    note(by.drawn, HITOS_TEXT("Errors", "drawing: walls are made of %1"));
    note(by.curved,
         HITOS_TEXT("Errors", "drawing: chords, at most 5 mm off, stand for the curves of %1"));
    note(by.annotation, HITOS_TEXT("Errors", "drawing: %1 passed over, which are no walls"));
    note(by.on_sheets, HITOS_TEXT("Errors", "drawing: %1 left out, on sheets (paper space)"));
    note(by.invisible, HITOS_TEXT("Errors", "drawing: %1 left out, invisible"));
    note(by.hidden, HITOS_TEXT("Errors",
                               "drawing: left out on layers that are off or frozen: %1; name them "
                               "(--layer, dxf_layer) to have them"));
    note(by.elsewhere, HITOS_TEXT("Errors", "drawing: left out on other layers: %1"));
    if (by.flat > 0) {
        result.notes.push_back(message(
            HITOS_TEXT("Errors", "drawing: left out, of no length seen from above: %1"), by.flat));
    }
    if (by.wide > 0) {
        result.warnings.push_back(message(HITOS_TEXT("Errors",
                                                     "drawing: polylines drawn with a width: %1; "
                                                     "their middle lines are taken for walls"),
                                          by.wide));
    }
    warn(by.unread, HITOS_TEXT("Errors",
                               "drawing: %1 cannot be read and may be walls that are missing; "
                               "explode them where they were drawn"));
    warn(by.missing, HITOS_TEXT("Errors",
                                "drawing: inserted, but not in the file: %1; bind external "
                                "references where it was drawn"));
}

[[noreturn]] void refuse(const std::filesystem::path& path, const DxfOptions& options,
                         const Draughtsman& by) {
    const Message place = options.layer.empty()
                              ? message(HITOS_TEXT("Errors", "the drawing"))
                              : message(HITOS_TEXT("Errors", "layer \"%1\""), options.layer);
    Counts rest;
    for (const Counts* counts : {&by.elsewhere, &by.hidden, &by.on_sheets, &by.invisible,
                                 &by.unread, &by.missing, &by.annotation}) {
        for (const auto& [name, count] : *counts) rest[name] += count;
    }
    if (rest.empty()) {
        throw FormatError(path.string(), 0,
                          HITOS_TEXT("Errors",
                                     "%1 holds no wall; expected LINE, LWPOLYLINE or POLYLINE "
                                     "entities of an ASCII DXF drawing"),
                          place);
    }
    throw FormatError(
        path.string(), 0,
        message(
            !by.elsewhere.empty()
                ? MessageText<2>(HITOS_TEXT(
                      "Errors", "%1 holds no wall; expected one of the layers that do: %2"))
                : MessageText<2>(HITOS_TEXT("Errors",
                                            "%1 holds no wall; found %2 that are none, cannot be "
                                            "read, or are hidden (name their layer to have them)")),
            place, listed(by.elsewhere.empty() ? rest : by.elsewhere)));
}

}  // namespace

DxfWalls read_dxf_walls(const std::filesystem::path& path, const DxfOptions& options) {
    std::error_code problem;
    if (std::filesystem::is_directory(path, problem)) {
        throw FileError(path.string(),
                        HITOS_TEXT("Errors", "is a directory; expected a DXF drawing"));
    }
    const dxf::Drawing drawing(input::read_text(path, kLargestDrawing), path);
    const dxf::Unit unit = dxf::unit_of(drawing.insunits, options.unit_m);
    Draughtsman by(drawing, path.string(), options.layer, unit.metres);
    by.draw();
    DxfWalls result;
    for (const auto& [key, layer] : drawing.layers) result.layers.push_back(layer.name);
    dxf::place(std::move(by.walls), unit, options.far_m, result);
    if (result.walls.empty()) refuse(path, options, by);
    tell_what_was_drawn(by, result);
    if (!drawing.ended) {
        result.warnings.push_back(
            message(HITOS_TEXT("Errors",
                               "drawing: breaks off before its end (EOF); what followed is "
                               "missing, its last entity too")));
    }
    return result;
}

}  // namespace hitos
