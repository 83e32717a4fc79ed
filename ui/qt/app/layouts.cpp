// SPDX-License-Identifier: GPL-3.0-or-later
#include "layouts.hpp"

#include <QAction>
#include <QApplication>
#include <QDockWidget>
#include <QMainWindow>
#include <QMenu>
#include <QSettings>
#include <cmath>
#include <utility>

#include "look/prompts.hpp"

namespace hitos::window {
namespace {

constexpr const char* kNamed = "layouts";
constexpr const char* kBefore = "before-presenting";
constexpr double kLarger = 1.5;

}  // namespace

Layouts::Layouts(QMainWindow& window, QMenu& menu, const Switches& switches, QSettings& settings,
                 Prompts& prompts, Means means)
    : QObject(&window),
      window_(window),
      menu_(menu),
      switches_(switches),
      settings_(settings),
      prompts_(prompts),
      means_(std::move(means)) {
    connect(&menu_, &QMenu::aboutToShow, this, &Layouts::fill);
    connect(switches_.presenting, &QAction::toggled, this, &Layouts::present);
    fill();
}

QStringList Layouts::names() const {
    settings_.beginGroup(kNamed);
    QStringList names = settings_.childGroups();
    settings_.endGroup();
    return names;
}

void Layouts::fill() {
    menu_.clear();
    for (const QString& name : names()) {
        QAction* action = menu_.addAction(QString(name).replace('&', "&&"), this, [this, name] {
            end_presenting();
            within(QString(kNamed) + '/' + name, means_.restore);
        });
        action->setObjectName("action_layout_" + name);
    }
    if (!names().isEmpty()) menu_.addSeparator();
    menu_.addAction(tr("Keep this layout…"), this, &Layouts::keep)->setObjectName("keep_layout");
    if (names().isEmpty()) return;
    QAction* forget = menu_.addAction(tr("Forget a layout…"), this, [this] {
        const QStringList all = names();
        const auto chosen =
            prompts_.choice(&window_, tr("Layouts"), tr("Layout to forget:"), all, 0);
        if (chosen) settings_.remove(QString(kNamed) + '/' + all[*chosen]);
    });
    forget->setObjectName("forget_layout");
}

void Layouts::keep() {
    const auto answer = prompts_.text(&window_, tr("Layouts"), tr("Name of this layout:"));
    // A slash would be a group in a group.
    const QString name = answer.value_or(QString()).replace('/', '-').replace('\\', '-').trimmed();
    if (name.isEmpty()) return;
    if (names().contains(name) &&
        !prompts_.confirm(
            &window_, {tr("Layouts"), tr("Replace the layout %1?").arg(name), {}, tr("Replace")})) {
        return;
    }
    end_presenting();
    within(QString(kNamed) + '/' + name, means_.save);
}

void Layouts::within(const QString& group, const std::function<void()>& use) {
    settings_.beginGroup(group);
    use();
    settings_.endGroup();
}

void Layouts::present(bool on) {
    if (!on) {
        qApp->setStyleSheet(qApp->styleSheet().remove(letters_));
        // What was hidden meanwhile, or has its letters from elsewhere, keeps the large ones.
        const double large = QApplication::font().pointSizeF() * kLarger;
        for (QWidget* widget : QApplication::allWidgets()) {
            if (std::abs(widget->font().pointSizeF() - large) < 0.01) widget->setFont(QFont());
        }
        switches_.alone->setChecked(false);
        within(kBefore, means_.restore);
        settings_.remove(kBefore);
        return;
    }
    switches_.alone->setChecked(false);
    within(kBefore, means_.save);
    // A font of the program's reaches no widget where it has a style sheet. The status line has
    // room for its own letters only.
    const double before = QApplication::font().pointSizeF();
    letters_ = QString("\n* { font-size: %1pt; } QStatusBar QLabel { font-size: %2pt; }")
                   .arg(before * kLarger)
                   .arg(before);
    qApp->setStyleSheet(qApp->styleSheet() + letters_);
    for (QDockWidget* dock : window_.findChildren<QDockWidget*>()) dock->hide();
    switches_.summary->setChecked(false);
    switches_.alone->setChecked(true);
}

void Layouts::end_presenting() {
    switches_.presenting->setChecked(false);
}

}  // namespace hitos::window
