// SPDX-License-Identifier: GPL-3.0-or-later
#include "joint_covariance.hpp"

#include <QCoreApplication>
#include <QHBoxLayout>
#include <QImage>
#include <QLabel>
#include <QMouseEvent>
#include <QPainter>
#include <QPushButton>
#include <QVBoxLayout>
#include <algorithm>
#include <array>
#include <cmath>

#include "hitos/base/thread_clock.hpp"
#include "look/flow_layout.hpp"
#include "look/named.hpp"
#include "look/parameter_text.hpp"
#include "views/canvas_paint.hpp"

namespace hitos::window {
namespace {

constexpr Eigen::Index kPoseRows = 3;
constexpr double kMargin = 6.0;
constexpr double kLegendWidth = 48.0;
constexpr int kShades = 255;  // an odd number: 0 has a colour of its own

/// From -1 over 0 to 1.
std::array<QRgb, kShades> shades_of(const Colours& colours) {
    std::array<QRgb, kShades> shades{};
    constexpr int kMiddle = kShades / 2;
    for (int i = 0; i < kShades; ++i) {
        const QColor& end = i < kMiddle ? colours.landmark : colours.robot;
        shades.at(static_cast<std::size_t>(i)) =
            mixed(colours.canvas, end, std::abs(i - kMiddle) / static_cast<double>(kMiddle)).rgb();
    }
    return shades;
}

std::size_t shade(double correlation) {
    if (!std::isfinite(correlation)) return kShades / 2;  // of a filter that has lost itself
    const double share = (std::clamp(correlation, -1.0, 1.0) + 1.0) / 2.0;
    return static_cast<std::size_t>(std::lround(share * (kShades - 1)));
}

/// 0 where a value is certain.
Eigen::MatrixXd correlations_of(const Eigen::MatrixXd& covariance) {
    Eigen::VectorXd by_sigma = covariance.diagonal();
    for (double& value : by_sigma) value = value > 0.0 ? 1.0 / std::sqrt(value) : 0.0;
    return by_sigma.asDiagonal() * covariance * by_sigma.asDiagonal();
}

QImage image_of_shades(const Eigen::MatrixXd& correlation, const Colours& colours) {
    const auto shades = shades_of(colours);
    const auto size = static_cast<int>(correlation.rows());
    QImage image(size, size, QImage::Format_RGB32);
    for (int row = 0; row < size; ++row) {
        for (int column = 0; column < size; ++column) {
            image.setPixel(column, row, shades.at(shade(correlation(row, column))));
        }
    }
    return image;
}

}  // namespace

CorrelationView::CorrelationView(QWidget* parent) : QWidget(parent) {
    setObjectName("correlation_view");
    setMouseTracking(true);
    setCursor(Qt::CrossCursor);
    setMinimumSize(200, 100);
    setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Expanding);
}

void CorrelationView::set_snapshot(const std::shared_ptr<const Snapshot>& snapshot) {
    snapshot_ = snapshot;
    correlation_ = snapshot ? correlations_of(snapshot->joint_covariance) : Eigen::MatrixXd();
    first_corner_ = rows();
    if (snapshot) {
        const auto corner = std::ranges::find(snapshot->best_map, FeatureKind::corner,
                                              [](const auto& landmark) { return landmark.kind(); });
        first_corner_ = kPoseRows + 2 * (corner - snapshot->best_map.begin());
    }
    tell();
    update();
}

double CorrelationView::left_margin() const {
    int widest = 0;
    for (const QString& name : {tr("Robot"), tr("Lines"), tr("Corners")}) {
        widest = std::max(widest, fontMetrics().horizontalAdvance(name));
    }
    return kMargin + widest + kMargin;
}

QRectF CorrelationView::square(const QSizeF& size) const {
    const double side = std::max(
        1.0, std::min(size.height() - 2 * kMargin, size.width() - left_margin() - kLegendWidth));
    return {left_margin(), kMargin, side, side};
}

std::optional<CorrelationView::Entry> CorrelationView::entry_at(const QPointF& point) const {
    const QRectF box = square(size());
    if (rows() == 0 || !box.contains(point)) return std::nullopt;
    const auto place = [&](double share) {
        const auto at = static_cast<Eigen::Index>(share * static_cast<double>(rows()));
        return std::clamp<Eigen::Index>(at, 0, rows() - 1);
    };
    return Entry{place((point.y() - box.top()) / box.height()),
                 place((point.x() - box.left()) / box.width())};
}

QPointF CorrelationView::place_of(const Entry& entry) const {
    const QRectF box = square(size());
    const double cell = box.width() / static_cast<double>(rows());
    return box.topLeft() + cell * QPointF(static_cast<double>(entry.column) + 0.5,
                                          static_cast<double>(entry.row) + 0.5);
}

bool CorrelationView::is_angle(Eigen::Index row) const {
    if (row < kPoseRows) return row == 2;
    return row < first_corner_ && (row - kPoseRows) % 2 == 1;
}

QString CorrelationView::name_of(Eigen::Index row) const {
    if (row < kPoseRows) {
        return tr("Robot") + ' ' + QStringList{"x", "y", "θ"}.at(static_cast<qsizetype>(row));
    }
    const Eigen::Index landmark = (row - kPoseRows) / 2;
    const bool second = (row - kPoseRows) % 2 == 1;
    const bool line = row < first_corner_;
    const QString name =
        QCoreApplication::translate("Landmarks", line ? "Line %1" : "Corner %1").arg(landmark + 1);
    const QString value = line ? (second ? "θ" : "ρ") : (second ? "y" : "x");
    return name + ' ' + value;
}

QString CorrelationView::words(const Entry& entry) const {
    const int angles = (is_angle(entry.row) ? 1 : 0) + (is_angle(entry.column) ? 1 : 0);
    const QString unit = QStringList{"m²", "m·rad", "rad²"}.at(angles);
    const double covariance = snapshot_->joint_covariance(entry.row, entry.column);
    return name_of(entry.row) + " – " + name_of(entry.column) + '\n' +
           tr("Correlation %1").arg(correlation_(entry.row, entry.column), 0, 'f', 3) + '\n' +
           tr("Covariance %1").arg(covariance, 0, 'g', 4) + ' ' + unit;
}

void CorrelationView::paint(QPainter& painter, const QSizeF& size, const Colours& colours) const {
    if (rows() == 0) return;
    const QRectF box = square(size);
    painter.setRenderHint(QPainter::SmoothPixmapTransform,
                          box.width() < static_cast<double>(rows()));
    painter.drawImage(box, image_of_shades(correlation_, colours));
    paint_separators(painter, box, colours);
    paint_names(painter, box, colours);
    paint_legend(painter, box, colours);
}

void CorrelationView::paint_separators(QPainter& painter, const QRectF& box,
                                       const Colours& colours) const {
    constexpr double kLeastCell = 5.0;  // pixels; finer lines would hide the colours
    const double cell = box.width() / static_cast<double>(rows());
    painter.setBrush(Qt::NoBrush);
    const auto draw = [&](Eigen::Index row, const QPen& pen) {
        const double way = cell * static_cast<double>(row);
        painter.setPen(pen);
        painter.drawLine(box.topLeft() + QPointF(way, 0.0), box.bottomLeft() + QPointF(way, 0.0));
        painter.drawLine(box.topLeft() + QPointF(0.0, way), box.topRight() + QPointF(0.0, way));
    };
    if (cell >= kLeastCell) {
        for (Eigen::Index row = kPoseRows + 2; row < rows(); row += 2) {
            draw(row, thin_pen(colours.border, 0.6));
        }
    }
    for (const Eigen::Index row : {kPoseRows, first_corner_}) {
        if (row < rows()) draw(row, thin_pen(colours.text, 1.2));
    }
    painter.setPen(thin_pen(colours.muted));
    painter.drawRect(box);
}

void CorrelationView::paint_names(QPainter& painter, const QRectF& box,
                                  const Colours& colours) const {
    struct Group {
        QString name;
        Eigen::Index from;
        Eigen::Index to;
    };
    const double cell = box.height() / static_cast<double>(rows());
    const double height = fontMetrics().height();
    double free = box.top();  // names of groups that are too small move down
    painter.setPen(colours.text);
    for (const Group& group :
         {Group{tr("Robot"), 0, kPoseRows}, Group{tr("Lines"), kPoseRows, first_corner_},
          Group{tr("Corners"), first_corner_, rows()}}) {
        if (group.from == group.to) continue;
        const double middle = box.top() + cell * static_cast<double>(group.from + group.to) / 2.0;
        const double top = std::max(free, middle - height / 2.0);
        painter.drawText(QRectF(0.0, top, box.left() - kMargin, height),
                         Qt::AlignRight | Qt::AlignVCenter, group.name);
        free = top + height;
    }
}

void CorrelationView::paint_legend(QPainter& painter, const QRectF& box,
                                   const Colours& colours) const {
    const QRectF bar(box.right() + 2 * kMargin, box.top(), 10.0, box.height());
    const auto shades = shades_of(colours);
    QLinearGradient gradient(bar.bottomLeft(), bar.topLeft());
    gradient.setColorAt(0.0, shades.front());
    gradient.setColorAt(0.5, shades.at(kShades / 2));
    gradient.setColorAt(1.0, shades.back());
    painter.setPen(thin_pen(colours.muted));
    painter.setBrush(gradient);
    painter.drawRect(bar);
    painter.setPen(colours.text);
    const double height = fontMetrics().height();
    const auto say = [&](const QString& text, double top) {
        painter.drawText(QRectF(bar.right() + kMargin, top, kLegendWidth, height),
                         Qt::AlignLeft | Qt::AlignVCenter, text);
    };
    say("1", bar.top());
    say("0", bar.center().y() - height / 2.0);
    say("−1", bar.bottom() - height);
}

Picture CorrelationView::picture(const FigureWish& wish) const {
    Picture picture;
    picture.size = size();
    picture.mm_per_point = wish.width_mm / width();
    picture.ground = wish.ground();
    picture.paint = [this, colours = wish.colours](QPaintDevice& device, double by) {
        QPainter painter(&device);
        painter.setRenderHint(QPainter::Antialiasing);
        painter.setFont(font());
        painter.scale(by, by);
        paint(painter, size(), *colours);
    };
    return picture;
}

FigureOffer CorrelationView::figure() const {
    FigureOffer offer;
    offer.width = width();
    offer.plain = true;
    offer.picture = [this](const FigureWish& wish) { return picture(wish); };
    return offer;
}

void CorrelationView::paintEvent(QPaintEvent* /*event*/) {
    const double begin = thread_seconds();
    QPainter painter(this);
    paint(painter, size(), colours());
    painter.end();
    emit painted(thread_seconds() - begin);
}

void CorrelationView::mouseMoveEvent(QMouseEvent* event) {
    cursor_ = event->position();
    tell();
}

void CorrelationView::leaveEvent(QEvent* event) {
    cursor_.reset();
    tell();
    QWidget::leaveEvent(event);
}

void CorrelationView::tell() {
    const auto entry = cursor_ ? entry_at(*cursor_) : std::nullopt;
    emit pointed_at(entry ? words(*entry) : QString());
}

JointCovariance::JointCovariance(Session& session, QWidget* parent)
    : QWidget(parent), session_(session) {
    auto* row = new QHBoxLayout(this);
    row->setContentsMargins(4, 4, 4, 4);
    view_ = new CorrelationView(this);
    view_->setAccessibleName(tr("Joint covariance"));
    row->addWidget(view_, 1);
    auto* column = new QVBoxLayout;
    row->addLayout(column, 1);  // beside the square, not at the far end
    constexpr int kWide = 480;
    stack_when_narrow(*this, *row, kWide);
    words_ = named(new QLabel(this), "joint_words");
    words_->setTextFormat(Qt::PlainText);
    words_->setWordWrap(true);
    words_->setAlignment(Qt::AlignLeft | Qt::AlignTop);
    words_->setMinimumWidth(fontMetrics().averageCharWidth() * 32);
    column->addWidget(words_, 1);
    save_ = named(new QPushButton(tr("Save as image…"), this), "joint_picture");
    copy_ = named(new QPushButton(tr("Copy picture"), this), "joint_copy");
    auto* buttons = new QHBoxLayout;
    buttons->addWidget(save_);
    buttons->addWidget(copy_);
    buttons->addStretch(1);
    column->addLayout(buttons);
    connect(save_, &QPushButton::clicked, this, &JointCovariance::picture_wanted);
    connect(copy_, &QPushButton::clicked, this, [this] { copy(view_->figure()); });
    connect(view_, &CorrelationView::painted, &session, &Session::note_cost);
    connect(view_, &CorrelationView::pointed_at, words_, [this](const QString& words) {
        words_->setText(words.isEmpty() ? tr("Point at an entry to read it.") : words);
    });
    connect(&session, &Session::snapshot_changed, this, &JointCovariance::refresh);
    // A snapshot holds what its run went back to: no view keeps that of a run which is gone.
    connect(&session, &Session::restarted, this, [this] { view_->set_snapshot(nullptr); });
}

Exportable JointCovariance::exportable() const {
    return {view_->accessibleName(), "joint-covariance", view_->font(), {view_->figure()}};
}

/// A square needs more height than a table.
QSize JointCovariance::sizeHint() const {
    return QWidget::sizeHint().expandedTo({560, 220});
}

void JointCovariance::showEvent(QShowEvent* event) {
    QWidget::showEvent(event);
    want();
    refresh();
}

void JointCovariance::hideEvent(QHideEvent* event) {
    QWidget::hideEvent(event);
    want();
}

void JointCovariance::want() {
    SnapshotParts parts = session_.parts();
    parts.joint_covariance = isVisible();
    session_.want(parts);
}

void JointCovariance::refresh() {
    if (!isVisible()) return;
    const auto snapshot = session_.snapshot();
    const bool there = snapshot && snapshot->joint_covariance.size() > 0;
    view_->setVisible(there);
    save_->setVisible(there);
    copy_->setVisible(there);
    view_->set_snapshot(there ? snapshot : nullptr);
    if (there) return;
    const bool none = snapshot && snapshot->parts.joint_covariance && snapshot->steps > 0;
    words_->setText(none ? tr("%1 keeps no joint covariance of pose and landmarks.")
                               .arg(algorithm_of(session_.configuration()))
                         : tr("It appears here once the algorithm runs."));
}

}  // namespace hitos::window
