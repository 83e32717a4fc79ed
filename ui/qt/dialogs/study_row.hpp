// SPDX-License-Identifier: GPL-3.0-or-later
// One parameter of a study, as the user writes it.
#pragma once

#include <QObject>
#include <QString>
#include <string>

#include "hitos/services/study/study_values.hpp"
#include "session/session.hpp"

class QComboBox;
class QLabel;
class QLineEdit;
class QWidget;

namespace hitos::window {

/// Where it is written, and what is told of it.
struct StudyRowFields {
    QComboBox* parameter;
    QLabel* parameter_error;
    QLabel* parameter_hint;
    QLabel* values_label;
    QLineEdit* values;
    QLabel* values_error;
    QLabel* values_hint;
};

/// Fills its list, explains what is chosen and says how the values are understood.
class StudyRow final : public QObject {
    Q_OBJECT

  public:
    /// One that is optional begins with "none".
    StudyRow(const StudyRowFields& fields, Session& session, bool optional, QObject* parent);

    const StudyRowFields& fields() const { return fields_; }
    /// "dmax=0.01,0.02", as the command line takes it; empty: none.
    void set_assignment(const std::string& written);
    QString parameter() const;
    /// As the command line has them.
    QString values() const;
    bool in_use() const { return !optional_ || !parameter().isEmpty(); }
    /// Whether the parameter has that name, or sets the key.
    bool names(const std::string& key) const;
    /// Throws hitos::Error, of values that nobody can read, that their key cannot take or that are
    /// there twice too.
    StudyParameter parsed() const;

  signals:
    /// Parameter or values.
    void changed();

  private:
    enum class Made { words, whole_numbers, fractions };

    void fill();
    Made made_of() const;
    void expect_no_comma() const;
    StudyParameter readable() const;
    QString words_of_values() const;
    void explain_parameter();
    void explain_values();

    StudyRowFields fields_;
    Session& session_;
    bool optional_;
};

}  // namespace hitos::window
