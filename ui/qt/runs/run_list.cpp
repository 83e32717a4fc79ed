// SPDX-License-Identifier: GPL-3.0-or-later
#include "run_list.hpp"

#include <QCoreApplication>
#include <QDir>
#include <QFileInfo>
#include <algorithm>
#include <utility>

#include "hitos/services/evaluation/tour_frames.hpp"
#include "session/background.hpp"
#include "views/plot_style.hpp"

namespace hitos::window {
namespace {

QString run_words(const char* text) {
    return QCoreApplication::translate("RunList", text);
}

}  // namespace

bool same_run(const KeptRun& a, const KeptRun& b) {
    return a.scans == b.scans && a.finished == b.finished && same_tour(a, b) &&
           differences(a.configuration, b.configuration).empty();
}

QString name_of(const ListedRun& listed) {
    return listed.number == 0
               ? run_words(QT_TRANSLATE_NOOP("RunList", "this run"))
               : run_words(QT_TRANSLATE_NOOP("RunList", "run %1")).arg(listed.number);
}

QColor colour_of(const ListedRun& listed) {
    return line_colour(static_cast<std::size_t>(listed.number));
}

QString log_of(const KeptRun& run) {
    const QString name =
        QFileInfo(QString::fromStdString(run.configuration.source.file)).fileName();
    return run.drive == 0 ? name : run_words(QT_TRANSLATE_NOOP("RunList", "%1, driven")).arg(name);
}

QString source_words(const ListedRun& listed) {
    const QString log = log_of(*listed.run);
    return listed.folder.isEmpty() ? log : log + ", " + QFileInfo(listed.folder).fileName();
}

RunList::RunList(Session& session, QObject* parent) : QObject(parent), session_(session) {
    connect(&session, &Session::leaving, this, &RunList::keep_present);
    connect(&session, &Session::references_changed, this, &RunList::measure_anew);
    // A snapshot holds what its run went back to, and the run is gone.
    connect(&session, &Session::restarted, this, [this] {
        present_ = nullptr;
        of_ = nullptr;
        ended_ = nullptr;
    });
    connect(&session, &Session::configuration_changed, this, &RunList::changed);
    connect(&session, &Session::snapshot_changed, this, [this] {
        const std::shared_ptr<const Snapshot> now = session_.of_run();
        if (now && has_ended(*now)) ended_ = now;
        emit present_changed();
    });
    connect(&session, &Session::progress_changed, this, [this] {
        const bool rests = present_rests();
        if (rests != std::exchange(rested_, rests)) emit present_changed();
    });
}

std::shared_ptr<const KeptRun> RunList::present() const {
    const std::shared_ptr<const Snapshot> now = session_.of_run();
    if (present_ && now == of_) return present_;
    of_ = now;
    present_ = std::make_shared<const KeptRun>(run_at(now.get()));
    return present_;
}

KeptRun RunList::run_at(const Snapshot* state) const {
    KeptRun run;
    run.configuration = session_.configuration();
    run.drive = session_.drive();
    if (state == nullptr || state->steps == 0) return run;
    run.scans = state->steps;
    run.finished = has_ended(*state);
    run.seconds = session_.computed_seconds(state->steps);
    run.map = state->best_map;
    run.line_extents = state->line_extents;
    run.path = state->best_trajectory;
    run.later_tours = state->later_tours;
    run.odometry = state->odometry_trajectory;
    run.grid = state->step_grid;
    measure(run);
    return run;
}

/// A run on the log that the references belong to.
void RunList::measure(KeptRun& run) const {
    const References& references = session_.references();
    if (references.trajectory) {
        const auto error =
            trajectory_error(in_one_frame(run.path, run.later_tours), *references.trajectory);
        run.figures["trajectory_error_m"] = error ? std::optional(error->rmse_m) : std::nullopt;
    }
    if (references.map) {
        const auto error = map_error(run.map, *references.map);
        run.figures["error_m"] = error ? std::optional(error->mean_m) : std::nullopt;
    }
}

void RunList::measure_listed(ListedRun& listed) const {
    if (!of_present_tour(*listed.run)) return;
    auto run = std::make_shared<KeptRun>(*listed.run);
    run->figures = listed.told;
    run->reference = reference_;
    measure(*run);
    listed.run = std::move(run);
}

/// Takes notice of the references of the present tour. Those that went with another tour are not
/// missed: what was measured by them stays.
bool RunList::references_missed() {
    const References& references = session_.references();
    const bool any = references.trajectory || references.map;
    const bool missed = !any && referenced_ && same_log(*referenced_, session_.configuration());
    reference_ = references.trajectory ? std::make_shared<const Trajectory>(*references.trajectory)
                                       : nullptr;
    referenced_ = any ? std::optional(session_.configuration()) : std::nullopt;
    return any || missed;
}

std::vector<ListedRun> RunList::runs() const {
    std::vector<ListedRun> all;
    if (session_.has_source()) all.push_back({0, present()});
    all.insert(all.end(), kept_.begin(), kept_.end());
    return all;
}

bool RunList::present_rests() const {
    return session_.progress().state != Progress::State::running;
}

bool RunList::of_present_tour(const KeptRun& run) const {
    return run.drive == session_.drive() && same_log(run.configuration, session_.configuration());
}

const Trajectory* RunList::reference_of(const KeptRun& run) const {
    const std::optional<Trajectory>& reference = session_.references().trajectory;
    return reference && of_present_tour(run) ? &*reference : run.reference.get();
}

ListedRun RunList::open(const QString& folder) {
    ListedRun listed{0, in_background([&] {
                         return std::make_shared<const KeptRun>(read_results(folder.toStdString()));
                     })};
    listed.told = listed.run->figures;
    listed.folder = QDir(folder).absolutePath();
    if (referenced_) measure_listed(listed);
    return add(std::move(listed));
}

ListedRun RunList::add(ListedRun listed) {
    // A folder may hold what another program or another log of that name has made.
    const auto again = std::ranges::find_if(kept_, [&](const ListedRun& one) {
        return one.folder == listed.folder && same_run(*one.run, *listed.run);
    });
    if (again != kept_.end()) {
        again->run = std::move(listed.run);
        emit changed();
        return *again;
    }
    if (kept_.size() >= kMost) kept_.erase(kept_.begin());
    listed.number = ++last_number_;
    kept_.push_back(std::move(listed));
    emit changed();
    return kept_.back();
}

/// Whole, where it has come to its end, whatever scan it was taken back to since.
void RunList::keep_present() {
    const std::shared_ptr<const Snapshot> state = ended_ ? ended_ : session_.of_run();
    // One scan shows nothing that could be compared.
    if (!state || state->steps <= 1) return;
    KeptRun run = run_at(state.get());
    // Walls from before a correction do not belong to the path after it, for good.
    if (state->grid_behind) run.grid = {};
    // That of a tour that is driven has grown since it came.
    if (const auto& reference = session_.references().trajectory)
        run.reference = std::make_shared<const Trajectory>(*reference);
    add({0, std::make_shared<const KeptRun>(std::move(run))});
}

void RunList::remove(int number) {
    if (std::erase_if(kept_, [&](const ListedRun& one) { return one.number == number; }) > 0) {
        emit changed();
    }
}

void RunList::measure_anew() {
    present_ = nullptr;
    if (references_missed()) {
        for (ListedRun& listed : kept_) measure_listed(listed);
    }
    emit changed();
}

}  // namespace hitos::window
