// SPDX-License-Identifier: GPL-3.0-or-later
// A study under way beside the window.
#pragma once

#include <QObject>
#include <QString>
#include <memory>
#include <mutex>
#include <thread>
#include <vector>

#include "hitos/services/study/study.hpp"

namespace hitos::window {

/// Why a study could not be done, and which of the user's words are to blame where that is known.
struct StudyProblem {
    QString words;
    std::string key;   ///< of hitos::ConfigError, else empty
    std::string path;  ///< of hitos::FileError, else empty
};

/// Runs run_studies() on threads of its own. All signals come in the window's thread.
class StudyRunner final : public QObject {
    Q_OBJECT

  public:
    explicit StudyRunner(QObject* parent = nullptr);
    /// Stops and waits for the steps under way.
    ~StudyRunner() override;

    /// One study at a time; `threads` as in StudyOptions.
    void start(Study study, int threads);
    /// Ends it within a step; what is done stays done.
    void stop();
    bool running() const { return running_; }

    /// Of the study under way or just ended; null before its first run.
    const StudyPlan* plan() const { return plan_.get(); }
    const std::vector<StudyRecord>& records() const { return records_; }

  signals:
    /// Runs were begun, have gone on or have ended.
    void progressed(hitos::StudyProgress progress);
    /// plan() and records() hold more than before.
    void results_changed();
    /// With plan() and records() of all runs, or of those that were done when it was stopped.
    void finished(hitos::StudyOutcome outcome);
    void failed(hitos::window::StudyProblem problem);

  private:
    using Number = quint64;

    void work(const Study& study, int threads, Number number, const std::stop_token& stop);
    void tell(Number number);
    void end(Number number, const std::function<void()>& last_words);

    bool running_ = false;
    Number number_ = 0;  ///< of the study under way: news of an earlier one are dropped
    std::shared_ptr<const StudyPlan> plan_;
    std::vector<StudyRecord> records_;

    std::mutex mutex_;  // guards what the workers leave for the window
    bool told_ = true;
    StudyProgress latest_;
    std::shared_ptr<const StudyPlan> latest_plan_;
    std::vector<std::pair<std::size_t, StudyRecord>> fresh_;

    std::jthread worker_;  // last: it uses everything above
};

}  // namespace hitos::window
