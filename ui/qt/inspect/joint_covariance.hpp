// SPDX-License-Identifier: GPL-3.0-or-later
// The joint covariance of pose and landmarks as a picture of its correlations.
#pragma once

#include <QWidget>
#include <memory>
#include <optional>

#include "look/theme.hpp"
#include "session/session.hpp"
#include "views/figure.hpp"

class QLabel;
class QPushButton;

namespace hitos::window {

/// Correlations from -1 to 1 in colours: the robot's three rows first, then two for every landmark
/// of the map, in its order, with lines between robot, lines and corners.
class CorrelationView final : public QWidget {
    Q_OBJECT

  public:
    explicit CorrelationView(QWidget* parent);

    /// One with a joint covariance, or null.
    void set_snapshot(const std::shared_ptr<const Snapshot>& snapshot);
    FigureOffer figure() const;

    struct Entry {
        Eigen::Index row = 0;
        Eigen::Index column = 0;
    };
    /// What is drawn at a point of the widget, and where an entry is drawn.
    std::optional<Entry> entry_at(const QPointF& point) const;
    QPointF place_of(const Entry& entry) const;
    /// Both values by name, their correlation and covariance.
    QString words(const Entry& entry) const;

  signals:
    /// The cursor has moved, or what is below it changed; empty where that is nothing.
    void pointed_at(QString words);
    void painted(double seconds);

  protected:
    void paintEvent(QPaintEvent* event) override;
    void mouseMoveEvent(QMouseEvent* event) override;
    void leaveEvent(QEvent* event) override;

  private:
    Picture picture(const FigureWish& wish) const;
    /// Where the square is drawn.
    QRectF square(const QSizeF& size) const;
    double left_margin() const;
    Eigen::Index rows() const { return correlation_.rows(); }
    void paint(QPainter& painter, const QSizeF& size, const Colours& colours) const;
    void paint_separators(QPainter& painter, const QRectF& box, const Colours& colours) const;
    void paint_names(QPainter& painter, const QRectF& box, const Colours& colours) const;
    void paint_legend(QPainter& painter, const QRectF& box, const Colours& colours) const;
    QString name_of(Eigen::Index row) const;
    bool is_angle(Eigen::Index row) const;
    void tell();

    std::shared_ptr<const Snapshot> snapshot_;
    Eigen::MatrixXd correlation_;
    Eigen::Index first_corner_ = 0;  // its row; the number of rows where there is none
    std::optional<QPointF> cursor_;
};

/// Follows the run while it can be seen; the joint covariance is part of the session's snapshots as
/// long. Says in words where the algorithm keeps none.
class JointCovariance final : public QWidget {
    Q_OBJECT

  public:
    JointCovariance(Session& session, QWidget* parent);

    CorrelationView& view() const { return *view_; }
    Exportable exportable() const;
    QSize sizeHint() const override;

  signals:
    void picture_wanted();

  protected:
    void showEvent(QShowEvent* event) override;
    void hideEvent(QHideEvent* event) override;

  private:
    void refresh();
    void want();

    Session& session_;
    CorrelationView* view_;
    QLabel* words_;
    QPushButton* save_;
    QPushButton* copy_;
};

}  // namespace hitos::window
