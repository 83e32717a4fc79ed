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

constexpr const char* kDash = " — ";

/// "dmax — D max": the name to use, then what it stands for.
QString item_of(std::string_view name, const std::vector<std::string_view>& keys) {
    QStringList labels;
    for (const std::string_view key : keys) labels << label_of(find_parameter(key));
    return to_qt(name) + kDash + labels.join(", ");
}

/// "0.5; 1.3; …": what is going to be run.
QString as_read(const std::vector<StudyValue>& values) {
    constexpr int kMost = 8;
    QStringList shown;
    for (const StudyValue& value : values) {
        if (shown.size() == kMost) {
            shown << "…";
            break;
        }
        QStringList parts;
        for (const std::string& part : value) parts << QString::fromStdString(part);
        shown << parts.join('/');
    }
    return shown.join("; ");
}

/// The study's value in the user's configuration. Throws ConfigError.
void try_value(Configuracion configuration, const StudyParameter& parameter,
               const StudyValue& value) {
    for (std::size_t i = 0; i < parameter.keys.size(); ++i)
        find_parameter(parameter.keys[i]).set(configuration, value[i]);
    check(configuration);
}

}  // namespace

StudyForm::StudyForm(Ui::StudyDialog& ui, Session& session, UserFiles& files, Prompts& prompts,
                     QWidget* dialog)
    : QObject(dialog),
      ui_(ui),
      session_(session),
      files_(files),
      prompts_(prompts),
      dialog_(dialog) {
    fill();
    restore();
    clear_errors();
    show_source();
    explain_parameter();
    connect(&session_, &Session::configuration_changed, this, [this] {
        show_source();
        explain_parameter();
    });
    connect(ui_.parameter, &QComboBox::currentTextChanged, this, &StudyForm::explain_parameter);
    connect(ui_.values, &QLineEdit::textChanged, this, &StudyForm::explain_values);
    connect(ui_.runs, &QSpinBox::valueChanged, this, &StudyForm::explain_values);
    connect(ui_.noise, &QDoubleSpinBox::valueChanged, this,
            [this](double level) { ui_.noise_kind->setEnabled(level > 0.0); });
    connect(ui_.reference_browse, &QPushButton::clicked, this, &StudyForm::browse_reference);
    connect(ui_.folder_browse, &QPushButton::clicked, this, &StudyForm::browse_folder);
    // What is being mended is no longer told to be wrong.
    connect(ui_.parameter, &QComboBox::editTextChanged, this,
            [this] { set_error(*ui_.parameter, *ui_.error_parameter, {}); });
    const std::array<std::pair<QLineEdit*, QLabel*>, 4> lines{{{ui_.values, ui_.error_values},
                                                               {ui_.seed, ui_.error_seed},
                                                               {ui_.reference, ui_.error_reference},
                                                               {ui_.folder, ui_.error_folder}}};
    for (const auto& [line, label] : lines) {
        connect(line, &QLineEdit::textChanged, this,
                [this, editor = line, error = label] { set_error(*editor, *error, {}); });
    }
}

void StudyForm::fill() {
    for (const ThesisParameter& thesis : thesis_parameters()) {
        ui_.parameter->addItem(item_of(thesis.name, thesis.keys));
        ui_.parameter->setItemData(ui_.parameter->count() - 1, words_of(marked(thesis.meaning)),
                                   Qt::ToolTipRole);
    }
    ui_.parameter->insertSeparator(ui_.parameter->count());
    for (const ConfigParameter& parameter : parameters()) {
        if (!can_be_varied(parameter) || parameter.type == ConfigParameter::Type::text) continue;
        ui_.parameter->addItem(item_of(parameter.key, {parameter.key}));
        ui_.parameter->setItemData(ui_.parameter->count() - 1, description_of(parameter),
                                   Qt::ToolTipRole);
    }
    for (const OdometryNoiseFacts& kind : kOdometryNoiseKinds) {
        ui_.noise_kind->addItem(
            QCoreApplication::translate("ParameterChoice", std::string(kind.label).c_str()));
    }
    ui_.threads->setSpecialValueText(tr("all (%1)").arg(std::thread::hardware_concurrency()));
}

void StudyForm::restore() {
    QSettings& settings = files_.settings();
    const QString name = settings.value("study/parameter", "dmax").toString();
    set_assignment(name + '=' + settings.value("study/values").toString());
    ui_.runs->setValue(settings.value("study/runs", ui_.runs->value()).toInt());
    ui_.noise->setValue(settings.value("study/noise", 0.0).toDouble());
    ui_.noise_kind->setCurrentIndex(settings.value("study/noise_kind", 0).toInt());
    ui_.noise_kind->setEnabled(ui_.noise->value() > 0.0);
    ui_.threads->setValue(settings.value("study/threads", 0).toInt());
    const QString loaded = session_.reference_map_file();
    ui_.reference->setText(QDir::toNativeSeparators(
        loaded.isEmpty() ? settings.value("study/reference").toString() : loaded));
    ui_.pictures->setChecked(settings.value("study/pictures", false).toBool());
    const QString folder = files_.place_to_save("hitos-study");
    set_folder(settings.value("study/folder", folder).toString());
}

void StudyForm::remember() {
    QSettings& settings = files_.settings();
    settings.setValue("study/parameter", parameter());
    settings.setValue("study/values", values());  // as the command line has them
    settings.setValue("study/runs", ui_.runs->value());
    settings.setValue("study/noise", ui_.noise->value());
    settings.setValue("study/noise_kind", ui_.noise_kind->currentIndex());
    settings.setValue("study/threads", ui_.threads->value());
    settings.setValue("study/reference", ui_.reference->text());
    settings.setValue("study/pictures", ui_.pictures->isChecked());
    settings.setValue("study/folder", ui_.folder->text());
}

void StudyForm::set_assignment(const QString& assignment) {
    const QString name = assignment.section('=', 0, 0).trimmed();
    const int place = ui_.parameter->findText(name + kDash, Qt::MatchStartsWith);
    if (place >= 0) {
        ui_.parameter->setCurrentIndex(place);
    } else {
        ui_.parameter->setEditText(name);
    }
    // As the command line has it: there a comma is never a decimal one.
    ui_.values->setText(assignment.section('=', 1).replace(',', decimal_comma() ? "; " : ","));
}

void StudyForm::set_runs(int runs) {
    ui_.runs->setValue(runs);
}

void StudyForm::set_folder(const QString& folder) {
    ui_.folder->setText(QDir::toNativeSeparators(folder));
}

QString StudyForm::parameter() const {
    return ui_.parameter->currentText().section(kDash, 0, 0).trimmed();
}

/// Whole numbers and words have no decimal commas.
QString StudyForm::values() const {
    bool fractions = true;
    try {
        const auto& keys = find_study_parameter(parameter().toStdString()).keys;
        fractions = std::ranges::any_of(keys, [](const std::string& key) {
            return find_parameter(key).type == ConfigParameter::Type::real;
        });
    } catch (const Error&) {  // half written
    }
    return list_with_points(ui_.values->text(), fractions);
}

QString StudyForm::assignment() const {
    return parameter() + '=' + values();
}

void StudyForm::show_source() {
    const QString file = QString::fromStdString(session_.configuration().source.file);
    ui_.source_title->setText(ui_.source_title->fontMetrics().elidedText(
        QFileInfo(file).fileName(), Qt::ElideMiddle, ui_.form_scroll->minimumWidth() - 60));
    ui_.source_title->setToolTip(QDir::toNativeSeparators(file));
}

/// What the parameter means, what it may be and what it is now, key by key.
void StudyForm::explain_parameter() {
    QStringList lines;
    try {
        for (const std::string& key : find_study_parameter(parameter().toStdString()).keys) {
            const ConfigParameter& known = find_parameter(key);
            lines << tr("%1 Allowed: %2. Now: %3.")
                         .arg(description_of(known), allowed_of(known),
                              value_with_unit(known, session_.configuration()));
        }
        if (lines.size() > 1) lines << tr("Join the parts of a value by “/”.");
    } catch (const Error&) {
        lines = {tr("A name from the list, or keys joined by “+”.")};
    }
    ui_.parameter_hint->setText(lines.join('\n'));
    explain_values();
}

void StudyForm::explain_values() {
    QString words =
        decimal_comma()
            ? tr("Values with semicolons or blanks between them, or a range from:to:step.")
            : tr("Values with commas, semicolons or blanks between them, or a range "
                 "from:to:step.");
    try {
        if (!ui_.values->text().trimmed().isEmpty()) {
            const auto values = parse_study_parameter(assignment().toStdString()).values;
            words = tr("Values: %1 (%2). Runs in all: %3.")
                        .arg(values.size())
                        .arg(as_read(values))
                        .arg(values.size() * static_cast<std::size_t>(ui_.runs->value()));
        }
    } catch (const Error&) {
        // Perhaps just half written; read() tells.
    }
    ui_.values_hint->setText(words);
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

void StudyForm::clear_errors() {
    first_wrong_ = nullptr;
    set_error(*ui_.parameter, *ui_.error_parameter, {});
    set_error(*ui_.values, *ui_.error_values, {});
    set_error(*ui_.seed, *ui_.error_seed, {});
    set_error(*ui_.reference, *ui_.error_reference, {});
    set_error(*ui_.folder, *ui_.error_folder, {});
}

void StudyForm::read_values(Study& study) {
    try {
        find_study_parameter(parameter().toStdString());
    } catch (const Error& error) {
        set_error(*ui_.parameter, *ui_.error_parameter, words_of(error));
        return;
    }
    if (ui_.values->text().trimmed().isEmpty()) {
        set_error(*ui_.values, *ui_.error_values, tr("Write at least one value."));
        return;
    }
    try {
        const StudyParameter chosen = parse_study_parameter(assignment().toStdString());
        for (const StudyValue& value : chosen.values) {
            try_value(session_.configuration(), chosen, value);
        }
        study.parameters = {chosen};
    } catch (const Error& error) {
        set_error(*ui_.values, *ui_.error_values, words_of(error));
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
        set_error(*ui_.values, *ui_.error_values, problem.words);
    }
    if (first_wrong_ == nullptr) return false;
    first_wrong_->setFocus();
    return true;
}

}  // namespace hitos::window
