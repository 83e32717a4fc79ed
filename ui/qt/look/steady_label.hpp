// SPDX-License-Identifier: GPL-3.0-or-later
// Labels that take the same room whatever they say: a picture above them does not move.
#pragma once

#include <QLabel>
#include <QScrollArea>

namespace hitos::window {

/// Room for so many lines of the label, which it now stands in; what it says beyond them is
/// scrolled to.
inline QScrollArea* keep_lines(QLabel& label, int lines) {
    auto* area = new QScrollArea(label.parentWidget());
    area->setFrameShape(QFrame::NoFrame);
    area->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
    area->setFocusPolicy(Qt::NoFocus);  // the keyboard is the drawing's
    area->setFixedHeight(label.fontMetrics().lineSpacing() * lines + 2);
    label.setAlignment(Qt::AlignLeft | Qt::AlignTop);
    label.setWordWrap(true);
    area->setWidgetResizable(true);
    area->setWidget(&label);
    for (QWidget* ground : {static_cast<QWidget*>(&label), area->viewport()})
        ground->setAutoFillBackground(false);
    return area;
}

}  // namespace hitos::window
