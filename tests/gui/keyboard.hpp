// SPDX-License-Identifier: GPL-3.0-or-later
// A user without a mouse: keys go to the window that has the keyboard, and nothing else is touched.
#pragma once

#include <QAbstractButton>
#include <QFileDialog>
#include <QMenu>
#include <QMessageBox>

#include "gui_fixture.hpp"

namespace hitos::window {

/// A window with its real questions, which are answered by keys.
struct KeyboardFixture : WindowFixture<QtPrompts> {
    explicit KeyboardFixture(int particles = 10) {
        QCoreApplication::setAttribute(Qt::AA_DontUseNativeDialogs);
        if (particles > 0) session.set_configuration(Fixture::tour(particles));
    }

    bool rests() const { return state() != Progress::State::running && shows_everything(); }
};

/// A desktop gives the keyboard to the window that is above the others; without a screen nobody
/// does it when one has closed.
inline void look_for_the_keyboard() {
    QWidget* above = QApplication::activeModalWidget();
    if (above == nullptr && QApplication::activeWindow() == nullptr) {
        for (QWidget* window : QApplication::topLevelWidgets()) {
            const bool main = qobject_cast<MainWindow*>(window) != nullptr;
            if (window->isVisible() && (main || above == nullptr)) above = window;
        }
    }
    if (above == nullptr || above->isActiveWindow()) return;
    above->activateWindow();
    QTRY_VERIFY(above->isActiveWindow());
}

/// What the next key goes to.
inline QWidget* listener() {
    if (QWidget* menu = QApplication::activePopupWidget()) return menu;
    look_for_the_keyboard();
    if (QWidget* focused = QApplication::focusWidget()) return focused;
    return QApplication::activeWindow();
}

inline void press(Qt::Key key, Qt::KeyboardModifiers with = Qt::NoModifier) {
    QWidget* to = listener();
    QVERIFY(to != nullptr);
    QTest::keyClick(to, key, with);
}

constexpr Qt::KeyboardModifiers kCtrl = Qt::ControlModifier;
constexpr Qt::KeyboardModifiers kCtrlShift = Qt::ControlModifier | Qt::ShiftModifier;

/// Into what has the keyboard, in the place of what is selected there.
inline void type(const QString& text) {
    QWidget* to = listener();
    QVERIFY(to != nullptr);
    QTest::keyClicks(to, text);
}

inline QString focused() {
    const QWidget* widget = QApplication::focusWidget();
    return widget == nullptr ? QString() : widget->objectName();
}

/// Tab, until what has that name has the keyboard.
inline void tab_to(const QString& name) {
    constexpr int kMost = 200;
    for (int i = 0; i < kMost && focused() != name; ++i) press(Qt::Key_Tab);
    QCOMPARE(focused(), name);
}

/// Tab, until the button with those words has the keyboard; then the space bar.
inline void tab_and_press(const QString& words) {
    constexpr int kMost = 50;
    const auto there = [&words] {
        const auto* button = qobject_cast<QAbstractButton*>(QApplication::focusWidget());
        return button != nullptr && button->text() == words;
    };
    for (int i = 0; i < kMost && !there(); ++i) press(Qt::Key_Tab);
    QVERIFY2(there(), qPrintable(words));
    press(Qt::Key_Space);
}

/// Opens the menu of that letter and goes down to the first name, and from there into its menu.
inline void choose_in_menu(Qt::Key letter, const QStringList& names) {
    press(letter, Qt::AltModifier);
    for (const QString& name : names) {
        QTRY_VERIFY(qobject_cast<QMenu*>(QApplication::activePopupWidget()) != nullptr);
        auto* menu = qobject_cast<QMenu*>(QApplication::activePopupWidget());
        const auto there = [menu, &name] {
            const QAction* action = menu->activeAction();
            if (action == nullptr) return false;
            return (action->menu() ? action->menu()->objectName() : action->objectName()) == name;
        };
        for (qsizetype i = 0; i < menu->actions().size() && !there(); ++i) press(Qt::Key_Down);
        QVERIFY2(there(), qPrintable(name));
        press(menu->activeAction()->menu() != nullptr ? Qt::Key_Right : Qt::Key_Return);
    }
}

/// Names a file in the file dialog that opens next; what its completer shows is not chosen.
inline void answer_file(const QString& path) {
    in_dialog<QFileDialog>([path](QFileDialog& dialog) {
        const QPointer<QFileDialog> open(&dialog);
        type(path);
        while (open && open->isVisible()) {
            press(Qt::Key_Return);
            QTest::qWait(10);
        }
    });
}

/// Escape in the dialog of that kind that opens next.
template <class Dialog>
void answer_escape() {
    in_dialog<Dialog>([](Dialog& /*dialog*/) { press(Qt::Key_Escape); });
}

/// Return in the question that opens next, or the button with those words.
inline void answer_box(const QString& words = {}) {
    in_dialog<QMessageBox>([words](QMessageBox& /*box*/) {
        words.isEmpty() ? press(Qt::Key_Return) : tab_and_press(words);
    });
}

}  // namespace hitos::window
