// SPDX-License-Identifier: GPL-3.0-or-later
// The runs that the window remembers: list, table and comparison.
#pragma once

#include <QObject>
#include <QPointer>
#include <vector>

#include "compare_window.hpp"
#include "look/docks.hpp"
#include "look/prompts.hpp"
#include "look/user_files.hpp"
#include "run_list.hpp"

namespace hitos::window {

class ResultActions;
class RunsPanel;

class Runs final : public QObject {
    Q_OBJECT

  public:
    Runs(Session& session, UserFiles& files, Prompts& prompts, const ViewSettings& settings,
         const DockPlace& place);

    RunList& list() { return *list_; }
    RunsPanel& panel() const { return *panel_; }
    /// Shows the list.
    QAction* list_action() const;
    /// Reads a folder of results, shows the list and the run beside that of the window. Returns
    /// whether it could be read; tells the user where not.
    bool open(const QString& folder);
    /// The same with a folder that the user is asked for.
    void ask();
    void compare(const std::vector<ListedRun>& runs);
    /// Null where none is open.
    CompareWindow* comparison() const { return comparison_; }

  signals:
    void opened(QWidget* window);
    void picture_wanted(const hitos::window::Exportable& figure);

  private:
    UserFiles& files_;
    const ViewSettings& settings_;
    QMainWindow* window_;
    RunList* list_;
    RunsPanel* panel_;
    QDockWidget* dock_;
    QPointer<CompareWindow> comparison_;
};

}  // namespace hitos::window
