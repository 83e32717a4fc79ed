// SPDX-License-Identifier: GPL-3.0-or-later
// A study, from its plan to its plots [T 8.2.2.11, 10.4].
#pragma once

#include <QDialog>
#include <QElapsedTimer>
#include <memory>

#include "look/prompts.hpp"
#include "look/user_files.hpp"
#include "session/session.hpp"
#include "study_form.hpp"
#include "views/study_plots.hpp"
#include "workers/study_runner.hpp"

namespace hitos::window {

namespace Ui {
class StudyDialog;
}

/// Runs the engine of `hitos-cli study` on the session's configuration, and writes the same files.
/// The main window can be used meanwhile.
class StudyDialog final : public QDialog {
    Q_OBJECT

  public:
    StudyDialog(Session& session, UserFiles& files, Prompts& prompts, QWidget* parent);
    ~StudyDialog() override;

    StudyForm& form() { return form_; }
    StudyPlots& plots() const;
    bool running() const { return runner_.running(); }
    void start();
    /// Whether what runs may be ended: asks the user where something does.
    bool may_end();
    void restyle();

  signals:
    /// The study has ended in whatever way, or could not begin.
    void ended();
    /// The user wants to look at this run.
    void run_wanted(const hitos::Configuracion& configuration);
    /// The user wants the session's configuration with values of the study: "dmax=0.02 p=5".
    void values_wanted(const hitos::Configuracion& configuration, const QString& values);

  protected:
    void closeEvent(QCloseEvent* event) override;
    void reject() override;

  private:
    bool may_replace(const StudyLayout& layout);
    void show_progress(const StudyProgress& progress);
    void finish(const StudyOutcome& outcome);
    void fail(const StudyProblem& problem);
    void show_state();
    void show_verdict(const QString& words, const char* role);
    void save_plot();
    void open_run();
    void use_values();

    std::unique_ptr<Ui::StudyDialog> ui_;
    Session& session_;
    UserFiles& files_;
    Prompts& prompts_;
    StudyForm form_;
    StudyLayout layout_;  ///< of the study under way or done
    Study study_;         ///< likewise
    QElapsedTimer clock_;
    StudyRunner runner_;
};

}  // namespace hitos::window
