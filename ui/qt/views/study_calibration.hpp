// SPDX-License-Identifier: GPL-3.0-or-later
// Whether a filter's regions hold the truth as often as they say, value by value of a study.
#pragma once

#include <qcustomplot.h>

#include <optional>
#include <vector>

#include "fitting_legend.hpp"
#include "hitos/services/study/calibration_figures.hpp"
#include "look/theme.hpp"

namespace hitos::window {

/// The share of the truth that was seen in a region against the one that is expected: a plot each
/// of poses, landmarks and distances, where they are known, with a line for each cell. Where the
/// covariances tell the truth the lines lie on the diagonal; below it the filter is too sure.
class StudyCalibration final : public QCustomPlot {
  public:
    explicit StudyCalibration(QWidget* parent);

    /// Whether any cell has such shares.
    static bool has(const std::vector<StudyCell>& cells);
    void show_results(const StudyPlan& plan, const std::vector<StudyCell>& cells);
    /// `screen`: what is chosen, which is for the screen alone, stands out.
    void style(const Colours& colours, bool screen = true);
    /// The others fade.
    void choose(std::optional<std::size_t> cell);
    std::optional<std::size_t> cell_at(const QPoint& place) const;
    /// On its line of the first plot that has one.
    QPoint middle_of(std::size_t cell) const;
    /// Its shares and NEES in words, a line each.
    static QStringList words_of(const StudyCell& cell);

  private:
    struct Panel {
        const CalibrationKind* kind = nullptr;
        int row = 0;
        int column = 0;
        QCPAxisRect* rect = nullptr;
        QCPGraph* ideal = nullptr;
        std::vector<QCPGraph*> lines;  ///< one for each cell, those without shares empty
    };

    void lay_out(const std::vector<StudyCell>& cells);
    void add_panel(const CalibrationKind& kind);
    void draw_panel(Panel& panel, const std::vector<StudyCell>& cells);
    QSize room_of_legend(bool below);
    void colour_lines(const std::optional<std::size_t>& chosen);

    std::vector<Panel> panels_;
    FittingLegend* legend_ = nullptr;  // of the plot's layout
    QStringList names_;                // of the cells
    std::optional<std::size_t> chosen_;
    Colours look_;
};

}  // namespace hitos::window
