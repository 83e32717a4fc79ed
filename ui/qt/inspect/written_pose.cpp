// SPDX-License-Identifier: GPL-3.0-or-later
#include "written_pose.hpp"

#include <QLineEdit>

#include "hitos/base/error.hpp"
#include "hitos/capture/joined_tour.hpp"

namespace hitos::window {

QString pose_text(const Pose& pose) {
    return QString("%1, %2, %3")
        .arg(pose.x, 0, 'f', 3)
        .arg(pose.y, 0, 'f', 3)
        .arg(pose.theta * kDegreesPerRadian, 0, 'f', 2);
}

std::optional<Pose> pose_of(const QLineEdit& line) {
    try {
        return start_of(line.text().remove(' ').toStdString());
    } catch (const Error&) {
        return std::nullopt;
    }
}

void make_pose_line(QLineEdit& line, const QString& words) {
    line.setToolTip(words);
    line.setAccessibleName(words);
    line.setMinimumWidth(line.fontMetrics().horizontalAdvance("-100.000, -100.000, -180.00") + 16);
}

}  // namespace hitos::window
