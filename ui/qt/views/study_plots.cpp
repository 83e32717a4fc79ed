// SPDX-License-Identifier: GPL-3.0-or-later
#include "study_plots.hpp"

#include <qcustomplot.h>

#include <QBuffer>
#include <QComboBox>
#include <QContextMenuEvent>
#include <QKeyEvent>
#include <QMenu>
#include <QPageSize>
#include <QPdfWriter>
#include <QToolTip>
#include <QVBoxLayout>
#include <algorithm>
#include <cmath>

#include "plot_style.hpp"
#include "study_calibration.hpp"
#include "study_heat.hpp"

namespace hitos::window {
namespace {

// Pixels round and between the words of the axis.
constexpr int kGap = 14;
constexpr int kLeft = 40;
constexpr int kTop = 4;
constexpr int kRight = 10;
constexpr int kBottom = 20;
constexpr double kRoom = 0.06;  // of the axis, at both ends

QString title_words(const Measure& measure) {
    const QString unit = unit_of(measure);
    return StudyPlots::tr("%1: every run, mean and standard deviation")
        .arg(axis_words(measure) + (unit.isEmpty() ? "" : " [" + unit + ']'));
}

/// "Map error: 0.123 ± 0.011 m"
QString figure_words(const Measure& measure, const Spread& spread) {
    QString words =
        axis_words(measure) + ": " + QString::fromStdString(measure.rounded(spread.mean, true));
    if (spread.variance) {
        words += " ± " + QString::fromStdString(measure.rounded(std::sqrt(*spread.variance), true));
    }
    return (words + ' ' + unit_of(measure)).trimmed();
}

/// The error of the map where there is a reference, else the first with a plot that was taken. What
/// has a value that it ought to have is only looked at by who wants it.
const Measure& quality_of(const StudyPlan& plan, const std::vector<StudyCell>& cells) {
    for (const Measure* measure : taken_measures()) {
        if (measure->plot.empty() || measure->is_count() || measure->rare) continue;
        const bool due = measure->of_landmarks() && plan.has_reference();
        if (due || has_figures(cells, *measure)) return *measure;
    }
    return run_measures().find("blur_m2");
}

/// What is chosen is for the screen alone.
class ChoiceLine final : public QCPItemStraightLine {
  public:
    using QCPItemStraightLine::QCPItemStraightLine;

  protected:
    void draw(QCPPainter* painter) override {
        if (!painter->modes().testFlag(QCPPainter::pmVectorized))
            QCPItemStraightLine::draw(painter);
    }
};

}  // namespace

StudyPlots::StudyPlots(QWidget* parent)
    : QWidget(parent),
      choice_(new QComboBox(this)),
      plot_(new QCustomPlot(this)),
      heat_(new StudyHeat(this)),
      calibration_(new StudyCalibration(this)) {
    auto* column = new QVBoxLayout(this);
    column->setContentsMargins(1, 1, 1, 1);  // where one sees that it has the keyboard
    column->setSpacing(0);
    choice_->setObjectName("study_figure");
    choice_->setAccessibleName(tr("Figure of the plot"));
    choice_->setToolTip(tr("What the plot shows of each run"));
    choice_->setSizeAdjustPolicy(QComboBox::AdjustToContents);
    column->addWidget(choice_, 0, Qt::AlignLeft);
    connect(choice_, &QComboBox::activated, this, [this](int place) {
        const std::vector<const Measure*> measures = qualities();
        const auto chosen = static_cast<std::size_t>(place);
        if (chosen >= measures.size()) return show_calibration();
        show_quality(*measures[chosen]);
    });
    column->addWidget(plot_);
    column->addWidget(heat_);
    column->addWidget(calibration_);
    plot_->setFocusPolicy(Qt::NoFocus);
    plot_->plotLayout()->clear();
    plot_->plotLayout()->setRowSpacing(2);
    leave_menu_to_parent(*plot_);
    quality_ = make_panel(0);
    landmarks_ = make_panel(1);
    landmarks_.measure = &run_measures().find("landmarks");
    // Both share the parameter's axis, so their left edges must agree.
    auto* margins = new QCPMarginGroup(plot_);
    for (const Panel* panel : {&quality_, &landmarks_})
        panel->rect->setMarginGroup(QCP::msLeft, margins);
    follow(*plot_);
    follow(*heat_);
    follow(*calibration_);
    clear();
    restyle();
}

void StudyPlots::follow(QCustomPlot& plot) {
    connect(&plot, &QCustomPlot::mouseMove, this,
            [this](const QMouseEvent* event) { tell(cell_at(event->pos()), event->pos()); });
    connect(&plot, &QCustomPlot::mousePress, this, [this](const QMouseEvent* event) {
        if (event->button() != Qt::LeftButton || empty()) return;
        setFocus();
        choose(cell_at(event->pos()));
    });
}

QCustomPlot* StudyPlots::shown() const {
    if (!calibration_->isHidden()) return calibration_;
    return heat_->isHidden() ? plot_ : heat_;
}

StudyPlots::Panel StudyPlots::make_panel(int row) {
    Panel panel;
    panel.rect = add_titled_plot(*plot_, row, 0, {});
    QCPAxis* x = panel.rect->axis(QCPAxis::atBottom);
    QCPAxis* y = panel.rect->axis(QCPAxis::atLeft);
    panel.reference = plot_->addGraph(x, y);
    panel.runs = plot_->addGraph(x, y);
    panel.runs->setLineStyle(QCPGraph::lsNone);
    panel.means = plot_->addGraph(x, y);
    panel.spread = new QCPErrorBars(x, y);
    panel.spread->setDataPlottable(panel.means);
    panel.spread->setSymbolGap(0.0);
    panel.choice = new ChoiceLine(plot_);
    panel.choice->setClipAxisRect(panel.rect);
    for (QCPItemPosition* end : {panel.choice->point1, panel.choice->point2}) end->setAxes(x, y);
    return panel;
}

void StudyPlots::restyle() {
    style(colours());
    heat_->style(colours());
    calibration_->style(colours());
    for (QCustomPlot* plot : findChildren<QCustomPlot*>())
        plot->replot(QCustomPlot::rpQueuedReplot);
}

void StudyPlots::style(const Colours& c) {
    constexpr double kLine = 1.6;
    constexpr double kDot = 7.0;
    const QFont small = plot_font(font());
    plot_->setBackground(c.card);
    int row = 0;
    for (const Panel* panel : {&quality_, &landmarks_}) {
        const QColor colour = panel == &quality_ ? c.path : c.landmark;
        QColor faint = colour;
        faint.setAlpha(90);
        style_plot(*panel->rect, *title_of(*plot_, row++, 0), c, small);
        panel->means->setPen(QPen(colour, kLine));
        panel->means->setScatterStyle(
            QCPScatterStyle(QCPScatterStyle::ssDisc, colour, colour, kDot));
        panel->spread->setPen(QPen(colour, kLine));
        panel->runs->setScatterStyle(
            QCPScatterStyle(QCPScatterStyle::ssCircle, faint, Qt::transparent, kDot));
        panel->reference->setPen(QPen(c.muted, kLine, Qt::DashLine));
        panel->choice->setPen(QPen(c.accent, kLine, Qt::DotLine));
    }
}

void StudyPlots::clear() {
    cells_.clear();
    records_.clear();
    choice_->hide();
    heat_->hide();
    calibration_->hide();
    plot_->show();
    choose(std::nullopt);
    setFocusPolicy(Qt::NoFocus);
    for (const Panel* panel : {&quality_, &landmarks_}) {
        for (QCPGraph* graph : {panel->runs, panel->means, panel->reference})
            graph->data()->clear();
        panel->spread->data()->clear();
        for (QCPAxis* axis : panel->rect->axes()) axis->setTickLabels(false);
        panel->rect->axis(QCPAxis::atBottom)->setLabel({});
    }
    StudyPlan usual;
    usual.reference_lines = 1;
    quality_.measure = &quality_of(usual, {});
    show_titles({});
    plot_->replot(QCustomPlot::rpQueuedReplot);
}

void StudyPlots::lay_out_axis(const StudyPlan::Axis& axis) {
    constexpr std::size_t kMostNamed = 12;
    constexpr double kSlant = 20.0;
    x_ = study_abscissa(axis);
    const auto [least, greatest] = x_.range(kRoom);
    const bool named = !x_.numbers || (x_.logarithmic && x_.positions.size() <= kMostNamed);
    const QFontMetrics metrics(plot_font(font()));
    int widest = 0;
    for (const std::string& word : x_.words) {
        widest = std::max(widest, metrics.horizontalAdvance(QString::fromStdString(word)));
    }
    // Words that would not stand beside each other lean; the last one needs room of its own.
    const auto places = static_cast<int>(x_.words.size());
    const bool slanted = named && places * (widest + kGap) > plot_->width() - kLeft;
    const int right = !named ? kRight : std::max(kRight, slanted ? widest : widest / 2);
    for (const Panel* panel : {&quality_, &landmarks_}) {
        QCPAxis* bottom = panel->rect->axis(QCPAxis::atBottom);
        panel->rect->setMinimumMargins(QMargins(kLeft, kTop, right, kBottom));
        bottom->setScaleType(x_.logarithmic ? QCPAxis::stLogarithmic : QCPAxis::stLinear);
        if (named) {
            auto ticker = QSharedPointer<QCPAxisTickerText>::create();
            for (std::size_t i = 0; i < x_.positions.size(); ++i)
                ticker->addTick(x_.positions[i], QString::fromStdString(x_.words[i]));
            bottom->setTicker(ticker);
        } else if (x_.logarithmic) {
            bottom->setTicker(QSharedPointer<QCPAxisTickerLog>::create());
        } else {
            bottom->setTicker(QSharedPointer<QCPAxisTicker>::create());
        }
        bottom->setTickLabelRotation(slanted ? kSlant : 0.0);
        bottom->setRange(least, greatest);
        for (QCPAxis* each : panel->rect->axes()) each->setTickLabels(true);
    }
    landmarks_.rect->axis(QCPAxis::atBottom)
        ->setLabel(QString::fromStdString(study_axis_label(axis)).replace("^2", "²"));
}

void StudyPlots::show_titles(const StudyPlan& plan) {
    QString quality = title_words(*quality_.measure);
    if (quality_.measure->target)
        quality += tr("; dashed: %1, as it ought to be").arg(*quality_.measure->target);
    title_of(*plot_, 0, 0)->setText(quality);
    QString landmarks = title_words(*landmarks_.measure);
    if (plan.has_reference()) {
        landmarks +=
            tr("; dashed: %1 in the reference").arg(plan.reference_lines + plan.reference_corners);
    }
    title_of(*plot_, 1, 0)->setText(landmarks);
}

void StudyPlots::draw(const Panel& panel) {
    QVector<double> xs;
    QVector<double> means;
    QVector<double> deviations;
    double top = 0.0;
    for (std::size_t i = 0; i < cells_.size(); ++i) {
        const std::optional<Spread>& figures = cells_[i].figures[*panel.measure];
        if (!figures) continue;
        const double deviation = std::sqrt(figures->variance.value_or(0.0));
        xs << x_.positions[i];
        means << figures->mean;
        deviations << deviation;
        top = std::max({top, figures->maximum, figures->mean + deviation});
    }
    // Error bars go by place, so the order must be that of the graph.
    std::vector<qsizetype> order(static_cast<std::size_t>(xs.size()));
    for (std::size_t i = 0; i < order.size(); ++i) order[i] = static_cast<qsizetype>(i);
    std::sort(order.begin(), order.end(), [&](auto a, auto b) { return xs[a] < xs[b]; });
    QVector<double> sorted;
    for (const qsizetype i : order) sorted << deviations[i];
    panel.means->setData(xs, means);
    panel.spread->setData(sorted);
    for (const auto& point : *panel.reference->data()) top = std::max(top, point.value);
    panel.rect->axis(QCPAxis::atLeft)->setRange(0.0, top > 0.0 ? top * (1.0 + kRoom) : 1.0);
}

void StudyPlots::show_results(const StudyPlan& plan, const std::vector<StudyRecord>& records) {
    plan_ = plan;
    records_ = records;
    cells_ = summarize(plan, records);
    for (std::size_t run = 0; run < records.size(); ++run) {  // those still to come have not failed
        if (!records[run].ok && records[run].problem.empty()) --cells_[plan.cell_of(run)].failed;
    }
    setFocusPolicy(Qt::StrongFocus);
    show_figures();
}

std::vector<const Measure*> StudyPlots::qualities() const {
    std::vector<const Measure*> offered;
    for (const Measure* measure : taken_measures()) {
        if (measure->plot.empty() || measure == landmarks_.measure) continue;
        if (measure == quality_.measure || has_figures(cells_, *measure))
            offered.push_back(measure);
    }
    return offered;
}

void StudyPlots::show_quality(const Measure& measure) {
    wanted_ = &measure;
    calibration_wanted_ = false;
    show_figures();
    choose(chosen_);  // its words have changed
}

void StudyPlots::show_calibration() {
    calibration_wanted_ = true;
    show_figures();
    choose(chosen_);
}

void StudyPlots::offer_qualities() {
    QStringList names;
    for (const Measure* measure : qualities()) names << axis_words(*measure);
    if (StudyCalibration::has(cells_)) names << tr("Calibration: expected and seen shares");
    const QSignalBlocker quiet(choice_);
    if (names != offered_) {  // else whoever has the list open keeps it
        offered_ = names;
        choice_->clear();
        choice_->addItems(names);
    }
    const bool last = shown() == calibration_;
    choice_->setCurrentIndex(
        static_cast<int>(last ? names.size() - 1 : names.indexOf(axis_words(*quality_.measure))));
    choice_->setVisible(names.size() > 1);
}

void StudyPlots::show_figures() {
    const bool has_wanted = wanted_ != nullptr && has_figures(cells_, *wanted_);
    quality_.measure = has_wanted ? wanted_ : &quality_of(plan_, cells_);
    const bool shares = calibration_wanted_ && StudyCalibration::has(cells_);
    const bool two = plan_.axes.size() > 1;
    plot_->setHidden(two || shares);
    heat_->setHidden(!two || shares);
    calibration_->setHidden(!shares);
    offer_qualities();
    if (!two) lay_out_axis(plan_.axes.front());  // arrow keys go by it
    if (shares) return calibration_->show_results(plan_, cells_);
    if (two) return heat_->show_results(plan_, cells_, *quality_.measure);
    show_titles(plan_);
    for (const Panel* panel : {&quality_, &landmarks_}) {
        panel->runs->data()->clear();
        for (std::size_t run = 0; run < records_.size(); ++run) {
            if (const auto& figure = records_[run].figures[*panel->measure])
                panel->runs->addData(x_.positions[plan_.cell_of(run)], *figure);
        }
    }
    const QCPRange range = landmarks_.rect->axis(QCPAxis::atBottom)->range();
    const auto level = [&](const Panel& panel, std::optional<double> value) {
        panel.reference->data()->clear();
        if (value) panel.reference->setData({range.lower, range.upper}, {*value, *value});
    };
    level(quality_, quality_.measure->target);
    level(landmarks_, plan_.has_reference()
                          ? std::optional<double>(plan_.reference_lines + plan_.reference_corners)
                          : std::nullopt);
    draw(quality_);
    draw(landmarks_);
    plot_->replot(QCustomPlot::rpQueuedReplot);
}

std::optional<std::size_t> StudyPlots::cell_at(const QPoint& place) const {
    constexpr double kNear = 24.0;
    if (shown() == heat_) return heat_->cell_at(place);
    if (shown() == calibration_) return calibration_->cell_at(place);
    for (const Panel* panel : {&quality_, &landmarks_}) {
        if (!panel->rect->rect().contains(place)) continue;
        const QCPAxis* bottom = panel->rect->axis(QCPAxis::atBottom);
        for (std::size_t i = 0; i < cells_.size(); ++i) {
            if (std::abs(bottom->coordToPixel(x_.positions[i]) - place.x()) <= kNear) return i;
        }
    }
    return std::nullopt;
}

QString StudyPlots::words_of_cell(std::size_t cell) const {
    const StudyCell& told = cells_[cell];
    QStringList lines{QString::fromStdString(plan_.cell_label(cell)),
                      tr("Runs: %1").arg(told.finished)};
    if (told.failed > 0) lines << tr("Failed: %1").arg(told.failed);
    if (shown() == calibration_) return (lines + StudyCalibration::words_of(told)).join('\n');
    for (const Panel* panel : {&quality_, &landmarks_}) {
        if (const auto& spread = told.figures[*panel->measure])
            lines << figure_words(*panel->measure, *spread);
    }
    return lines.join('\n');
}

void StudyPlots::tell(std::optional<std::size_t> cell, const QPoint& place) {
    if (!cell) return QToolTip::hideText();
    QToolTip::showText(shown()->mapToGlobal(place), words_of_cell(*cell), shown());
}

void StudyPlots::choose(std::optional<std::size_t> cell) {
    chosen_ = cell;
    setAccessibleDescription(cell ? words_of_cell(*cell) : QString());
    const bool one = cell && shown() == plot_;
    for (const Panel* panel : {&quality_, &landmarks_}) {
        panel->choice->setVisible(one);
        if (!one) continue;
        panel->choice->point1->setCoords(x_.positions[*cell], 0.0);
        panel->choice->point2->setCoords(x_.positions[*cell], 1.0);
    }
    heat_->choose(cell);
    calibration_->choose(cell);
    plot_->replot(QCustomPlot::rpQueuedReplot);
    emit choice_changed();
}

/// The cell next to the chosen one, which itself where there is none; at first the best.
std::optional<std::size_t> StudyPlots::beside(int across, int up) const {
    if (!chosen_) return best_cell(cells_, *quality_.measure).value_or(0);
    std::vector<std::size_t> places = plan_.places(*chosen_);
    if (places.size() > 1) {
        const auto moved = [&](std::size_t axis, int by) {
            const auto last = static_cast<std::ptrdiff_t>(plan_.axes[axis].values.size()) - 1;
            return static_cast<std::size_t>(std::clamp<std::ptrdiff_t>(
                static_cast<std::ptrdiff_t>(places[axis]) + by, 0, last));
        };
        return moved(0, across) * plan_.axes[1].values.size() + moved(1, up);
    }
    // Values need not be written in their order.
    std::size_t next = *chosen_;
    for (std::size_t i = 0; i < x_.positions.size(); ++i) {
        const auto ahead = [&](std::size_t cell) {
            return across * (x_.positions[cell] - x_.positions[*chosen_]);
        };
        if (ahead(i) > 0.0 && (next == *chosen_ || ahead(i) < ahead(next))) next = i;
    }
    return next;
}

void StudyPlots::keyPressEvent(QKeyEvent* event) {
    int across = 0;
    int up = 0;
    switch (event->key()) {
        case Qt::Key_Left:
            across = -1;
            break;
        case Qt::Key_Right:
            across = 1;
            break;
        case Qt::Key_Down:
            up = -1;
            break;
        case Qt::Key_Up:
            up = 1;
            break;
        case Qt::Key_Return:
        case Qt::Key_Enter:
            if (chosen_) emit use_wanted();
            return;
        default:
            return QWidget::keyPressEvent(event);
    }
    if (empty()) return;
    choose(beside(across, up));
    QPoint place =
        shown() == calibration_ ? calibration_->middle_of(*chosen_) : heat_->middle_of(*chosen_);
    if (shown() == plot_) {
        const QCPAxisRect* rect = quality_.rect;
        const double x = rect->axis(QCPAxis::atBottom)->coordToPixel(x_.positions[*chosen_]);
        place = QPoint(static_cast<int>(x), rect->center().y());
    }
    tell(chosen_, place);
}

void StudyPlots::paintEvent(QPaintEvent* event) {
    QWidget::paintEvent(event);
    if (!hasFocus()) return;
    QPainter painter(this);
    painter.setPen(colours().accent);
    painter.drawRect(rect().adjusted(0, 0, -1, -1));
}

Exportable StudyPlots::exportable() {
    return {tr("Study"), "study", plot_font(font()), {figure_of(*shown(), [this](const Colours& c) {
                if (shown() == heat_) return heat_->style(c);
                if (shown() == calibration_) return calibration_->style(c, &c == &colours());
                style(c);
            })}};
}

int StudyPlots::means() const {
    const auto known = [this](const StudyCell& cell) {
        return cell.figures[*quality_.measure].has_value();
    };
    return static_cast<int>(std::ranges::count_if(cells_, known));
}

QString StudyPlots::quality_title() const {
    return title_of(*plot_, 0, 0)->text();
}

void StudyPlots::contextMenuEvent(QContextMenuEvent* event) {
    if (empty()) return;
    auto* menu = new QMenu(this);
    menu->setAttribute(Qt::WA_DeleteOnClose);
    menu->addAction(tr("Copy picture"), this, [this] { copy(exportable().offers.front()); });
    menu->addAction(tr("Save as image…"), this, &StudyPlots::picture_wanted);
    menu->popup(event->globalPos());
}

}  // namespace hitos::window
