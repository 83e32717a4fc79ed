// SPDX-License-Identifier: GPL-3.0-or-later
// Figures of the run against time.
#pragma once

#include <QElapsedTimer>
#include <QTimer>
#include <QWidget>
#include <limits>
#include <memory>
#include <vector>

#include "figure.hpp"
#include "session/session.hpp"
#include "workers/reference_meter.hpp"

class QCPAxisRect;
class QCPGraph;
class QCPItemStraightLine;
class QCPTextElement;
class QCustomPlot;

namespace hitos::window {

/// One plot for every figure that there is something to say of: Neff and weights where there are
/// several hypotheses, errors where there is a reference. Wheel and drag zoom and move all along
/// time, a double click shows all; a click goes to that scan; the titles tell the values under the
/// mouse. By keys, + and - zoom about the scan that is shown, and F shows all.
class Plots final : public QWidget {
    Q_OBJECT

  public:
    /// Their order is that on the screen.
    enum Figure {
        neff,
        landmarks,
        features,
        best_weight,
        step_time,
        position_error,
        pose_nees,
        trajectory_error,
        map_error,
    };

    /// What a scan's pose is against the reference; not a number where there is none.
    struct Against {
        double position_error_m = std::numeric_limits<double>::quiet_NaN();
        double nees = std::numeric_limits<double>::quiet_NaN();
    };

    Plots(Session& session, ReferenceMeter& meter, QWidget* parent = nullptr);

    QSize sizeHint() const override;

    Exportable exportable();
    void copy_picture() { copy(exportable().offers.front()); }

    /// Points drawn so far; 0 where the plot is not shown.
    int points(Figure figure) const;
    bool shows(Figure figure) const;
    /// As the title tells it, with the value under the mouse.
    QString title(Figure figure) const;
    /// Where a time [s] is in the plots, and the times that they show.
    QPoint place_of(double time_s) const;
    std::pair<double, double> times() const;

    void restyle();

  signals:
    void picture_wanted();
    void table_wanted();

  protected:
    void showEvent(QShowEvent* event) override;
    void resizeEvent(QResizeEvent* event) override;
    void contextMenuEvent(QContextMenuEvent* event) override;
    void keyPressEvent(QKeyEvent* event) override;
    void paintEvent(QPaintEvent* event) override;
    bool eventFilter(QObject* watched, QEvent* event) override;

  private:
    struct Shown {
        Figure figure;
        QCPAxisRect* rect;
        QCPTextElement* title;
        QCPGraph* graph;
        QCPItemStraightLine* now;
        std::vector<QCPItemStraightLine*> bounds = {};
    };

    std::vector<Figure> wanted() const;
    /// Makes the plots anew where others are wanted.
    void lay_out();
    void add_plot(Figure figure, int place, int columns);
    QCPItemStraightLine* add_line(QCPAxisRect* rect);
    void style(const Colours& colours);
    void clear();
    void refresh(bool at_once);
    void fill();
    void note_errors(const Measured& figures);
    void set_times(double from_s, double to_s);
    void show_all_times();
    void zoom(double factor);
    void follow_clicks();
    void show_values(const QPoint& place);
    void hide_values();
    void go_to(const QPoint& place);
    const Shown* find(Figure figure) const;

    Session& session_;
    QCustomPlot* plot_;
    std::vector<Shown> shown_;
    std::vector<StepFigures> figures_;
    std::vector<Against> against_;  // by scan
    std::optional<PositionError> position_error_;
    std::vector<ErrorPoint> course_;
    int columns_ = 0;
    std::size_t filled_ = 0;  // scans in the graphs
    bool zoomed_ = false;
    std::optional<QPoint> pressed_;
    QPoint clicked_;
    QTimer click_;
    QElapsedTimer clock_;
};

}  // namespace hitos::window
