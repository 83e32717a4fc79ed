// Every parameter in one form [T 9.2.6.5, use case 8.2.2.4].
#pragma once

#include <QDialog>
#include <memory>
#include <utility>
#include <vector>

#include "hitos/services/configuration/configuracion.hpp"
#include "look/prompts.hpp"
#include "parameter_field.hpp"

class QGridLayout;
class QLabel;

namespace hitos::window {

namespace Ui {
class ConfigurationDialog;
}

/// Made from the parameter table. It can be left by OK only when every value and all of them
/// together are possible and the user confirms what changes.
class ConfigurationDialog final : public QDialog {
    Q_OBJECT

  public:
    ConfigurationDialog(const Configuracion& configuration, Prompts& prompts, QWidget* parent);
    ~ConfigurationDialog() override;

    /// As confirmed; what it was given until then. Opened again, it still compares with what it was
    /// given: what was confirmed may not have been possible.
    const Configuracion& configuration() const { return result_; }
    void show_group(ParameterGroup group);

    void accept() override;

  private:
    void add_group(ParameterGroup group, QGridLayout* rows, QWidget* box);
    void fill(const Configuracion& configuration);
    void mark_unused();
    FieldOf<Configuracion>* field(std::string_view key) const;
    /// The form's values, or nothing where one is not possible; each mistake is shown at its field.
    bool read(Configuracion& out);
    QString changes(const Configuracion& next) const;
    void show_verdict();

    std::unique_ptr<Ui::ConfigurationDialog> ui_;
    Prompts& prompts_;
    const Configuracion original_;
    Configuracion result_;
    std::vector<FieldOf<Configuracion>*> fields_;
    std::vector<std::pair<ParameterGroup, QLabel*>> titles_;
};

}  // namespace hitos::window
