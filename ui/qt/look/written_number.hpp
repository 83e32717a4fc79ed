// SPDX-License-Identifier: GPL-3.0-or-later
// Numbers as people write them. Files, command lines and what the window shows have decimal points;
// where the user's country writes commas, a comma that is typed is one.
#pragma once

#include <QObject>
#include <QString>

class QAbstractSpinBox;

namespace hitos::window {

/// Whether the user's country writes decimal commas.
bool decimal_comma();
/// Before there is a window.
void set_decimal_comma(bool on);

/// Of the application: every spin box takes a decimal comma for the point that it shows, and tells
/// of a number out of its range, for which Return does not do; what was left of it would be another
/// one.
class NumberBoxes final : public QObject {
    Q_OBJECT

  public:
    using QObject::QObject;

  protected:
    bool eventFilter(QObject* watched, QEvent* event) override;

  private:
    static void look_after(QAbstractSpinBox& box);
};

/// As the library reads a number.
QString with_point(const QString& number);
/// As the library reads a list, with commas between its values. Semicolons and blanks are as good;
/// where a comma is a decimal one, it is only between digits of `fractions`, and not in a list that
/// has points and no semicolons: "0,5; 1,3", "0,5 1,3", "0.5, 1.3" and "0.5,1.3" are two values.
QString list_with_points(const QString& list, bool fractions);

}  // namespace hitos::window
