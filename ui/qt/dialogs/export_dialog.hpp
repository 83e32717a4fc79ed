// SPDX-License-Identifier: GPL-3.0-or-later
// Saving a view or plot as a figure [T use case 8.2.2.10].
#pragma once

#include <QDialog>
#include <QTimer>

#include "look/prompts.hpp"
#include "look/user_files.hpp"
#include "views/figure.hpp"

class QCheckBox;
class QComboBox;
class QDialogButtonBox;
class QDoubleSpinBox;
class QFormLayout;
class QLabel;
class QLineEdit;
class QListWidget;

namespace hitos::window {

/// Asks how a figure is to be, and shows it so; what was chosen last is chosen again.
class ExportDialog final : public QDialog {
    Q_OBJECT

  public:
    ExportDialog(Exportable what, QSettings& settings, QWidget* parent);

    /// As it is wished now. Throws hitos::Error where it cannot be.
    Picture picture() const;
    /// "jpg", "png", "svg" or "pdf".
    QString format() const;
    /// Of a file in that format, as it was when it was accepted.
    const QByteArray& bytes() const { return bytes_; }
    void accept() override;

  private:
    void add_size(QFormLayout& form);
    void add_parts(QFormLayout& form);
    QString width_key() const;
    void take_last();
    void remember();
    const FigureOffer& offer() const;
    bool in_mm() const;
    /// Whether it is made of shapes and not of pixels.
    bool of_shapes() const;
    FigureWish wish() const;
    void choose_offer();
    /// Fields that mean nothing are grey.
    void refresh();
    void preview();
    void resizeEvent(QResizeEvent* event) override;

    Exportable what_;
    QSettings& settings_;
    QByteArray bytes_;
    QTimer later_;  ///< a preview for several changes at once
    QComboBox* part_;
    QComboBox* format_;
    QComboBox* unit_;
    QDoubleSpinBox* width_mm_;
    QDoubleSpinBox* width_pixels_;
    QDoubleSpinBox* dots_;
    QDoubleSpinBox* letters_;
    QLineEdit* title_;
    QCheckBox* axes_;
    QCheckBox* legend_;
    QCheckBox* light_;
    QListWidget* layers_;
    QLabel* preview_;
    QLabel* sum_;
    QDialogButtonBox* buttons_;
};

/// Asks how and where, and writes it; the path, empty where the user gave up.
QString export_figure(UserFiles& files, Prompts& prompts, QWidget* parent, const Exportable& what);

}  // namespace hitos::window
