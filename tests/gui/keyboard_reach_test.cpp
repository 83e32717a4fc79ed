// SPDX-License-Identifier: GPL-3.0-or-later
// What the keys reach: everything, and each of them one thing.

#include <QAbstractItemView>
#include <QAbstractSlider>
#include <QAbstractSpinBox>
#include <QButtonGroup>
#include <QComboBox>
#include <QDockWidget>
#include <QHeaderView>
#include <QLabel>
#include <QLineEdit>
#include <QListWidget>
#include <QMap>
#include <QMenuBar>
#include <QPlainTextEdit>
#include <QPushButton>
#include <QScrollBar>
#include <QShortcut>
#include <QTextBrowser>
#include <QTranslator>

#include "animation/animation_dialog.hpp"
#include "dialogs/configuration_dialog.hpp"
#include "dialogs/connect_dialog.hpp"
#include "dialogs/export_dialog.hpp"
#include "dialogs/run_until_dialog.hpp"
#include "dialogs/source_dialog.hpp"
#include "dialogs/study_dialog.hpp"
#include "inspect/graph_window.hpp"
#include "keyboard.hpp"
#include "runs/compare_window.hpp"
#include "runs/runs.hpp"
#include "tests.hpp"
#include "views/plots.hpp"

namespace hitos::window {
namespace {

template <class... Kinds>
bool is_one_of(const QWidget& widget) {
    return (... || (qobject_cast<const Kinds*>(&widget) != nullptr));
}

/// Something that a user without a mouse has to come to; Qt's own small parts are no controls.
bool is_control(const QWidget& widget, const QWidget& window) {
    if (!widget.isVisible() || !widget.isEnabled() || widget.window() != &window) return false;
    if (widget.property("role") == "chip") return false;  // a layer of the View menu
    const QWidget* parent = widget.parentWidget();
    if (is_one_of<QScrollBar, QHeaderView>(widget) || widget.objectName().startsWith("qt_") ||
        is_one_of<QAbstractSpinBox, QComboBox, QLineEdit, QTabBar, QAbstractItemView>(*parent)) {
        return false;
    }
    return is_one_of<QAbstractButton, QComboBox, QAbstractSpinBox, QAbstractItemView, QLineEdit,
                     QPlainTextEdit, QAbstractSlider, CanvasView, Plots>(widget);
}

QString name_of(const QWidget& widget) {
    const auto* button = qobject_cast<const QAbstractButton*>(&widget);
    return widget.metaObject()->className() + (' ' + widget.objectName()) +
           (button == nullptr ? QString() : ' ' + button->text());
}

/// Of buttons that exclude each other one has the Tab key, and the arrows go on from there.
bool is_reached(const QWidget& widget, const QSet<const QWidget*>& reached) {
    if (reached.contains(&widget)) return true;
    const auto* button = qobject_cast<const QAbstractButton*>(&widget);
    if (button == nullptr || !button->isCheckable()) return false;
    return std::ranges::any_of(reached, [button](const QWidget* other) {
        const auto* sibling = qobject_cast<const QAbstractButton*>(other);
        return sibling != nullptr && sibling->isCheckable() && sibling->isChecked() &&
               sibling->parentWidget() == button->parentWidget() &&
               (sibling->autoExclusive() || (sibling->group() && sibling->group()->exclusive()));
    });
}

/// Tab goes from link to link of a page, and then on.
void press_tab() {
    const auto* page = qobject_cast<const QTextBrowser*>(QApplication::focusWidget());
    constexpr int kMostLinks = 100;
    for (int i = 0; i < kMostLinks; ++i) {
        press(Qt::Key_Tab);
        if (page == nullptr || page != QApplication::focusWidget()) return;
    }
}

void check_tab(QWidget& window, const QString& name) {
    window.show();
    window.activateWindow();
    QTRY_VERIFY2(QApplication::activeWindow() == &window, qPrintable(name));
    press_tab();
    const QWidget* first = QApplication::focusWidget();
    QSet<const QWidget*> reached;
    constexpr int kMost = 300;
    for (int i = 0; i < kMost && !reached.contains(QApplication::focusWidget()); ++i) {
        const QWidget* now = QApplication::focusWidget();
        QVERIFY2(now != nullptr, qPrintable(name));
        QVERIFY2(now->window() == &window, qPrintable(name + ": goes to " + name_of(*now)));
        const QRect place(now->mapTo(&window, QPoint()), now->size());
        QVERIFY2(window.rect().intersects(place),
                 qPrintable(name + ": out of sight: " + name_of(*now)));
        reached.insert(now);
        press_tab();
    }
    QVERIFY2(QApplication::focusWidget() == first,
             qPrintable(name + ": does not leave " + name_of(*QApplication::focusWidget())));
    for (const auto* widget : window.findChildren<QWidget*>()) {
        if (!is_control(*widget, window)) continue;
        QVERIFY2(is_reached(*widget, reached),
                 qPrintable(name + ": not reached: " + name_of(*widget)));
    }
}

/// The letters that are underlined in a window, each with what it belongs to.
QMultiMap<QString, QString> letters_of(const QWidget& window) {
    QMultiMap<QString, QString> letters;
    const auto note = [&letters](const QString& text) {
        const QKeySequence letter = QKeySequence::mnemonic(text);
        if (!letter.isEmpty()) letters.insert(letter.toString(), text);
    };
    for (const auto* button : window.findChildren<QAbstractButton*>()) {
        if (button->window() == &window) note(button->text());
    }
    for (const auto* label : window.findChildren<QLabel*>()) {
        if (label->window() == &window && label->buddy() != nullptr) note(label->text());
    }
    for (const auto* bar : window.findChildren<QMenuBar*>()) {
        for (const auto* action : bar->actions()) note(action->text());
    }
    return letters;
}

void check_once(const QMultiMap<QString, QString>& keys, const QString& name) {
    for (const QString& key : keys.uniqueKeys()) {
        const QStringList meanings = keys.values(key);
        QVERIFY2(meanings.size() == 1,
                 qPrintable(QString("%1: %2 means %3").arg(name, key, meanings.join(" and "))));
    }
}

/// Every window that there is, on a run of some steps; `look` sees each while it is shown.
void visit_windows(KeyboardFixture& f, const std::function<void(QWidget&, const QString&)>& look) {
    f.session.run_steps(30);
    QTRY_VERIFY(f.rests());
    look(*f.window, "main window");
    const auto visit = [&look](QWidget& window, const QString& name) {
        look(window, name);
        window.close();
    };
    ConfigurationDialog form(f.session.configuration(), f.window.get());
    form.show();
    visit(form, "form");
    SourceDialog source(f.session.configuration().source, f.prompts, {}, f.window.get());
    source.show();
    visit(source, "source");
    ExportDialog picture(f.window->grid_view().exportable(), f.files.settings(), f.window.get());
    picture.show();
    visit(picture, "picture");
    visit(f.window->open_connection(), "connection");
    RunUntilDialog until(f.session, f.files.settings(), f.window.get());
    until.show();
    visit(until, "run until");
    AnimationDialog animation(30, f.window.get());
    animation.show();
    visit(animation, "animation");
    visit(f.window->open_study(), "study");
    f.window->result_actions().view_best();
    visit(*f.window->result_actions().best_window(), "map");
    References references;
    references.trajectory = f.session.snapshot()->odometry_trajectory;
    f.session.set_references(references);
    f.window->runs().compare({});
    f.window->runs().comparison()->show_figures(true);
    visit(*f.window->runs().comparison(), "compare");
    GraphWindow& poses = f.window->open_graph(f.write(
        "small.g2o", "VERTEX_SE2 0 0 0 0\nVERTEX_SE2 1 1 0 0\nEDGE_SE2 0 1 1 0 0 1 0 0 1 0 1\n"));
    QTRY_VERIFY(poses.shown() && !poses.busy());
    poses.findChild<QLineEdit*>("graph_b")->setText("0");
    QTest::keyClicks(poses.findChild<QLineEdit*>("graph_a"), "1");
    poses.findChild<QPushButton*>("graph_slip")->click();
    QTRY_VERIFY(!poses.busy());
    poses.findChild<QListWidget*>("graph_edits")->setCurrentRow(0);
    look(poses, "graph");
    poses.findChild<QPushButton*>("graph_undo")->click();
    QTRY_VERIFY(!poses.busy());
    poses.close();
    f.window->findChild<QAction*>("action_guide")->trigger();
    visit(*f.window->findChild<QDialog*>("guide_window"), "guide");
    for (const char* name : {"keys", "about"}) {
        f.window->findChild<QAction*>(QString("action_") + name)->trigger();
        visit(*f.window->findChild<QDialog*>(name), name);
    }
}

}  // namespace

void KeyboardTest::tab_reaches_everything() {
    KeyboardFixture f;
    visit_windows(f, check_tab);
    // With the hint, and each of the docks.
    f.session.set_configuration([] {
        Configuracion other = Fixture::tour(10);
        other.source.file = Fixture::source_file("data/logs/carmen-flaser.log.gz").toStdString();
        return other;
    }());
    f.session.run_steps(20);
    QTRY_VERIFY(f.rests());
    const auto docks = f.window->findChildren<QDockWidget*>();
    QVERIFY(docks.size() >= 6);
    for (auto* dock : docks) {
        dock->show();
        dock->raise();
        check_tab(*f.window, dock->objectName());
    }
}

/// Else the keyboard is at the button that comes next, and Space presses it.
void KeyboardTest::a_dock_that_closes_leaves_space_to_the_run() {
    KeyboardFixture f;
    f.session.run_steps(20);
    QTRY_VERIFY(f.rests());
    for (auto* dock : f.window->findChildren<QDockWidget*>()) {
        dock->show();
        dock->raise();
        QTRY_VERIFY(dock->widget()->isEnabled());
        QWidget* inside = nullptr;
        for (auto* widget : dock->findChildren<QWidget*>()) {
            if (widget->isVisible() && widget->isEnabled() && widget->focusPolicy() != Qt::NoFocus)
                inside = widget;
        }
        if (inside == nullptr) continue;
        inside->setFocus();
        dock->close();
        const QWidget* keys = f.window->focusWidget();
        QVERIFY2(qobject_cast<const QAbstractButton*>(keys) == nullptr,
                 qPrintable(dock->objectName()));
    }
}

void KeyboardTest::letters_with_control_move_no_view() {
    KeyboardFixture f;
    f.session.run_steps(20);
    QTRY_VERIFY(f.rests());
    auto& view = f.window->grid_view();
    view.setFocus();
    const QPointF before = view.camera().centre;
    for (const Qt::Key key : {Qt::Key_A, Qt::Key_D, Qt::Key_W})
        QTest::keyClick(&view, key, Qt::ControlModifier | Qt::AltModifier);
    QCOMPARE(view.camera().centre, before);
    QTest::keyClick(&view, Qt::Key_A);
    QVERIFY(view.camera().centre != before);
}

void KeyboardTest::no_letter_means_two_things_data() {
    QTest::addColumn<QString>("language");
    for (const char* language : {"en", "es"}) QTest::addRow("%s", language) << language;
}

void KeyboardTest::no_letter_means_two_things() {
    QFETCH(QString, language);
    QTranslator words;
    QVERIFY(words.load(":/i18n/hitos_es.qm"));
    if (language == "es") QApplication::installTranslator(&words);
    {
        KeyboardFixture f;
        for (auto* dock : f.window->findChildren<QDockWidget*>()) dock->show();
        visit_windows(
            f, [](QWidget& window, const QString& name) { check_once(letters_of(window), name); });
        for (const auto* menu : f.window->findChildren<QMenu*>()) {
            QMultiMap<QString, QString> letters;
            for (const auto* action : menu->actions()) {
                const QKeySequence letter = QKeySequence::mnemonic(action->text());
                if (!letter.isEmpty()) letters.insert(letter.toString(), action->text());
            }
            check_once(letters, menu->title());
        }
    }
    QApplication::removeTranslator(&words);
}

void KeyboardTest::no_key_means_two_things() {
    KeyboardFixture f;
    visit_windows(f, [](QWidget& window, const QString& name) {
        QSet<QAction*> actions;
        const QList<QWidget*> widgets = window.findChildren<QWidget*>() << &window;
        for (const auto* widget : widgets) {
            if (widget->window() != &window) continue;
            for (auto* action : widget->actions()) actions << action;
        }
        for (auto* menu : window.findChildren<QMenu*>()) {
            for (auto* action : menu->actions()) actions << action;
        }
        QMultiMap<QString, QString> keys;
        for (const auto* action : actions) {
            for (const QKeySequence& key : action->shortcuts())
                keys.insert(key.toString(), action->text());
        }
        for (const auto* shortcut : window.findChildren<QShortcut*>())
            keys.insert(shortcut->key().toString(), "shortcut");
        check_once(keys, name);
        for (const QString& key : keys.uniqueKeys())  // those of the views
            QVERIFY2(!QStringList({"+", "-", "F", "W", "A", "S", "D"}).contains(key),
                     qPrintable(name + ": " + key));
    });
}

}  // namespace hitos::window
