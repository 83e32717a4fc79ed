// SPDX-License-Identifier: GPL-3.0-or-later
// Asks how far to run.
#pragma once

#include <QDialog>
#include <vector>

#include "session/session.hpp"

class QAbstractSpinBox;
class QCheckBox;
class QDoubleSpinBox;
class QFormLayout;
class QLabel;
class QSettings;
class QSpinBox;

namespace hitos::window {

/// A condition a line; those that are ticked are alternatives: the first that is met stops the run.
/// Remembers what was chosen. Accepting runs; a scan or a time that is behind is gone back to.
class RunUntilDialog final : public QDialog {
    Q_OBJECT

  public:
    RunUntilDialog(Session& session, QSettings& settings, QWidget* parent = nullptr);

    void accept() override;

  private:
    struct Line {
        QCheckBox* chosen = nullptr;
        QAbstractSpinBox* value = nullptr;  ///< null where there is none
    };

    QCheckBox* add(const char* name, const QString& text, QAbstractSpinBox* value = nullptr);
    QSpinBox* count_box(int most) const;
    QDoubleSpinBox* value_box(double most, double step, int decimals, const QString& unit) const;
    /// The scan that is to be gone back to; nothing where none is behind.
    std::optional<quint64> behind(quint64 now) const;
    StopRules rules() const;
    void remember() const;
    void recall();

    Session& session_;
    QSettings& settings_;
    QLabel* hint_ = nullptr;
    QFormLayout* form_ = nullptr;
    std::vector<Line> lines_;
    QCheckBox* more_ = nullptr;
    QCheckBox* to_scan_ = nullptr;
    QCheckBox* to_time_ = nullptr;
    QCheckBox* neff_ = nullptr;
    QCheckBox* born_ = nullptr;
    QCheckBox* again_ = nullptr;
    QCheckBox* loop_ = nullptr;
    QCheckBox* best_ = nullptr;
    QCheckBox* error_ = nullptr;
    QSpinBox* more_scans_ = nullptr;
    QSpinBox* scan_ = nullptr;
    QDoubleSpinBox* time_s_ = nullptr;
    QDoubleSpinBox* neff_below_ = nullptr;
    QDoubleSpinBox* again_s_ = nullptr;
    QDoubleSpinBox* error_m_ = nullptr;
};

}  // namespace hitos::window
