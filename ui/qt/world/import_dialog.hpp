// SPDX-License-Identifier: GPL-3.0-or-later
// How walls are to be found in a picture, a map or a drawing, and what is found.
#pragma once

#include <QDialog>
#include <optional>
#include <vector>

#include "hitos/workbench/world_import.hpp"

class QComboBox;
class QDoubleSpinBox;
class QFormLayout;
class QLabel;
class QLineEdit;
class QPushButton;

namespace hitos::window {

/// "Walls found: 34; drawing: unit 0.001 m, …"
QString found_words(const WorldText& world, const ImportReport& report);

/// Asks for the size of a pixel, where a picture does not say it, and for the tolerance; of a
/// drawing for its unit and layers. Looks for walls beside the window, and can be left by OK only
/// with walls.
class ImportDialog final : public QDialog {
    Q_OBJECT

  public:
    ImportDialog(const QString& source, WallSource kind, QWidget* parent);

    const std::optional<WorldText>& world() const { return world_; }
    /// What was found, "Walls found: 34, tolerance two pixels".
    const QString& words() const { return words_; }
    /// Why it asks.
    void tell(const std::vector<Message>& doubts);

    void accept() override;

  private:
    void ask_for_tolerance(QFormLayout& form);
    void ask_for_layer_and_unit(QFormLayout& form);
    void finish(const std::optional<WorldText>& world, const ImportReport& report,
                const QString& problem);

    QString source_;
    WallSource kind_;
    QDoubleSpinBox* pixel_ = nullptr;
    QDoubleSpinBox* tolerance_ = nullptr;
    QComboBox* unit_ = nullptr;
    QLineEdit* layer_ = nullptr;
    QLabel* verdict_ = nullptr;
    QPushButton* find_ = nullptr;
    std::optional<WorldText> world_;
    QString words_;
};

}  // namespace hitos::window
