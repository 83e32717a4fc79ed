// SPDX-License-Identifier: GPL-3.0-or-later
// The places that looked like an earlier one, as rows of figures.
#pragma once

#include <QString>
#include <optional>
#include <vector>

#include "hitos/services/evaluation/run_loops.hpp"
#include "look/figures_table.hpp"

namespace hitos::window {

/// "Closed", or why not.
QString verdict_words(LoopVerdict verdict);

class LoopModel final : public FiguresModel {
    Q_OBJECT

  public:
    enum Column { scan, earlier, verdict, error, score, overlap, through, chi, way, moved, weight };

    explicit LoopModel(QObject* parent);
    void set_loops(std::vector<RunLoop> loops);
    const std::vector<RunLoop>& loops() const { return loops_; }

  protected:
    QVariant key(int row, int column) const override;
    QString text(int row, int column) const override;
    /// Closed ones.
    bool strong(int row) const override;

  private:
    std::optional<double> figure(int row, int column) const;

    std::vector<RunLoop> loops_;
};

}  // namespace hitos::window
