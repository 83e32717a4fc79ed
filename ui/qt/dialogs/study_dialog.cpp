// SPDX-License-Identifier: GPL-3.0-or-later
#include "study_dialog.hpp"

#include <QCloseEvent>
#include <QDesktopServices>
#include <QDir>
#include <QFileInfo>
#include <QRegularExpression>
#include <QUrl>
#include <cmath>

#include "export_dialog.hpp"
#include "hitos/base/atomic_file.hpp"
#include "hitos/base/error.hpp"
#include "hitos/base/file_exchange.hpp"
#include "hitos/services/configuration/config_parameter.hpp"
#include "look/screen_fit.hpp"
#include "look/theme.hpp"
#include "look/words_of.hpp"
#include "ui_study_dialog.h"

namespace hitos::window {
namespace {

QString text_of(const std::filesystem::path& path) {
    return QDir::toNativeSeparators(QString::fromStdString(path.string()));
}

std::unique_ptr<Ui::StudyDialog> make_ui(StudyDialog* dialog) {
    auto ui = std::make_unique<Ui::StudyDialog>();
    ui->setupUi(dialog);
    return ui;
}

/// The run's label, whose last word is in the window's language.
QString label_words(const std::string& label) {
    static const QRegularExpression seed("(?:^|(?<= ))seed (\\d+)$");
    QString words = QString::fromStdString(label);
    const QRegularExpressionMatch found = seed.match(words);
    if (!found.hasMatch()) return words;
    return words.left(found.capturedStart()) + StudyDialog::tr("seed %1").arg(found.captured(1));
}

QString first_failure(const StudyOutcome& outcome) {
    for (std::size_t run = 0; run < outcome.records.size(); ++run) {
        const StudyRecord& record = outcome.records[run];
        if (record.ok || record.problem.empty()) continue;
        return label_words(outcome.plan.label(run)) + ": " + words_of(record.problem);
    }
    return {};
}

}  // namespace

StudyDialog::StudyDialog(Session& session, UserFiles& files, Prompts& prompts, QWidget* parent)
    : QDialog(parent, Qt::Window),
      ui_(make_ui(this)),
      session_(session),
      files_(files),
      prompts_(prompts),
      form_(*ui_, session, files, prompts, this) {
    fit_to_screen(*this);
    connect(ui_->start, &QPushButton::clicked, this, &StudyDialog::start);
    connect(ui_->stop, &QPushButton::clicked, this, [this] {
        ui_->stop->setEnabled(false);
        show_verdict(tr("Stopping…"), "muted");
        runner_.stop();
    });
    connect(ui_->close, &QPushButton::clicked, this, &QDialog::close);
    connect(ui_->save, &QPushButton::clicked, this, &StudyDialog::save_plot);
    connect(ui_->plots, &StudyPlots::picture_wanted, this, &StudyDialog::save_plot);
    connect(ui_->open_run, &QPushButton::clicked, this, &StudyDialog::open_run);
    connect(ui_->use, &QPushButton::clicked, this, &StudyDialog::use_values);
    connect(ui_->plots, &StudyPlots::use_wanted, this, &StudyDialog::use_values);
    connect(ui_->plots, &StudyPlots::choice_changed, this, &StudyDialog::show_state);
    connect(ui_->open_folder, &QPushButton::clicked, this, [this] {
        QDesktopServices::openUrl(
            QUrl::fromLocalFile(QString::fromStdString(layout_.folder.string())));
    });
    connect(&runner_, &StudyRunner::progressed, this, &StudyDialog::show_progress);
    connect(&runner_, &StudyRunner::results_changed, this, [this] {
        ui_->plots->show_results(*runner_.plan(), runner_.records());
        show_state();
    });
    connect(&runner_, &StudyRunner::finished, this, &StudyDialog::finish);
    connect(&runner_, &StudyRunner::failed, this, &StudyDialog::fail);
    show_verdict(tr("Every value is run several times and every map is measured, against the "
                    "reference where there is one, exactly as hitos-cli study does it."),
                 "muted");
    show_state();
}

StudyDialog::~StudyDialog() = default;

StudyPlots& StudyDialog::plots() const {
    return *ui_->plots;
}

void StudyDialog::show_state() {
    const bool running = runner_.running();
    ui_->form->setEnabled(!running);
    ui_->start->setEnabled(!running);
    ui_->stop->setEnabled(running);
    ui_->progress->setVisible(running);
    ui_->save->setEnabled(!ui_->plots->empty());
    ui_->open_folder->setEnabled(!layout_.folder.empty());
    ui_->open_run->setEnabled(!ui_->plots->empty());
    ui_->use->setEnabled(ui_->plots->chosen().has_value());
}

void StudyDialog::show_verdict(const QString& words, const char* role) {
    ui_->verdict->setText(words);
    set_look(*ui_->verdict, "role", role);
}

void StudyDialog::restyle() {
    ui_->plots->restyle();
}

/// A folder that this window filled goes on being filled without a question.
bool StudyDialog::may_replace(const StudyLayout& layout) {
    if (layout.folder == layout_.folder ||
        (!is_there(layout.quality_file()) && !is_there(layout.file("study.json")))) {
        return true;
    }
    return prompts_.confirm(
        this, {tr("The folder holds a study"), tr("Write into %1?").arg(text_of(layout.folder)),
               tr("Runs that are the same are kept and not done again. What is there stays until "
                  "the new study is complete; then its tables and plots take the place of these."),
               tr("Write")});
}

void StudyDialog::start() {
    if (runner_.running()) return;
    std::optional<StudyRequest> request = form_.read();
    if (!request) {
        show_verdict(tr("Nothing starts until all fields are possible."), "error");
        emit ended();
        return;
    }
    if (!may_replace(request->study.layout)) {
        emit ended();
        return;
    }
    form_.remember();
    layout_ = request->study.layout;
    study_ = request->study;
    ui_->plots->clear();
    ui_->progress->setValue(0);
    clock_.start();
    runner_.start(std::move(request->study), request->threads);
    show_verdict(tr("Reading the log…"), "muted");
    show_state();
    ui_->stop->setFocus();
}

void StudyDialog::show_progress(const StudyProgress& progress) {
    ui_->progress->setValue(static_cast<int>(std::lround(progress.fraction * 1000.0)));
    if (!ui_->stop->isEnabled()) return;  // it is told already that it stops
    if (progress.running_number == 0) return;
    QStringList words{tr("Run %1 of %2: %3")
                          .arg(progress.running_number)
                          .arg(progress.runs)
                          .arg(label_words(progress.running))};
    if (progress.reused > 0) words << tr("done before: %1").arg(progress.reused);
    if (progress.failed > 0) words << tr("failed: %1").arg(progress.failed);
    show_verdict(words.join(" · "), progress.failed > 0 ? "error" : "muted");
}

void StudyDialog::finish(const StudyOutcome& outcome) {
    ui_->plots->show_results(outcome.plan, outcome.records);
    const std::size_t good = outcome.computed + outcome.reused - outcome.failed;
    if (outcome.stopped) {
        show_verdict(tr("Stopped; runs done: %1 of %2. Start goes on where it was.")
                         .arg(good)
                         .arg(outcome.plan.runs()),
                     "muted");
    } else {
        QStringList words{tr("Runs done: %1 of %2, in %3 s. Results: %4")
                              .arg(good)
                              .arg(outcome.plan.runs())
                              .arg(static_cast<double>(clock_.elapsed()) / 1e3, 0, 'f', 1)
                              .arg(text_of(layout_.folder))};
        if (outcome.failed > 0) {
            words << tr("Runs failed: %1; the first: %2")
                         .arg(outcome.failed)
                         .arg(first_failure(outcome));
        }
        if (const StudyRecord* record = most_damaged(outcome.records)) {
            words << tr("The log is damaged: lines skipped: %1, stamps that did not advance: %2")
                         .arg(record->report.skipped)
                         .arg(record->report.stamps_backwards);
        }
        for (const Advice& doubt : outcome.doubts) words << words_of(doubt);
        for (const Message& doubt : outcome.tour_doubts) words << words_of(doubt);
        if (!outcome.plot_problem.empty()) {
            words << tr("No picture files of the plots: %1").arg(words_of(outcome.plot_problem));
        }
        if (!outcome.picture_problem.empty()) {
            words << tr("No contact sheet: %1").arg(words_of(outcome.picture_problem));
        }
        show_verdict(words.join('\n'), outcome.failed > 0 ? "error" : "good");
    }
    show_state();
    ui_->start->setFocus();
    emit ended();
}

void StudyDialog::fail(const StudyProblem& problem) {
    show_state();
    const bool told = form_.blame(problem);
    show_verdict(told ? tr("Nothing starts until all fields are possible.") : problem.words,
                 "error");
    emit ended();
}

bool StudyDialog::may_end() {
    if (!runner_.running()) return true;
    return prompts_.confirm(
        this, {tr("A study is under way"), tr("Stop the study?"),
               tr("Runs that are done stay in its folder; started again, it goes on from there."),
               tr("Stop the study")});
}

void StudyDialog::closeEvent(QCloseEvent* event) {
    if (!may_end()) {
        event->ignore();
        return;
    }
    runner_.stop();
    event->accept();
}

void StudyDialog::reject() {
    close();
}

void StudyDialog::open_run() {
    const StudyPlan& plan = *runner_.plan();
    QStringList words;
    std::vector<std::size_t> runs;
    std::optional<int> of_chosen;
    for (std::size_t run = 0; run < runner_.records().size(); ++run) {
        const StudyRecord& record = runner_.records()[run];
        if (!record.ok) continue;
        QString label = label_words(plan.label(run));
        if (const auto& error = record.figures["error_m"])
            label += tr(": map error %1 m").arg(*error, 0, 'f', 4);
        if (!of_chosen && ui_->plots->chosen() == plan.cell_of(run))
            of_chosen = static_cast<int>(words.size());
        words << label;
        runs.push_back(run);
    }
    const std::optional<int> chosen = prompts_.choice(
        this, tr("Open a run of the study"), tr("Run to look at:"), words, of_chosen.value_or(0));
    if (!chosen) return;
    emit run_wanted(job_of(study_, plan, runs[static_cast<std::size_t>(*chosen)]).configuration);
}

/// What is not the study's own stays: log and seed among it.
void StudyDialog::use_values() {
    const StudyPlan& plan = *runner_.plan();
    const std::size_t cell = *ui_->plots->chosen();
    const std::vector<std::string> keys = plan.keys();
    const std::vector<std::string> texts = plan.texts(cell);
    Configuracion next = session_.configuration();
    for (std::size_t i = 0; i < keys.size(); ++i) find_parameter(keys[i]).set(next, texts[i]);
    emit values_wanted(next, QString::fromStdString(plan.cell_label(cell)));
}

void StudyDialog::save_plot() {
    const QString path = export_figure(files_, prompts_, this, ui_->plots->exportable());
    if (path.isEmpty()) return;
    show_verdict(tr("Plot saved: %1").arg(QDir::toNativeSeparators(path)), "muted");
}

}  // namespace hitos::window
