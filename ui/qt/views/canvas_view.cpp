// SPDX-License-Identifier: GPL-3.0-or-later
#include "canvas_view.hpp"

#include <QApplication>
#include <QContextMenuEvent>
#include <QKeyEvent>
#include <QMenu>
#include <QMouseEvent>
#include <QPainter>
#include <QWheelEvent>
#include <algorithm>
#include <cmath>
#include <utility>

#include "canvas_paint.hpp"
#include "hitos/base/thread_clock.hpp"

namespace hitos::window {
namespace {

constexpr double kLeastZoom = 0.005;    // pixels per metre: graphs may be of a country
constexpr double kGreatestZoom = 5000;  // a millimetre is five pixels
constexpr double kWholeMargin = 1.06;   // of a whole picture round its content
constexpr double kClickPixels = 4.0;
constexpr double kScaleBand = 46.0;  // pixels at the bottom that belong to the scale bar

}  // namespace

QTransform Camera::to_screen(const QSizeF& size) const {
    QTransform transform;
    transform.translate(size.width() / 2.0, size.height() / 2.0);
    transform.scale(pixels_per_m, -pixels_per_m);
    transform.rotateRadians(turn_rad);
    transform.translate(-centre.x(), -centre.y());
    return transform;
}

QString place_words(QPointF world_m) {
    return QString("x %1  y %2 m").arg(world_m.x(), 0, 'f', 2).arg(world_m.y(), 0, 'f', 2);
}

CanvasView::CanvasView(QWidget* parent) : QWidget(parent) {
    setMouseTracking(true);
    setFocusPolicy(Qt::StrongFocus);
    setMinimumSize(220, 90);
    setAttribute(Qt::WA_OpaquePaintEvent);
    setCursor(Qt::CrossCursor);
}

void CanvasView::fit() {
    if (follow_) set_follow(false);
    fit_ = true;
    apply_fit();
    update();
    emit camera_moved();
}

void CanvasView::look_as(const CanvasView& other) {
    camera_ = other.camera_;
    fit_ = other.fit_;
    update();
}

void CanvasView::zoom(double factor) {
    zoom_at(QPointF(width() / 2.0, height() / 2.0), factor);
}

void CanvasView::set_follow(bool on) {
    if (follow_ == on) return;
    follow_ = on;
    if (on) {
        fit_ = false;
        if (robot_) camera_.centre = *robot_;
        camera_.pixels_per_m = std::max(camera_.pixels_per_m, 30.0);
        update();
    }
    emit follow_changed(on);
}

void CanvasView::hold_camera(bool on) {
    held_ = on;
    if (!on) content_changed();
}

void CanvasView::set_turn(double turn_rad) {
    camera_.turn_rad = turn_rad;
}

QPointF CanvasView::world_at(const QPointF& pixel) const {
    const QPointF point = camera_.to_screen(size()).inverted().map(pixel);
    const Point2 world = transform(inverse(pose_view_world()), Point2{point.x(), point.y()});
    return {world.x, world.y};
}

void CanvasView::set_tool(ViewTool& tool) {
    tool_ = &tool;
    connect(&tool, &ViewTool::changed, this, qOverload<>(&QWidget::update));
    connect(&tool, &ViewTool::switched, this, [this] {
        hover_again();
        update();
    });
}

/// With Shift a place is a place, whatever lies there.
PointedAt CanvasView::pointed_at(const QPointF& pixel, Qt::KeyboardModifiers keys) const {
    const QPointF world = world_at(pixel);
    PointedAt pointed{{world.x(), world.y()}, {}, tolerance_m(), keys.testFlag(Qt::ShiftModifier)};
    if (!pointed.exact) {
        pointed.landmark = landmark_below(camera_.to_screen(size()).inverted().map(pixel));
    }
    return pointed;
}

void CanvasView::point_at(const std::optional<QPointF>& pixel, Qt::KeyboardModifiers keys) {
    const bool own = pixel && !measures();
    hover(own ? std::optional(camera_.to_screen(size()).inverted().map(*pixel)) : std::nullopt);
    if (measures()) tool_->hover(pixel ? std::optional(pointed_at(*pixel, keys)) : std::nullopt);
}

Camera CanvasView::fitted(const QSizeF& size) const {
    constexpr double kMargin = 1.08;
    Camera camera = camera_;
    const QRectF box = content();
    if (!box.isValid()) return camera;
    QTransform turn;
    turn.rotateRadians(camera.turn_rad);
    const QRectF turned = turn.mapRect(box);
    const double above = band_above(size);
    const double height = std::max(size.height() - kScaleBand - above, size.height() / 2.0);
    camera.centre = box.center();
    camera.pixels_per_m =
        std::clamp(std::min(size.width() / turned.width(), height / turned.height()) / kMargin,
                   kLeastZoom, kGreatestZoom);
    const QTransform back = camera.to_screen(size).inverted();
    camera.centre += back.map(QPointF(0.0, -above / 2.0)) - back.map(QPointF());
    make_room_for_scale_bar(camera, size);
    return camera;
}

/// Lifts the content, which is in the middle, until the bar below covers none of it.
void CanvasView::make_room_for_scale_bar(Camera& camera, const QSizeF& size) const {
    const QTransform to_screen = camera.to_screen(size);
    const double free = size.height() - to_screen.mapRect(content()).bottom();
    const double lift = std::clamp(kScaleBand - free, 0.0, kScaleBand / 2.0);
    const QTransform back = to_screen.inverted();
    camera.centre += back.map(QPointF(0.0, lift)) - back.map(QPointF());
}

void CanvasView::apply_fit() {
    if (fit_ && !held_) camera_ = fitted(size());
}

void CanvasView::content_changed(std::optional<QPointF> robot) {
    robot_ = robot;
    if (follow_ && robot_ && !held_) camera_.centre = *robot_;
    apply_fit();
    hover_again();
    update();
}

void CanvasView::hover_again() {
    if (dragged_ || !(cursor_ || (measures() && hasFocus()))) return;
    point_at(picking_place(), QApplication::keyboardModifiers());
    if (cursor_) emit hovered_at(world_at(*cursor_));
}

void CanvasView::set_layers(const LayerSet& layers) {
    layers_ = layers;
    hover_again();
    update();
}

FigureOffer CanvasView::offer(const QString& words, bool whole) {
    FigureOffer offer;
    offer.words = words;
    offer.width = width();
    QTransform turn;
    turn.rotateRadians(camera_.turn_rad);
    if (whole && content().isValid()) {
        offer.width = std::clamp(
            turn.mapRect(content()).width() * kWholeMargin * whole_pixels_per_m(), 64.0, 4000.0);
    }
    offer.legend = offer.axes = true;
    offer.particles = of_particles();
    offer.layers = drawable();
    offer.shown = layers_;
    offer.picture = [this, whole](const FigureWish& wish) { return figure(whole, wish); };
    return offer;
}

std::vector<FigureOffer> CanvasView::figures() {
    return {offer(tr("What is seen now"), false), offer(tr("The whole picture"), true)};
}

Picture CanvasView::figure(bool whole, const FigureWish& wish) {
    FigureWish drawn = wish;
    drawn.layers = wish.layers & drawable();
    for (const LayerInfo& info : kLayerTable)
        if (hidden().has(info.layer)) drawn.layers.set(info.layer, false);
    const FigureFrame frame(drawn, font(), of_particles(), entries());
    const QMarginsF around = frame.around();
    const double wide = std::max(wish.points() - around.left() - around.right(), 1.0);
    const double band = wish.axes ? 0.0 : kScaleBand;  // of the scale bar
    QTransform turn;
    turn.rotateRadians(camera_.turn_rad);
    const QRectF box = turn.mapRect(content());
    Camera camera = camera_;
    QSizeF inside(wide, wide * height() / width());
    if (whole && box.isValid()) {
        camera.centre = content().center();
        camera.pixels_per_m = wide / (box.width() * kWholeMargin);
        inside.setHeight(
            std::max(box.height() * kWholeMargin * camera.pixels_per_m + band, kScaleBand));
        if (band > 0.0) make_room_for_scale_bar(camera, inside);
    } else {
        camera.pixels_per_m *= wide / width();
    }
    Picture picture;
    picture.size = inside.grownBy(around);
    picture.mm_per_point = wish.mm_per_point;
    picture.ground = wish.ground();
    picture.paint = [this, frame, inside, camera, wish, size = picture.size](QPaintDevice& device,
                                                                             double by) {
        QPainter painter(&device);
        painter.setRenderHints(QPainter::Antialiasing | QPainter::LosslessImageRendering);
        painter.setFont(font());
        painter.scale(by, by);
        painter.fillRect(QRectF(QPointF(), size), wish.ground());
        painter.translate(frame.around().left(), frame.around().top());
        const Scene scene{camera.to_screen(inside),
                          inside,
                          camera.pixels_per_m,
                          *wish.colours,
                          true,
                          !wish.axes,
                          !wish.as_seen};
        painter.save();
        painter.setClipRect(QRectF(QPointF(), inside));
        const LayerSet before = std::exchange(layers_, wish.layers);
        paint_all(painter, scene);
        layers_ = before;
        painter.restore();
        frame.paint(painter, scene, layer_colours(*wish.colours));
    };
    return picture;
}

void CanvasView::paint_all(QPainter& painter, const Scene& scene) const {
    paint_scene(painter, scene);
    if (!tool_) return;
    const Pose pose = pose_view_world();
    QTransform view_world;
    view_world.translate(pose.x, pose.y);
    view_world.rotateRadians(pose.theta);
    tool_->paint(painter, {view_world * scene.to_screen, scene.size, scene.pixels_per_m,
                           scene.colours, scene.chrome, scene.scale_bar});
}

void CanvasView::paintEvent(QPaintEvent* event) {
    Q_UNUSED(event)
    const double begin = thread_seconds();
    QPainter painter(this);
    const Colours& c = colours();
    painter.fillRect(rect(), c.canvas);
    painter.setRenderHint(QPainter::Antialiasing);
    if (content().isValid()) {
        paint_all(painter,
                  {camera_.to_screen(size()), QSizeF(size()), camera_.pixels_per_m, c, true});
    } else {
        painter.setPen(c.muted);
        painter.drawText(rect().adjusted(24, 24, -24, -24), Qt::AlignCenter | Qt::TextWordWrap,
                         empty_text());
    }
    if (hasFocus() && measures() && !cursor_) draw_cross(painter, picking_place(), c.text);
    if (hasFocus()) {
        painter.setRenderHint(QPainter::Antialiasing, false);
        painter.setPen(QPen(faded(c.accent, 120), 1));
        painter.setBrush(Qt::NoBrush);
        painter.drawRect(rect().adjusted(0, 0, -1, -1));
    }
    painter.end();
    emit painted(thread_seconds() - begin);
}

void CanvasView::moved_by_user() {
    fit_ = false;
    hover_again();
    update();
    emit camera_moved();
}

void CanvasView::zoom_at(const QPointF& pixel, double factor) {
    const QPointF before = camera_.to_screen(size()).inverted().map(pixel);
    camera_.pixels_per_m = std::clamp(camera_.pixels_per_m * factor, kLeastZoom, kGreatestZoom);
    if (!follow_) {
        const QPointF after = camera_.to_screen(size()).inverted().map(pixel);
        camera_.centre += before - after;
    }
    moved_by_user();
}

void CanvasView::pan(const QPointF& pixels) {
    const QTransform back = camera_.to_screen(size()).inverted();
    camera_.centre -= back.map(pixels) - back.map(QPointF());
    if (follow_) set_follow(false);
    moved_by_user();
}

void CanvasView::wheelEvent(QWheelEvent* event) {
    zoom_at(event->position(), std::pow(1.0015, event->angleDelta().y()));
    event->accept();
}

void CanvasView::mousePressEvent(QMouseEvent* event) {
    if (event->button() != Qt::LeftButton) return;
    press_ = last_ = event->position();
    pressed_ = true;
    dragged_ = false;
    picked_up_ = measures() ? tool_->pick_up(pointed_at(press_, event->modifiers()))
                            : pick_up(camera_.to_screen(size()).inverted().map(press_));
}

void CanvasView::drag_to(const QPointF& pixel, Qt::KeyboardModifiers keys) {
    if (!picked_up_) {
        pan(pixel - last_);
    } else if (measures()) {
        tool_->drag(pointed_at(pixel, keys));
    } else {
        drag(camera_.to_screen(size()).inverted().map(pixel));
    }
}

void CanvasView::mouseMoveEvent(QMouseEvent* event) {
    const QPointF pixel = event->position();
    cursor_ = pixel;
    if (event->buttons() & Qt::LeftButton) {
        if (!dragged_ && (pixel - press_).manhattanLength() > kClickPixels) {
            dragged_ = true;
            setCursor(Qt::ClosedHandCursor);
        }
        if (dragged_) drag_to(pixel, event->modifiers());
        last_ = pixel;
    } else {
        point_at(pixel, event->modifiers());
    }
    emit hovered_at(world_at(pixel));
}

void CanvasView::mouseReleaseEvent(QMouseEvent* event) {
    if (event->button() != Qt::LeftButton) return;
    setCursor(Qt::CrossCursor);
    // The second release of a double click belongs to no press.
    if (std::exchange(pressed_, false) && !dragged_) {
        if (measures()) {
            tool_->click(pointed_at(event->position(), event->modifiers()));
        } else {
            click(camera_.to_screen(size()).inverted().map(event->position()));
        }
    }
    if (std::exchange(picked_up_, false) && dragged_) measures() ? tool_->drop() : drop();
    dragged_ = false;
}

void CanvasView::mouseDoubleClickEvent(QMouseEvent* event) {
    if (event->button() != Qt::LeftButton) return;
    press_ = last_ = event->position();
    if (!measures() || !tool_->double_click()) fit();
}

void CanvasView::leaveEvent(QEvent* event) {
    cursor_.reset();
    point_at(std::nullopt, {});
    emit left();
    QWidget::leaveEvent(event);
}

bool CanvasView::key_of_tool(int key, Qt::KeyboardModifiers keys) {
    if (!measures()) return false;
    if (key == Qt::Key_Escape) {
        tool_->escape();
    } else if (key == Qt::Key_Return || key == Qt::Key_Enter) {
        tool_->click(pointed_at(picking_place(), keys));
    } else {
        return tool_->key(key, keys);
    }
    return true;
}

void CanvasView::keyPressEvent(QKeyEvent* event) {
    constexpr double kStep = 48.0;
    if (key_of_tool(event->key(), event->modifiers())) return;
    constexpr Qt::KeyboardModifiers kOthers =
        Qt::ControlModifier | Qt::AltModifier | Qt::MetaModifier;
    const bool letter = event->key() >= Qt::Key_A && event->key() <= Qt::Key_Z;
    if (letter && (event->modifiers() & kOthers) != 0) return QWidget::keyPressEvent(event);
    switch (event->key()) {
        case Qt::Key_Plus:
        case Qt::Key_Equal:
            zoom(1.25);
            break;
        case Qt::Key_Minus:
            zoom(0.8);
            break;
        case Qt::Key_F:
        case Qt::Key_0:
            fit();
            break;
        case Qt::Key_A:
            pan({kStep, 0.0});
            break;
        case Qt::Key_D:
            pan({-kStep, 0.0});
            break;
        case Qt::Key_W:
            pan({0.0, kStep});
            break;
        case Qt::Key_S:
            pan({0.0, -kStep});
            break;
        case Qt::Key_Menu:
            emit picture_wanted();
            break;
        default:
            QWidget::keyPressEvent(event);
    }
}

void CanvasView::resizeEvent(QResizeEvent* event) {
    apply_fit();
    QWidget::resizeEvent(event);
}

void CanvasView::contextMenuEvent(QContextMenuEvent* event) {
    auto* menu = new QMenu(this);
    menu->setAttribute(Qt::WA_DeleteOnClose);
    menu->setObjectName("view_menu");
    menu->addAction(tr("Save as image…"), this, &CanvasView::picture_wanted);
    menu->addAction(tr("Copy picture"), this, &CanvasView::copy_picture);
    menu->addSeparator();
    menu->addAction(tr("Fit to window"), this, &CanvasView::fit);
    menu->addAction(tr("Zoom in"), this, [this] { zoom(1.25); });
    menu->addAction(tr("Zoom out"), this, [this] { zoom(0.8); });
    menu->popup(event->globalPos());
}

}  // namespace hitos::window
