// SPDX-License-Identifier: GPL-3.0-or-later
// How far runs are from the truth: along the time or the way, and in figures.
#pragma once

#include <QColor>
#include <QPointF>
#include <QString>
#include <QWidget>
#include <optional>
#include <vector>

#include "hitos/services/evaluation/path_errors.hpp"
#include "hitos/services/evaluation/relative_error.hpp"
#include "hitos/services/evaluation/tour_frames.hpp"
#include "look/theme.hpp"
#include "views/figure.hpp"

class QCheckBox;
class QComboBox;
class QCPAxisRect;
class QCPGraph;
class QCPLegend;
class QCustomPlot;
class QLabel;

namespace hitos::window {

/// As many as colours tell apart and as lines of words leave the views their room.
constexpr std::size_t kMostCompared = 6;

/// A path against the reference of its log.
struct PathFigures {
    std::optional<TrajectoryError> absolute;  ///< nothing where the reference tells nothing of it
    std::optional<RelativeError> relative;    ///< over one metre of the way
    std::vector<PathError> errors;            ///< aligned as `absolute`, or by the first pose
    double begin_s = 0.0;                     ///< its first stamp
    std::vector<QPointF> reference;  ///< its positions, laid on the path as the errors have it

    double greatest_m() const;
};
/// Of what lies in one frame.
PathFigures path_figures(const Trajectory& path, const std::vector<SecondTour>& later_tours,
                         const Trajectory& reference, bool aligned);

/// The two sides of a comparison and what else was chosen with them, one over the other.
class ErrorStrip final : public QWidget {
    Q_OBJECT

  public:
    explicit ErrorStrip(QWidget* parent);

    struct Side {
        QString name;
        QColor colour;
        PathFigures figures;
        QString problem = {};  ///< why there are no figures
    };
    void show_sides(std::vector<Side> sides);
    /// Whether the errors are to be those after the alignment of the ATE.
    bool aligned() const;
    void restyle();

    /// What is drawn of a side, for tests: seconds or metres of way, and metres.
    std::vector<QPointF> curve(std::size_t side) const;

  signals:
    void alignment_changed();
    void picture_wanted(const hitos::window::Exportable& figure);

  protected:
    void contextMenuEvent(QContextMenuEvent* event) override;
    void resizeEvent(QResizeEvent* event) override;

  private:
    QWidget* make_tools();
    void make_plot();
    void make_curves(std::size_t count);
    void draw();
    void show_legend(bool on);
    void wrap_legend();
    void style(const Colours& colours);
    Exportable exportable();

    std::vector<Side> sides_;
    QComboBox* along_ = nullptr;
    QCheckBox* aligned_ = nullptr;
    QCustomPlot* plot_;
    QCPAxisRect* rect_ = nullptr;
    QCPLegend* legend_ = nullptr;
    std::vector<QCPGraph*> curves_;
    std::vector<QLabel*> words_;
};

}  // namespace hitos::window
