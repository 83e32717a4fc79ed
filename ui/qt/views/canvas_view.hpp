// SPDX-License-Identifier: GPL-3.0-or-later
// What all views of the plane share: navigation, scale, coordinates, pictures.
#pragma once

#include <QPointF>
#include <QPointer>
#include <QRectF>
#include <QSizeF>
#include <QTransform>
#include <QWidget>
#include <optional>

#include "figure.hpp"
#include "view_tool.hpp"

class QContextMenuEvent;

namespace hitos::window {

/// Where the eye is: `centre` [m] of the view's frame lies in the middle of the widget.
struct Camera {
    QPointF centre;
    double pixels_per_m = 40.0;
    double turn_rad = 0.0;  ///< the view's frame is shown turned by it, counter-clockwise
    QTransform to_screen(const QSizeF& size) const;
};

/// "x 1.20  y -3.00 m", as coordinates are shown everywhere.
QString place_words(QPointF world_m);

/// Base of the views. Wheel zooms at the cursor, dragging pans, double click and F fit; W, A, S and
/// D pan, + and - zoom. Until the user moves the camera it keeps everything in sight.
class CanvasView : public QWidget {
    Q_OBJECT

  public:
    explicit CanvasView(QWidget* parent = nullptr);

    const Camera& camera() const { return camera_; }
    bool fits() const { return fit_; }
    const LayerSet& layers() const { return layers_; }
    void set_layers(const LayerSet& layers);
    /// What is seen, then all that there is, then other ways to show it. Whole content is at first
    /// as wide as `whole_pixels_per_m()` makes it.
    virtual std::vector<FigureOffer> figures();
    Exportable exportable() { return {accessibleName(), file_name(), font(), figures()}; }
    /// What is seen, to the clipboard.
    void copy_picture() { copy(figures().front()); }
    /// World coordinates at a point of the widget.
    QPointF world_at(const QPointF& pixel) const;
    /// Draws over the view, and has its clicks while it wants them.
    void set_tool(hitos::window::ViewTool& tool);

    virtual void fit();
    void zoom(double factor);
    void set_follow(bool on);
    bool follows() const { return follow_; }
    /// While on, the camera neither fits nor follows; the user moves it.
    void hold_camera(bool on);
    /// Looks where another one looks.
    void look_as(const CanvasView& other);

  signals:
    /// By the user.
    void camera_moved();
    void picture_wanted();
    void hovered_at(QPointF world_m);
    void left();
    void follow_changed(bool on);
    void painted(double seconds);

  protected:
    virtual void paint_scene(QPainter& painter, const Scene& scene) const = 0;
    /// Everything worth seeing, in the view's frame [m]; null where there is nothing.
    virtual QRectF content() const = 0;
    /// What a view of that size keeps free of it at its upper edge, when all of it is to be seen.
    virtual double band_above(const QSizeF& /*size*/) const { return 0.0; }
    /// Pixels per metre of a whole picture at scale 1.
    virtual double whole_pixels_per_m() const { return 20.0; }
    virtual Pose pose_view_world() const { return {}; }
    /// Those that its layers are drawn in.
    virtual const Colours& layer_colours(const Colours& screen) const { return screen; }
    /// Of its pictures, without an ending.
    virtual QString file_name() const = 0;
    /// The layers that there is something of to draw.
    virtual LayerSet drawable() const { return {}; }
    /// Those that nothing is seen of, because the same is drawn over it in another colour.
    virtual LayerSet hidden() const { return {}; }
    /// What the legend of its figures has besides layers.
    virtual std::vector<FigureEntry> entries() const { return {}; }
    /// Whether several hypotheses are drawn: layers have other names.
    virtual bool of_particles() const { return false; }
    /// The landmark below a point of the view's frame, as it is in the world.
    virtual std::optional<ICaracteristica> landmark_below(const QPointF& point) const = 0;
    /// The cursor is at `point` of the view's frame, nothing when it left.
    virtual void hover(std::optional<QPointF> point) { Q_UNUSED(point) }
    virtual void click(const QPointF& point) { Q_UNUSED(point) }
    /// Whether what is at the point (view's frame) is dragged by the mouse, in place of the view.
    virtual bool pick_up(const QPointF& point) {
        Q_UNUSED(point)
        return false;
    }
    /// What was picked up is to be here.
    virtual void drag(const QPointF& point) { Q_UNUSED(point) }
    virtual void drop() {}
    /// What is drawn where there is nothing to see yet.
    virtual QString empty_text() const = 0;

    /// Content changed: fits, or follows `robot`, and asks for a new picture.
    void content_changed(std::optional<QPointF> robot);
    /// The same with the robot where it was.
    void content_changed() { content_changed(robot_); }
    /// What is drawn has moved or changed below a cursor that rests.
    void hover_again();
    void set_turn(double turn_rad);
    double tolerance_m() const { return 8.0 / camera_.pixels_per_m; }

    void paintEvent(QPaintEvent* event) override;
    void wheelEvent(QWheelEvent* event) override;
    void mousePressEvent(QMouseEvent* event) override;
    void mouseMoveEvent(QMouseEvent* event) override;
    void mouseReleaseEvent(QMouseEvent* event) override;
    void mouseDoubleClickEvent(QMouseEvent* event) override;
    void leaveEvent(QEvent* event) override;
    void keyPressEvent(QKeyEvent* event) override;
    void resizeEvent(QResizeEvent* event) override;
    void contextMenuEvent(QContextMenuEvent* event) override;

  private:
    FigureOffer offer(const QString& words, bool whole);
    Picture figure(bool whole, const FigureWish& wish);
    void paint_all(QPainter& painter, const Scene& scene) const;
    bool measures() const { return tool_ && tool_->takes_clicks(); }
    /// Where the keyboard picks: below the cursor, else in the middle.
    QPointF picking_place() const { return cursor_.value_or(QRectF(rect()).center()); }
    void point_at(const std::optional<QPointF>& pixel, Qt::KeyboardModifiers keys);
    PointedAt pointed_at(const QPointF& pixel, Qt::KeyboardModifiers keys) const;
    bool key_of_tool(int key, Qt::KeyboardModifiers keys);
    void drag_to(const QPointF& pixel, Qt::KeyboardModifiers keys);
    void zoom_at(const QPointF& pixel, double factor);
    void pan(const QPointF& pixels);
    void moved_by_user();
    void apply_fit();
    Camera fitted(const QSizeF& size) const;
    void make_room_for_scale_bar(Camera& camera, const QSizeF& size) const;

    LayerSet layers_ = default_layers();
    Camera camera_;
    bool fit_ = true;
    bool follow_ = false;
    bool held_ = false;
    bool pressed_ = false;
    bool dragged_ = false;
    bool picked_up_ = false;
    QPointF press_;
    std::optional<QPointF> cursor_;  ///< [pixels], nothing where it is elsewhere
    QPointF last_;
    std::optional<QPointF> robot_;
    QPointer<ViewTool> tool_;
};

}  // namespace hitos::window
