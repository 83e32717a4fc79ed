// SPDX-License-Identifier: GPL-3.0-or-later
#include "error_strip.hpp"

#include <qcustomplot.h>

#include <QCheckBox>
#include <QComboBox>
#include <QContextMenuEvent>
#include <QHBoxLayout>
#include <QLabel>
#include <QMenu>
#include <QPushButton>
#include <QVBoxLayout>
#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "hitos/services/files/tour_time.hpp"
#include "look/named.hpp"
#include "look/words_of.hpp"
#include "run_list.hpp"
#include "views/plot_style.hpp"

namespace hitos::window {
namespace {

constexpr double kRelativeWay = 1.0;  // [m]

QString words_of_side(const ErrorStrip::Side& side) {
    const auto& [absolute, relative, errors, begin, reference] = side.figures;
    if (!absolute) return side.name + ": " + side.problem;
    QString words = ErrorStrip::tr("%1: ATE %2 (RMSE, aligned), mean %3, greatest %4")
                        .arg(side.name, metre_words(absolute->rmse_m),
                             metre_words(absolute->mean_m), metre_words(absolute->maximum_m));
    words +=
        absolute->heading_rmse_rad
            ? ErrorStrip::tr("; heading %1 (RMSE)").arg(degree_words(*absolute->heading_rmse_rad))
            : ErrorStrip::tr("; the reference has no headings");
    if (relative) {
        words += ErrorStrip::tr("; RPE per metre %1, %2 (RMSE)")
                     .arg(metre_words(relative->translation_m.rmse),
                          degree_words(relative->rotation_rad.rmse));
    }
    return words + ErrorStrip::tr("; poses compared: %1").arg(absolute->poses);
}

}  // namespace

double PathFigures::greatest_m() const {
    double greatest = 0.0;
    for (const PathError& error : errors) greatest = std::max(greatest, error.error_m);
    return greatest;
}

PathFigures path_figures(const Trajectory& path, const std::vector<SecondTour>& later_tours,
                         const Trajectory& reference, bool aligned) {
    PathFigures figures;
    const Trajectory known = in_one_frame(path, later_tours);
    figures.absolute = trajectory_error(known, reference);
    if (!figures.absolute) return figures;
    figures.relative = relative_error(known, reference, {PairSpacing::By::distance, kRelativeWay});
    // Without headings the first pose says nothing of how the frames lie.
    aligned = aligned || !figures.absolute->heading_rmse_rad;
    const std::optional<Pose> laid = aligned
                                         ? std::optional(figures.absolute->pose_reference_estimate)
                                         : first_alignment(known, reference);
    figures.errors = path_errors(path, reference, laid);
    std::erase_if(figures.errors,
                  [&](const PathError& error) { return lies_beside(later_tours, error.pose); });
    figures.begin_s = path.front().time_s;
    const std::vector<double> seconds = tour_seconds(path);
    for (PathError& error : figures.errors) error.time_s = figures.begin_s + seconds[error.pose];
    if (!laid) return figures;
    const Pose pose_estimate_reference = inverse(*laid);
    figures.reference.reserve(reference.size());
    for (const StampedPose& stamped : reference) {
        const Pose pose = compose(pose_estimate_reference, stamped.pose);
        figures.reference.emplace_back(pose.x, pose.y);
    }
    return figures;
}

ErrorStrip::ErrorStrip(QWidget* parent) : QWidget(parent), plot_(new QCustomPlot(this)) {
    setObjectName("compare_figures");
    auto* column = new QVBoxLayout(this);
    column->setContentsMargins(0, 0, 0, 0);
    column->setSpacing(4);
    column->addWidget(make_tools());
    make_plot();
    column->addWidget(plot_);
    make_curves(0);
}

/// A curve and a line of words for each.
void ErrorStrip::make_curves(std::size_t count) {
    while (curves_.size() > count) {
        plot_->removeGraph(curves_.back());  // with its entry of the legend
        curves_.pop_back();
        delete words_.back();
        words_.pop_back();
    }
    while (curves_.size() < count) {
        QCPGraph* curve =
            plot_->addGraph(rect_->axis(QCPAxis::atBottom), rect_->axis(QCPAxis::atLeft));
        curve->addToLegend(legend_);
        curves_.push_back(curve);
        auto* words = named(new QLabel(this), QString("figures_%1").arg(words_.size()));
        words->setTextFormat(Qt::PlainText);
        words->setWordWrap(true);
        words->setMinimumHeight(fontMetrics().lineSpacing());
        layout()->addWidget(words);
        words_.push_back(words);
    }
    restyle();
}

QWidget* ErrorStrip::make_tools() {
    auto* tools = new QWidget(this);
    auto* row = new QHBoxLayout(tools);
    row->setContentsMargins(0, 0, 0, 0);
    along_ = named(new QComboBox(tools), "figures_along");
    along_->setAccessibleName(tr("Error along"));
    along_->addItems({tr("Over time"), tr("By way")});
    connect(along_, &QComboBox::currentIndexChanged, this, &ErrorStrip::draw);
    aligned_ = named(new QCheckBox(tr("Aligned"), tools), "figures_aligned");
    aligned_->setToolTip(
        tr("Each path is laid over the reference as well as possible, as for the ATE, and the maps "
           "over the left one likewise; else so that the first poses agree"));
    aligned_->setChecked(true);
    connect(aligned_, &QCheckBox::toggled, this, &ErrorStrip::alignment_changed);
    auto* picture = new QPushButton(tr("Save plot…"), tools);
    connect(picture, &QPushButton::clicked, this, [this] { emit picture_wanted(exportable()); });
    row->addWidget(along_);
    row->addWidget(aligned_);
    row->addStretch(1);
    row->addWidget(picture);
    return tools;
}

void ErrorStrip::make_plot() {
    constexpr int kHeight = 150;
    plot_->setFixedHeight(kHeight);
    plot_->plotLayout()->clear();
    plot_->plotLayout()->setRowSpacing(2);
    leave_menu_to_parent(*plot_);
    rect_ = add_titled_plot(*plot_, 0, 0, tr("Distance from the reference [m]"));
    for (QCPAxis* axis : rect_->axes()) axis->ticker()->setTickCount(4);
    legend_ = new QCPLegend;  // below, where no curve is
    plot_->plotLayout()->addElement(2, 0, legend_);
    plot_->plotLayout()->setRowStretchFactor(2, 0.01);
    legend_->setLayer("legend");
    legend_->setFillOrder(QCPLayoutGrid::foColumnsFirst);
    legend_->setMargins(QMargins(40, 0, 4, 2));
}

bool ErrorStrip::aligned() const {
    return aligned_->isChecked();
}

void ErrorStrip::show_sides(std::vector<Side> sides) {
    sides_ = std::move(sides);
    make_curves(sides_.size());
    for (std::size_t side = 0; side < sides_.size(); ++side) {
        words_[side]->setText(words_of_side(sides_[side]));
        curves_[side]->setName(sides_[side].name);
    }
    draw();
}

void ErrorStrip::draw() {
    constexpr double kRoom = 1.1;
    const bool by_way = along_->currentIndex() == 1;
    double begin_s = std::numeric_limits<double>::infinity();
    for (const Side& side : sides_) {
        if (!side.figures.errors.empty()) begin_s = std::min(begin_s, side.figures.begin_s);
    }
    double length = 0.0;
    double top = 0.0;
    for (std::size_t side = 0; side < sides_.size(); ++side) {
        QVector<double> xs;
        QVector<double> ys;
        for (const PathError& error : sides_[side].figures.errors) {
            xs << (by_way ? error.way_m : error.time_s - begin_s);
            ys << error.error_m;
            length = std::max(length, xs.back());
        }
        curves_[side]->setData(xs, ys);
        top = std::max(top, sides_[side].figures.greatest_m());
    }
    const bool any = std::isfinite(begin_s);
    for (QWidget* shown : {along_->parentWidget(), static_cast<QWidget*>(plot_)})
        shown->setVisible(any);
    QCPAxis* bottom = rect_->axis(QCPAxis::atBottom);
    bottom->setLabel(by_way ? tr("Way [m]") : tr("Time [s]"));
    bottom->setRange(0.0, length > 0.0 ? length : 1.0);
    rect_->axis(QCPAxis::atLeft)->setRange(0.0, top > 0.0 ? kRoom * top : 1.0);
    plot_->replot(QCustomPlot::rpQueuedReplot);
}

void ErrorStrip::restyle() {
    style(colours());
    plot_->replot(QCustomPlot::rpQueuedReplot);
}

void ErrorStrip::style(const Colours& c) {
    constexpr double kLine = 1.6;
    const QFont small = plot_font(font());
    plot_->setBackground(c.card);
    style_plot(*rect_, *title_of(*plot_, 0, 0), c, small);
    for (std::size_t side = 0; side < sides_.size(); ++side)
        curves_[side]->setPen(QPen(sides_[side].colour, kLine));
    legend_->setBorderPen(Qt::NoPen);
    legend_->setBrush(Qt::NoBrush);
    legend_->setFont(small);
    legend_->setTextColor(c.text);
    wrap_legend();
}

void ErrorStrip::show_legend(bool on) {
    for (QCPGraph* curve : curves_)
        on ? curve->addToLegend(legend_) : curve->removeFromLegend(legend_);
}

/// As many names beside each other as have room.
void ErrorStrip::wrap_legend() {
    constexpr int kAround = 60;  // of all
    constexpr int kSign = 44;    // of each, with what is free beside it
    const QFontMetrics metrics(legend_->font());
    int widest = 1;
    for (const Side& side : sides_)
        widest = std::max(widest, metrics.horizontalAdvance(side.name) + kSign);
    const int wrap = std::max(1, (plot_->width() - kAround) / widest);
    if (legend_->wrap() == wrap) return;
    legend_->setWrap(wrap);
    // What is there already is laid out anew.
    show_legend(false);
    show_legend(true);
}

void ErrorStrip::resizeEvent(QResizeEvent* event) {
    QWidget::resizeEvent(event);
    wrap_legend();
}

std::vector<QPointF> ErrorStrip::curve(std::size_t side) const {
    std::vector<QPointF> points;
    for (const QCPGraphData& point : *curves_[side]->data())
        points.emplace_back(point.key, point.value);
    return points;
}

Exportable ErrorStrip::exportable() {
    return {
        tr("Path errors"),
        "path-errors",
        font(),
        {figure_of(
            *plot_, [this](const Colours& c) { style(c); }, [this](bool on) { show_legend(on); })}};
}

void ErrorStrip::contextMenuEvent(QContextMenuEvent* event) {
    if (!plot_->isVisible()) return;
    auto* menu = new QMenu(this);
    menu->setAttribute(Qt::WA_DeleteOnClose);
    menu->addAction(tr("Copy picture"), this, [this] { copy(exportable().offers.front()); });
    menu->addAction(tr("Save as image…"), this, [this] { emit picture_wanted(exportable()); });
    menu->popup(event->globalPos());
}

}  // namespace hitos::window
