// SPDX-License-Identifier: GPL-3.0-or-later
#include "result_actions.hpp"

#include <QApplication>
#include <QDir>
#include <QFileInfo>
#include <QWidget>
#include <algorithm>
#include <chrono>
#include <optional>

#include "dialogs/export_dialog.hpp"
#include "dialogs/skipped_lines.hpp"
#include "hitos/base/error.hpp"
#include "hitos/services/files/dxf_file.hpp"
#include "hitos/services/files/segment_file.hpp"
#include "hitos/slam/filters.hpp"
#include "look/parameter_text.hpp"
#include "look/screen_fit.hpp"
#include "views/grid_view.hpp"

namespace hitos::window {
namespace {

ParticleDetails best_of(const Algoritmo& run) {
    return details_of(run, run.filter().best_hypothesis());
}

}  // namespace

ResultActions::ResultActions(Session& session, UserFiles& files, Prompts& prompts,
                             const ViewSettings& settings, QWidget* window)
    : QObject(window),
      session_(session),
      files_(files),
      prompts_(prompts),
      settings_(settings),
      window_(window) {
    // Of a run that is no more nothing is written.
    connect(&session, &Session::restarted, this, [this] {
        was_over_ = false;
        if (!writing()) emit busy({});
    });
    connect(&session, &Session::progress_changed, this, [this] {
        was_over_ = was_over_ || session_.progress().state == Progress::State::finished;
    });
}

ResultActions::~ResultActions() {
    if (writing_.valid()) writing_.wait();  // it calls back here
    if (path_of_particle_.valid()) path_of_particle_.wait();
    if (skipped_.valid()) skipped_.wait();
}

MapWindow* ResultActions::open_window(QPointer<MapWindow>& place, const QString& title,
                                      MapWindow::Show show) {
    const QString log =
        QFileInfo(QString::fromStdString(session_.configuration().source.file)).fileName();
    const std::optional<QRect> before = place ? std::optional(place->geometry()) : std::nullopt;
    if (place) place->close();
    place = new MapWindow(title + " – " + log, show, settings_, window_);
    if (before) {
        place->setGeometry(*before);
        keep_on_screen(*place);
    } else {  // no window covers another one whole
        constexpr int kStep = 48;
        const int others = (best_ ? 1 : 0) + (particle_ ? 1 : 0) + (odometry_ ? 1 : 0);
        place_beside_parent(*place, QPoint(kStep, kStep) * others);
    }
    connect(place, &MapWindow::picture_wanted, this,
            [this](GridView* view) { save_figure(view->exportable()); });
    emit opened(place);
    place->show();
    return place;
}

/// Whether the run is not where the views are, which is told.
bool ResultActions::only_foreseen() {
    const bool foreseen = session_.snapshot() != nullptr && session_.of_run() == nullptr;
    if (foreseen) {
        emit notice(
            tr("What is shown is foreseen; the run is not there yet. Try again when it is."));
    }
    return foreseen;
}

void ResultActions::view_best() {
    if (session_.progress().steps == 0 || only_foreseen()) return;
    const auto snapshot = session_.snapshot();
    // The newest state, which while the run goes on is a few steps after the one in the views.
    auto moment = session_.worker()->with_run([](const Algoritmo& run) { return best_of(run); });
    const Configuracion& configuration = session_.configuration();
    const QString title = has_particles(configuration)
                              ? tr("Grid map of the best particle")
                              : tr("Grid map by %1").arg(algorithm_of(configuration));
    MapWindow* map = open_window(best_, title, MapWindow::Show::result);
    const bool shown = snapshot && snapshot->steps > 0;
    // Where a slow step is under way, what is in the views will do.
    const ParticleDetails best =
        !shown || moment.wait_for(std::chrono::milliseconds(40)) == std::future_status::ready
            ? moment.get()
            : ParticleDetails{snapshot->best_hypothesis, snapshot->best_map, snapshot->line_extents,
                              snapshot->best_trajectory};
    map->view().set_landmarks({best.map, best.line_extents});
    map->builder().build(configuration, best.path, session_.live_tour());
}

void ResultActions::view_particle() {
    if (session_.progress().steps == 0) return;
    const auto count = static_cast<int>(hypothesis_count(session_.configuration().filter));
    const std::optional<int> particle =
        prompts_.number(window_, tr("Map of one particle"),
                        tr("Number of the particle, 0 to %1:").arg(count - 1), 0, count - 1);
    if (particle) view_grid_of(*particle);
}

void ResultActions::view_grid_of(int particle) {
    if (session_.worker() == nullptr || only_foreseen()) return;
    MapWindow* map = open_window(particle_, tr("Grid map of particle %1").arg(particle),
                                 MapWindow::Show::result);
    // The run may be in the middle of a slow step: the window does not wait for its end.
    path_of_particle_ = session_.worker()->with_run(
        [this, place = QPointer<MapWindow>(map), configuration = session_.configuration(),
         number = static_cast<std::size_t>(particle)](const Algoritmo& run) {
            QMetaObject::invokeMethod(
                this,
                [this, place, configuration, path = run.trajectory_of(number)] {
                    if (place) place->builder().build(configuration, path, session_.live_tour());
                },
                Qt::QueuedConnection);
        });
}

void ResultActions::view_odometry() {
    if (!session_.has_source()) return;
    MapWindow* map =
        open_window(odometry_, tr("Grid map based on odometry"), MapWindow::Show::growth);
    map->builder().build(session_.configuration(), std::nullopt, session_.live_tour());
}

void ResultActions::list_skipped() {
    if (!session_.has_source()) return;
    skipped_ = session_.worker()->with_run([this](const Algoritmo& run) {
        QMetaObject::invokeMethod(
            this,
            [this, report = run.reader().report(), file = run.reader().name()] {
                show_skipped_lines(window_, QString::fromStdString(file), report);
            },
            Qt::QueuedConnection);
    });
}

void ResultActions::save_map() {
    if (session_.progress().steps == 0 || only_foreseen()) return;
    at_chosen_scan([this] {
        save_moment(moment_of(std::nullopt), has_particles(session_.configuration())
                                                 ? tr("Save best particle's map")
                                                 : tr("Save map"));
    });
}

void ResultActions::set_total(std::optional<quint64> scans) {
    total_ = scans;
}

/// Where the run has been further than it stands now the user says which of the two is meant. At
/// its end its path is smoothed, which it is at no scan before, not even at the last one.
void ResultActions::at_chosen_scan(const std::function<void()>& save) {
    delete going_;
    const Progress now = session_.progress();
    const quint64 furthest = session_.worker()->figures_since(0).size();
    // Without registration there are no last passes.
    const bool at_last =
        total_ && now.steps >= *total_ && needs_registration(session_.configuration().filter);
    const bool to_end =
        !session_.is_live() && now.state != Progress::State::finished && (was_over_ || at_last);
    if (now.state == Progress::State::running || (!to_end && now.steps >= furthest)) return save();
    const std::optional<int> chosen = prompts_.choice(
        window_in_use(), to_end ? tr("The run is not at its end") : tr("The run has been further"),
        tr("What to save:"),
        {tr("As it is now, at scan %1").arg(now.steps),
         (to_end ? tr("As it is at its end, scan %1") : tr("As far as it came, at scan %1"))
             .arg(furthest)},
        0);
    if (!chosen) return;
    if (*chosen == 0) return save();
    going_ = new QTimer(this);
    connect(&session_, &Session::leaving, going_, &QObject::deleteLater);
    connect(going_, &QTimer::timeout, this, [this, save, furthest, to_end] {
        const Progress at = session_.progress();
        if (at.state == Progress::State::running || !session_.up_to_date()) return;
        going_->deleteLater();
        going_->stop();
        // Else the user went elsewhere meanwhile.
        if (to_end ? at.state == Progress::State::finished : at.steps == furthest) save();
    });
    session_.seek(to_end ? RunWorker::kToTheEnd : furthest);
    constexpr int kLookMs = 20;
    going_->start(kLookMs);
}

void ResultActions::save_map_of(int particle) {
    if (session_.progress().steps == 0 || only_foreseen()) return;
    save_moment(moment_of(static_cast<std::size_t>(particle)),
                tr("Save the map of particle %1").arg(particle));
}

std::shared_future<ParticleDetails> ResultActions::moment_of(
    std::optional<std::size_t> particle) const {
    return session_.worker()
        ->with_run([particle](const Algoritmo& run) {
            return particle ? details_of(run, *particle) : best_of(run);
        })
        .share();
}

void ResultActions::save_moment(const std::shared_future<ParticleDetails>& moment,
                                const QString& title) {
    const QString path = save_until_done(
        prompts_, window_,
        {title, files_.place_to_save("map"),
         tr("Maps (*.txt *.map);;Segments (*.seg);;CAD drawings (*.dxf);;All files (*)"), "txt"},
        [&](const QString& target) {
            const ParticleDetails& now = moment.get();
            const std::string file = target.toStdString();
            const QString ending = QFileInfo(target).suffix().toLower();
            if (ending == "dxf") {
                write_dxf(now.map, now.line_extents, now.path, file);
            } else if (ending == "seg") {
                write_segments(now.map, now.line_extents, file);
            } else {
                write_map(now.map, file);
            }
        });
    if (path.isEmpty()) return;
    files_.note_saved("map", path);
    emit notice(tr("Map saved: %1").arg(QDir::toNativeSeparators(path)));
}

void ResultActions::save_path_of(int particle) {
    if (session_.progress().steps == 0 || only_foreseen()) return;
    const auto moment = moment_of(static_cast<std::size_t>(particle));
    const QString path = save_until_done(
        prompts_, window_,
        {tr("Save the path of particle %1").arg(particle), files_.place_to_save("trajectory"),
         tr("Trajectories (*.tum);;All files (*)"), "tum"},
        [&](const QString& target) { write_trajectory(moment.get().path, target.toStdString()); });
    if (path.isEmpty()) return;
    files_.note_saved("map", path);
    emit notice(tr("Path saved: %1").arg(QDir::toNativeSeparators(path)));
}

/// What was asked of a run that has ended since is over too.
bool ResultActions::writing() const {
    return writing_.valid() &&
           writing_.wait_for(std::chrono::seconds(0)) != std::future_status::ready;
}

void ResultActions::save_results() {
    if (!session_.has_source() || session_.progress().steps == 0 || writing() || only_foreseen())
        return;
    at_chosen_scan([this] { ask_for_results(); });
}

void ResultActions::ask_for_results() {
    if (!session_.has_source() || session_.progress().steps == 0 || writing()) return;
    const QString folder = ask_where_to_save(
        prompts_, window_,
        {tr("Save all results: name of a new folder"),
         results_folder_.isEmpty() ? files_.place_to_save("results") : results_folder_,
         {},
         {},
         true});
    results_folder_ = folder;
    if (folder.isEmpty()) return;
    QString problem;
    try {
        if (const auto name = somebodys_file(folder.toStdString(), {}))
            problem = tr("%1 is in that folder and of no run: it would be written over. Choose "
                         "another folder.")
                          .arg(QString::fromStdString(*name));
    } catch (const Error& error) {
        problem = words_of(error);
    }
    if (problem.isEmpty()) return write_results_to(folder);
    tell_not_written(prompts_, window_, problem);
    ask_for_results();
}

/// Pictures of a great map take a second: they are written on the run's thread, and the window is
/// told when it is done.
void ResultActions::write_results_to(const QString& folder) {
    RunWorker& worker = *session_.worker();
    const double seconds = session_.computed_seconds(session_.progress().steps);
    writing_ = worker.with_run([this, number = ++writings_, folder, seconds,
                                references = session_.references()](const Algoritmo& run) {
        QString problem;
        QStringList missing;
        const WritingObserver told = [this](const WritingProgress& now) {
            const QString words = tr("Writing results: %1 (%2 of %3)")
                                      .arg(QString::fromStdString(now.file))
                                      .arg(now.number)
                                      .arg(now.count);
            QMetaObject::invokeMethod(
                this, [this, words] { emit busy(words); }, Qt::QueuedConnection);
        };
        try {
            const RunSummary summary =
                write_results(run, references, seconds, folder.toStdString(), told);
            for (const NotWritten& file : summary.not_written)
                missing += QString::fromStdString(file.file);
        } catch (const std::exception& error) {
            problem = words_of(error);
        }
        QMetaObject::invokeMethod(
            this,
            [this, number, folder, problem, missing] {
                end_writing(number, folder, problem, missing);
            },
            Qt::QueuedConnection);
    });
    emit busy(tr("Writing results…"));
    emit writing_changed();
}

void ResultActions::end_writing(int number, const QString& folder, const QString& problem,
                                const QStringList& missing) {
    if (number != writings_) return;
    writing_ = {};
    emit writing_changed();
    emit written(problem.isEmpty());
    if (!problem.isEmpty()) {
        emit busy({});
        tell_not_written(prompts_, window_, problem);
        ask_for_results();
        return;
    }
    results_folder_.clear();
    files_.note_saved("results", folder);
    const QString saved = tr("Results saved: %1").arg(QDir::toNativeSeparators(folder));
    emit notice(missing.isEmpty() ? saved
                                  : tr("%1; not written: %2").arg(saved, missing.join(", ")));
}

void ResultActions::save_figures() {
    if (!session_.has_source()) return;
    const std::vector<StepFigures> figures = session_.worker()->figures_since(0);
    const std::optional<Trajectory>& reference = session_.references().trajectory;
    const QString path = save_until_done(
        prompts_, window_,
        {tr("Save the figures of every scan"), files_.place_to_save("figures.csv"),
         tr("Tables (*.csv)"), "csv"},
        [&](const QString& target) {
            write_figures(figures, reference ? &*reference : nullptr, target.toStdString());
        });
    if (path.isEmpty()) return;
    files_.note_saved("figures", path);
    emit notice(tr("Figures saved: %1").arg(QDir::toNativeSeparators(path)));
}

/// A question of another window does not bring the main one before it.
QWidget* ResultActions::window_in_use() const {
    QWidget* active = QApplication::activeWindow();
    return active == nullptr ? window_ : active;
}

void ResultActions::save_figure(const Exportable& figure) {
    const QString path = export_figure(files_, prompts_, window_in_use(), figure);
    if (!path.isEmpty()) emit notice(tr("Image saved: %1").arg(QDir::toNativeSeparators(path)));
}

}  // namespace hitos::window
