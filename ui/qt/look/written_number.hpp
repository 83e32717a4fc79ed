// SPDX-License-Identifier: GPL-3.0-or-later
// Numbers as people write them. Files, command lines and what the window shows have decimal points;
// where the user's country writes commas, a comma that is typed is one.
#pragma once

#include <QObject>
#include <QString>
#include <optional>

#include "hitos/base/parameter.hpp"

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
/// Nothing where it is none, or none that is finite.
std::optional<double> number_of(const QString& written);
/// Whether a list has a comma between digits where that is a decimal one.
bool has_decimal_comma(const QString& list);
/// As the library reads a list, with commas between its values. Semicolons and blanks are as good;
/// where a comma is a decimal one, it is only between digits of `fractions`, and not in a list that
/// has points and no semicolons: "0,5; 1,3", "0,5 1,3", "0.5, 1.3" and "0.5,1.3" are two values.
QString list_with_points(const QString& list, bool fractions);
/// The same of x, y and heading: "0,0,180" is a pose as it stands, as files have it.
QString pose_with_points(const QString& pose);
/// As files have it, a list where a comma is never a decimal one: as it is written here.
QString list_as_written(const QString& list);

/// What is written in the field of a parameter, as the library reads it, and the other way round.
QString as_read(const ParameterFacts& parameter, const QString& written);
QString as_written(const ParameterFacts& parameter, const QString& read);

}  // namespace hitos::window
