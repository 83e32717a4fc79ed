// SPDX-License-Identifier: GPL-3.0-or-later
#include "hitos/services/run/run_worker.hpp"

#include <algorithm>
#include <utility>

#include "hitos/base/error.hpp"
#include "hitos/base/thread_clock.hpp"
#include "hitos/capture/file_growth.hpp"
#include "hitos/slam/association_record.hpp"

namespace hitos {

RunWorker::RunWorker(const Configuracion& configuration, std::unique_ptr<TourReader> reader,
                     const AlgoritmoOptions& options)
    : growth_(configuration.source.read.growth),
      run_(configuration, std::move(reader), options),
      worker_([this](const std::stop_token& stop) { work(stop); }) {}

RunWorker::~RunWorker() {
    worker_.request_stop();
    worker_.join();
}

void RunWorker::run(std::uint64_t steps, const StopRules& rules) {
    if (steps == 0) {
        pause();
        return;
    }
    const std::scoped_lock lock(mutex_);
    if (progress_.state == Progress::State::finished || progress_.state == Progress::State::failed)
        return;
    seek_wanted_.reset();
    foreseen_ = false;
    budget_ = steps;
    rules_ = rules;
    pacer_.begin();
    paced_ = true;
    note_due();
    progress_.state = Progress::State::running;
    progress_.stopped_by = StopReason::none;
    rate_since_ = std::chrono::steady_clock::now();
    rate_steps_ = progress_.steps;
    wake_.notify_one();
}

void RunWorker::set_pace(const Pace& pace) {
    const std::scoped_lock lock(mutex_);
    pacer_.set(pace);
    note_due();
    wake_.notify_one();
}

/// Of the last step. A scan that was seen before has its figures.
const StepFigures& RunWorker::noted_figures() {
    const bool kept = run_.options().figures || run_.options().go_back;
    if (!kept) figures_.clear();
    if (kept && progress_.steps <= figures_.size()) return figures_[progress_.steps - 1];
    return figures_.emplace_back(figures_of(run_, progress_.step_seconds));
}

void RunWorker::set_reference(std::optional<Trajectory> reference) {
    const std::scoped_lock lock(mutex_);
    error_.reset();
    if (!reference) return;
    error_.emplace(*std::move(reference));
    for (const StepFigures& step : figures_) {
        if (error_->at(step.online)) return;  // the first pair is all that it keeps
    }
}

void RunWorker::note_due() {
    if (paced_) due_ = pacer_.next(progress_.steps, progress_.duration_s, Pacer::Clock::now());
}

bool RunWorker::waits_for_pace() const {
    return budget_ > 0 && paced_ && Pacer::Clock::now() < due_;
}

bool RunWorker::passes_by() const {
    using namespace std::chrono_literals;
    return budget_ > 0 && !paced_ &&
           (foreseen_ || std::chrono::steady_clock::now() < seek_began_ + 300ms);
}

void RunWorker::pause() {
    const std::scoped_lock lock(mutex_);
    budget_ = 0;
    seek_wanted_.reset();
    // A step under way says itself that it was the last one.
    if (progress_.state == Progress::State::running && !stepping_) {
        progress_.state = Progress::State::paused;
    }
    wake_.notify_one();
}

void RunWorker::restart() {
    const std::scoped_lock lock(mutex_);
    budget_ = 0;
    seek_wanted_.reset();
    foreseen_ = false;
    restart_wanted_ = true;
    progress_ = {};
    snapshot_ = nullptr;
    figures_.clear();
    if (error_) error_->begin_anew();
    wake_.notify_one();
}

void RunWorker::seek(std::uint64_t steps) {
    const std::scoped_lock lock(mutex_);
    if (progress_.state == Progress::State::failed) return;
    // Who is sent on and on, behind a tour that grows, is to be seen all the same.
    const bool on = progress_.state == Progress::State::running && !paced_ && steps >= seek_target_;
    if (!on) seek_began_ = std::chrono::steady_clock::now();
    budget_ = 0;
    rules_ = {};
    paced_ = false;
    seek_wanted_ = seek_target_ = steps;
    foreseen_ = false;
    progress_.state = Progress::State::running;
    progress_.stopped_by = StopReason::none;
    wake_.notify_one();
}

void RunWorker::set_edits(const std::string& edits) {
    static_cast<void>(parse_graph_edits(edits));  // throws
    const std::scoped_lock lock(mutex_);
    const bool sought = progress_.state == Progress::State::running && !paced_;
    if (!edits_wanted_) {
        edit_target_ = progress_.state == Progress::State::finished ||
                               progress_.state == Progress::State::failed
                           ? kToTheEnd
                       : sought ? seek_target_
                                : progress_.steps;
    }
    edits_wanted_ = edits;
    seek_wanted_.reset();
    budget_ = 0;
    rules_ = {};
    paced_ = false;
    seek_target_ = edit_target_;
    seek_began_ = std::chrono::steady_clock::now();
    progress_.state = Progress::State::running;
    progress_.stopped_by = StopReason::none;
    progress_.error = {};
    progress_.failure = nullptr;
    snapshot_ = nullptr;
    wake_.notify_one();
}

void RunWorker::wait() {
    std::unique_lock lock(mutex_);
    idle_.wait(lock, [this] { return idle(); });
}

void RunWorker::wait_for(std::chrono::milliseconds time) {
    std::unique_lock lock(mutex_);
    idle_.wait_for(lock, time, [this] { return idle(); });
}

bool RunWorker::idle() const {
    return !busy_ && budget_ == 0 && !restart_wanted_ && !seek_wanted_ && !edits_wanted_ &&
           !snapshot_wanted_ && tasks_.empty();
}

Progress RunWorker::progress() const {
    const std::scoped_lock lock(mutex_);
    Progress progress = progress_;
    progress.waits = waits_for_pace();
    return progress;
}

void RunWorker::request_snapshot(const SnapshotParts& parts) {
    const std::scoped_lock lock(mutex_);
    snapshot_wanted_ = parts;
    wake_.notify_one();
    if (growth_) growth_->nudge();
}

std::shared_ptr<const Snapshot> RunWorker::latest_snapshot() const {
    const std::scoped_lock lock(mutex_);
    return snapshot_;
}

std::vector<StepFigures> RunWorker::figures_since(std::uint64_t first) const {
    const std::scoped_lock lock(mutex_);
    if (first >= figures_.size()) return {};
    return {figures_.begin() + static_cast<std::ptrdiff_t>(first), figures_.end()};
}

std::future<std::shared_ptr<const AssociationRecord>> RunWorker::weighed() {
    return with_run([this](const Algoritmo& run) -> std::shared_ptr<const AssociationRecord> {
        if (run.steps() == 0) return nullptr;
        return run_.weighed(checkpoints_.before(run.steps() - 1).get());
    });
}

void RunWorker::post(std::function<void(const Algoritmo&)> task) {
    const std::scoped_lock lock(mutex_);
    tasks_.push_back(std::move(task));
    wake_.notify_one();
}

void RunWorker::work(const std::stop_token& stop) {
    std::optional<FileGrowth::Meanwhile> meanwhile;
    if (growth_) meanwhile.emplace(*growth_, [this] { answer_meanwhile(); });
    for (;;) {
        Message error;
        std::exception_ptr failure;
        try {
            work_until(stop);
            return;
        } catch (const std::exception& caught) {
            error = message_of(caught);
            failure = std::current_exception();
        }
        // Told when this thread no longer handles it: whoever is told has it to himself.
        fail(std::move(error), std::move(failure));
    }
}

void RunWorker::fail(Message error, std::exception_ptr failure) {
    const std::scoped_lock lock(mutex_);
    busy_ = false;
    const bool in_a_step = std::exchange(stepping_, false);
    takes_scan_ = false;
    idle_.notify_all();
    if (restart_wanted_ || edits_wanted_) return;  // then it no longer matters
    if (in_a_step) note_progress();
    foreseen_ = false;
    budget_ = 0;
    seek_wanted_.reset();
    progress_.state = Progress::State::failed;
    progress_.error = std::move(error);
    progress_.failure = std::move(failure);
}

void RunWorker::work_until(const std::stop_token& stop) {
    std::unique_lock lock(mutex_);
    while (!stop.stop_requested()) {
        const auto wanted = [this] {
            return (budget_ > 0 && !waits_for_pace()) || restart_wanted_ || seek_wanted_ ||
                   edits_wanted_ || snapshot_wanted_ || !tasks_.empty();
        };
        if (waits_for_pace()) {
            const auto due = due_;  // read while others may set it
            wake_.wait_until(lock, stop, due, wanted);
        } else {
            wake_.wait(lock, stop, wanted);
        }
        if (stop.stop_requested()) break;
        busy_ = true;
        if (std::exchange(restart_wanted_, false)) {
            const auto edits = std::exchange(edits_wanted_, std::nullopt);
            lock.unlock();
            grid_.begin_anew();
            checkpoints_.clear();
            if (edits) run_.set_edits(*edits);
            run_.restart();
            lock.lock();
        } else if (edits_wanted_) {
            take_edits(lock);
        } else if (seek_wanted_) {
            go_to(*std::exchange(seek_wanted_, std::nullopt), lock);
        } else if (budget_ > 0 && !waits_for_pace()) {
            step(lock);
        }
        if (snapshot_wanted_ && !edits_wanted_ && !passes_by()) publish_snapshot(lock);
        for (const auto& task : std::exchange(tasks_, {})) {
            lock.unlock();
            task(run_);
            lock.lock();
        }
        busy_ = false;
        idle_.notify_all();
    }
}

void RunWorker::go_to(std::uint64_t steps, std::unique_lock<std::mutex>& lock) {
    // Past the end the path is smoothed: that is no state after a scan.
    const bool back = run_.steps() > steps || run_.finished();
    std::shared_ptr<const RunCheckpoint> from = checkpoints_.before(steps);
    if (from && !back && from->steps() <= run_.steps()) from = nullptr;
    // Said before the lock is let go, so that what is ordered meanwhile counts.
    budget_ = steps - (from ? from->steps() : back ? 0 : run_.steps());
    stepping_ = true;
    lock.unlock();
    if (from || back) leave_for(from.get());
    lock.lock();
    stepping_ = false;
    if (restart_wanted_ || edits_wanted_) return;
    begin_rate();
    note_progress();
    pacer_.begin();
    note_due();
    if (seek_wanted_) return;  // a newer one
    progress_.state = budget_ > 0 ? Progress::State::running : Progress::State::paused;
}

void RunWorker::leave_for(const RunCheckpoint* checkpoint) {
    grid_.begin_anew();
    if (checkpoint != nullptr) {
        run_.go_to(*checkpoint);
    } else if (!run_.rewind()) {
        checkpoints_.clear();
    }
}

void RunWorker::take_edits(std::unique_lock<std::mutex>& lock) {
    const std::string edits = *std::exchange(edits_wanted_, std::nullopt);
    const std::uint64_t untouched = run_.untouched_scans(edits);
    checkpoints_.forget_after(untouched);
    const auto from = checkpoints_.before(std::min(untouched, edit_target_));
    // Said before the lock is let go, so that what is ordered meanwhile counts.
    budget_ = edit_target_ - (from ? from->steps() : 0);
    stepping_ = true;
    const bool again = std::exchange(foreseen_, false) && bent_;
    const bool rests = edit_target_ == (run_.finished() ? kToTheEnd : run_.steps());
    if (rests || again) foresee(edits, !rests, lock);
    lock.unlock();
    run_.set_edits(edits);
    leave_for(from.get());
    lock.lock();
    stepping_ = false;
    if (restart_wanted_ || edits_wanted_) return;
    if (figures_.size() > run_.steps())
        figures_.erase(figures_.begin() + static_cast<std::ptrdiff_t>(run_.steps()),
                       figures_.end());
    begin_rate();
    note_progress();
    if (budget_ == 0) bent_ = nullptr;
    if (seek_wanted_) return;  // a newer one
    progress_.state = budget_ > 0            ? Progress::State::running
                      : progress_.steps == 0 ? Progress::State::ready
                                             : Progress::State::paused;
}

void RunWorker::foresee(const std::string& edits, bool from_the_last,
                        std::unique_lock<std::mutex>& lock) {
    lock.unlock();
    bool foreseen = false;
    try {
        if (from_the_last) run_.go_to(*bent_);
        foreseen = run_.foresee(edits);
        bent_ = foreseen ? run_.checkpoint(true) : nullptr;
        lock.lock();
        if (foreseen) publish_snapshot(lock, true);
    } catch (const std::exception&) {  // who has no memory for it goes without
        if (!lock.owns_lock()) lock.lock();
        bent_ = nullptr;
    }
    foreseen_ = foreseen && !seek_wanted_ && !restart_wanted_;
}

void RunWorker::step(std::unique_lock<std::mutex>& lock) {
    --budget_;
    stepping_ = true;
    lock.unlock();
    const auto begin = std::chrono::steady_clock::now();
    takes_scan_ = true;
    const bool more = run_.step();
    takes_scan_ = false;
    const auto end = std::chrono::steady_clock::now();
    if (more) {
        grid_.note_step(run_);
        checkpoints_.note(run_);
    }
    lock.lock();
    stepping_ = false;
    if (restart_wanted_ || edits_wanted_) return;  // this step's outcome no longer matters
    progress_.step_seconds = std::chrono::duration<double>(end - begin).count();
    note_progress();
    if (budget_ == 0 || !more) bent_ = nullptr;
    if (!more) {
        budget_ = 0;
        progress_.state = Progress::State::finished;
        progress_.fraction = 1.0;
        return;
    }
    const StepFigures& figures = noted_figures();
    progress_.stopped_by = rules_.met(figures, error_ ? error_->at(figures.online) : std::nullopt);
    if (progress_.stopped_by != StopReason::none ||
        (rules_.scan && progress_.steps >= *rules_.scan)) {
        budget_ = 0;
    }
    if (budget_ == 0 && !seek_wanted_) progress_.state = Progress::State::paused;
    note_due();
}

void RunWorker::begin_rate() {
    rate_since_ = std::chrono::steady_clock::now();
    rate_steps_ = run_.steps();
}

void RunWorker::note_progress() {
    progress_.steps = run_.steps();
    progress_.revision = run_.revision();
    progress_.fraction = run_.reader().progress();
    progress_.time_s = run_.scan().stamp_s();
    progress_.duration_s = run_.duration_s();
    progress_.lines = run_.filter().best_count(FeatureKind::line);
    progress_.corners = run_.filter().best_count(FeatureKind::corner);
    progress_.statistics = run_.filter().statistics();
    progress_.skipped_lines = run_.report().skipped;
    const auto now = std::chrono::steady_clock::now();
    const double seconds = std::chrono::duration<double>(now - rate_since_).count();
    if (seconds >= 0.5) {
        progress_.steps_per_second = static_cast<double>(progress_.steps - rate_steps_) / seconds;
        rate_since_ = now;
        rate_steps_ = progress_.steps;
    }
}

/// What the run is made of rests until the step has all that it waits for.
void RunWorker::answer_meanwhile() {
    if (!takes_scan_ || run_.steps() == 0) return;
    std::unique_lock lock(mutex_);
    if (!snapshot_wanted_ || edits_wanted_ || passes_by()) return;
    publish_snapshot(lock, false, Rest::between_scans);
}

void RunWorker::publish_snapshot(std::unique_lock<std::mutex>& lock, bool foreseen, Rest rest) {
    const SnapshotParts parts = snapshot_wanted_.value_or(parts_);
    parts_ = parts;
    if (!foreseen) snapshot_wanted_.reset();  // else the run's own is still to come
    const bool rests = foreseen || rest == Rest::between_scans || budget_ == 0 || waits_for_pace();
    lock.unlock();
    const double begin = thread_seconds();
    auto snapshot = std::make_shared<Snapshot>(snapshot_of(run_, parts));
    snapshot->foreseen = foreseen;
    snapshot->checkpoints = checkpoints_.all();
    snapshot->grid_behind = !rests && grid_.may_wait(run_);
    snapshot->step_grid = snapshot->grid_behind ? grid_.last() : grid_.now(run_);
    snapshot->seconds = thread_seconds() - begin;
    lock.lock();
    if (!restart_wanted_ && !edits_wanted_) snapshot_ = std::move(snapshot);
}

}  // namespace hitos
