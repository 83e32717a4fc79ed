// SPDX-License-Identifier: GPL-3.0-or-later
#include "written_pose.hpp"

#include <QCoreApplication>
#include <QLineEdit>

#include "hitos/base/error.hpp"
#include "hitos/capture/joined_tour.hpp"
#include "look/field_tip.hpp"
#include "look/theme.hpp"
#include "look/written_number.hpp"

namespace hitos::window {

QString pose_text(const Pose& pose) {
    return QString("%1, %2, %3")
        .arg(pose.x, 0, 'f', 3)
        .arg(pose.y, 0, 'f', 3)
        .arg(pose.theta * kDegreesPerRadian, 0, 'f', 2);
}

std::optional<Pose> pose_of(const QLineEdit& line) {
    try {
        return start_of(pose_with_points(line.text()).toStdString());
    } catch (const Error&) {
        return std::nullopt;
    }
}

void make_pose_line(QLineEdit& line, const QString& words) {
    line.setToolTip(words);
    line.setAccessibleName(words);
    line.setPlaceholderText(QCoreApplication::translate("WrittenPose", "x, y [m], heading [°]"));
    line.setMinimumWidth(line.fontMetrics().horizontalAdvance("-100.000, -100.000, -180.00") + 16);
    const auto unread = [&line] { return !line.text().trimmed().isEmpty() && !pose_of(line); };
    QObject::connect(&line, &QLineEdit::textChanged, &line,
                     [&line, unread] { set_look(line, "state", unread() ? "wrong" : "good"); });
    QObject::connect(&line, &QLineEdit::returnPressed, &line, [&line, unread] {
        if (!unread()) return;
        show_field_tip(
            line, QCoreApplication::translate("WrittenPose", "Expected: %1").arg(line.toolTip()));
    });
}

}  // namespace hitos::window
