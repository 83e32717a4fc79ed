// SPDX-License-Identifier: GPL-3.0-or-later
// What mouse and keyboard do with the plots.

#include <qcustomplot.h>

#include <QApplication>
#include <QContextMenuEvent>
#include <QKeyEvent>
#include <QMenu>
#include <QMouseEvent>
#include <QPainter>
#include <algorithm>
#include <iterator>
#include <utility>

#include "look/theme.hpp"
#include "plots.hpp"
#include "session/session.hpp"

namespace hitos::window {

void Plots::follow_clicks() {
    connect(plot_, &QCustomPlot::mousePress, this,
            [this](QMouseEvent* event) { pressed_ = event->position().toPoint(); });
    connect(plot_, &QCustomPlot::mouseRelease, this, [this](QMouseEvent* event) {
        const QPoint place = event->position().toPoint();
        const auto pressed = std::exchange(pressed_, std::nullopt);
        const bool moved =
            !pressed || (place - *pressed).manhattanLength() >= QApplication::startDragDistance();
        if (event->button() != Qt::LeftButton || moved) return;
        clicked_ = place;
        click_.start();
    });
    // A click goes to its scan once it cannot become a double click.
    click_.setSingleShot(true);
    click_.setInterval(QApplication::doubleClickInterval());
    connect(&click_, &QTimer::timeout, this, [this] { go_to(clicked_); });
    connect(plot_, &QCustomPlot::mouseDoubleClick, this, [this] {
        click_.stop();
        pressed_.reset();
        show_all_times();
    });
}

/// About the scan that is shown; less than a second or more than all tells nothing.
void Plots::zoom(double factor) {
    constexpr double kLeastTime = 1.0;  // [s]
    const auto [from_s, to_s] = times();
    const double all_s = figures_.empty() ? kLeastTime : figures_.back().time_s;
    if ((to_s - from_s) * factor >= all_s) {
        show_all_times();
        return;
    }
    const double length_s = std::max(kLeastTime, (to_s - from_s) * factor);
    const double now_s = std::clamp(session_.progress().duration_s, from_s, to_s);
    const double part = (now_s - from_s) / (to_s - from_s);
    zoomed_ = true;
    set_times(now_s - part * length_s, now_s + (1.0 - part) * length_s);
}

void Plots::go_to(const QPoint& place) {
    const QCPAxisRect* under = plot_->axisRectAt(place);
    if (under == nullptr || figures_.empty()) return;
    const double time_s = under->axis(QCPAxis::atBottom)->pixelToCoord(place.x());
    auto at = std::ranges::lower_bound(figures_, time_s, {}, &StepFigures::time_s);
    if (at == figures_.end()) --at;
    if (at != figures_.begin() && time_s - std::prev(at)->time_s < at->time_s - time_s) --at;
    session_.seek(static_cast<quint64>(at - figures_.begin()) + 1);
}

bool Plots::eventFilter(QObject* watched, QEvent* event) {
    if (event->type() == QEvent::MouseMove) {
        // NOLINTNEXTLINE(*-static-cast-downcast): by its type
        show_values(static_cast<QMouseEvent*>(event)->position().toPoint());
    } else if (event->type() == QEvent::Leave) {
        hide_values();
    }
    return QWidget::eventFilter(watched, event);
}

void Plots::keyPressEvent(QKeyEvent* event) {
    switch (event->key()) {
        case Qt::Key_Plus:
        case Qt::Key_Equal:
            return zoom(0.8);
        case Qt::Key_Minus:
            return zoom(1.25);
        case Qt::Key_F:
        case Qt::Key_0:
            return show_all_times();
        default:
            QWidget::keyPressEvent(event);
    }
}

void Plots::paintEvent(QPaintEvent* event) {
    QWidget::paintEvent(event);
    if (!hasFocus()) return;
    QPainter painter(this);
    painter.setPen(colours().accent);
    painter.drawRect(rect().adjusted(0, 0, -1, -1));
}

void Plots::contextMenuEvent(QContextMenuEvent* event) {
    auto* menu = new QMenu(this);
    menu->setAttribute(Qt::WA_DeleteOnClose);
    menu->addAction(tr("Copy picture"), this, &Plots::copy_picture);
    menu->addAction(tr("Save as image…"), this, &Plots::picture_wanted);
    menu->addAction(tr("Save the figures as CSV…"), this, &Plots::table_wanted);
    menu->popup(event->globalPos());
}

}  // namespace hitos::window
