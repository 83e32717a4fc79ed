// SPDX-License-Identifier: GPL-3.0-or-later
#include "undo_keys.hpp"

#include <QAbstractSpinBox>
#include <QApplication>
#include <QComboBox>
#include <QDockWidget>
#include <QKeyEvent>

namespace hitos::window {
namespace {

/// The field that a widget with the focus writes into; null where it has none.
QLineEdit* line_of(QWidget* widget) {
    if (auto* line = qobject_cast<QLineEdit*>(widget)) return line;
    if (auto* combo = qobject_cast<QComboBox*>(widget)) return combo->lineEdit();
    return qobject_cast<QAbstractSpinBox*>(widget) != nullptr ? widget->findChild<QLineEdit*>()
                                                              : nullptr;
}

/// Docks that float are windows of the one that they belong to.
QWidget* window_of(const QWidget& widget) {
    QWidget* window = widget.window();
    const bool floats = qobject_cast<QDockWidget*>(window) != nullptr;
    return floats && window->parentWidget() != nullptr ? window->parentWidget()->window() : window;
}

}  // namespace

UndoKeys::UndoKeys(QWidget* window) : QObject(window), window_(window) {
    qApp->installEventFilter(this);  // fields come and go
}

void UndoKeys::watch(QLineEdit* line) {
    if (watched_) disconnect(watched_, nullptr, this, nullptr);
    watched_ = line;
    written_in_ = nullptr;
    connect(line, &QLineEdit::textEdited, this, [this] { written_in_ = watched_; });
    connect(line, &QLineEdit::returnPressed, this, [this] { written_in_ = nullptr; });
}

bool UndoKeys::eventFilter(QObject* watched, QEvent* event) {
    const QEvent::Type type = event->type();
    if (type != QEvent::FocusIn && type != QEvent::ShortcutOverride && type != QEvent::KeyPress)
        return false;
    auto* widget = qobject_cast<QWidget*>(watched);
    QLineEdit* line = widget != nullptr ? line_of(widget) : nullptr;
    if (line == nullptr || window_of(*widget) != window_) return false;
    if (type == QEvent::FocusIn) {
        const Qt::FocusReason reason = static_cast<QFocusEvent*>(event)->reason();
        const bool comes_back = reason == Qt::ActiveWindowFocusReason ||
                                reason == Qt::PopupFocusReason || reason == Qt::MenuBarFocusReason;
        if (line != watched_ || !comes_back) watch(line);
        return false;
    }
    const auto* key = static_cast<QKeyEvent*>(event);
    if (!key->matches(QKeySequence::Undo) && !key->matches(QKeySequence::Redo)) return false;
    if (line == written_in_) return false;
    // A key press comes where the window has nothing to undo: the text is not undone for that.
    event->setAccepted(type == QEvent::KeyPress);
    return true;
}

void set_enabled(QWidget& widget, bool enabled, QWidget& instead) {
    if (!enabled && widget.hasFocus()) instead.setFocus();
    widget.setEnabled(enabled);
}

}  // namespace hitos::window
