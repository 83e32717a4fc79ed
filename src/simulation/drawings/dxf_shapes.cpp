// SPDX-License-Identifier: GPL-3.0-or-later
#include "dxf_shapes.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>

#include "dxf_curves.hpp"
#include "hitos/base/geometry.hpp"

namespace hitos::dxf {
namespace {

using Eigen::Vector3d;

/// The point whose x has this group code; y and z have 10 and 20 more.
Vector3d point_of(const Fields& fields, int code, const Vector3d& otherwise = Vector3d::Zero()) {
    return {fields.number(code, otherwise.x()), fields.number(code + 10, otherwise.y()),
            fields.number(code + 20, otherwise.z())};
}

bool has_point(const Fields& fields, int code) {
    return !fields.word(code).empty() && !fields.word(code + 10).empty();
}

Vector3d extrusion_of(const Fields& fields) {
    return point_of(fields, 210, Vector3d::UnitZ());
}

/// To the drawing's coordinates from the entity's own.
void turn(Shape& shape, const Fields& fields) {
    const Eigen::Matrix3d axes = axes_of(extrusion_of(fields));
    if (axes.isIdentity(0.0)) return;
    for (Curve& curve : shape.curves) {
        for (Vector3d& point : curve) point = axes * point;
    }
}

void line(Shape& shape, const Fields& fields) {
    shape.readable = has_point(fields, 10) && has_point(fields, 11);
    shape.curves.push_back({point_of(fields, 10), point_of(fields, 11)});
}

void round(Shape& shape, const Fields& fields, bool whole, double chord) {
    const double radius = std::abs(fields.number(40, 0.0));
    shape.readable = has_point(fields, 10) && radius > 0.0 &&
                     (whole || (!fields.word(50).empty() && !fields.word(51).empty()));
    shape.curved = true;
    const double from = fields.number(50, 0.0) * kRadiansPerDegree;
    const double to = fields.number(51, 0.0) * kRadiansPerDegree;
    shape.curves.push_back(
        chords_of({point_of(fields, 10), radius * Vector3d::UnitX(), radius * Vector3d::UnitY(),
                   whole ? 0.0 : from, whole ? 2.0 * kPi : sweep_between(from, to)},
                  chord));
}

void ellipse(Shape& shape, const Fields& fields, double chord) {
    const Vector3d u = point_of(fields, 11);
    const Vector3d v = extrusion_of(fields).normalized().cross(u) * fields.number(40, 1.0);
    const double from = fields.number(41, 0.0);
    shape.readable = has_point(fields, 10) && has_point(fields, 11);
    shape.curved = true;
    shape.curves.push_back(chords_of(
        {point_of(fields, 10), u, v, from, sweep_between(from, fields.number(42, 2.0 * kPi))},
        chord));
}

/// Points that come one after the other, x first.
void collect(std::vector<Vector3d>& points, const Group& group, int x, double value) {
    if (group.code == x) points.emplace_back(value, 0.0, 0.0);
    if (points.empty()) return;
    if (group.code == x + 10) points.back().y() = value;
    if (group.code == x + 20) points.back().z() = value;
}

void spline(Shape& shape, const Fields& fields, double chord) {
    constexpr int kClosed = 1;
    Spline read;
    Curve fit;
    for (const Group& group : fields.all()) {
        switch (group.code) {
            case 40:
                read.knots.push_back(fields.number(group));
                break;
            case 41:
                read.weights.push_back(fields.number(group));
                break;
            case 10:
            case 20:
            case 30:
                collect(read.points, group, 10, fields.number(group));
                break;
            case 11:
            case 21:
            case 31:
                collect(fit, group, 11, fields.number(group));
                break;
            default:
                break;
        }
    }
    read.degree = fields.integer(71, 3);
    shape.curved = true;
    Curve curve = chords_of(read, chord);
    if (curve.empty() && read.points.empty()) {  // only the points that it goes through are told
        curve = fit;
        if ((fields.integer(70, 0) & kClosed) != 0 && !fit.empty()) curve.push_back(fit.front());
    }
    shape.readable = curve.size() >= 2;
    shape.curves.push_back(std::move(curve));
}

struct Corner {
    Vector3d at;
    double bulge = 0.0;  ///< of the way to the next one
};

void chain(Shape& shape, const std::vector<Corner>& corners, bool closed, double chord) {
    Curve curve;
    shape.readable = shape.readable && !corners.empty();
    if (corners.empty()) return;
    for (std::size_t i = 0; i < corners.size() + (closed ? 1 : 0); ++i) {
        const double bulge = i == 0 ? 0.0 : corners[i - 1].bulge;
        shape.curved = shape.curved || bulge != 0.0;
        append_bulge(curve, corners[i % corners.size()].at, bulge, chord);
    }
    shape.curves.push_back(std::move(curve));
}

void light_polyline(Shape& shape, const Fields& fields, double chord) {
    constexpr int kClosed = 1;
    std::vector<Corner> corners;
    const double height = fields.number(38, 0.0);
    for (const Group& group : fields.all()) {
        if (group.code == 10) {
            corners.push_back({{fields.number(group), 0.0, height}, 0.0});
        } else if (group.code == 43) {
            shape.wide = fields.number(group) > 0.0;
        } else if (!corners.empty()) {
            if (group.code == 20) corners.back().at.y() = fields.number(group);
            if (group.code == 42) corners.back().bulge = fields.number(group);
            if (group.code == 40 || group.code == 41)
                shape.wide = shape.wide || fields.number(group) > 0.0;
        }
    }
    chain(shape, corners, (fields.integer(70, 0) & kClosed) != 0, chord);
}

/// The edges of a mesh's faces; a negative corner begins an edge that is not seen.
void faces(Shape& shape, const std::vector<Vector3d>& points,
           const std::vector<std::array<int, 4>>& corners) {
    const auto at = [&](int corner) { return static_cast<std::size_t>(std::abs(corner)) - 1; };
    for (const auto& face : corners) {
        std::vector<int> used;
        std::ranges::copy_if(face, std::back_inserter(used),
                             [](int corner) { return corner != 0; });
        for (std::size_t i = 0; i < used.size(); ++i) {
            const int next = used[(i + 1) % used.size()];
            if (at(used[i]) >= points.size() || at(next) >= points.size()) {
                shape.readable = false;
            } else if (used[i] > 0) {
                shape.curves.push_back({points[at(used[i])], points[at(next)]});
            }
        }
    }
}

/// M x N points, row by row; closed in one direction, the other or both.
void grid(Shape& shape, const std::vector<Vector3d>& points, std::size_t m, std::size_t n,
          int flags) {
    shape.readable = m >= 1 && n >= 1 && points.size() / n == m && points.size() % n == 0;
    if (!shape.readable) return;
    const auto thread = [&](std::size_t first, std::size_t step, std::size_t count, bool closed) {
        Curve curve;
        for (std::size_t i = 0; i < count; ++i) curve.push_back(points[first + i * step]);
        if (closed) curve.push_back(points[first]);
        shape.curves.push_back(std::move(curve));
    };
    for (std::size_t i = 0; i < m; ++i) thread(i * n, 1, n, (flags & 32) != 0);
    for (std::size_t j = 0; j < n; ++j) thread(j, n, m, (flags & 1) != 0);
}

void heavy_polyline(Shape& shape, const Drawing& drawing, const Fields& fields,
                    std::span<const Entity> vertices, double chord) {
    constexpr int kClosed = 1;
    constexpr int kSplineFitted = 4;
    constexpr int kInSpace = 8;
    constexpr int kMesh = 16;
    constexpr int kPolyface = 64;
    constexpr int kFrame = 16;        // of a vertex: it only steers a spline
    constexpr int kFaceRecord = 128;  // of a vertex of a polyface, without kPolyface
    const int flags = fields.integer(70, 0);
    const double height = fields.number(30, 0.0);
    const bool in_space = (flags & (kInSpace | kMesh | kPolyface)) != 0;
    shape.wide = !in_space && (fields.number(40, 0.0) > 0.0 || fields.number(41, 0.0) > 0.0);
    std::vector<Corner> corners;
    std::vector<Vector3d> points;
    std::vector<std::array<int, 4>> records;
    for (const Entity& vertex : vertices) {
        const Fields its(drawing, vertex);
        const int kind = its.integer(70, 0);
        if ((flags & kPolyface) != 0 && (kind & kFaceRecord) != 0 && (kind & kPolyface) == 0) {
            records.push_back(
                {its.integer(71, 0), its.integer(72, 0), its.integer(73, 0), its.integer(74, 0)});
            continue;
        }
        if ((flags & kSplineFitted) != 0 && (kind & kFrame) != 0) continue;
        shape.readable = shape.readable && has_point(its, 10);
        Vector3d at = point_of(its, 10);
        points.push_back(at);
        if (!in_space) at.z() = height;
        corners.push_back({at, in_space ? 0.0 : its.number(42, 0.0)});
        shape.wide =
            shape.wide || (!in_space && (its.number(40, 0.0) > 0.0 || its.number(41, 0.0) > 0.0));
    }
    if ((flags & kPolyface) != 0) {
        faces(shape, points, records);
    } else if ((flags & kMesh) != 0) {
        const bool smooth = (flags & kSplineFitted) != 0;
        grid(shape, points,
             static_cast<std::size_t>(std::max(0, fields.integer(smooth ? 73 : 71, 0))),
             static_cast<std::size_t>(std::max(0, fields.integer(smooth ? 74 : 72, 0))), flags);
    } else {
        chain(shape, corners, (flags & kClosed) != 0, chord);
        if (!in_space) turn(shape, fields);
    }
}

/// SOLID and TRACE tell their last two corners crosswise; edges of a 3DFACE may be unseen.
void face(Shape& shape, const Fields& fields, bool crosswise) {
    shape.readable = has_point(fields, 10) && has_point(fields, 11) && has_point(fields, 12);
    const Vector3d third = point_of(fields, 12);
    const Vector3d fourth = point_of(fields, 13, third);
    const std::array corners = {point_of(fields, 10), point_of(fields, 11),
                                crosswise ? fourth : third, crosswise ? third : fourth};
    const int unseen = crosswise ? 0 : fields.integer(70, 0);
    for (std::size_t i = 0; i < corners.size(); ++i) {
        if ((unseen & (1 << i)) != 0) continue;
        const Vector3d& next = corners[(i + 1) % corners.size()];
        if (!shape.curves.empty() && shape.curves.back().back() == corners[i]) {
            shape.curves.back().push_back(next);
        } else {
            shape.curves.push_back({corners[i], next});
        }
    }
}

/// A corner of an MLINE: along `mitre` its elements are met, along `way` they go on to the next.
struct MlineCorner {
    Vector3d at;
    Vector3d way = Vector3d::Zero();
    Vector3d mitre = Vector3d::Zero();
    /// Of each element: how far along the mitre, then where along the way it begins and where it
    /// is cut, begins again, and so on; nothing more than the beginning: it goes to its end.
    std::vector<std::vector<double>> elements;
};

void mline(Shape& shape, const Drawing& drawing, const Fields& fields) {
    constexpr int kClosed = 2;
    std::vector<MlineCorner> corners;
    std::vector<Vector3d> points;
    std::vector<Vector3d> ways;
    std::vector<Vector3d> mitres;
    for (const Group& group : fields.all()) {
        if (group.code == 11) corners.emplace_back();
        if (group.code >= 11 && group.code <= 33 && group.code % 10 >= 1 && group.code % 10 <= 3) {
            const double value = fields.number(group);
            collect(points, group, 11, value);
            collect(ways, group, 12, value);
            collect(mitres, group, 13, value);
        }
        if (corners.empty()) continue;
        if (group.code == 74) corners.back().elements.emplace_back();
        if (group.code == 41 && !corners.back().elements.empty())
            corners.back().elements.back().push_back(fields.number(group));
    }
    shape.readable = corners.size() >= 2 && points.size() == corners.size() &&
                     ways.size() == corners.size() && mitres.size() == corners.size();
    if (!shape.readable) return;
    const std::size_t elements = corners.front().elements.size();
    for (std::size_t i = 0; i < corners.size(); ++i) {
        corners[i].at = points[i];
        corners[i].way = ways[i];
        corners[i].mitre = mitres[i];
        // The last corner of an open one need tell no more than where its elements end.
        shape.readable = shape.readable && corners[i].elements.size() == elements && elements > 0 &&
                         std::ranges::none_of(corners[i].elements, &std::vector<double>::empty);
    }
    if (!shape.readable) return;
    const auto end = [&](const MlineCorner& corner, std::size_t element) -> Vector3d {
        return corner.at + corner.mitre * corner.elements[element].front();
    };
    const int flags = fields.integer(71, 0);
    const bool closed = (flags & kClosed) != 0;
    for (std::size_t element = 0; element < elements; ++element) {
        for (std::size_t i = 0; i + (closed ? 0 : 1) < corners.size(); ++i) {
            const MlineCorner& corner = corners[i];
            const std::vector<double>& cuts = corner.elements[element];
            const Vector3d from = end(corner, element);
            const Vector3d to = end(corners[(i + 1) % corners.size()], element);
            for (std::size_t k = 1; k < std::max<std::size_t>(cuts.size(), 2); k += 2) {
                shape.curves.push_back(
                    {k < cuts.size() ? Vector3d(from + corner.way * cuts[k]) : from,
                     k + 1 < cuts.size() ? Vector3d(from + corner.way * cuts[k + 1]) : to});
            }
        }
    }
    // Caps, whatever their form, are straight; they join the outermost elements.
    const auto style = drawing.mline_flags.find(key_of(fields.word(2)));
    if (closed || style == drawing.mline_flags.end()) return;
    constexpr int kCapsAtStart = 16 | 64;
    constexpr int kCapsAtEnd = 256 | 1024;
    const auto cap = [&](const MlineCorner& corner) {
        const auto [least, most] = std::ranges::minmax_element(
            corner.elements, {}, [](const std::vector<double>& cuts) { return cuts.front(); });
        shape.curves.push_back(
            {corner.at + corner.mitre * least->front(), corner.at + corner.mitre * most->front()});
    };
    if ((style->second & kCapsAtStart) != 0 && (flags & 4) == 0) cap(corners.front());
    if ((style->second & kCapsAtEnd) != 0 && (flags & 8) == 0) cap(corners.back());
}

/// One edge of a HATCH's boundary from the groups that follow its kind (72).
Curve hatch_edge(const Fields& fields, int kind, std::span<const Group> groups, double chord) {
    Vector3d at = Vector3d::Zero();
    Vector3d to = Vector3d::Zero();
    Spline spline;
    double ratio_or_radius = 0.0;
    double from = 0.0;
    double until = 0.0;
    bool clockwise = false;
    for (const Group& group : groups) {
        const double value = fields.number(group);
        if (kind == 4) {
            if (group.code == 94) spline.degree = whole(value);
            if (group.code == 40) spline.knots.push_back(value);
            if (group.code == 42) spline.weights.push_back(value);
            collect(spline.points, group, 10, value);
        } else if (group.code == 10 || group.code == 20) {
            (group.code == 10 ? at.x() : at.y()) = value;
        } else if (group.code == 11 || group.code == 21) {
            (group.code == 11 ? to.x() : to.y()) = value;
        } else if (group.code == 40) {
            ratio_or_radius = value;
        } else if (group.code == 50 || group.code == 51) {
            (group.code == 50 ? from : until) = value * kRadiansPerDegree;
        } else if (group.code == 73) {
            clockwise = value == 0.0;
        }
    }
    if (kind == 1) return {at, to};
    if (kind == 4) return chords_of(spline, chord);
    // Clockwise ones tell their angles as if seen from below.
    if (clockwise) std::swap(from = -from, until = -until);
    const Vector3d u = kind == 2 ? Vector3d(ratio_or_radius, 0.0, 0.0) : to;
    const Vector3d v = Vector3d(-u.y(), u.x(), 0.0) * (kind == 2 ? 1.0 : ratio_or_radius);
    return chords_of({at, u, v, from, sweep_between(from, until)}, chord);
}

/// The outlines of a filled surface.
void hatch(Shape& shape, const Fields& fields, double chord) {
    shape.fill = fields.integer(70, 0) != 1;
    if (shape.fill) return;
    constexpr int kPolyline = 2;
    const std::vector<Group>& all = fields.all();
    const auto find = [&](std::size_t from, auto wanted) {
        while (from < all.size() && !wanted(all[from].code)) ++from;
        return from;
    };
    const auto boundary_ends = [](int code) { return code == 92 || code == 97 || code == 75; };
    std::size_t i = find(0, [](int code) { return code == 92 || code == 75; });
    std::size_t points = 0;
    while (i < all.size() && all[i].code == 92 && points <= kMostPoints) {
        const bool polyline = (whole(fields.number(all[i])) & kPolyline) != 0;
        const std::size_t begin = i + 1;
        std::vector<Corner> corners;
        bool closed = true;
        if (polyline) {
            i = find(begin, boundary_ends);
            for (std::size_t k = begin; k < i; ++k) {
                const double value = fields.number(all[k]);
                if (all[k].code == 73) closed = value != 0.0;
                if (all[k].code == 10) corners.push_back({{value, 0.0, 0.0}, 0.0});
                if (corners.empty()) continue;
                if (all[k].code == 20) corners.back().at.y() = value;
                if (all[k].code == 42) corners.back().bulge = value;
            }
            chain(shape, corners, closed, chord);
            if (!shape.readable) return;
            points += shape.curves.back().size();
        } else {
            i = find(begin, [&](int code) { return code == 72 || boundary_ends(code); });
            while (i < all.size() && all[i].code == 72 && points <= kMostPoints) {
                const int kind = whole(fields.number(all[i]));
                const std::size_t edge = i + 1;
                // A spline's own 97 counts points that it goes through: 11 follows it, or 12.
                i = find(edge, [&](int code) { return code == 72 || boundary_ends(code); });
                while (kind == 4 && i + 1 < all.size() && all[i].code == 97 &&
                       (all[i + 1].code == 11 || all[i + 1].code == 72 || all[i + 1].code == 97)) {
                    i = find(i + 1, [&](int code) { return code == 72 || boundary_ends(code); });
                }
                Curve curve =
                    hatch_edge(fields, kind, std::span(all).subspan(edge, i - edge), chord);
                shape.curved = shape.curved || kind != 1;
                shape.readable = shape.readable && curve.size() >= 2;
                points += curve.size();
                shape.curves.push_back(std::move(curve));
            }
        }
        i = find(i, [](int code) { return code == 92 || code == 75; });
    }
    shape.readable = shape.readable && !shape.curves.empty();
}

}  // namespace

Eigen::Matrix3d axes_of(const Vector3d& extrusion) {
    constexpr double kNearlyUpright = 1.0 / 64.0;
    const double length = extrusion.norm();
    if (!(length > 0.0) || !std::isfinite(length)) return Eigen::Matrix3d::Identity();
    const Vector3d z = extrusion / length;
    const bool upright = std::abs(z.x()) < kNearlyUpright && std::abs(z.y()) < kNearlyUpright;
    const Vector3d x = (upright ? Vector3d::UnitY() : Vector3d::UnitZ()).cross(z).normalized();
    Eigen::Matrix3d axes;
    axes << x, z.cross(x), z;
    return axes;
}

bool has_shape(std::string_view type) {
    constexpr std::array kTypes = {"LINE",   "LWPOLYLINE", "POLYLINE", "ARC",   "CIRCLE", "ELLIPSE",
                                   "SPLINE", "MLINE",      "SOLID",    "TRACE", "3DFACE", "HATCH"};
    return std::ranges::find(kTypes, type) != kTypes.end();
}

Shape shape_of(const Drawing& drawing, const Entity& entity, std::span<const Entity> vertices,
               double chord) {
    const std::string_view type = entity.type;
    const Fields fields(drawing, entity);
    Shape shape;
    if (type == "LINE") {
        line(shape, fields);
    } else if (type == "ELLIPSE") {
        ellipse(shape, fields, chord);
    } else if (type == "SPLINE") {
        spline(shape, fields, chord);
    } else if (type == "MLINE") {
        mline(shape, drawing, fields);
    } else if (type == "3DFACE") {
        face(shape, fields, false);
    } else if (type == "POLYLINE") {
        heavy_polyline(shape, drawing, fields, vertices, chord);
    } else {  // in coordinates of their own
        if (type == "LWPOLYLINE") light_polyline(shape, fields, chord);
        if (type == "ARC" || type == "CIRCLE") round(shape, fields, type == "CIRCLE", chord);
        if (type == "SOLID" || type == "TRACE") face(shape, fields, true);
        if (type == "HATCH") hatch(shape, fields, chord);
        turn(shape, fields);
    }
    return shape;
}

}  // namespace hitos::dxf
