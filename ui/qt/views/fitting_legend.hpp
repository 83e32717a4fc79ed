// SPDX-License-Identifier: GPL-3.0-or-later
// What many lines of a plot are called, as far as there is room.
#pragma once

#include <qcustomplot.h>

#include <functional>
#include <optional>
#include <vector>

namespace hitos::window {

/// Names its lines in as many columns as there is room for, whether that is of a window or of a
/// figure for print. Where they are too many it says how many are left and how they are seen.
class FittingLegend final : public QCPLayoutInset {
  public:
    /// Its points, asked whenever the plot is laid out.
    using Room = std::function<QSize()>;

    /// Where it stands below its plots it takes no more lines than it needs.
    FittingLegend(Room room, bool below);
    /// Nothing below may be called before it is in a plot. The first line is always named.
    void show_lines(std::vector<QCPGraph*> lines);
    /// Before they are deleted.
    void forget_lines();
    /// Of the lines after the first: named in any case.
    void choose(std::optional<std::size_t> line) { chosen_ = line; }
    void style(const QFont& font, const QColor& text);
    void update(UpdatePhase phase) override;

  protected:
    void parentPlotInitialized(QCustomPlot* plot) override;

  private:
    void fit();

    Room room_;
    bool below_;
    QCPLegend* legend_ = nullptr;  // once it is in a plot
    std::vector<QCPGraph*> lines_;
    std::optional<std::size_t> chosen_;
};

}  // namespace hitos::window
