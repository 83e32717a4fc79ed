// SPDX-License-Identifier: GPL-3.0-or-later
#include "edit_words.hpp"

#include <QCoreApplication>

#include "hitos/capture/joined_tour.hpp"

namespace hitos::window {
namespace {

QString words(const char* text) {
    return QCoreApplication::translate("hitos::window::EditList", text);
}

}  // namespace

QString change_in_words(const GraphEdit& edit) {
    const QString scan = QString::number(edit.scan.scan + 1);
    const QString earlier = QString::number(edit.earlier.scan + 1);
    switch (edit.kind) {
        case GraphEdit::Kind::refuse:
            return words(QT_TRANSLATE_NOOP("hitos::window::EditList",
                                           "Refused: scan %1 has not come back to %2"))
                .arg(scan, earlier);
        case GraphEdit::Kind::close:
            return words(QT_TRANSLATE_NOOP("hitos::window::EditList",
                                           "Closed: scan %1 has come back to %2"))
                .arg(scan, earlier);
        case GraphEdit::Kind::fix:
            return words(QT_TRANSLATE_NOOP("hitos::window::EditList", "Scan %1 is fixed"))
                .arg(scan);
        case GraphEdit::Kind::wall:
            return words(QT_TRANSLATE_NOOP(
                             "hitos::window::EditList",
                             "Scan %1 is anchored to a wall of the drawing, seen at %2°"))
                .arg(scan)
                .arg(edit.bearing * kDegreesPerRadian, 0, 'f', 0);
        case GraphEdit::Kind::point:
            return words(
                       QT_TRANSLATE_NOOP("hitos::window::EditList",
                                         "Scan %1 is anchored to the point %2, %3 of the drawing"))
                .arg(scan)
                .arg(edit.left.x, 0, 'f', 2)
                .arg(edit.left.y, 0, 'f', 2);
        default:
            return words(
                       QT_TRANSLATE_NOOP("hitos::window::EditList", "The step to scan %1 slipped"))
                .arg(scan);
    }
}

}  // namespace hitos::window
