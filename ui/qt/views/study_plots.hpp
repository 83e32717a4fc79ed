// The outcome of a study of one parameter, as the thesis draws it [T 10.4].
#pragma once

#include <QString>
#include <QWidget>
#include <vector>

#include "figure.hpp"
#include "hitos/services/study/study_abscissa.hpp"
#include "hitos/services/study/study_result.hpp"
#include "look/theme.hpp"

class QCPAxisRect;
class QCPErrorBars;
class QCPGraph;
class QCustomPlot;

namespace hitos::window {

/// Quality and number of landmarks against the parameter's values: every run, mean and
/// standard deviation, and how many landmarks the reference has. Quality is the error of the map;
/// without a reference the error of the path; where that is unknown too, the blur of the grid map.
class StudyPlots final : public QWidget {
    Q_OBJECT

  public:
    explicit StudyPlots(QWidget* parent = nullptr);

    /// The plan must have one parameter.
    void show_results(const StudyPlan& plan, const std::vector<StudyRecord>& records);
    void clear();
    bool empty() const { return cells_.empty(); }
    void restyle();

    Exportable exportable();

    /// Values that have a mean quality, for tests.
    int means() const;
    /// What is written over the plot of the quality, for tests.
    QString quality_title() const;

  signals:
    void picture_wanted();

  protected:
    void contextMenuEvent(QContextMenuEvent* event) override;

  private:
    struct Panel {
        const Measure* measure = nullptr;  ///< what it shows
        QCPAxisRect* rect = nullptr;
        QCPGraph* runs = nullptr;
        QCPGraph* means = nullptr;
        QCPErrorBars* spread = nullptr;
        QCPGraph* reference = nullptr;
    };

    Panel make_panel(int row);
    void show_titles(const StudyPlan& plan);
    void style(const Colours& colours);
    void lay_out_axis(const StudyPlan::Axis& axis);
    void draw(const Panel& panel);
    void explain(const QPoint& place);

    QCustomPlot* plot_;
    Panel quality_;
    Panel landmarks_;
    StudyAbscissa x_;
    std::vector<StudyCell> cells_;
};

}  // namespace hitos::window
