// Saving a view as a picture [T use case 8.2.2.10].
#pragma once

#include <QDialog>
#include <memory>

#include "views/canvas_view.hpp"

namespace hitos::window {

namespace Ui {
class PictureDialog;
}

/// Asks what part of a view to save, and how large.
class PictureDialog final : public QDialog {
    Q_OBJECT

  public:
    PictureDialog(const CanvasView& view, QWidget* parent);
    ~PictureDialog() override;

    bool whole() const;
    double scale() const;

  private:
    std::unique_ptr<Ui::PictureDialog> ui_;
};

}  // namespace hitos::window
