// SPDX-License-Identifier: GPL-3.0-or-later
// What somebody who looks at the screen sees, and where they would click.
#pragma once

#include <QPoint>
#include <QPointer>
#include <QString>
#include <QStringList>
#include <QWidget>

namespace hitos::window {

struct Target {
    QPointer<QWidget> widget;  ///< null: nothing of that name is in sight
    QPoint at;
    bool slow = false;  ///< of a list that has just opened: a click counts a little later
};

/// As a text is read: without the mark of the letter that chooses it.
QString as_read(QString text);

/// The button, menu, tab, cell or field with one of those words: what is written on it, else the
/// label of a field, else its name in the program.
Target target_of(const QStringList& words);

/// All that is written in the windows that can be used now.
QStringList all_in_sight();

/// The open menu, else the dialog that has to be answered, else the window above.
QWidget* window_above();

}  // namespace hitos::window
