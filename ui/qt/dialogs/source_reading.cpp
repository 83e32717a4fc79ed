#include "source_reading.hpp"

#include <QGridLayout>
#include <QHBoxLayout>
#include <algorithm>
#include <array>

#include "hitos/services/configuration/config_parameter.hpp"
#include "parameter_text.hpp"

namespace hitos::window {

SourceReading::SourceReading(const SourceParams& source, QWidget* parent) : QWidget(parent) {
    constexpr int kPauseMs = 500;
    constexpr int kTight = 3;  // on low screens the verdict needs room too
    pause_.setSingleShot(true);
    pause_.setInterval(kPauseMs);
    connect(&pause_, &QTimer::timeout, this, &SourceReading::take);
    auto* columns = new QHBoxLayout(this);
    columns->setContentsMargins(0, 0, 0, 0);
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
    Configuracion configuration;
    configuration.source = source;
    for (const ConfigParameter& parameter : parameters()) {
        if (parameter.table() != "source" || names_source(parameter)) continue;
        QGridLayout* column = rows[fields_.size() % rows.size()];
        auto* field = new FieldOf<Configuracion>(parameter, column, this);
        field->set_value(configuration);
        connect(field, &ParameterField::edited, &pause_, qOverload<>(&QTimer::start));
        fields_.push_back(field);
    }
    mark_unused(source);
}

void SourceReading::take() {
    Configuracion scratch;
    for (FieldOf<Configuracion>* field : fields_) field->apply(scratch);
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
