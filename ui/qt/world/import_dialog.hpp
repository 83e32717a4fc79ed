// How walls are to be found in a picture or a map, and what is found.
#pragma once

#include <QDialog>
#include <optional>

#include "hitos/workbench/world_import.hpp"

class QDoubleSpinBox;
class QLabel;
class QPushButton;

namespace hitos::window {

/// Asks for the size of a pixel, where a picture does not say it, and for the tolerance. Traces
/// beside the window, and can be left by OK only with walls.
class ImportDialog final : public QDialog {
    Q_OBJECT

  public:
    ImportDialog(const QString& source, WallSource kind, QWidget* parent);

    const std::optional<WorldText>& world() const { return world_; }
    /// "Walls found: 34, tolerance two pixels"
    const QString& words() const { return words_; }

    void accept() override;

  private:
    void finish(const std::optional<WorldText>& world, std::size_t left_out,
                const QString& problem);

    QString source_;
    WallSource kind_;
    QDoubleSpinBox* pixel_ = nullptr;
    QDoubleSpinBox* tolerance_ = nullptr;
    QLabel* verdict_ = nullptr;
    QPushButton* find_ = nullptr;
    std::optional<WorldText> world_;
    QString words_;
};

}  // namespace hitos::window
