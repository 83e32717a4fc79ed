// SPDX-License-Identifier: GPL-3.0-or-later
// What an animation is to show.
#pragma once

#include <QDialog>
#include <functional>
#include <optional>

#include "animation.hpp"
#include "look/prompts.hpp"
#include "look/user_files.hpp"

class QCheckBox;
class QComboBox;
class QLabel;
class QSpinBox;

namespace hitos::window {

class GridView;
class ScanView;

/// How every frame shows the run.
struct FilmStyle {
    bool scan = false;   ///< the last scan,
    bool grid = true;    ///< the map; both: beside each other
    QSize most;          ///< pixels that it may have; empty: those of the screen
    bool still = false;  ///< looks where the views look at the beginning
};

class AnimationDialog final : public QDialog {
    Q_OBJECT

  public:
    /// `scans` of the log, as far as it is known; `all` of them where they are counted.
    AnimationDialog(quint64 scans, QWidget* parent, std::optional<quint64> all = {});

    AnimationPlan plan() const;
    FilmStyle style() const;

  private:
    void refresh();

    QComboBox* view_;
    QSpinBox* from_;
    QSpinBox* to_;
    QSpinBox* every_;
    QSpinBox* rate_;
    QComboBox* size_;
    QCheckBox* still_;
    QLabel* sum_;
};

/// Asks, and writes the animation with a progress window that can cancel it. `notice` is told what
/// came of it. `scans` of the tour, where they are counted.
void save_animation(Session& session, std::optional<quint64> scans, UserFiles& files,
                    Prompts& prompts, ScanView& scan, GridView& grid, QWidget* window,
                    const std::function<void(QString)>& notice);

}  // namespace hitos::window
