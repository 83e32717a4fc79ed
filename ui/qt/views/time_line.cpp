// SPDX-License-Identifier: GPL-3.0-or-later
#include "time_line.hpp"

#include <QHelpEvent>
#include <QKeyEvent>
#include <QMouseEvent>
#include <QPainter>
#include <QStringList>
#include <QToolTip>
#include <algorithm>
#include <cmath>

#include "look/theme.hpp"

namespace hitos::window {
namespace {

constexpr int kEdge = 7;            // beside the line, half the handle
constexpr int kGroove = 4;          // its height
constexpr int kTen = 10;            // scans with Shift
constexpr int kNear = 3;            // pixels about a place that a tip tells of
constexpr qsizetype kTipLines = 8;  // of a tip

}  // namespace

TimeLine::TimeLine(QWidget* parent) : QAbstractSlider(parent) {
    setOrientation(Qt::Horizontal);
    setFocusPolicy(Qt::StrongFocus);
    setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Fixed);
    setRange(0, 0);
    setAccessibleName(tr("Time line"));
}

void TimeLine::show_run(int scan, int last) {
    if (scan == wanted_) on_its_way_ = false;
    setMaximum(std::max(last, scan));
    setValue(scan);
    update();
}

void TimeLine::set_marks(std::vector<Mark> marks) {
    marks_ = std::move(marks);
    update();
}

void TimeLine::add_marks(const std::vector<Mark>& marks) {
    if (marks.empty()) return;
    marks_.insert(marks_.end(), marks.begin(), marks.end());
    update();
}

int TimeLine::x_of(int scan) const {
    const int length = width() - 2 * kEdge;
    if (maximum() <= 0) return kEdge;
    return kEdge + static_cast<int>(std::lround(static_cast<double>(length) * scan / maximum()));
}

int TimeLine::scan_at(int x) const {
    const int length = std::max(1, width() - 2 * kEdge);
    const double part = std::clamp(static_cast<double>(x - kEdge) / length, 0.0, 1.0);
    return std::max(1, static_cast<int>(std::lround(part * maximum())));
}

void TimeLine::choose(int scan) {
    if (maximum() <= 0) return;
    wanted_ = std::clamp(scan, 1, maximum());
    on_its_way_ = wanted_ != value();
    emit chosen(wanted_);
}

int TimeLine::event_beside(bool after) const {
    int found = 0;
    for (const Mark& mark : marks_) {
        if (mark.kind == Mark::Kind::filter) continue;
        if (after ? mark.scan > place() && (found == 0 || mark.scan < found)
                  : mark.scan < place() && mark.scan > found) {
            found = mark.scan;
        }
    }
    return found;
}

void TimeLine::choose_event(bool after) {
    if (const int scan = event_beside(after); scan > 0) choose(scan);
}

void TimeLine::mousePressEvent(QMouseEvent* event) {
    if (event->button() == Qt::LeftButton) choose(scan_at(event->position().toPoint().x()));
}

void TimeLine::mouseMoveEvent(QMouseEvent* event) {
    if ((event->buttons() & Qt::LeftButton) == 0U) return;
    const int scan = scan_at(event->position().toPoint().x());
    if (scan != wanted_) choose(scan);
}

void TimeLine::keyPressEvent(QKeyEvent* event) {
    const int from = place();
    const int step = (event->modifiers() & Qt::ShiftModifier) != 0U ? kTen : 1;
    switch (event->key()) {
        case Qt::Key_Left:
            return choose(from - step);
        case Qt::Key_Right:
            return choose(from + step);
        case Qt::Key_Home:
            return choose(1);
        case Qt::Key_End:
            return choose(maximum());
        default:
            event->ignore();  // the space bar runs and stops
    }
}

/// A turned wheel is no wish to leave where one is.
void TimeLine::wheelEvent(QWheelEvent* event) {
    event->ignore();
}

QString TimeLine::tip_at(int x) const {
    QStringList lines{tr("Scan %1 of %2").arg(scan_at(x)).arg(maximum())};
    for (const Mark& mark : marks_) {
        // What happens all the time is told of the one scan alone.
        const bool near = mark.kind == Mark::Kind::filter ? mark.scan == scan_at(x)
                                                          : std::abs(x_of(mark.scan) - x) <= kNear;
        if (!near) continue;
        if (lines.size() == kTipLines) {
            lines << QStringLiteral("…");
            break;
        }
        lines << QStringLiteral("%1: %2").arg(mark.scan).arg(mark.text);
    }
    return lines.join('\n');
}

bool TimeLine::event(QEvent* event) {
    if (event->type() == QEvent::ToolTip && maximum() > 0) {
        const auto* help = static_cast<QHelpEvent*>(event);  // NOLINT(*-static-cast-downcast)
        QToolTip::showText(help->globalPos(), tip_at(help->pos().x()), this);
        return true;
    }
    if (event->type() == QEvent::ShortcutOverride) {
        // The window's shortcuts have an arrow of their own: where the line has the keyboard it is
        // the line's. With Ctrl it is the window's.
        const auto* pressed = static_cast<QKeyEvent*>(event);  // NOLINT(*-static-cast-downcast)
        const int key = pressed->key();
        if ((pressed->modifiers() & Qt::ControlModifier) != 0U)
            return QAbstractSlider::event(event);
        if (key == Qt::Key_Left || key == Qt::Key_Right || key == Qt::Key_Home ||
            key == Qt::Key_End) {
            event->accept();
            return true;
        }
    }
    return QAbstractSlider::event(event);
}

/// The marks of one kind: a long run has many at one place, where one is seen.
void TimeLine::draw_marks(QPainter& painter, Mark::Kind kind, int middle) const {
    using Kind = Mark::Kind;
    const Colours& c = colours();
    const bool above = kind == Kind::filter;
    const bool rare = kind == Kind::loop || kind == Kind::damage || kind == Kind::disturbance;
    const int from = above ? middle - kGroove : middle + kGroove;
    std::vector<bool> drawn(static_cast<std::size_t>(std::max(width(), 0)) + 1);
    QList<QLine> lines;
    for (const Mark& mark : marks_) {
        if (mark.kind != kind) continue;
        const int x = std::clamp(x_of(mark.scan), 0, std::max(width(), 0));
        auto place = drawn[static_cast<std::size_t>(x)];
        if (place) continue;
        place = true;
        lines.append(QLine(x, from, x, above ? from - 3 : from + (rare ? 6 : 3)));
    }
    painter.setPen(kind == Kind::loop          ? c.highlight
                   : kind == Kind::damage      ? c.danger
                   : kind == Kind::disturbance ? c.accent
                                               : c.muted);
    painter.drawLines(lines);
}

void TimeLine::paintEvent(QPaintEvent* /*event*/) {
    const Colours& c = colours();
    QPainter painter(this);
    painter.setRenderHint(QPainter::Antialiasing);
    const int middle = height() / 2;
    const QRect groove(kEdge, middle - kGroove / 2, width() - 2 * kEdge, kGroove);
    painter.setPen(Qt::NoPen);
    painter.setBrush(c.border);
    painter.drawRoundedRect(groove, kGroove / 2.0, kGroove / 2.0);
    if (maximum() <= 0) return;
    const int now = x_of(value());
    painter.setBrush(c.accent);
    painter.drawRoundedRect(QRect(groove.left(), groove.top(), now - groove.left(), kGroove),
                            kGroove / 2.0, kGroove / 2.0);
    painter.setRenderHint(QPainter::Antialiasing, false);
    using Kind = Mark::Kind;
    for (const Kind kind :
         {Kind::filter, Kind::event, Kind::loop, Kind::disturbance, Kind::damage}) {
        draw_marks(painter, kind, middle);
    }
    painter.setRenderHint(QPainter::Antialiasing);
    painter.setPen(QPen(hasFocus() ? c.text : c.accent, hasFocus() ? 2.0 : 1.0));
    painter.setBrush(isEnabled() ? c.accent : c.border);
    painter.drawEllipse(QPointF(now, middle), 5.0, 5.0);
}

}  // namespace hitos::window
