// SPDX-License-Identifier: GPL-3.0-or-later
#include "source_reading.hpp"

#include <QComboBox>
#include <QGridLayout>
#include <QHBoxLayout>
#include <QSignalBlocker>
#include <algorithm>
#include <array>

#include "hitos/services/configuration/config_parameter.hpp"
#include "look/parameter_text.hpp"

namespace hitos::window {

SourceReading::SourceReading(const SourceParams& source, QWidget* parent) : QWidget(parent) {
    constexpr int kPauseMs = 500;
    constexpr int kTight = 3;  // on low screens the verdict needs room too
    pause_.setSingleShot(true);
    pause_.setInterval(kPauseMs);
    connect(&pause_, &QTimer::timeout, this, &SourceReading::take);
    auto* all = new QVBoxLayout(this);
    all->setContentsMargins(0, 0, 0, 0);
    auto* wide = new QGridLayout;  // texts may be long
    wide->setColumnStretch(1, 1);
    wide->setVerticalSpacing(kTight);
    all->addLayout(wide);
    auto* columns = new QHBoxLayout;
    all->addLayout(columns);
    std::array<QGridLayout*, 2> rows{};
    for (QGridLayout*& grid : rows) {
        auto* column = new QVBoxLayout;
        grid = new QGridLayout;
        grid->setColumnStretch(1, 1);
        grid->setVerticalSpacing(kTight);
        column->addLayout(grid);
        column->addStretch(1);
        columns->addLayout(column, 1);
    }
    std::size_t short_fields = 0;
    for (const ConfigParameter& parameter : parameters()) {
        if (parameter.table() != "source" || names_source(parameter)) continue;
        const bool text = parameter.type == ConfigParameter::Type::text;
        QGridLayout* column = text ? wide : rows[short_fields++ % rows.size()];
        auto* field = new FieldOf<Configuracion>(parameter, column, this);
        connect(field, &ParameterField::edited, &pause_, qOverload<>(&QTimer::start));
        connect(field, &ParameterField::edited, this, &SourceReading::edited);
        fields_.push_back(field);
    }
    for (QComboBox* choice : findChildren<QComboBox*>())
        choice->setSizeAdjustPolicy(QComboBox::AdjustToContents);
    show(source);
    mark_unused(source);
}

void SourceReading::show(const SourceParams& source) {
    Configuracion configuration;
    configuration.source = source;
    const QSignalBlocker quiet(this);  // nobody types
    for (FieldOf<Configuracion>* field : fields_) field->set_value(configuration);
    pause_.stop();
}

void SourceReading::take() {
    Configuracion scratch;
    for (FieldOf<Configuracion>* field : fields_) field->apply(scratch);
    emit changed();
}

FieldOf<Configuracion>* SourceReading::field_of(const ConfigParameter& parameter) const {
    const auto found = std::ranges::find_if(fields_, [&](const FieldOf<Configuracion>* field) {
        return field->parameter().key == parameter.key;
    });
    return found == fields_.end() ? nullptr : *found;
}

bool SourceReading::has(const ConfigParameter& parameter) const {
    return field_of(parameter) != nullptr;
}

void SourceReading::set(const ConfigParameter& parameter, const std::string& value) {
    FieldOf<Configuracion>* field = field_of(parameter);
    if (field == nullptr) return;
    field->set_text(value);
    pause_.stop();
    emit changed();
}

void SourceReading::give(SourceParams& source) const {
    Configuracion configuration;
    configuration.source = source;
    for (const FieldOf<Configuracion>* field : fields_) field->give(configuration);
    source = configuration.source;
}

bool SourceReading::good() const {
    return std::ranges::none_of(fields_, &ParameterField::has_error);
}

void SourceReading::mark_unused(const SourceParams& source) {
    Configuracion configuration;
    configuration.source = source;
    for (FieldOf<Configuracion>* field : fields_)
        field->set_used(field->parameter().used_by(configuration));
}

}  // namespace hitos::window
