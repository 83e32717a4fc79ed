// SPDX-License-Identifier: GPL-3.0-or-later
// How a source is read, in the form that selects it: what its findings advise.
#pragma once

#include <QTimer>
#include <QWidget>
#include <string>
#include <vector>

#include "hitos/services/configuration/config_parameter.hpp"
#include "parameter_field.hpp"

namespace hitos::window {

class SourceReading final : public QWidget {
    Q_OBJECT

  public:
    SourceReading(const SourceParams& source, QWidget* parent);

    void show(const SourceParams& source);
    /// The last possible values.
    void give(SourceParams& source) const;
    /// Every field holds a value that is possible.
    bool good() const;
    /// What was typed last is no value yet.
    bool pending() const { return pause_.isActive(); }
    bool has(const ConfigParameter& parameter) const;
    /// As if it were typed; nothing where the form has no such field.
    void set(const ConfigParameter& parameter, const std::string& value);
    /// Greys out what such a source has no use for.
    void mark_unused(const SourceParams& source);

  signals:
    /// Somebody types, or has chosen.
    void edited();
    /// Nobody has typed for a moment, after values were changed.
    void changed();

  private:
    void take();
    FieldOf<Configuracion>* field_of(const ConfigParameter& parameter) const;

    std::vector<FieldOf<Configuracion>*> fields_;
    QTimer pause_;
};

}  // namespace hitos::window
