// The outcome of a study of one parameter, as the thesis draws it [T 10.4].
#pragma once

#include <QString>
#include <QWidget>
#include <optional>
#include <vector>

#include "hitos/services/study/study_abscissa.hpp"
#include "hitos/services/study/study_result.hpp"
#include "look/theme.hpp"
#include "picture.hpp"

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

    /// For paper: in light colours. `scale` is pixels per point.
    Picture picture(double scale);

    /// Values that have a mean quality, for tests.
    int means() const;
    /// What is written over the plot of the quality, for tests.
    QString quality_title() const;

  signals:
    void picture_wanted();

  protected:
    void contextMenuEvent(QContextMenuEvent* event) override;

  private:
    /// What the upper plot shows.
    struct Quality {
        std::optional<Spread> StudyCell::*cell = &StudyCell::error_m;
        std::optional<double> StudyRecord::*run = &StudyRecord::error_m;
        QString title;
        QString figure;  ///< with %1 for mean and deviation
        int decimals = 4;
    };
    struct Measure {
        QCPAxisRect* rect = nullptr;
        QCPGraph* runs = nullptr;
        QCPGraph* means = nullptr;
        QCPErrorBars* spread = nullptr;
        QCPGraph* reference = nullptr;
    };

    static Quality quality_of(const StudyPlan& plan, const std::vector<StudyCell>& cells);
    Measure make_measure(int row, const QString& title);
    void style(const Colours& colours);
    void lay_out_axis(const StudyPlan::Axis& axis);
    void draw(const Measure& measure, std::optional<Spread> StudyCell::*spread);
    void explain(const QPoint& place);

    QCustomPlot* plot_;
    Quality shown_;
    Measure quality_;
    Measure landmarks_;
    StudyAbscissa x_;
    std::vector<StudyCell> cells_;
};

}  // namespace hitos::window
