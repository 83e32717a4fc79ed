// SPDX-License-Identifier: GPL-3.0-or-later
#include "study_form.hpp"

#include <QDir>
#include <QFileInfo>
#include <QPushButton>
#include <algorithm>
#include <array>
#include <thread>

#include "hitos/base/error.hpp"
#include "hitos/services/configuration/config_parameter.hpp"
#include "hitos/services/files/reference_files.hpp"
#include "hitos/workbench/study_noise.hpp"
#include "look/parameter_text.hpp"
#include "look/theme.hpp"
#include "look/words_of.hpp"
#include "look/written_number.hpp"
#include "ui_study_dialog.h"

namespace hitos::window {
namespace {

/// As another session finds it, wherever that is started.
QString whole(const QString& path) {
    return path.isEmpty() ? path : QFileInfo(path).absoluteFilePath();
}

}  // namespace

StudyForm::StudyForm(Ui::StudyDialog& ui, Session& session, UserFiles& files, Prompts& prompts,
                     QWidget* dialog)
    : QObject(dialog),
      ui_(ui),
      session_(session),
      files_(files),
      prompts_(prompts),
      dialog_(dialog),
      rows_{new StudyRow({ui.parameter, ui.error_parameter, ui.parameter_hint, ui.values_label,
                          ui.values, ui.error_values, ui.values_hint},
                         session, false, this),
            new StudyRow({ui.parameter_2, ui.error_parameter_2, ui.parameter_hint_2,
                          ui.values_label_2, ui.values_2, ui.error_values_2, ui.values_hint_2},
                         session, true, this)} {
    fill();
    restore();
    clear_errors();
    show_source();
    count_runs();
    connect(&session_, &Session::configuration_changed, this, &StudyForm::show_source);
    for (const StudyRow* row : rows_) {
        connect(row, &StudyRow::changed, this, &StudyForm::count_runs);
        connect(row->fields().parameter, &QComboBox::currentTextChanged, this,
                [this, row] { clear_errors(*row); });
        connect(row->fields().values, &QLineEdit::textChanged, this,
                [this, row] { clear_errors(*row); });
    }
    connect(ui_.runs, &QSpinBox::valueChanged, this, &StudyForm::count_runs);
    connect(ui_.noise, &QDoubleSpinBox::valueChanged, this,
            [this](double level) { ui_.noise_kind->setEnabled(level > 0.0); });
    connect(ui_.reference_browse, &QPushButton::clicked, this, &StudyForm::browse_reference);
    connect(ui_.folder_browse, &QPushButton::clicked, this, &StudyForm::browse_folder);
    // What is being mended is no longer told to be wrong.
    const std::array<std::pair<QLineEdit*, QLabel*>, 3> lines{{{ui_.seed, ui_.error_seed},
                                                               {ui_.reference, ui_.error_reference},
                                                               {ui_.folder, ui_.error_folder}}};
    for (const auto& [line, label] : lines) {
        connect(line, &QLineEdit::textChanged, this,
                [this, editor = line, error = label] { set_error(*editor, *error, {}); });
    }
}

void StudyForm::fill() {
    for (const OdometryNoiseFacts& kind : kOdometryNoiseKinds) {
        ui_.noise_kind->addItem(
            QCoreApplication::translate("ParameterChoice", std::string(kind.label).c_str()));
    }
    ui_.threads->setSpecialValueText(tr("all (%1)").arg(std::thread::hardware_concurrency()));
}

void StudyForm::restore() {
    QSettings& settings = files_.settings();
    const auto kept = [&settings](const char* name, const char* otherwise) {
        return settings.value(QString("study/") + name, otherwise).toString().toStdString();
    };
    set_assignments({kept("parameter", "dmax") + '=' + kept("values", ""),
                     kept("parameter_2", "") + '=' + kept("values_2", "")});
    ui_.runs->setValue(settings.value("study/runs", ui_.runs->value()).toInt());
    ui_.noise->setValue(settings.value("study/noise", 0.0).toDouble());
    ui_.noise_kind->setCurrentIndex(settings.value("study/noise_kind", 0).toInt());
    ui_.noise_kind->setEnabled(ui_.noise->value() > 0.0);
    ui_.threads->setValue(settings.value("study/threads", 0).toInt());
    ui_.pictures->setChecked(settings.value("study/pictures", false).toBool());
    const QString folder = files_.place_to_save("hitos-study");
    set_folder(settings.value("study/folder", folder).toString());
}

void StudyForm::remember() {
    QSettings& settings = files_.settings();
    settings.setValue("study/parameter", rows_[0]->parameter());
    settings.setValue("study/values", rows_[0]->values());  // as the command line has them
    settings.setValue("study/parameter_2", rows_[1]->parameter());
    settings.setValue("study/values_2", rows_[1]->values());
    settings.setValue("study/runs", ui_.runs->value());
    settings.setValue("study/noise", ui_.noise->value());
    settings.setValue("study/noise_kind", ui_.noise_kind->currentIndex());
    settings.setValue("study/threads", ui_.threads->value());
    settings.setValue("study/reference", whole(ui_.reference->text().trimmed()));
    settings.setValue("study/reference_of", whole(source_file()));
    settings.setValue("study/pictures", ui_.pictures->isChecked());
    settings.setValue("study/folder", whole(ui_.folder->text().trimmed()));
}

void StudyForm::set_assignments(const std::vector<std::string>& assignments) {
    for (std::size_t i = 0; i < rows_.size(); ++i)
        rows_.at(i)->set_assignment(i < assignments.size() ? assignments[i] : std::string());
}

void StudyForm::set_runs(int runs) {
    ui_.runs->setValue(runs);
}

void StudyForm::set_folder(const QString& folder) {
    ui_.folder->setText(QDir::toNativeSeparators(folder));
}

QString StudyForm::source_file() const {
    return QString::fromStdString(session_.configuration().source.file);
}

/// A reference belongs to its log: none of another one is offered.
void StudyForm::offer_reference() {
    Configuracion former;
    former.source.file = offered_for_.toStdString();
    if (same_log(former, session_.configuration())) return;
    offered_for_ = whole(source_file());
    QString file = session_.reference_map_file();
    QSettings& settings = files_.settings();
    former.source.file = settings.value("study/reference_of").toString().toStdString();
    if (file.isEmpty() && same_log(former, session_.configuration()))
        file = settings.value("study/reference").toString();
    ui_.reference->setText(QDir::toNativeSeparators(file));
}

void StudyForm::show_source() {
    offer_reference();
    const QString file = source_file();
    ui_.source_title->setText(ui_.source_title->fontMetrics().elidedText(
        QFileInfo(file).fileName(), Qt::ElideMiddle, ui_.form_scroll->minimumWidth() - 60));
    ui_.source_title->setToolTip(QDir::toNativeSeparators(file));
}

void StudyForm::count_runs() {
    QString words;
    try {
        auto runs = static_cast<double>(ui_.runs->value());
        for (const StudyRow* row : rows_) {
            if (row->in_use()) runs *= static_cast<double>(row->parsed().values.size());
        }
        words = tr("Runs in all: %1").arg(runs, 0, 'f', 0);
    } catch (const Error&) {
        // Likewise.
    }
    ui_.all_runs->setText(words);
}

void StudyForm::browse_reference() {
    const QString path = prompts_.open_file(
        dialog_,
        {tr("Reference map"),
         ui_.reference->text().isEmpty() ? files_.folder_to_open("map") : ui_.reference->text(),
         tr("Maps (*.map *.txt);;All files (*)"),
         {}});
    if (path.isEmpty()) return;
    ui_.reference->setText(QDir::toNativeSeparators(path));
    files_.note_opened("map", path);
}

void StudyForm::browse_folder() {
    const QString path = prompts_.choose_folder(dialog_, tr("Results folder"), ui_.folder->text());
    if (!path.isEmpty()) set_folder(path);
}

void StudyForm::set_error(QWidget& editor, QLabel& label, const QString& words) {
    label.setText(words);
    label.setVisible(!words.isEmpty());
    set_look(editor, "state", words.isEmpty() ? "good" : "wrong");
    if (!words.isEmpty() && first_wrong_ == nullptr) first_wrong_ = &editor;
}

void StudyForm::clear_errors(const StudyRow& row) {
    set_error(*row.fields().parameter, *row.fields().parameter_error, {});
    set_error(*row.fields().values, *row.fields().values_error, {});
}

void StudyForm::clear_errors() {
    first_wrong_ = nullptr;
    for (const StudyRow* row : rows_) {
        clear_errors(*row);
    }
    set_error(*ui_.seed, *ui_.error_seed, {});
    set_error(*ui_.reference, *ui_.error_reference, {});
    set_error(*ui_.folder, *ui_.error_folder, {});
}

std::optional<StudyParameter> StudyForm::read_parameter(const StudyRow& row) {
    const StudyRowFields& fields = row.fields();
    try {
        find_study_parameter(row.parameter().toStdString());
    } catch (const Error& error) {
        set_error(*fields.parameter, *fields.parameter_error, words_of(error));
        return std::nullopt;
    }
    QString problem = tr("Write at least one value.");
    try {
        if (!fields.values->text().trimmed().isEmpty()) return row.parsed();
    } catch (const Error& error) {
        problem = words_of(error);
    }
    set_error(*fields.values, *fields.values_error, problem);
    return std::nullopt;
}

void StudyForm::read_values(Study& study) {
    std::array<std::optional<StudyParameter>, 2> chosen;
    for (std::size_t i = 0; i < rows_.size(); ++i) {
        if (rows_.at(i)->in_use()) chosen.at(i) = read_parameter(*rows_.at(i));
    }
    for (std::size_t i = 0; i < rows_.size(); ++i) {
        if (!chosen.at(i)) continue;
        const auto& other = chosen.at(1 - i);
        try {
            check_values(session_.configuration(), *chosen.at(i), other ? &*other : nullptr);
            study.parameters.push_back(*chosen.at(i));
        } catch (const Error& error) {
            const StudyRowFields& fields = rows_.at(i)->fields();
            set_error(*fields.values, *fields.values_error, words_of(error));
        }
    }
}

void StudyForm::read_seed(Study& study) {
    bool good = false;
    study.first_seed = ui_.seed->text().trimmed().toULongLong(&good);
    if (!good) set_error(*ui_.seed, *ui_.error_seed, tr("Expected a whole number, 0 or more."));
    study.seeds = ui_.runs->value();
}

void StudyForm::read_reference(Study& study) {
    const QString path = ui_.reference->text().trimmed();
    if (path.isEmpty()) return;  // the paths and grids are measured then
    try {
        const ReferenceFiles files = by_content({path.toStdString(), {}});
        if (!files.map.empty()) study.reference = read_map(files.map);
        if (!files.trajectory.empty())
            study.reference_trajectory = read_trajectory(files.trajectory);
    } catch (const Error& error) {
        set_error(*ui_.reference, *ui_.error_reference, words_of(error));
    }
}

void StudyForm::read_folder(Study& study) {
    const QString path = ui_.folder->text().trimmed();
    if (path.isEmpty()) {
        set_error(*ui_.folder, *ui_.error_folder, tr("Choose a folder for the results."));
        return;
    }
    study.layout = study_in_folder(path.toStdString());
}

std::optional<StudyRequest> StudyForm::read() {
    clear_errors();
    StudyRequest request;
    request.threads = ui_.threads->value();
    request.study.configuration = session_.configuration();
    read_values(request.study);
    read_seed(request.study);
    request.study.reference_trajectory = session_.user_references().trajectory;
    read_reference(request.study);
    read_folder(request.study);
    if (ui_.pictures->isChecked()) request.study.pictures = StudyPictures::first;
    const auto kind = static_cast<OdometryNoiseKind>(ui_.noise_kind->currentIndex());
    set_study_source(request.study, ui_.noise->value(), kind);
    if (first_wrong_ == nullptr) return request;
    first_wrong_->setFocus();
    return std::nullopt;
}

bool StudyForm::blame(const StudyProblem& problem) {
    const std::string folder = ui_.folder->text().trimmed().toStdString();
    clear_errors();
    if (!problem.path.empty() && problem.path.starts_with(folder)) {
        set_error(*ui_.folder, *ui_.error_folder, problem.words);
    } else if (problem.key == "seed") {
        set_error(*ui_.seed, *ui_.error_seed, problem.words);
    } else if (!problem.key.empty()) {
        const bool second = rows_[1]->in_use() && rows_[1]->names(problem.key);
        const StudyRowFields& fields = rows_.at(second ? 1 : 0)->fields();
        set_error(*fields.values, *fields.values_error, problem.words);
    }
    if (first_wrong_ == nullptr) return false;
    first_wrong_->setFocus();
    return true;
}

}  // namespace hitos::window
