// SPDX-License-Identifier: GPL-3.0-or-later
#include "study_row.hpp"

#include <QComboBox>
#include <QLabel>
#include <QLineEdit>
#include <algorithm>
#include <initializer_list>

#include "hitos/base/error.hpp"
#include "hitos/base/text_input.hpp"
#include "hitos/services/configuration/config_parameter.hpp"
#include "hitos/services/study/study.hpp"
#include "look/parameter_text.hpp"
#include "look/words_of.hpp"
#include "look/written_number.hpp"

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
QString in_words(const std::vector<StudyValue>& values) {
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

/// Throws hitos::Error of what is none of its values; a number out of its range is one.
void check_readable(const ParameterFacts& parameter, const std::string& text) {
    bool number = false;
    if (parameter.type == ParameterFacts::Type::real) {
        number = input::parse_number(text).has_value();
    } else if (parameter.type == ParameterFacts::Type::integer) {
        QString::fromStdString(text).toLongLong(&number);
    }
    if (!number) parameter.value_from(text);
}

}  // namespace

StudyRow::StudyRow(const StudyRowFields& fields, Session& session, bool optional, QObject* parent)
    : QObject(parent), fields_(fields), session_(session), optional_(optional) {
    fill();
    connect(&session_, &Session::configuration_changed, this, &StudyRow::explain_parameter);
    connect(fields_.parameter, &QComboBox::currentTextChanged, this, &StudyRow::explain_parameter);
    connect(fields_.values, &QLineEdit::textChanged, this, &StudyRow::explain_values);
    explain_parameter();
}

void StudyRow::fill() {
    if (optional_) fields_.parameter->addItem(tr("none"));
    for (const ThesisParameter& thesis : thesis_parameters()) {
        fields_.parameter->addItem(item_of(thesis.name, thesis.keys));
        fields_.parameter->setItemData(fields_.parameter->count() - 1,
                                       words_of(marked(thesis.meaning)), Qt::ToolTipRole);
    }
    fields_.parameter->insertSeparator(fields_.parameter->count());
    for (const ConfigParameter& parameter : parameters()) {
        if (!can_be_varied(parameter) || parameter.type == ConfigParameter::Type::text) continue;
        fields_.parameter->addItem(item_of(parameter.key, {parameter.key}));
        fields_.parameter->setItemData(fields_.parameter->count() - 1, description_of(parameter),
                                       Qt::ToolTipRole);
    }
}

void StudyRow::set_assignment(const std::string& written) {
    const QString assignment = QString::fromStdString(written);
    const QString name = assignment.section('=', 0, 0).trimmed();
    const int place = optional_ && name.isEmpty()
                          ? 0
                          : fields_.parameter->findText(name + kDash, Qt::MatchStartsWith);
    if (place >= 0) {
        fields_.parameter->setCurrentIndex(place);
    } else {
        fields_.parameter->setEditText(name);
    }
    // As the command line has it: there a comma is never a decimal one.
    fields_.values->setText(list_as_written(assignment.section('=', 1)));
}

QString StudyRow::parameter() const {
    const QString text = fields_.parameter->currentText();
    if (optional_ && text == fields_.parameter->itemText(0)) return {};
    return text.section(kDash, 0, 0).trimmed();
}

/// Words have no decimal commas.
QString StudyRow::values() const {
    return list_with_points(fields_.values->text(), made_of() != Made::words);
}

StudyRow::Made StudyRow::made_of() const {
    using Type = ConfigParameter::Type;
    Made made = Made::whole_numbers;
    try {
        for (const std::string& key : find_study_parameter(parameter().toStdString()).keys) {
            const Type type = find_parameter(key).type;
            if (type == Type::real) return Made::fractions;
            if (type != Type::integer) made = Made::words;
        }
    } catch (const Error&) {  // half written
        return Made::fractions;
    }
    return made;
}

bool StudyRow::names(const std::string& key) const {
    const StudyParameter known = find_study_parameter(parameter().toStdString());
    return known.name == key || std::ranges::find(known.keys, key) != known.keys.end();
}

StudyParameter StudyRow::parsed() const {
    expect_no_comma();
    StudyParameter read = readable();
    check_values(read);
    return read;
}

/// Throws ConfigError where "0,02" is written of whole numbers: it is neither one nor two.
void StudyRow::expect_no_comma() const {
    if (made_of() != Made::whole_numbers || !has_decimal_comma(fields_.values->text())) return;
    throw ConfigError(parameter().toStdString(),
                      HITOS_TEXT("Errors",
                                 "found %1, and a comma is a decimal one here, while these are "
                                 "whole numbers; part values by semicolons or blanks"),
                      input::in_quotes(fields_.values->text().trimmed().toStdString()));
}

/// Throws hitos::Error of what nobody can read.
StudyParameter StudyRow::readable() const {
    StudyParameter read = parse_study_parameter((parameter() + '=' + values()).toStdString());
    for (const StudyValue& value : read.values) {
        for (std::size_t i = 0; i < read.keys.size(); ++i)
            check_readable(find_parameter(read.keys[i]), value.at(i));
    }
    return read;
}

/// What the parameter means, what it may be and what it is now, key by key.
void StudyRow::explain_parameter() {
    QStringList lines;
    for (QWidget* widget : std::initializer_list<QWidget*>{
             fields_.parameter_hint, fields_.values_label, fields_.values, fields_.values_hint}) {
        widget->setVisible(in_use());
    }
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
    fields_.parameter_hint->setText(lines.join('\n'));
    explain_values();
}

/// Throws hitos::Error of what nobody can read.
QString StudyRow::words_of_values() const {
    try {
        expect_no_comma();
    } catch (const Error& error) {
        return words_of(error);
    }
    const StudyParameter read = readable();
    try {
        check_values(read);
    } catch (const Error& error) {
        return words_of(error);
    }
    return tr("Values: %1 (%2).").arg(read.values.size()).arg(in_words(read.values));
}

void StudyRow::explain_values() {
    QString words =
        decimal_comma()
            ? tr("Values with semicolons or blanks between them, or a range from:to:step.")
            : tr("Values with commas, semicolons or blanks between them, or a range "
                 "from:to:step.");
    try {
        if (!fields_.values->text().trimmed().isEmpty()) words = words_of_values();
    } catch (const Error&) {
        // Perhaps just half written; read() tells.
    }
    fields_.values_hint->setText(words);
    emit changed();
}

}  // namespace hitos::window
