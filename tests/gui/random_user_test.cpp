// SPDX-License-Identifier: GPL-3.0-or-later
// Somebody who clicks, drags, scrubs and types at random: nothing may crash, hang, leak or
// complain.

#include <QAbstractButton>
#include <QComboBox>
#include <QDialog>
#include <QDockWidget>
#include <QElapsedTimer>
#include <QMenu>
#include <QMouseEvent>
#include <QTimer>
#include <QWheelEvent>
#include <random>

#include "gui_fixture.hpp"
#include "tests.hpp"
#include "views/plots.hpp"
#include "views/time_line.hpp"

namespace hitos::window {
namespace {

/// What the window's libraries said meanwhile.
QStringList& complaints() {
    static QStringList said;
    return said;
}

void note_complaint(QtMsgType type, const QMessageLogContext& /*context*/, const QString& text) {
    if (type == QtDebugMsg || type == QtInfoMsg) return;
    // Of windows without a screen, and of a click that nobody wants.
    if (text.startsWith("This plugin does not support") ||
        text.contains("not accepted by receiving widget")) {
        return;
    }
    complaints() << text;
}

int from_environment(const char* name, int otherwise) {
    bool known = false;
    const int value = qEnvironmentVariableIntValue(name, &known);
    return known ? value : otherwise;
}

class RandomUser {
  public:
    RandomUser(Fixture& fixture, unsigned seed) : f_(fixture), random_(seed) {
        // Dialogs and menus hold the loop that opened them until they are closed.
        QObject::connect(&guard_, &QTimer::timeout, [this] { leave_what_is_open(); });
        guard_.start(kGuardMs);
    }

    void act() {
        switch (below(12)) {
            case 0:
                return trigger_action();
            case 1:
                return click_button(some_window());
            case 2:
                return scrub();
            case 3:
            case 4:
                return drag(some_view());
            case 5:
                return turn_wheel(some_view());
            case 6:
            case 7:
                return press_key();
            case 8:
            case 9:
                return click(some_view());
            case 10:
                return choose();
            default:
                f_.window->resize(1024 + below(400), 700 + below(300));
        }
    }

    int below(int limit) { return std::uniform_int_distribution<int>(0, limit - 1)(random_); }

  private:
    static constexpr int kGuardMs = 15;

    QPoint place_in(const QWidget& widget) {
        return {below(std::max(1, widget.width())), below(std::max(1, widget.height()))};
    }

    /// The main window twice as often as one of the maps, or the comparison.
    QWidget& some_window() {
        QList<QWidget*> windows{f_.window.get(), f_.window.get()};
        for (auto* dialog : f_.window->findChildren<QDialog*>()) {
            if (dialog->isVisible() && !dialog->isModal()) windows << dialog;
        }
        return *windows[below(static_cast<int>(windows.size()))];
    }

    QWidget& some_view() {
        QList<QWidget*> views{&f_.window->scan_view(), &f_.window->grid_view()};
        for (auto* view : f_.window->findChildren<GridView*>()) {
            if (view->isVisible()) views << view;
        }
        for (auto* dock : f_.window->findChildren<QDockWidget*>()) {
            if (dock->isVisible() && dock->widget() != nullptr) views << dock->widget();
        }
        if (f_.window->plots().isVisible()) {
            views << f_.window->plots().findChildren<QWidget*>(QString(),
                                                               Qt::FindDirectChildrenOnly);
        }
        return *views[below(static_cast<int>(views.size()))];
    }

    /// Any of the menus' but those that end the program, leave it, or compute for long.
    void trigger_action() {
        static const QStringList left_out{"action_exit", "action_guide", "action_study"};
        QList<QAction*> actions;
        for (auto* action : f_.window->findChildren<QAction*>()) {
            const bool may = action->isEnabled() && action->isVisible() && !action->isSeparator() &&
                             action->menu() == nullptr && !left_out.contains(action->objectName());
            if (may) actions << action;
        }
        if (!actions.isEmpty()) actions[below(static_cast<int>(actions.size()))]->trigger();
    }

    void click_button(const QWidget& parent) {
        QList<QAbstractButton*> buttons;
        for (auto* button : parent.findChildren<QAbstractButton*>()) {
            if (button->isVisible() && button->isEnabled()) buttons << button;
        }
        if (!buttons.isEmpty()) click(*buttons[below(static_cast<int>(buttons.size()))]);
    }

    /// What lies there gets it, as a table of a dock or one of its buttons.
    void click(QWidget& widget) {
        const Qt::MouseButton button = below(6) == 0 ? Qt::RightButton : Qt::LeftButton;
        const QPoint place = place_in(widget);
        QWidget* below_it = widget.childAt(place);
        QWidget* to = below_it == nullptr ? &widget : below_it;
        const QPoint there = to->mapFrom(&widget, place);
        if (below(8) == 0) {
            QTest::mouseDClick(to, button, {}, there);
        } else {
            QTest::mouseClick(to, button, below(4) == 0 ? Qt::ShiftModifier : Qt::NoModifier,
                              there);
        }
    }

    /// Another line of one of the lists, as that of the runs to compare.
    void choose() {
        QList<QComboBox*> boxes;
        for (auto* box : f_.window->findChildren<QComboBox*>()) {
            if (box->isVisible() && box->isEnabled()) boxes << box;
        }
        if (boxes.isEmpty()) return;
        QTest::keyClick(boxes[below(static_cast<int>(boxes.size()))],
                        below(2) == 0 ? Qt::Key_Down : Qt::Key_Up);
    }

    void drag(QWidget& widget) {
        const QPoint from = place_in(widget);
        QTest::mousePress(&widget, Qt::LeftButton, {}, from);
        QPoint at = from;
        for (int i = below(6); i >= 0; --i) {
            at = place_in(widget);
            QMouseEvent move(QEvent::MouseMove, at, widget.mapToGlobal(at), Qt::NoButton,
                             Qt::LeftButton, Qt::NoModifier);
            QApplication::sendEvent(&widget, &move);
        }
        QTest::mouseRelease(&widget, Qt::LeftButton, {}, at);
    }

    /// At times while it runs.
    void scrub() {
        if (below(2) == 0 && f_.action("action_run")->isEnabled()) {
            f_.action("action_run")->trigger();
        }
        if (auto* line = f_.window->findChild<TimeLine*>()) drag(*line);
    }

    void turn_wheel(QWidget& widget) {
        const QPoint at = place_in(widget);
        QWheelEvent turn(at, widget.mapToGlobal(at), {}, {0, below(2) == 0 ? 120 : -120},
                         Qt::NoButton, Qt::NoModifier, Qt::NoScrollPhase, false);
        QApplication::sendEvent(&widget, &turn);
    }

    void press_key() {
        static const QList<Qt::Key> plain{
            Qt::Key_Space, Qt::Key_Right, Qt::Key_Left, Qt::Key_Home, Qt::Key_End, Qt::Key_Plus,
            Qt::Key_Minus, Qt::Key_F,     Qt::Key_W,    Qt::Key_A,    Qt::Key_S,   Qt::Key_D,
            Qt::Key_B,     Qt::Key_O,     Qt::Key_P,    Qt::Key_Tab,  Qt::Key_Down};
        constexpr auto kCtrlShift = Qt::ControlModifier | Qt::ShiftModifier;
        static const QList<QKeyCombination> keys{
            Qt::Key_M,      Qt::SHIFT | Qt::Key_M,   kCtrlShift | Qt::Key_M, Qt::CTRL | Qt::Key_K,
            Qt::Key_Return, kCtrlShift | Qt::Key_K,  kCtrlShift | Qt::Key_J, kCtrlShift | Qt::Key_A,
            Qt::Key_Escape, Qt::SHIFT | Qt::Key_Tab, Qt::CTRL | Qt::Key_G,   Qt::CTRL | Qt::Key_Z};
        QWidget* to = QApplication::focusWidget();
        if (to == nullptr) to = f_.window.get();
        if (below(3) == 0) {
            const QKeyCombination key = keys[below(static_cast<int>(keys.size()))];
            QTest::keyClick(to, key.key(), key.keyboardModifiers());
            return;
        }
        const auto with = below(8) == 0 ? Qt::ShiftModifier : Qt::NoModifier;
        QTest::keyClick(to, plain[below(static_cast<int>(plain.size()))], with);
    }

    /// Clicks about in what is open, and closes it sooner or later.
    void leave_what_is_open() {
        if (QWidget* menu = QApplication::activePopupWidget()) {
            menu->close();
            return;
        }
        const QPointer<QWidget> open = QApplication::activeModalWidget();
        if (!open) return;
        if (below(4) != 0) {
            click_button(*open);
        } else if (auto* dialog = qobject_cast<QDialog*>(open)) {
            dialog->reject();
        } else {
            open->close();
        }
    }

    Fixture& f_;
    std::mt19937 random_;
    QTimer guard_;
};

/// Says yes and no, names files, and at times gives up.
void answer(Fixture& f, RandomUser& user) {
    const QStringList files{Fixture::source_file("config/simulated.cfg"),
                            Fixture::source_file("config/ekf.cfg"),
                            Fixture::source_file("data/bigloop.log.gz"),
                            Fixture::source_file("data/maps/bigloop.map"),
                            Fixture::source_file("README.md"),
                            f.path("nowhere.cfg")};
    const QStringList endings{"png", "jpg", "txt", "dxf", "csv", "cfg", "seg"};
    f.prompts.opens = {files[user.below(static_cast<int>(files.size()))]};
    f.prompts.saves = {f.path(QString("written%1.%2")
                                  .arg(user.below(9))
                                  .arg(endings[user.below(static_cast<int>(endings.size()))]))};
    f.prompts.confirms = {user.below(2) == 0, user.below(2) == 0};
    f.prompts.numbers = {user.below(10)};
    f.prompts.folders = {f.path("results")};
    if (user.below(3) == 0) f.prompts.opens.clear();
    if (user.below(4) == 0) f.prompts.saves = {f.path("results")};
    if (user.below(3) == 0) f.prompts.saves.clear();
    if (user.below(3) == 0) f.prompts.folders.clear();
}

}  // namespace

/// HITOS_REPEAT makes it longer and HITOS_USER_SEED another.
void RandomUserTest::nothing_that_a_user_does_breaks_the_window() {
    const int seconds = 20 * from_environment("HITOS_REPEAT", 1);
    const auto seed = static_cast<unsigned>(from_environment("HITOS_USER_SEED", 1));
    complaints().clear();
    const auto before = qInstallMessageHandler(note_complaint);
    int acts = 0;
    {
        Fixture f;
        f.window->resize(1024, 700);
        f.run_steps(20);
        f.prompts.saves = {f.path("results")};  // to be opened
        f.trigger("action_save_results");
        QTRY_VERIFY(f.action("action_save_results")->isEnabled());
        RandomUser user(f, seed);
        QElapsedTimer clock;
        clock.start();
        while (clock.elapsed() < 1000LL * seconds && complaints().isEmpty()) {
            answer(f, user);
            user.act();
            QTest::qWait(user.below(10));
            ++acts;
        }
        // It still does what it is for, once what was asked before is done.
        while (QWidget* open = QApplication::activeModalWidget()) open->close();
        f.session.set_configuration(Fixture::tour(10));
        f.run_steps(5);
        const auto steps = [&] { return f.session.progress().steps; };
        if (!QTest::qWaitFor([&] { return steps() == 5; }, 20'000)) {
            complaints() << QString("the run does not step any more: %1 of 5 steps").arg(steps());
        }
    }
    qInstallMessageHandler(before);
    QVERIFY2(complaints().isEmpty(), qPrintable(QString("seed %1, after %2 acts: %3")
                                                    .arg(seed)
                                                    .arg(acts)
                                                    .arg(complaints().join(" | "))));
    QVERIFY(acts > 0);
}

}  // namespace hitos::window
