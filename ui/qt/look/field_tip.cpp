// SPDX-License-Identifier: GPL-3.0-or-later
#include "field_tip.hpp"

#include <QAbstractButton>
#include <QAbstractItemView>
#include <QAbstractSpinBox>
#include <QApplication>
#include <QComboBox>
#include <QLineEdit>
#include <QScreen>
#include <QToolTip>
#include <array>

namespace hitos::window {
namespace {

QRect global_rect(const QWidget& widget) {
    return {widget.mapToGlobal(QPoint()), widget.size()};
}

bool is_input(const QWidget& widget) {
    return qobject_cast<const QAbstractSpinBox*>(&widget) != nullptr ||
           qobject_cast<const QLineEdit*>(&widget) != nullptr ||
           qobject_cast<const QComboBox*>(&widget) != nullptr ||
           qobject_cast<const QAbstractButton*>(&widget) != nullptr ||
           qobject_cast<const QAbstractItemView*>(&widget) != nullptr;
}

/// Whether it would lie on the field or on another input.
bool covers(const QRect& place, const QWidget& field) {
    if (place.intersects(global_rect(field))) return true;
    for (const QWidget* widget : field.window()->findChildren<QWidget*>()) {
        if (widget->isVisible() && is_input(*widget) && place.intersects(global_rect(*widget)))
            return true;
    }
    return false;
}

/// The first of the places round the field, and round its window, that will do.
QPoint place_for(const QSize& size, const QWidget& field) {
    constexpr int kGap = 4;
    const QRect own = global_rect(field);
    const QRect window = field.window()->frameGeometry();
    const int beside = own.center().y() - size.height() / 2;
    const std::array places{QPoint(own.right() + kGap, beside),
                            QPoint(own.left(), own.bottom() + kGap),
                            QPoint(own.left(), own.top() - kGap - size.height()),
                            QPoint(window.right() + kGap, beside),
                            QPoint(window.left() - kGap - size.width(), beside),
                            QPoint(own.left(), window.bottom() + kGap)};
    for (const QPoint& place : places) {
        const QRect there(place, size);
        if (field.screen()->availableGeometry().contains(there) && !covers(there, field))
            return place;
    }
    return places.front();
}

}  // namespace

void show_field_tip(QWidget& field, const QString& words) {
    QToolTip::showText(field.mapToGlobal(QPoint(field.width(), 0)), words, &field);
    for (QWidget* tip : QApplication::topLevelWidgets()) {
        if (tip->objectName() == "qtooltip_label") tip->move(place_for(tip->size(), field));
    }
}

void hide_field_tip() {
    QToolTip::hideText();
}

}  // namespace hitos::window
