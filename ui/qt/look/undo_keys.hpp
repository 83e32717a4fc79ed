// SPDX-License-Identifier: GPL-3.0-or-later
// Undo and redo by keys, in windows that have changes of their own to take back.
#pragma once

#include <QLineEdit>
#include <QObject>
#include <QPointer>

namespace hitos::window {

/// Fields take the keys of undo and redo for their text. In this window they have them only where
/// somebody is writing: has typed into the field since it got the focus. Else they are the
/// window's.
class UndoKeys final : public QObject {
    Q_OBJECT

  public:
    explicit UndoKeys(QWidget* window);

    bool eventFilter(QObject* watched, QEvent* event) override;

  private:
    void watch(QLineEdit* line);

    QWidget* window_;
    QPointer<QLineEdit> watched_;     ///< has the focus
    QPointer<QLineEdit> written_in_;  ///< since it has the focus
};

/// Where a widget goes out of use while it has the focus, `instead` gets it: Qt would take the next
/// one, a button that the same key presses or a field that the next keys change.
void set_enabled(QWidget& widget, bool enabled, QWidget& instead);

}  // namespace hitos::window
