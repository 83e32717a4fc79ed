// SPDX-License-Identifier: GPL-3.0-or-later
// What views lend their clicks to, and let draw over them.
#pragma once

#include <QObject>
#include <QSizeF>
#include <QTransform>
#include <optional>

#include "hitos/features/caracteristica.hpp"
#include "look/theme.hpp"

class QPainter;

namespace hitos::window {

/// What a picture is drawn with.
struct Scene {
    QTransform to_screen;  ///< from the view's frame [m] to pixels
    QSizeF size;
    double pixels_per_m = 1.0;
    const Colours& colours;
    bool chrome = true;     ///< with scale bar and legends
    bool scale_bar = true;  ///< where there is no axis
    bool framed = false;    ///< what would be explained inside is so round it, or not at all
};

/// A place of the world that the user points at, and the landmark there if it counts.
struct PointedAt {
    Point2 place;
    std::optional<ICaracteristica> landmark;
    double reach_m = 0.0;  ///< what is further from it is not meant
    bool exact = false;    ///< the place itself, whatever lies near
};

class ViewTool : public QObject {
    Q_OBJECT

  public:
    using QObject::QObject;
    ~ViewTool() override;

    /// Whether clicks and cursor are its own.
    virtual bool takes_clicks() const = 0;
    virtual void hover(const std::optional<PointedAt>& pointed) = 0;
    virtual void click(const PointedAt& pointed) = 0;
    /// Whether it wants what is dragged from there, in place of the view; a click is one all the
    /// same.
    virtual bool pick_up(const PointedAt& pointed);
    virtual void drag(const PointedAt& pointed);
    virtual void drop() {}
    /// Whether a double click, whose first click it has had, means something to it.
    virtual bool double_click() { return false; }
    /// The user wants to leave off.
    virtual void escape() = 0;
    /// Whether another key means something to it.
    virtual bool key(int key, Qt::KeyboardModifiers keys);
    /// `scene` is of the world's frame.
    virtual void paint(QPainter& painter, const Scene& scene) const = 0;

  signals:
    /// What it draws is another.
    void changed();
    /// It takes clicks, or does so no more.
    void switched();
};

}  // namespace hitos::window
