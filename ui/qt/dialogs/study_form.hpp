// SPDX-License-Identifier: GPL-3.0-or-later
// What is to be studied, as the user writes it.
#pragma once

#include <QObject>
#include <array>
#include <optional>
#include <string>
#include <vector>

#include "look/prompts.hpp"
#include "look/user_files.hpp"
#include "session/session.hpp"
#include "study_row.hpp"
#include "workers/study_runner.hpp"

class QLabel;
class QWidget;

namespace hitos::window {

namespace Ui {
class StudyDialog;
}

struct StudyRequest {
    Study study;
    int threads = 0;  ///< as in StudyOptions
};

/// The left side of the study's dialog: fills its fields, tells at each what is wrong with it, and
/// makes a Study of them.
class StudyForm final : public QObject {
    Q_OBJECT

  public:
    StudyForm(Ui::StudyDialog& ui, Session& session, UserFiles& files, Prompts& prompts,
              QWidget* dialog);

    /// "dmax=0.01,0.02", as the command line takes it; of one parameter or two.
    void set_assignments(const std::vector<std::string>& assignments);
    void set_runs(int runs);
    void set_folder(const QString& folder);

    /// Nothing where a field is wrong; then the fields say so and the first of them has the focus.
    std::optional<StudyRequest> read();
    /// Tells at the field that is to blame. False where none is.
    bool blame(const StudyProblem& problem);
    /// For the next time.
    void remember();

  private:
    void fill();
    void restore();
    QString source_file() const;
    void offer_reference();
    void show_source();
    void count_runs();
    void browse_reference();
    void browse_folder();
    void set_error(QWidget& editor, QLabel& label, const QString& words);
    void clear_errors(const StudyRow& row);
    void clear_errors();
    std::optional<StudyParameter> read_parameter(const StudyRow& row);
    void read_values(Study& study);
    void read_seed(Study& study);
    void read_reference(Study& study);
    void read_folder(Study& study);

    Ui::StudyDialog& ui_;
    Session& session_;
    UserFiles& files_;
    Prompts& prompts_;
    QWidget* dialog_;
    std::array<StudyRow*, 2> rows_;
    QWidget* first_wrong_ = nullptr;
    QString offered_for_;  ///< the source that the reference in the form is of
};

}  // namespace hitos::window
