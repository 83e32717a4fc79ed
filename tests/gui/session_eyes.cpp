// SPDX-License-Identifier: GPL-3.0-or-later
#include "session_eyes.hpp"

#include <QAbstractButton>
#include <QAbstractItemView>
#include <QApplication>
#include <QCheckBox>
#include <QComboBox>
#include <QGroupBox>
#include <QHeaderView>
#include <QLabel>
#include <QLineEdit>
#include <QMenu>
#include <QMenuBar>
#include <QPlainTextEdit>
#include <QRadioButton>
#include <QSpinBox>
#include <QStatusBar>
#include <QTabBar>
#include <QTextDocument>
#include <QTextEdit>
#include <QToolTip>
#include <functional>

#include "app/main_window.hpp"

namespace hitos::window {
namespace {

QList<QWidget*> windows_in_use() {
    if (QWidget* menu = QApplication::activePopupWidget()) return {menu};
    if (QWidget* dialog = QApplication::activeModalWidget()) return {dialog};
    QList<QWidget*> found;
    for (QWidget* window : QApplication::topLevelWidgets()) {
        if (!window->isVisible() || window->windowType() == Qt::ToolTip) continue;
        window->isActiveWindow() ? found.prepend(window) : found.append(window);
    }
    return found;
}

void with_all_in(QWidget& window, const std::function<void(QWidget&)>& look) {
    look(window);
    for (QWidget* widget : window.findChildren<QWidget*>()) {
        if (widget->window() == &window && widget->isVisible()) look(*widget);
    }
}

Target action_in(QWidget& bar, const QList<QAction*>& actions, const QString& words,
                 const std::function<QRect(QAction*)>& place) {
    for (QAction* action : actions) {
        if (action->isVisible() && action->isEnabled() && as_read(action->text()) == words)
            return {&bar, place(action).center()};
    }
    return {};
}

Target cell_of(QAbstractItemView& view, const QString& words) {
    const QAbstractItemModel* model = view.model();
    if (model == nullptr || words.isEmpty()) return {};
    for (int row = 0; row < model->rowCount(view.rootIndex()); ++row) {
        for (int column = 0; column < model->columnCount(view.rootIndex()); ++column) {
            const QModelIndex index = model->index(row, column, view.rootIndex());
            if (as_read(index.data().toString()) != words) continue;
            view.scrollTo(index);
            const bool list = view.window()->windowType() == Qt::Popup;
            return {view.viewport(), view.visualRect(index).center(), list};
        }
    }
    return {};
}

Target whole(QWidget& widget) {
    const bool box = qobject_cast<QCheckBox*>(&widget) || qobject_cast<QRadioButton*>(&widget);
    constexpr int kOfBox = 8;
    return {&widget, box ? QPoint(kOfBox, widget.height() / 2) : widget.rect().center()};
}

/// What can be clicked under those words in the widget itself.
Target within(QWidget& widget, const QString& words) {
    if (auto* bar = qobject_cast<QMenuBar*>(&widget)) {
        return action_in(*bar, bar->actions(), words,
                         [bar](QAction* action) { return bar->actionGeometry(action); });
    }
    if (auto* menu = qobject_cast<QMenu*>(&widget)) {
        return action_in(*menu, menu->actions(), words,
                         [menu](QAction* action) { return menu->actionGeometry(action); });
    }
    if (auto* tabs = qobject_cast<QTabBar*>(&widget)) {
        for (int i = 0; i < tabs->count(); ++i) {
            if (as_read(tabs->tabText(i)) == words) return {tabs, tabs->tabRect(i).center()};
        }
    }
    if (auto* view = qobject_cast<QAbstractItemView*>(&widget);
        view != nullptr && qobject_cast<QHeaderView*>(&widget) == nullptr) {
        if (Target cell = cell_of(*view, words); cell.widget != nullptr) return cell;
    }
    if (auto* button = qobject_cast<QAbstractButton*>(&widget)) {
        if (button->isEnabled() && (as_read(button->text()) == words ||
                                    (button->text().isEmpty() && button->toolTip() == words)))
            return whole(*button);
    }
    if (auto* label = qobject_cast<QLabel*>(&widget); label != nullptr && label->buddy()) {
        if (as_read(label->text()) == words) return whole(*label->buddy());
    }
    if (widget.isEnabled() && (widget.objectName() == words || widget.accessibleName() == words))
        return whole(widget);
    return {};
}

QString text_of(const QWidget& widget) {
    if (const auto* label = qobject_cast<const QLabel*>(&widget)) {
        if (!Qt::mightBeRichText(label->text())) return as_read(label->text());
        QTextDocument rich;
        rich.setHtml(label->text());
        return rich.toPlainText();
    }
    if (const auto* button = qobject_cast<const QAbstractButton*>(&widget))
        return as_read(button->text());
    if (const auto* bar = qobject_cast<const QStatusBar*>(&widget)) return bar->currentMessage();
    if (const auto* line = qobject_cast<const QLineEdit*>(&widget)) return line->text();
    if (const auto* number = qobject_cast<const QAbstractSpinBox*>(&widget)) return number->text();
    if (const auto* box = qobject_cast<const QComboBox*>(&widget)) return box->currentText();
    if (const auto* box = qobject_cast<const QGroupBox*>(&widget)) return as_read(box->title());
    if (const auto* edit = qobject_cast<const QTextEdit*>(&widget)) return edit->toPlainText();
    if (const auto* edit = qobject_cast<const QPlainTextEdit*>(&widget)) return edit->toPlainText();
    return {};
}

void add_cells(const QAbstractItemView& view, QStringList& seen) {
    constexpr int kRows = 200;
    const QAbstractItemModel* model = view.model();
    if (model == nullptr || qobject_cast<const QHeaderView*>(&view) != nullptr) return;
    for (int row = 0; row < std::min(kRows, model->rowCount()); ++row) {
        QStringList cells;
        for (int column = 0; column < model->columnCount(); ++column)
            cells << model->index(row, column).data().toString();
        seen << cells.join(" | ");
    }
}

}  // namespace

QString as_read(QString text) {
    text.replace("&&", "\x01").remove('&').replace('\x01', '&');
    return text.section('\t', 0, 0).trimmed();
}

Target target_of(const QStringList& words) {
    for (QWidget* window : windows_in_use()) {
        Target found;
        with_all_in(*window, [&](QWidget& widget) {
            for (const QString& one : words)
                if (found.widget == nullptr) found = within(widget, one);
        });
        if (found.widget != nullptr) return found;
    }
    return {};
}

QStringList all_in_sight() {
    QStringList seen{QToolTip::text()};
    for (QWidget* window : windows_in_use()) {
        seen << window->windowTitle();
        with_all_in(*window, [&](QWidget& widget) {
            seen << text_of(widget);
            if (const auto* view = qobject_cast<QAbstractItemView*>(&widget))
                add_cells(*view, seen);
            if (const auto* menu = qobject_cast<QMenu*>(&widget)) {
                for (const QAction* action : menu->actions()) seen << as_read(action->text());
            }
        });
    }
    seen.removeAll({});
    seen.removeDuplicates();
    return seen;
}

QWidget* window_above() {
    const QList<QWidget*> windows = windows_in_use();
    for (QWidget* window : windows) {
        if (window->isActiveWindow() || window->windowType() == Qt::Popup) return window;
    }
    for (QWidget* window : windows) {
        if (qobject_cast<MainWindow*>(window) != nullptr) return window;
    }
    return windows.isEmpty() ? nullptr : windows.front();
}

}  // namespace hitos::window
