// SPDX-License-Identifier: GPL-3.0-or-later
#include "help_guide.hpp"

#include <QApplication>
#include <QDialog>
#include <QKeyEvent>
#include <array>

#include "dialogs/guide_window.hpp"
#include "hitos/workbench/shipped_data.hpp"
#include "language.hpp"
#include "look/prompts.hpp"
#include "look/user_files.hpp"

namespace hitos::window {
namespace {

constexpr const char* kGuide = "docs/user-guide.md";

/// The window with the keyboard belongs to it, or is it.
bool belongs_to(const QWidget* widget, const QWidget& main) {
    while (widget != nullptr && widget != &main) widget = widget->parentWidget();
    return widget == &main;
}

}  // namespace

std::span<const HelpPlace> help_places() {
    static constexpr std::array<HelpPlace, 29> kPlaces{{
        {"centralwidget", "the-window"},
        {"MapWindow", "the-window"},
        {"run_until", "the-window"},
        {"lesson_dock", "a-first-experiment"},
        {"SourceDialog", "data-source"},
        {"skipped_lines", "data-source"},
        {"connect_dialog", "a-running-robot"},
        {"world_window", "drawing-a-world"},
        {"world_form", "drawing-a-world"},
        {"import_dialog", "drawing-a-world"},
        {"driving", "driving-a-robot"},
        {"summary", "parameters"},
        {"hint", "parameters"},
        {"ConfigurationDialog", "parameters"},
        {"plots_dock", "plots"},
        {"landmarks_dock", "looking-at-a-run-in-numbers"},
        {"particles_dock", "looking-at-a-run-in-numbers"},
        {"associations_dock", "looking-at-a-run-in-numbers"},
        {"measurements_dock", "measuring"},
        {"joint_dock", "the-joint-covariance"},
        {"graph_window", "graphs-of-poses"},
        {"runs_dock", "comparing-runs"},
        {"compare_window", "comparing-runs"},
        {"StudyDialog", "studies"},
        {"export", "pictures-and-results"},
        {"animation", "pictures-and-results"},
        {"guide_window", "help"},
        {"keys", "help"},
        {"about", "help"},
    }};
    return kPlaces;
}

QString help_for(const QWidget* widget) {
    for (; widget != nullptr; widget = widget->parentWidget()) {
        const QVariant told = widget->property("help");
        const QString part = told.isValid() ? told.toString() : widget->objectName();
        for (const HelpPlace& place : help_places())
            if (part == place.part) return place.heading;
    }
    return {};
}

HelpGuide::HelpGuide(QWidget& main, UserFiles& files, Prompts& prompts)
    : QObject(&main), main_(main), files_(files), prompts_(prompts) {
    qApp->installEventFilter(this);
}

void HelpGuide::open(const QString& heading) {
    const QString guide = QString::fromStdString(shipped_file(kGuide).string());
    if (guide.isEmpty()) {
        prompts_.warn(&main_, tr("User's guide"), tr("docs/user-guide.md is not installed."));
        return;
    }
    if (!window_) window_ = new GuideWindow(files_.settings(), spoken_language(), &main_);
    // A dialog that waits for its answer blocks every window but those that belong to it.
    QWidget* above = QApplication::activeModalWidget();
    belong_to(above == nullptr ? main_ : *above);
    window_->go_to(guide, heading);
    window_->show();
    window_->raise();
    window_->activateWindow();
}

void HelpGuide::explain() {
    const QWidget* focused = QApplication::focusWidget();
    open(help_for(focused == nullptr ? QApplication::activeWindow() : focused));
}

void HelpGuide::belong_to(QWidget& window) {
    if (window_->parentWidget() == &window) return;
    const bool shown = window_->isVisible();
    window_->setParent(&window, window_->windowFlags());
    window_->setVisible(shown);
    auto* dialog = qobject_cast<QDialog*>(&window);
    if (dialog == nullptr) return;
    connect(dialog, &QDialog::finished, this, &HelpGuide::give_back, Qt::UniqueConnection);
}

/// To the dialog that waits then: one may have been opened by another.
void HelpGuide::give_back() {
    if (!window_) return;
    QWidget* waits = QApplication::activeModalWidget();
    belong_to(waits == nullptr ? main_ : *waits);
}

/// In dialogs, where the menu's key does not count.
bool HelpGuide::eventFilter(QObject* watched, QEvent* event) {
    if (event->type() != QEvent::KeyPress || QApplication::activePopupWidget() != nullptr) {
        return QObject::eventFilter(watched, event);
    }
    const auto* key = static_cast<QKeyEvent*>(event);
    const bool ours = key->key() == Qt::Key_F1 && key->modifiers() == Qt::NoModifier &&
                      belongs_to(QApplication::activeWindow(), main_);
    if (ours) explain();
    return ours;
}

}  // namespace hitos::window
