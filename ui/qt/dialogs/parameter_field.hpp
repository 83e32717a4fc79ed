// One parameter in a form: label, editor, unit, and what is wrong with it.
#pragma once

#include <QObject>
#include <QString>

#include "hitos/services/configuration/configuracion.hpp"

class QComboBox;
class QGridLayout;
class QLabel;
class QLineEdit;

namespace hitos::window {

class ParameterField final : public QObject {
    Q_OBJECT

  public:
    /// Adds its widgets as new rows of the grid (columns: label, editor, unit).
    ParameterField(const ConfigParameter& parameter, QGridLayout* rows, QWidget* parent);

    const ConfigParameter& parameter() const { return parameter_; }
    QString text() const;
    void set_value(const Configuracion& configuration);
    /// Gives the value to the configuration. Where it cannot be, says so at the field and returns
    /// false.
    bool apply(Configuracion& configuration);
    /// Gives its last possible value, and says nothing.
    void give(Configuracion& configuration) const;
    void set_error(const QString& error);
    bool has_error() const;
    /// What is not used is grey, and has its last possible value.
    void set_used(bool used);
    void focus();

  signals:
    void edited();

  private:
    void mark_changed();
    QWidget* editor() const;

    const ConfigParameter& parameter_;
    QLabel* label_ = nullptr;
    QComboBox* choice_ = nullptr;
    QLineEdit* line_ = nullptr;
    QLabel* unit_ = nullptr;
    QLabel* error_ = nullptr;
    QString good_;
};

}  // namespace hitos::window
