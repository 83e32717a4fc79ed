// SPDX-License-Identifier: GPL-3.0-or-later
#include "study_runner.hpp"

#include <exception>
#include <utility>

#include "hitos/base/error.hpp"
#include "look/words_of.hpp"
#include "session/background.hpp"

namespace hitos::window {
namespace {

StudyProblem problem_of(const std::exception& error) {
    StudyProblem problem{words_of(error), {}, {}};
    if (const auto* bad_value = dynamic_cast<const ConfigError*>(&error)) {
        problem.key = bad_value->key();
    } else if (const auto* bad_file = dynamic_cast<const FileError*>(&error)) {
        problem.path = bad_file->path();
    }
    return problem;
}

}  // namespace

StudyRunner::StudyRunner(QObject* parent) : QObject(parent) {}

StudyRunner::~StudyRunner() = default;

void StudyRunner::start(Study study, int threads) {
    worker_ = {};  // waits for an earlier one
    running_ = true;
    plan_.reset();
    records_.clear();
    latest_plan_.reset();
    fresh_.clear();
    told_ = true;
    worker_ =
        std::jthread([this, study = std::move(study), threads, number = ++number_](
                         const std::stop_token& stop) { work(study, threads, number, stop); });
}

void StudyRunner::stop() {
    worker_.request_stop();
}

void StudyRunner::work(const Study& study, int threads, Number number,
                       const std::stop_token& stop) {
    begin_background_work();
    StudyOptions options;
    options.threads = threads;
    options.stop = stop;
    options.observer = [this, number](const StudyProgress& progress) {
        const std::scoped_lock lock(mutex_);
        latest_ = progress;
        tell(number);
    };
    options.listener = [this, number](const StudyPlan& plan, std::size_t run,
                                      const StudyRecord& record) {
        const std::scoped_lock lock(mutex_);
        if (!latest_plan_) latest_plan_ = std::make_shared<const StudyPlan>(plan);
        fresh_.emplace_back(run, record);
        tell(number);
    };
    try {
        StudyOutcome outcome = std::move(run_studies({&study, 1}, options).front());
        QMetaObject::invokeMethod(
            this,
            [this, number, outcome = std::move(outcome)] {
                end(number, [&] {
                    plan_ = std::make_shared<const StudyPlan>(outcome.plan);
                    records_ = outcome.records;
                    emit finished(outcome);
                });
            },
            Qt::QueuedConnection);
    } catch (const std::exception& error) {
        QMetaObject::invokeMethod(
            this,
            [this, number, problem = problem_of(error)] {
                end(number, [&] { emit failed(problem); });
            },
            Qt::QueuedConnection);
    }
}

/// With the mutex held. However fast the news come, the window is told once for all that wait.
void StudyRunner::tell(Number number) {
    if (!std::exchange(told_, false)) return;
    QMetaObject::invokeMethod(
        this,
        [this, number] {
            if (number != number_) return;
            StudyProgress progress;
            bool more = false;
            {
                const std::scoped_lock lock(mutex_);
                told_ = true;
                progress = latest_;
                more = !fresh_.empty();
                if (more && !plan_) {
                    plan_ = latest_plan_;
                    records_.resize(plan_->runs());
                }
                for (const auto& [run, record] : std::exchange(fresh_, {})) records_[run] = record;
            }
            if (!running_) return;
            emit progressed(progress);
            if (more) emit results_changed();
        },
        Qt::QueuedConnection);
}

void StudyRunner::end(Number number, const std::function<void()>& last_words) {
    if (number != number_) return;
    running_ = false;
    last_words();
}

}  // namespace hitos::window
