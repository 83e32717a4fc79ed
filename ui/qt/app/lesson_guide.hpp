// SPDX-License-Identifier: GPL-3.0-or-later
// The lessons that come with Hitos, in the menu and beside the views.
#pragma once

#include <QMainWindow>
#include <QObject>

#include "hitos/workbench/shipped_data.hpp"

class QAction;
class QDockWidget;
class QMenu;

namespace hitos::window {

class ConfigurationActions;
class MarkdownPage;
class Prompts;
class RunGuard;

/// A menu of the lessons. A lesson opens its world with its configuration, and its page, in the
/// language of the window, in a dock beside the views, with links to the lessons before and after;
/// what the page says to choose is a link that does it. The configuration before can be had back by
/// Undo; a long run is not discarded without a question.
class LessonGuide final : public QObject {
    Q_OBJECT

  public:
    /// The menu is put into `help` before `before`; none where no lessons are installed.
    LessonGuide(QMainWindow& window, QMenu& help, QAction* before,
                ConfigurationActions& configuration, const RunGuard& guard, Prompts& prompts);

  private:
    void open(const Lesson& lesson);
    void show_page(const Lesson& lesson, const QString& path);
    QString title_of(const Lesson& lesson) const;
    QString with_links(const QString& page, int number) const;
    void follow(const QUrl& link);

    QMainWindow& window_;
    std::vector<Lesson> lessons_;
    ConfigurationActions& configuration_;
    const RunGuard& guard_;
    Prompts& prompts_;
    QDockWidget* dock_ = nullptr;  ///< null until a lesson was opened
    MarkdownPage* page_ = nullptr;
};

}  // namespace hitos::window
