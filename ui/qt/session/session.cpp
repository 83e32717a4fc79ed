// SPDX-License-Identifier: GPL-3.0-or-later
#include "session.hpp"

#include <QScopedValueRollback>
#include <QThreadPool>
#include <algorithm>
#include <filesystem>
#include <numeric>
#include <system_error>
#include <utility>

#include "background.hpp"
#include "hitos/base/error.hpp"
#include "hitos/base/thread_clock.hpp"
#include "hitos/simulation/drive/simulated_tour_reader.hpp"
#include "hitos/workbench/open_tour.hpp"
#include "incoming_tour.hpp"
#include "look/words_of.hpp"

namespace hitos::window {
namespace {

constexpr int kTickMs = 5;
constexpr qint64 kFrameUs = 16'000;  // sixty pictures a second
constexpr qint64 kTellMs = 100;

}  // namespace

Session::Session(QObject* parent) : QObject(parent) {
    timer_.setInterval(kTickMs);
    timer_.setTimerType(Qt::PreciseTimer);
    connect(&timer_, &QTimer::timeout, this, &Session::tick);
    clock_.start();
}

Session::~Session() = default;

Progress Session::progress() const {
    Progress progress = worker_ ? worker_->progress() : Progress{};
    if (following_ && is_live() && progress.state == Progress::State::paused) {
        progress.state = Progress::State::running;  // until the next scan is there
        progress.waits = true;
    }
    return progress;
}

bool Session::is_live() const {
    return (live_ && live_->is_live()) || (incoming_ && incoming_->is_live());
}

std::uint64_t Session::scans_there() const {
    return live_ ? live_->scans() : incoming_->scans();
}

double Session::computed_seconds(std::uint64_t steps) const {
    if (!worker_) return 0.0;
    std::vector<StepFigures> figures = worker_->figures_since(0);
    if (figures.size() > steps) figures.resize(steps);
    return std::accumulate(
        figures.begin(), figures.end(), 0.0,
        [](double sum, const StepFigures& step) { return sum + step.step_seconds; });
}

/// The old run ends after the step under way; nobody waits for it here.
void Session::retire() {
    if (!worker_) return;
    QThreadPool::globalInstance()->start(
        [old = std::shared_ptr<RunWorker>(std::move(worker_))]() mutable { old.reset(); });
}

/// Its end may take a while, for which nobody waits here.
void Session::give_up_incoming(std::shared_ptr<IncomingTour> former) const {
    if (!former || former == incoming_) return;
    QThreadPool::globalInstance()->start(
        [former = std::move(former)]() mutable { former.reset(); });
}

void Session::set_configuration(const Configuracion& configuration) {
    const bool same = live_ && is_live() && configuration.source == configuration_.source;
    const bool comes_in = incoming_ && incoming_->is_of(configuration);
    open(configuration, same ? live_ : nullptr, comes_in ? incoming_ : nullptr);
}

void Session::set_incoming(const Configuracion& configuration, std::shared_ptr<IncomingTour> tour) {
    open(configuration, nullptr, std::move(tour));
}

void Session::set_live(const Configuracion& configuration,
                       std::shared_ptr<const SimulatedTour> tour) {
    open(configuration, std::move(tour), nullptr);
}

void Session::open(const Configuracion& configuration, std::shared_ptr<const SimulatedTour> live,
                   std::shared_ptr<IncomingTour> incoming) {
    check(configuration);
    if (opening_) {
        throw Error(message(
            HITOS_TEXT("Errors", "another source is being opened; try again when it is there")));
    }
    const QScopedValueRollback opening(opening_, true);
    std::unique_ptr<RunWorker> next;
    std::optional<Truth> truth;
    std::shared_ptr<const SimulatedTour> simulated;
    if (!configuration.source.file.empty()) {
        next = in_background([&] {
            std::unique_ptr<TourReader> reader =
                live       ? std::make_unique<SimulatedTourReader>(live, configuration.source.read)
                : incoming ? incoming->open(configuration)
                           : open_tour(configuration);
            truth = reader->truth();
            if (const auto* tour = dynamic_cast<const SimulatedTourReader*>(reader.get())) {
                simulated = tour->tour();
            }
            AlgoritmoOptions options;
            options.go_back = true;
            return std::make_unique<RunWorker>(configuration, std::move(reader), options);
        });
    }
    if (worker_) emit leaving();
    retire();
    const bool another_log = !same_log(configuration, configuration_) || live != live_;
    const bool counted = incoming == incoming_ && configuration.source == configuration_.source;
    if (incoming && !counted) incoming->count(configuration);
    configuration_ = configuration;
    if (live && live != live_) ++last_drive_;
    live_ = std::move(live);
    give_up_incoming(std::exchange(incoming_, std::move(incoming)));
    following_ = is_live();
    worker_ = std::move(next);
    if (worker_) worker_->set_pace(pace_);
    truth_ = std::move(truth);
    simulated_ = std::move(simulated);
    if (another_log) {
        set_references({});
    } else {
        join_references();  // the world may have changed
    }
    begin_anew();
    emit configuration_changed();
    if (incoming_) follow();  // nobody knows when the next scan comes
}

void Session::set_edits(const std::string& edits) {
    Configuracion next = configuration_;
    next.registration.edits = edits;
    check(next);
    check_held_map(next);
    if (!worker_) {
        set_configuration(next);
        return;
    }
    emit leaving();
    // Who takes the last changes back sees at once what was there before them: it comes again.
    std::shared_ptr<Snapshot> again;
    const bool elsewhere =
        of_run() && (!before_edits() || progress().state == Progress::State::running);
    std::string edits_now = std::exchange(configuration_.registration.edits, edits);
    if (before_ && edits == edits_before_ && !elsewhere) {
        again = std::make_shared<Snapshot>(*before_);
        again->foreseen = true;
    }
    std::shared_ptr<const Snapshot> before = of_run();
    if (!before) {  // the run was not yet where the last ones lead
        before = before_;
        edits_now = edits_before_;
    }
    worker_->set_edits(edits);
    begin_anew();
    before_ = std::move(before);
    edits_before_ = std::move(edits_now);
    snapshot_ = std::move(again);
    if (snapshot_) emit snapshot_changed();
    emit configuration_changed();
    wake();
}

void Session::begin_anew() {
    snapshot_ = before_ = nullptr;
    shows_before_ = false;
    requested_ = false;
    told_ = {};
    emit restarted();
    emit snapshot_changed();
    emit progress_changed();
}

std::shared_ptr<const Snapshot> Session::before_edits() const {
    const bool other = edits_before_ != configuration_.registration.edits;
    const bool same_scans = before_ && snapshot_ && before_->revision == snapshot_->revision;
    return other && same_scans ? before_ : nullptr;
}

void Session::show_before(bool before) {
    if (before == shows_before_ || (before && !before_edits())) return;
    shows_before_ = before;
    emit snapshot_changed();
}

void Session::set_references(const References& references, const QString& map_file) {
    user_references_ = references;
    reference_map_file_ = map_file;
    join_references();
}

void Session::join_references() {
    references_ = user_references_;
    add_truth(references_, truth_);
    if (worker_) worker_->set_reference(references_.trajectory);
    emit references_changed();
}

void Session::run(const StopRules& rules) {
    if (!worker_) return;
    if (is_live()) {
        following_ = true;
        follow();
        return;
    }
    worker_->run(RunWorker::kToTheEnd, rules);
    wake();
}

void Session::run_steps(quint64 steps) {
    if (!worker_) return;
    if (is_live()) {
        seek(worker_->progress().steps + steps);
        return;
    }
    worker_->run(steps);
    wake();
}

void Session::follow() {
    if (!worker_ || !(live_ || incoming_)) return;
    if (live_) note_truth();
    if (!following_) {
        if (incoming_ && !is_live()) emit progress_changed();  // that it is over
        return;
    }
    following_ = live_ || is_live();
    go_to(following_ ? scans_there() : RunWorker::kToTheEnd);
}

/// The path of a driven tour grows; what was true stays true, so nobody has to begin anew.
void Session::note_truth() {
    if (!truth_) return;
    const std::uint64_t scans = live_->scans();
    Trajectory& path = truth_->path;
    for (std::uint64_t k = path.size(); k < scans; ++k) {
        path.push_back({live_->scan_time(k), live_->true_pose(k)});
    }
    if (user_references_.trajectory) return;
    references_.trajectory = path;
    worker_->set_reference(path);
}

void Session::go_to(quint64 steps) {
    if (steps == 0) return;
    worker_->seek(steps);
    wake();
}

void Session::set_pace(const Pace& pace) {
    pace_ = pace;
    if (worker_) worker_->set_pace(pace);
}

void Session::pause() {
    if (!worker_) return;
    following_ = false;
    worker_->pause();
    wake();
}

void Session::seek(quint64 steps) {
    if (!worker_) return;
    following_ = false;
    steps = std::max<quint64>(steps, 1);
    go_to(is_live() ? std::min<quint64>(steps, scans_there()) : steps);
}

void Session::restart() {
    if (!worker_) return;
    emit leaving();
    following_ = false;
    worker_->restart();
    begin_anew();
}

void Session::want(const SnapshotParts& parts) {
    if (parts == parts_) return;
    parts_ = parts;
    if (worker_) timer_.start();  // not at once: who asks may be about to go
}

void Session::wake() {
    show_before(false);
    timer_.start();
    tick();
}

void Session::tick() {
    if (!worker_) {
        timer_.stop();
        return;
    }
    const Progress now = progress();
    const bool changed_state = now.state != told_.state;
    if (changed_state || (now.steps != told_.steps && clock_.elapsed() - told_ms_ >= kTellMs)) {
        told_ = now;
        told_ms_ = clock_.elapsed();
        emit progress_changed();
        if (changed_state && now.state == Progress::State::failed) {
            emit failed(words_of(now.error));
        }
    }
    const qint64 now_us = clock_.nsecsElapsed() / 1000;
    const std::shared_ptr<const Snapshot> latest = worker_->latest_snapshot();
    const bool foreseen_twice = latest && snapshot_ && latest->foreseen && snapshot_->foreseen;
    if (requested_ && latest && latest != snapshot_ && !foreseen_twice) {
        requested_ = false;
        snapshot_ = latest;
        if (!before_edits()) shows_before_ = false;
        const double begin = thread_seconds();
        emit snapshot_changed();
        const double cost =
            latest->seconds + std::exchange(paint_seconds_, 0.0) + thread_seconds() - begin;
        const double share = now.waits ? kShareOfWaiting : kShare;
        request_not_before_us_ =
            now_us + std::max(kFrameUs, static_cast<qint64>(cost / share * 1e6));
    }
    const bool running = now.state == Progress::State::running;
    const bool behind = now.steps > 0 && !shows(now);
    if (!requested_ && behind && (!running || now_us >= request_not_before_us_)) {
        requested_ = true;
        worker_->request_snapshot(parts_);
    }
    if (!running && now.steps == 0 && snapshot_) {  // what was foreseen does not come
        snapshot_ = nullptr;
        shows_before_ = false;
        emit snapshot_changed();
    }
    if (!running && !behind && told_.steps == now.steps && !changed_state) timer_.stop();
}

}  // namespace hitos::window
