// SPDX-License-Identifier: GPL-3.0-or-later
// The outcome of a study of two parameters as a map of colours.
#pragma once

#include <qcustomplot.h>

#include <optional>
#include <vector>

#include "hitos/services/study/study_result.hpp"
#include "look/theme.hpp"

namespace hitos::window {

/// A cell for every pair of values, which are categories: the first parameter's along x, in their
/// order. Its colour and figure are the mean of a measure over its runs; the less the better.
class StudyHeat final : public QCustomPlot {
  public:
    explicit StudyHeat(QWidget* parent);

    /// The plan must have two parameters.
    void show_results(const StudyPlan& plan, const std::vector<StudyCell>& cells,
                      const Measure& measure);
    void style(const Colours& colours);
    void choose(std::optional<std::size_t> cell);
    std::optional<std::size_t> cell_at(const QPoint& place) const;
    QPoint middle_of(std::size_t cell) const;

  private:
    class Cells;

    QCPAxisRect* rect_;
    QCPColorScale* scale_;
    Cells* cells_;
};

/// "Map error"
QString axis_words(const Measure& measure);
/// "m²"
QString unit_of(const Measure& measure);
/// The cell whose mean is the least; nothing where none has one.
std::optional<std::size_t> best_cell(const std::vector<StudyCell>& cells, const Measure& measure);

}  // namespace hitos::window
