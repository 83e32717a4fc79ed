// SPDX-License-Identifier: GPL-3.0-or-later
// One parameter in a form: label, editor, unit, and what is wrong with it.
#pragma once

#include <QList>
#include <QObject>
#include <QString>
#include <optional>
#include <string>

#include "hitos/base/parameter.hpp"

class QComboBox;
class QGridLayout;
class QLabel;
class QLineEdit;

namespace hitos::window {

class ParameterField : public QObject {
    Q_OBJECT

  public:
    /// Adds its widgets as new rows of the grid (columns: label, editor, unit). `normal` is the
    /// text of the default.
    ParameterField(const ParameterFacts& facts, const std::string& normal, QGridLayout* rows,
                   QWidget* parent);

    const ParameterFacts& facts() const { return facts_; }
    QString text() const;
    void set_text(const std::string& text);
    /// The value; nothing where it cannot be, which is said at the field.
    std::optional<ParameterFacts::Value> take();
    /// The last possible value; nothing where there was none.
    std::optional<ParameterFacts::Value> last_good() const;
    void set_error(const QString& error);
    bool has_error() const;
    /// From the default.
    bool differs() const;
    /// What is not used is grey, and has its last possible value.
    void set_used(bool used);
    bool is_used() const;
    void set_shown(bool shown);
    bool is_shown() const;
    bool has_focus() const;
    void focus();

  signals:
    void edited();

  private:
    void mark_changed();
    QWidget* editor() const;
    QList<QWidget*> parts() const;

    const ParameterFacts& facts_;
    const QString normal_;
    QLabel* label_ = nullptr;
    QComboBox* choice_ = nullptr;
    QLineEdit* line_ = nullptr;
    QLabel* unit_ = nullptr;  ///< choices have none
    QLabel* error_ = nullptr;
    QString good_;
};

/// A long label stands in two lines of about the same length: one that wraps by itself has no
/// height of its own in a form that scrolls.
QString in_lines(QString label);

/// The field of a parameter of `Owner`.
template <class Owner>
class FieldOf final : public ParameterField {
  public:
    FieldOf(const Parameter<Owner>& parameter, QGridLayout* rows, QWidget* parent)
        : ParameterField(parameter, parameter.text(Owner{}), rows, parent), parameter_(parameter) {}

    const Parameter<Owner>& parameter() const { return parameter_; }
    void set_value(const Owner& owner) { set_text(parameter_.text(owner)); }
    /// Gives the value to the owner. Where it cannot be, says so at the field and returns false.
    bool apply(Owner& owner) {
        const auto value = take();
        if (value) parameter_.put(owner, *value);
        return value.has_value();
    }
    /// Gives its last possible value, and says nothing.
    void give(Owner& owner) const {
        if (const auto value = last_good()) parameter_.put(owner, *value);
    }

  private:
    const Parameter<Owner>& parameter_;
};

}  // namespace hitos::window
