// SPDX-License-Identifier: GPL-3.0-or-later
// Drawing a world with clicks.
#pragma once

#include <array>
#include <optional>
#include <vector>

#include "hitos/simulation/text/snapping.hpp"
#include "hitos/simulation/text/world_editing.hpp"
#include "views/view_tool.hpp"

namespace hitos::window {

class WorldDraft;

enum class DrawMode { select, wall, room, door, box, person, way_point, start, measure };

/// What the user has typed for the next piece of a line; nothing: as the cursor says.
struct TypedPiece {
    std::optional<double> length_m;
    std::optional<double> direction_deg;
};

/// Turns clicks into changes of the draft, draws what is chosen and what the next click would draw.
class DrawTool final : public ViewTool {
    Q_OBJECT

  public:
    DrawTool(WorldDraft& draft, QObject* parent);

    /// Whether clicks draw at all.
    void set_active(bool on);
    DrawMode mode() const { return mode_; }
    /// Ends what was begun.
    void set_mode(DrawMode mode);
    void set_grid(double step_m);
    double grid() const { return grid_m_; }
    void type(const TypedPiece& piece);
    /// Ends what was begun: a line has the points that it has.
    void finish();
    /// The point that the typed numbers and the cursor say, as if it were clicked.
    void place_typed();
    /// Points that are drawn and belong to nothing yet.
    const std::vector<Point2>& pending() const { return pending_; }
    void drop_last_point();

    const std::optional<WorldItem>& chosen() const { return chosen_; }
    void choose(std::optional<WorldItem> item);

    bool takes_clicks() const override { return active_; }
    void hover(const std::optional<PointedAt>& pointed) override;
    void click(const PointedAt& pointed) override;
    bool pick_up(const PointedAt& pointed) override;
    void drag(const PointedAt& pointed) override;
    void drop() override;
    bool double_click() override;
    /// Ends a line with the points that it has; then lets go of what is chosen; then of the mode.
    void escape() override;
    /// Digits begin a number. Delete and Backspace take out what is chosen, or the point drawn
    /// last; Ctrl and an arrow move what is chosen by a step of the grid.
    bool key(int key, Qt::KeyboardModifiers keys) override;
    void paint(QPainter& painter, const Scene& scene) const override;

  signals:
    void chosen_changed();
    void mode_changed();
    /// Points were drawn, or begun things are done.
    void pending_changed();
    /// The beginning of a number was typed, with something that has numbers.
    void number_begun(QString digits);

  private:
    bool is_line() const { return mode_ == DrawMode::wall || mode_ == DrawMode::person; }
    Snapped snapped(const PointedAt& pointed) const;
    /// Where a click there would put a point.
    Point2 target(const PointedAt& pointed) const;
    Point2 as_typed(const Point2& point) const;
    void place(Point2 point);
    bool takes_effect();
    bool add_line(const std::vector<Point2>& line);
    void clear_pending();
    void keep_chosen();
    void keep_others();
    void remove_chosen();
    void nudge(int right, int up);
    static Polyline rectangle(const Point2& a, const Point2& b);
    QString words_of_piece(const Point2& from, const Point2& to) const;
    void paint_chosen(QPainter& painter, const Scene& scene) const;
    void paint_pending(QPainter& painter, const Scene& scene) const;

    WorldDraft& draft_;
    bool active_ = false;
    DrawMode mode_ = DrawMode::select;
    double grid_m_ = 0.1;
    TypedPiece typed_;
    std::vector<Point2> pending_;
    std::optional<PointedAt> cursor_;
    std::optional<Snapped> shown_;  ///< of the cursor
    std::optional<WorldItem> chosen_;
    std::optional<Point2> held_at_;  ///< where what is dragged was picked up
    Point2 dragged_by_;
    std::vector<WallSegment> others_;  ///< walls that it may snap to
};

}  // namespace hitos::window
