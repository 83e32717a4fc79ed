// SPDX-License-Identifier: GPL-3.0-or-later
// A pose as somebody writes it.
#pragma once

#include <QString>
#include <optional>

#include "hitos/base/geometry.hpp"

class QLineEdit;

namespace hitos::window {

/// "1.250, -3.000, 90.00": x, y [m] and heading [°].
QString pose_text(const Pose& pose);
/// Nothing where it is none.
std::optional<Pose> pose_of(const QLineEdit& line);
/// Wide enough for one, and `words` say of what. What is none looks wrong, and Enter says what is
/// expected.
void make_pose_line(QLineEdit& line, const QString& words);

}  // namespace hitos::window
