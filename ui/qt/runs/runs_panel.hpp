// SPDX-License-Identifier: GPL-3.0-or-later
// The list of runs as a table, with what can be done with them.
#pragma once

#include <QElapsedTimer>
#include <QWidget>
#include <memory>
#include <vector>

#include "look/figures_table.hpp"
#include "look/prompts.hpp"
#include "look/user_files.hpp"
#include "run_list.hpp"
#include "views/grid_view.hpp"

class QPushButton;

namespace hitos::window {

class RunsModel final : public FiguresModel {
    Q_OBJECT

  public:
    /// What tells runs apart first: a narrow column shows no more.
    enum Column { name, path_error, map_error, different, landmarks, scans, seconds, log };

    explicit RunsModel(QObject* parent);
    /// What is different is told against `base`.
    void set_runs(std::vector<ListedRun> runs, const Configuracion& base);
    const ListedRun& run(int row) const { return runs_[static_cast<std::size_t>(row)]; }

  protected:
    QVariant key(int row, int column) const override;
    QString text(int row, int column) const override;
    /// That of the window.
    bool strong(int row) const override { return run(row).number == 0; }
    QColor colour(int row) const override { return colour_of(run(row)); }

  private:
    std::vector<ListedRun> runs_;
    std::vector<QString> differences_;
};

/// Any number of its rows can be chosen: the paths of the runs are drawn into the grid map.
class RunsPanel final : public QWidget {
    Q_OBJECT

  public:
    RunsPanel(Session& session, RunList& list, UserFiles& files, Prompts& prompts, QWidget* parent);

    FiguresTable& table() const { return *table_; }
    std::vector<ListedRun> chosen() const;
    /// Empty where the user names none.
    QString ask_folder();
    /// Nothing where it could not be read; the user is told.
    std::optional<ListedRun> open_folder(const QString& folder);

  signals:
    /// Some of the list; none: whatever is there.
    void comparison_wanted(const std::vector<hitos::window::ListedRun>& runs);
    void results_wanted();
    void configuration_wanted(const hitos::Configuracion& configuration);
    void traces_changed(std::vector<hitos::window::RunTrace> traces);

  protected:
    void showEvent(QShowEvent* event) override;
    void hideEvent(QHideEvent* event) override;

  private:
    QPushButton* add_button(const QString& text, const char* name, void (RunsPanel::*act)());
    void compare() { emit comparison_wanted(chosen()); }
    void remove();
    void use();
    void refresh();
    void show_choice();

    Session& session_;
    RunList& list_;
    UserFiles& files_;
    Prompts& prompts_;
    RunsModel* model_;
    FiguresTable* table_;
    QWidget* buttons_;
    QPushButton* compare_;
    QPushButton* use_;
    QPushButton* remove_;
    QElapsedTimer since_refresh_;
};

}  // namespace hitos::window
