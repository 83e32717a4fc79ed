// SPDX-License-Identifier: GPL-3.0-or-later
// The use cases that look at or keep what a run made [T 8.2.2.7-10].
#pragma once

#include <QObject>
#include <QPointer>
#include <QTimer>
#include <functional>
#include <future>

#include "look/prompts.hpp"
#include "look/user_files.hpp"
#include "session/session.hpp"
#include "views/figure.hpp"
#include "views/map_window.hpp"

namespace hitos::window {

class ViewSettings;

class ResultActions final : public QObject {
    Q_OBJECT

  public:
    ResultActions(Session& session, UserFiles& files, Prompts& prompts,
                  const ViewSettings& settings, QWidget* window);
    ~ResultActions() override;

    MapWindow* best_window() const { return best_; }
    MapWindow* odometry_window() const { return odometry_; }
    MapWindow* particle_window() const { return particle_; }

    void view_best();
    /// The grid along the path of a particle whose number the user gives [T 9.2.5].
    void view_particle();
    /// The same of this one.
    void view_grid_of(int particle);
    void view_odometry();
    /// The damaged lines of the log that were skipped so far, in a window of its own.
    void list_skipped();
    /// How many scans the tour has; nothing while that is not known.
    void set_total(std::optional<quint64> scans);
    const std::optional<quint64>& total() const { return total_; }
    void save_map();
    void save_map_of(int particle);
    /// As a TUM file.
    void save_path_of(int particle);
    void save_results();
    /// The figures of every scan that the run has been at, as a table.
    void save_figures();
    /// All results are being written; until the end no others can be.
    bool writing() const;
    void save_figure(const hitos::window::Exportable& figure);

  signals:
    void notice(QString text);
    /// What lasts until the next notice; empty: no longer.
    void busy(QString text);
    void writing_changed();
    /// save_results() has come to its end: whether all is there.
    void written(bool good);
    /// A map has a window of its own now.
    void opened(QWidget* window);

  private:
    MapWindow* open_window(QPointer<MapWindow>& place, const QString& title, MapWindow::Show show);

    /// What one hypothesis believes at this moment, however long the user thinks about a name.
    std::shared_future<ParticleDetails> moment_of(std::optional<std::size_t> particle) const;
    bool only_foreseen();
    void save_moment(const std::shared_future<ParticleDetails>& moment, const QString& title);
    QWidget* window_in_use() const;
    void at_chosen_scan(const std::function<void()>& save);
    void ask_for_results();
    void write_results_to(const QString& folder);
    void end_writing(int number, const QString& folder, const QString& problem,
                     const QStringList& missing);

    Session& session_;
    UserFiles& files_;
    Prompts& prompts_;
    const ViewSettings& settings_;
    QWidget* window_;
    QPointer<MapWindow> best_;
    QPointer<MapWindow> odometry_;
    QPointer<MapWindow> particle_;
    bool was_over_ = false;  ///< the run has been at its end
    std::optional<quint64> total_;
    QPointer<QTimer> going_;  ///< to the scan at which something is to be saved
    std::future<void> path_of_particle_;
    std::future<void> skipped_;
    std::future<void> writing_;  ///< valid while results are written
    int writings_ = 0;           ///< so far; what an earlier one has to say is dropped
    QString results_folder_;     ///< that could not be written
};

}  // namespace hitos::window
