// SPDX-License-Identifier: GPL-3.0-or-later
// Every parameter in one form [T 9.2.6.5, use case 8.2.2.4].
#pragma once

#include <QDialog>
#include <memory>
#include <vector>

#include "hitos/services/configuration/configuracion.hpp"
#include "parameter_field.hpp"

class QBoxLayout;
class QGridLayout;
class QLabel;
class QToolButton;

namespace hitos::window {

namespace Ui {
class ConfigurationDialog;
}

/// Made from the parameter table: of each group what the cards show and what differs from its
/// default, the rest behind a button, and all of it by a search. It says what would change, and can
/// be left by OK only when every value and all of them together are possible.
class ConfigurationDialog final : public QDialog {
    Q_OBJECT

  public:
    ConfigurationDialog(const Configuracion& configuration, QWidget* parent);
    ~ConfigurationDialog() override;

    /// As confirmed; what it was given until then. Opened again, it still compares with what it was
    /// given: what was confirmed may not have been possible.
    const Configuracion& configuration() const { return result_; }
    void show_group(ParameterGroup group);

    void accept() override;

  protected:
    void keyPressEvent(QKeyEvent* event) override;
    void resizeEvent(QResizeEvent* event) override;

  private:
    void add_group(ParameterGroup group, QGridLayout* rows, QWidget* box);
    void fill(const Configuracion& configuration);
    Configuracion mark_unused();
    FieldOf<Configuracion>* field(std::string_view key) const;
    /// The form's values, or nothing where one is not possible; each mistake is shown at its field.
    bool read(Configuracion& out);
    QStringList changes(const Configuracion& next) const;
    void arrange();
    void show_verdict();

    std::unique_ptr<Ui::ConfigurationDialog> ui_;
    QBoxLayout* columns_ = nullptr;
    const Configuracion original_;
    Configuracion result_;
    std::vector<FieldOf<Configuracion>*> fields_;
    struct Box {
        ParameterGroup group;
        QWidget* box;
        QLabel* title;
        QToolButton* more;  ///< shows what else the group has
    };
    std::vector<Box> boxes_;
};

}  // namespace hitos::window
