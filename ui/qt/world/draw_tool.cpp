// SPDX-License-Identifier: GPL-3.0-or-later
#include "draw_tool.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "hitos/base/error.hpp"
#include "views/canvas_view.hpp"
#include "world_draft.hpp"

namespace hitos::window {
namespace {

constexpr double kUsualSide = 0.5;  // m, of a box

std::vector<WallSegment> walls_and_doors(const World& world) {
    std::vector<WallSegment> walls = world.walls;
    walls.insert(walls.end(), world.doors.begin(), world.doors.end());
    return walls;
}

}  // namespace

DrawTool::DrawTool(WorldDraft& draft, QObject* parent) : ViewTool(parent), draft_(draft) {
    connect(&draft, &WorldDraft::opened, this, [this] {
        clear_pending();
        choose(std::nullopt);
    });
    // The same number may be another thing there.
    connect(&draft, &WorldDraft::stepped, this, [this] { choose(std::nullopt); });
    connect(&draft, &WorldDraft::changed, this, &DrawTool::keep_chosen);
}

/// What is chosen may be no more.
void DrawTool::keep_chosen() {
    if (chosen_ && outline_of(draft_.text(), *chosen_).empty()) choose(std::nullopt);
    emit chosen_changed();
    emit changed();
}

void DrawTool::set_active(bool on) {
    if (active_ == on) return;
    active_ = on;
    finish();
    clear_pending();
    emit switched();
}

void DrawTool::set_mode(DrawMode mode) {
    if (mode == mode_) return;
    finish();
    clear_pending();
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
    typed_ = {};
    emit pending_changed();
    emit changed();
}

void DrawTool::choose(std::optional<WorldItem> item) {
    chosen_ = item;
    if (!item) {
        held_at_.reset();
        dragged_by_ = {};
    }
    emit chosen_changed();
    emit changed();
}

void DrawTool::remove_chosen() {
    if (!chosen_) return;
    const WorldItem item = *chosen_;
    // What lies beside it may take its number: nothing is chosen by chance.
    choose(std::nullopt);
    if (!draft_.change([&](WorldText& text) { remove_item(text, item); })) choose(item);
}

void DrawTool::nudge(int right, int up) {
    if (!chosen_) return;
    constexpr double kWithoutGrid = 0.01;  // m
    const double step = grid_m_ > 0.0 ? grid_m_ : kWithoutGrid;
    draft_.change([&](WorldText& text) { move_item(text, *chosen_, {right * step, up * step}); });
}

Polyline DrawTool::rectangle(const Point2& a, const Point2& b) {
    return {a, {b.x, a.y}, b, {a.x, b.y}, a};
}

Snapped DrawTool::snapped(const PointedAt& pointed) const {
    if (pointed.exact) return {to_the_micrometre(pointed.place), SnappedTo::nothing};
    SnapOptions options;
    options.grid_m = grid_m_;
    options.reach_m = pointed.reach_m;
    options.to_walls = mode_ != DrawMode::person && mode_ != DrawMode::way_point &&
                       mode_ != DrawMode::start && mode_ != DrawMode::box;
    SnapFrom from;
    // The two corners of a room have nothing to do with right angles.
    if (!pending_.empty() && mode_ != DrawMode::room) {
        from.point = pending_.back();
        if (pending_.size() > 1) from.before = pending_[pending_.size() - 2];
    }
    // Its beginning, to close it. The last point is no place for the next one.
    const bool closes = is_line() && pending_.size() > 2;
    const std::span<const Point2> ends(pending_.data(), closes ? 1U : 0U);
    return snap(walls_and_doors(draft_.world()), ends, pointed.place, from, options);
}

Point2 DrawTool::as_typed(const Point2& point) const {
    if (pending_.empty() || (!typed_.length_m && !typed_.direction_deg)) return point;
    const Point2& from = pending_.back();
    const double heading = typed_.direction_deg ? *typed_.direction_deg / kDegreesPerRadian
                                                : std::atan2(point.y - from.y, point.x - from.x);
    const double length = typed_.length_m.value_or(distance(from, point));
    return to_the_micrometre(
        {from.x + length * std::cos(heading), from.y + length * std::sin(heading)});
}

Point2 DrawTool::target(const PointedAt& pointed) const {
    return as_typed(snapped(pointed).at);
}

void DrawTool::hover(const std::optional<PointedAt>& pointed) {
    cursor_ = pointed;
    shown_.reset();
    if (pointed && mode_ != DrawMode::select) shown_ = snapped(*pointed);
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

void DrawTool::place(Point2 point) {
    // What was typed round a room comes back to its beginning but for its last digits.
    constexpr double kSamePoint = 1e-4;  // m
    const bool closes = is_line() && pending_.size() > 2;
    if (closes && distance(pending_.front(), point) < kSamePoint) point = pending_.front();
    if (!pending_.empty() && pending_.back() == point) return;  // nothing has no length
    if (!(std::abs(point.x) <= kFarthest && std::abs(point.y) <= kFarthest)) {
        emit draft_.refused(tr("Found a point at %1; expected one no further than %2 km from the "
                               "origin.")
                                .arg(place_words({point.x, point.y}))
                                .arg(kFarthest / 1000.0));
        return;
    }
    pending_.push_back(point);
    typed_ = {};
    if (takes_effect()) {
        clear_pending();
    } else {
        emit pending_changed();
        emit changed();
    }
}

/// Whether the points drawn so far have become something.
bool DrawTool::takes_effect() {
    const Point2& point = pending_.back();
    const bool two = pending_.size() > 1;
    bool could = true;
    switch (mode_) {
        case DrawMode::wall:
        case DrawMode::person:
            if (pending_.size() > 3 && point == pending_.front()) finish();
            return false;
        case DrawMode::room:
            could = two && pending_[0].x != point.x && pending_[0].y != point.y;
            if (could) could = add_line(rectangle(pending_[0], point));
            break;
        case DrawMode::door:
            could = two && draft_.change([this](WorldText& text) {
                add_door(text, pending_[0], pending_[1]);
            });
            break;
        case DrawMode::box:
            draft_.change([&](WorldText& text) { add_box(text, point, kUsualSide); });
            return true;
        case DrawMode::way_point:
            draft_.change([&](WorldText& text) { add_way_point(text, point); });
            return true;
        case DrawMode::start:
            draft_.change([&](WorldText& text) {
                Pose start = text.world().tour.start;
                if (two) {
                    start.theta = std::atan2(point.y - start.y, point.x - start.x);
                } else {
                    start = {point.x, point.y, start.theta};
                }
                text.set_start(start);
            });
            return two;
        case DrawMode::measure:
            if (pending_.size() > 2) pending_ = {point};
            return false;
        case DrawMode::select:
            return true;
    }
    // What could not be done is done by another second point.
    if (two && !could) pending_.pop_back();
    return could;
}

void DrawTool::finish() {
    const bool line = is_line() && pending_.size() > 1;
    if (!line || add_line(pending_)) clear_pending();
}

/// Where it cannot be the points stay, to be taken back.
bool DrawTool::add_line(const std::vector<Point2>& line) {
    const bool walks = mode_ == DrawMode::person;
    return draft_.change(
        [&](WorldText& text) { walks ? add_person(text, line) : add_wall(text, line); });
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
    const bool number = (key >= Qt::Key_0 && key <= Qt::Key_9) || key == Qt::Key_Period;
    if (number && !keys.testFlag(Qt::ControlModifier) && (!pending_.empty() || chosen_)) {
        emit number_begun(QChar(key));
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
    keep_others();
    return true;
}

/// What is dragged does not snap to itself.
void DrawTool::keep_others() {
    others_.clear();
    if (chosen_->kind == ItemKind::door) {
        WorldText without = draft_.text();
        try {
            remove_item(without, *chosen_);
            others_ = without.world().walls;
        } catch (const Error&) {  // then it goes by the grid
        }
    } else if (chosen_->kind == ItemKind::wall && chosen_->first == chosen_->last) {
        const int own = static_cast<int>(chosen_->index) + 1;
        for (const WallSegment& wall : draft_.world().walls) {
            if (wall.wall != own) others_.push_back(wall);
        }
    }
}

void DrawTool::drag(const PointedAt& pointed) {
    if (!held_at_ || !chosen_) return;
    cursor_ = pointed;
    const Polyline now = outline_of(draft_.text(), *chosen_);
    if (now.empty()) return;
    // The point nearest to the cursor is what snaps.
    const Point2 anchor = *std::ranges::min_element(
        now, {}, [&](const Point2& point) { return distance(point, *held_at_); });
    PointedAt to = pointed;
    to.place = {anchor.x + pointed.place.x - held_at_->x, anchor.y + pointed.place.y - held_at_->y};
    SnapOptions options;
    options.grid_m = grid_m_;
    options.reach_m = pointed.reach_m;
    Snapped place{to_the_micrometre(to.place), SnappedTo::nothing};
    if (!pointed.exact) place = snap(others_, {}, to.place, {}, options);
    dragged_by_ = {place.at.x - anchor.x, place.at.y - anchor.y};
    emit changed();
}

void DrawTool::drop() {
    if (!std::exchange(held_at_, std::nullopt) || !chosen_) return;
    const Point2 by = std::exchange(dragged_by_, {});
    const WorldItem item = *chosen_;
    if (by != Point2{}) draft_.change([&](WorldText& text) { move_item(text, item, by); });
    emit changed();
}

}  // namespace hitos::window
