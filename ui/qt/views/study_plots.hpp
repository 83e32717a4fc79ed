// SPDX-License-Identifier: GPL-3.0-or-later
// The outcome of a study, as the thesis draws it [T 10.4].
#pragma once

#include <QString>
#include <QStringList>
#include <QWidget>
#include <optional>
#include <vector>

#include "figure.hpp"
#include "hitos/services/study/study_abscissa.hpp"
#include "hitos/services/study/study_result.hpp"
#include "look/theme.hpp"

class QCPAxisRect;
class QCPErrorBars;
class QCPGraph;
class QCPItemStraightLine;
class QComboBox;
class QCustomPlot;

namespace hitos::window {

class StudyCalibration;
class StudyHeat;

/// Quality and number of landmarks against the parameter's values: every run, mean and
/// standard deviation, and how many landmarks the reference has. Quality is the error of the map;
/// without a reference the error of the path; where that is unknown too, the blur of the grid map;
/// or another figure that the user chooses, such as how often the truth lies in the filter's
/// regions. Of two parameters the quality alone, as a map of colours. Of either how often the truth
/// lay in all of the filter's regions, against how often it ought to. One value, or pair of values,
/// can be chosen: by a click or the arrow keys, which begin at the best.
class StudyPlots final : public QWidget {
    Q_OBJECT

  public:
    explicit StudyPlots(QWidget* parent = nullptr);

    /// The plan must have one parameter or two.
    void show_results(const StudyPlan& plan, const std::vector<StudyRecord>& records);
    void clear();
    bool empty() const { return cells_.empty(); }
    void restyle();

    Exportable exportable();

    /// The cell of the plan that is chosen.
    std::optional<std::size_t> chosen() const { return chosen_; }
    void choose(std::optional<std::size_t> cell);
    /// What can be looked at as quality: what the runs have.
    std::vector<const Measure*> qualities() const;
    void show_quality(const Measure& measure);
    /// In its place expected against seen shares, where any run has them.
    void show_calibration();
    /// Values, runs and figures of a cell.
    QString words_of_cell(std::size_t cell) const;

    /// Values that have a mean quality, for tests.
    int means() const;
    /// What is written over the plot of the quality, for tests.
    QString quality_title() const;

  signals:
    void picture_wanted();
    void choice_changed();
    /// What is chosen is to be used.
    void use_wanted();

  protected:
    void keyPressEvent(QKeyEvent* event) override;
    void paintEvent(QPaintEvent* event) override;
    void contextMenuEvent(QContextMenuEvent* event) override;

  private:
    struct Panel {
        const Measure* measure = nullptr;  ///< what it shows
        QCPAxisRect* rect = nullptr;
        QCPGraph* runs = nullptr;
        QCPGraph* means = nullptr;
        QCPErrorBars* spread = nullptr;
        QCPGraph* reference = nullptr;
        QCPItemStraightLine* choice = nullptr;
    };

    Panel make_panel(int row);
    void show_titles(const StudyPlan& plan);
    void show_figures();
    void offer_qualities();
    void style(const Colours& colours);
    void lay_out_axis(const StudyPlan::Axis& axis);
    void draw(const Panel& panel);
    void follow(QCustomPlot& plot);
    QCustomPlot* shown() const;
    std::optional<std::size_t> cell_at(const QPoint& place) const;
    std::optional<std::size_t> beside(int across, int up) const;
    void tell(std::optional<std::size_t> cell, const QPoint& place);

    QComboBox* choice_;
    QCustomPlot* plot_;
    StudyHeat* heat_;
    StudyCalibration* calibration_;
    Panel quality_;
    Panel landmarks_;
    StudyAbscissa x_;
    StudyPlan plan_;
    std::vector<StudyRecord> records_;
    std::vector<StudyCell> cells_;
    QStringList offered_;
    const Measure* wanted_ = nullptr;  // as quality; null: what suits
    bool calibration_wanted_ = false;  // where there is one
    std::optional<std::size_t> chosen_;
};

}  // namespace hitos::window
