#include "draw_tool.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "views/canvas_paint.hpp"
#include "world_draft.hpp"

namespace hitos::window {
namespace {

constexpr double kDegrees = 180.0 / kPi;
constexpr double kUsualSide = 0.5;  // m, of a box

QPointF point_of(const Point2& point) {
    return {point.x, point.y};
}

double length_of(const Point2& a, const Point2& b) {
    return std::hypot(b.x - a.x, b.y - a.y);
}

Polyline rectangle(const Point2& a, const Point2& b) {
    return {a, {b.x, a.y}, b, {a.x, b.y}, a};
}

std::vector<WallSegment> walls_and_doors(const World& world) {
    std::vector<WallSegment> walls = world.walls;
    walls.insert(walls.end(), world.doors.begin(), world.doors.end());
    return walls;
}

void draw_line(QPainter& painter, const Scene& scene, const std::vector<Point2>& line) {
    QPolygonF pixels;
    for (const Point2& point : line) pixels.append(scene.to_screen.map(point_of(point)));
    painter.drawPolyline(pixels);
}

void draw_handle(QPainter& painter, const Scene& scene, const Point2& point, bool filled) {
    constexpr double kHalf = 4.0;
    const QPointF at = scene.to_screen.map(point_of(point));
    painter.setPen(thin_pen(scene.colours.accent, 1.6));
    painter.setBrush(filled ? QBrush(scene.colours.accent) : QBrush(Qt::NoBrush));
    painter.drawRect(QRectF(at.x() - kHalf, at.y() - kHalf, 2.0 * kHalf, 2.0 * kHalf));
}

}  // namespace

DrawTool::DrawTool(WorldDraft& draft, QObject* parent) : ViewTool(parent), draft_(draft) {
    connect(&draft, &WorldDraft::opened, this, [this] {
        clear_pending();
        choose(std::nullopt);
    });
    connect(&draft, &WorldDraft::changed, this, &DrawTool::keep_chosen);
}

/// What is chosen may be no more.
void DrawTool::keep_chosen() {
    if (chosen_ && outline_of(draft_.text(), *chosen_).empty()) chosen_.reset();
    emit chosen_changed();
    emit changed();
}

void DrawTool::set_active(bool on) {
    if (active_ == on) return;
    active_ = on;
    finish();
    emit switched();
}

void DrawTool::set_mode(DrawMode mode) {
    if (mode == mode_) return;
    finish();
    mode_ = mode;
    if (mode != DrawMode::select) choose(std::nullopt);
    emit mode_changed();
    emit switched();
}

void DrawTool::set_grid(double step_m) {
    grid_m_ = step_m;
    emit changed();
}

void DrawTool::type(const TypedPiece& piece) {
    typed_ = piece;
    emit changed();
}

void DrawTool::clear_pending() {
    pending_.clear();
    typed_ = {};
    emit pending_changed();
    emit changed();
}

void DrawTool::drop_last_point() {
    if (pending_.empty()) return;
    pending_.pop_back();
    emit pending_changed();
    emit changed();
}

void DrawTool::choose(std::optional<WorldItem> item) {
    chosen_ = item;
    emit chosen_changed();
    emit changed();
}

void DrawTool::remove_chosen() {
    if (!chosen_) return;
    const WorldItem item = *chosen_;
    // What lies beside it may take its number: nothing is chosen by chance.
    chosen_.reset();
    if (!draft_.change([&](WorldText& text) { remove_item(text, item); })) choose(item);
}

void DrawTool::nudge(int right, int up) {
    if (!chosen_) return;
    constexpr double kWithoutGrid = 0.01;  // m
    const double step = grid_m_ > 0.0 ? grid_m_ : kWithoutGrid;
    draft_.change([&](WorldText& text) { move_item(text, *chosen_, {right * step, up * step}); });
}

Snapped DrawTool::snapped(const PointedAt& pointed, const std::optional<Point2>& from) const {
    if (pointed.exact) return {to_the_micrometre(pointed.place), SnappedTo::nothing};
    SnapOptions options;
    options.grid_m = grid_m_;
    options.reach_m = pointed.reach_m;
    options.to_walls = mode_ != DrawMode::person && mode_ != DrawMode::way_point &&
                       mode_ != DrawMode::start && mode_ != DrawMode::box;
    SnapFrom drawn_from{from, {}};
    if (pending_.size() > 1 && from == pending_.back()) {
        drawn_from.before = pending_[pending_.size() - 2];
    }
    // Its beginning, to close it. The last point is no place for the next one.
    const bool closes = is_line() && pending_.size() > 2;
    const std::span<const Point2> ends(pending_.data(), closes ? 1U : 0U);
    return snap(walls_and_doors(draft_.world()), ends, pointed.place, drawn_from, options);
}

Point2 DrawTool::as_typed(const Point2& point) const {
    if (pending_.empty() || (!typed_.length_m && !typed_.direction_deg)) return point;
    const Point2& from = pending_.back();
    const double heading = typed_.direction_deg ? *typed_.direction_deg / kDegrees
                                                : std::atan2(point.y - from.y, point.x - from.x);
    const double length = typed_.length_m.value_or(length_of(from, point));
    return to_the_micrometre(
        {from.x + length * std::cos(heading), from.y + length * std::sin(heading)});
}

Point2 DrawTool::target(const PointedAt& pointed) const {
    // The two corners of a room have nothing to do with right angles.
    const bool from = !pending_.empty() && mode_ != DrawMode::room;
    return as_typed(snapped(pointed, from ? std::optional(pending_.back()) : std::nullopt).at);
}

void DrawTool::hover(const std::optional<PointedAt>& pointed) {
    cursor_ = pointed;
    shown_.reset();
    if (pointed && mode_ != DrawMode::select) {
        shown_ = snapped(*pointed, pending_.empty() || mode_ == DrawMode::room
                                       ? std::nullopt
                                       : std::optional(pending_.back()));
    }
    emit changed();
}

void DrawTool::click(const PointedAt& pointed) {
    if (mode_ == DrawMode::select) {
        choose(item_at(draft_.text(), pointed.place, pointed.reach_m));
    } else {
        place(target(pointed));
    }
}

void DrawTool::place_typed() {
    if (pending_.empty()) return;
    // Without a cursor the direction is that of the piece before, or to the right.
    const Point2 last = pending_.back();
    Point2 ahead{last.x + 1.0, last.y};
    if (pending_.size() > 1) {
        const Point2& before = pending_[pending_.size() - 2];
        ahead = {2.0 * last.x - before.x, 2.0 * last.y - before.y};
    }
    if (cursor_) {
        place(target(*cursor_));
    } else if (typed_.length_m) {
        place(as_typed(ahead));
    }
}

void DrawTool::place(const Point2& point) {
    if (!pending_.empty() && pending_.back() == point) return;  // nothing has no length
    pending_.push_back(point);
    typed_ = {};
    switch (mode_) {
        case DrawMode::wall:
        case DrawMode::person:
            if (pending_.size() > 3 && point == pending_.front()) finish();
            break;
        case DrawMode::room:
            if (pending_.size() < 2) break;
            if (pending_[0].x == point.x || pending_[0].y == point.y) {  // no room yet
                pending_.pop_back();
                break;
            }
            add_line(rectangle(pending_[0], point));
            return;
        case DrawMode::door:
            if (pending_.size() < 2) break;
            draft_.change([&](WorldText& text) { add_door(text, pending_[0], pending_[1]); });
            clear_pending();
            return;
        case DrawMode::box:
            draft_.change([&](WorldText& text) { add_box(text, point, kUsualSide); });
            clear_pending();
            return;
        case DrawMode::way_point:
            draft_.change([&](WorldText& text) { add_way_point(text, point); });
            clear_pending();
            return;
        case DrawMode::start:
            draft_.change([&](WorldText& text) {
                Pose start = text.world().tour.start;
                if (pending_.size() == 1) {
                    start = {point.x, point.y, start.theta};
                } else {
                    start.theta = std::atan2(point.y - start.y, point.x - start.x);
                }
                text.set_start(start);
            });
            if (pending_.size() > 1) {
                clear_pending();
                return;
            }
            break;
        case DrawMode::measure:
            if (pending_.size() > 2) pending_ = {point};
            break;
        case DrawMode::select:
            pending_.clear();
            break;
    }
    emit pending_changed();
    emit changed();
}

void DrawTool::finish() {
    if (is_line() && pending_.size() > 1) {
        add_line(pending_);
    } else {
        clear_pending();
    }
}

void DrawTool::add_line(std::vector<Point2> line) {
    const bool walks = mode_ == DrawMode::person;
    clear_pending();
    draft_.change([&](WorldText& text) { walks ? add_person(text, line) : add_wall(text, line); });
}

/// The second click of the two has put no point: it was where the first one was.
bool DrawTool::double_click() {
    if (mode_ == DrawMode::select) {
        if (chosen_) choose(whole_of(draft_.text(), *chosen_));
        return chosen_.has_value();
    }
    if (is_line()) finish();
    return true;
}

void DrawTool::escape() {
    if (!pending_.empty()) {
        finish();
    } else if (chosen_) {
        choose(std::nullopt);
    } else {
        set_mode(DrawMode::select);
    }
}

bool DrawTool::key(int key, Qt::KeyboardModifiers keys) {
    if (key == Qt::Key_Delete || key == Qt::Key_Backspace) {
        pending_.empty() ? remove_chosen() : drop_last_point();
        return true;
    }
    const int right = (key == Qt::Key_Right ? 1 : 0) - (key == Qt::Key_Left ? 1 : 0);
    const int up = (key == Qt::Key_Up ? 1 : 0) - (key == Qt::Key_Down ? 1 : 0);
    if (!keys.testFlag(Qt::ControlModifier) || (right == 0 && up == 0)) return false;
    nudge(right, up);
    return true;
}

/// Only what is chosen already, or lies there: else the view is dragged.
bool DrawTool::pick_up(const PointedAt& pointed) {
    if (mode_ != DrawMode::select) return false;
    const auto item = item_at(draft_.text(), pointed.place, pointed.reach_m);
    if (!item) return false;
    const bool part_of_chosen = chosen_ && chosen_->kind == item->kind &&
                                chosen_->index == item->index && chosen_->first <= item->first &&
                                item->last <= chosen_->last;
    if (!part_of_chosen) choose(item);
    held_at_ = pointed.place;
    dragged_by_ = {};
    return true;
}

void DrawTool::drag(const PointedAt& pointed) {
    if (!held_at_ || !chosen_) return;
    cursor_ = pointed;
    const Polyline now = outline_of(draft_.text(), *chosen_);
    if (now.empty()) return;
    // The point nearest to the cursor is what snaps.
    const Point2 anchor = *std::ranges::min_element(
        now, {}, [&](const Point2& point) { return length_of(point, *held_at_); });
    PointedAt to = pointed;
    to.place = {anchor.x + pointed.place.x - held_at_->x, anchor.y + pointed.place.y - held_at_->y};
    SnapOptions options;
    options.grid_m = grid_m_;
    options.reach_m = pointed.reach_m;
    options.to_walls = chosen_->first == chosen_->last ? chosen_->kind == ItemKind::wall
                                                       : chosen_->kind == ItemKind::door;
    Snapped place{to_the_micrometre(to.place), SnappedTo::nothing};
    if (!pointed.exact) place = snap(draft_.world().walls, {}, to.place, {}, options);
    dragged_by_ = {place.at.x - anchor.x, place.at.y - anchor.y};
    emit changed();
}

void DrawTool::drop() {
    if (!std::exchange(held_at_, std::nullopt) || !chosen_) return;
    const Point2 by = std::exchange(dragged_by_, {});
    const WorldItem item = *chosen_;
    draft_.change([&](WorldText& text) { move_item(text, item, by); });
    emit changed();
}

QString DrawTool::words_of_piece(const Point2& to) const {
    const Point2& from = pending_.back();
    const double heading = std::atan2(to.y - from.y, to.x - from.x) * kDegrees;
    if (mode_ == DrawMode::room) {
        return tr("%1 × %2 m")
            .arg(std::abs(to.x - from.x), 0, 'f', 2)
            .arg(std::abs(to.y - from.y), 0, 'f', 2);
    }
    return tr("%1 m, %2°").arg(length_of(from, to), 0, 'f', 3).arg(heading, 0, 'f', 1);
}

void DrawTool::paint(QPainter& painter, const Scene& scene) const {
    if (!active_) return;
    paint_chosen(painter, scene);
    paint_pending(painter, scene);
}

void DrawTool::paint_chosen(QPainter& painter, const Scene& scene) const {
    if (!chosen_) return;
    const WorldItem whole = whole_of(draft_.text(), *chosen_);
    Polyline line = outline_of(draft_.text(), whole);
    const bool box = chosen_->kind == ItemKind::box;
    const std::size_t first = box ? 0 : chosen_->first;
    const std::size_t last = box ? line.size() - 1 : chosen_->last;
    const bool closed = line.size() > 2 && line.front() == line.back();
    for (std::size_t i = first; i <= last && i < line.size(); ++i) {
        line[i] = {line[i].x + dragged_by_.x, line[i].y + dragged_by_.y};
    }
    if (closed && !box && first == 0) line.back() = line.front();
    if (closed && !box && last + 1 == line.size()) line.front() = line.back();
    painter.setBrush(Qt::NoBrush);
    painter.setPen(thin_pen(faded(scene.colours.accent, 110), 2.0));
    draw_line(painter, scene, line);
    painter.setPen(thin_pen(scene.colours.accent, 3.0));
    const auto at = [&](std::size_t i) { return line.begin() + static_cast<std::ptrdiff_t>(i); };
    draw_line(painter, scene, {at(first), at(last + 1)});
    for (std::size_t i = 0; i < line.size() && !box; ++i) {
        draw_handle(painter, scene, line[i], i >= first && i <= last);
    }
}

void DrawTool::paint_pending(QPainter& painter, const Scene& scene) const {
    painter.setBrush(Qt::NoBrush);
    painter.setPen(thin_pen(scene.colours.accent, 2.4));
    draw_line(painter, scene, pending_);
    if (mode_ == DrawMode::measure && pending_.size() == 2) {
        const QPointF at = scene.to_screen.map(point_of(pending_[1]));
        const Point2 from = pending_[0];
        const double heading =
            std::atan2(pending_[1].y - from.y, pending_[1].x - from.x) * kDegrees;
        draw_chip(
            painter, scene, at + QPointF(12.0, 12.0),
            {tr("%1 m, %2°").arg(length_of(from, pending_[1]), 0, 'f', 3).arg(heading, 0, 'f', 1)});
        return;
    }
    if (!cursor_ || mode_ == DrawMode::select) return;
    const Point2 to = target(*cursor_);
    const QPointF at = scene.to_screen.map(point_of(to));
    if (!pending_.empty()) {
        painter.setPen(thin_pen(scene.colours.accent, 1.6, Qt::DashLine));
        draw_line(painter, scene,
                  mode_ == DrawMode::room ? rectangle(pending_.back(), to)
                                          : Polyline{pending_.back(), to});
    }
    const bool near = shown_ && (shown_->to == SnappedTo::end || shown_->to == SnappedTo::wall);
    near ? draw_handle(painter, scene, to, shown_->to == SnappedTo::end)
         : draw_cross(painter, at, scene.colours.accent);
    const QString words = pending_.empty() ? place_words(point_of(to)) : words_of_piece(to);
    draw_chip(painter, scene, at + QPointF(14.0, 14.0), {words});
}

}  // namespace hitos::window
