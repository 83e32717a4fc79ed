// SPDX-License-Identifier: GPL-3.0-or-later
// Measuring with clicks in the views.
#pragma once

#include <vector>

#include "measurements.hpp"
#include "views/view_tool.hpp"

class QAction;

namespace hitos::window {

/// Two clicks make a distance, two walls or three clicks an angle. Draws what is measured, and what
/// the next click would measure.
class MeasureTool final : public ViewTool {
    Q_OBJECT

  public:
    /// Each action switches one quantity on, and with it the other one off.
    MeasureTool(Measurements& measurements, QAction* distance, QAction* angle, QObject* parent);

    bool takes_clicks() const override;
    void hover(const std::optional<PointedAt>& pointed) override;
    void click(const PointedAt& pointed) override;
    /// Drops the places picked; without any ends measuring.
    void escape() override;
    void paint(QPainter& painter, const Scene& scene) const override;

    /// Whether what is measured is drawn although no clicks are taken.
    void set_shown(bool on);

  signals:
    /// What the user is to do.
    void notice(QString text);

  private:
    void begin();
    Quantity wanted() const;
    void paint_row(QPainter& painter, const Scene& scene, const MeasuredRow& row,
                   bool strong) const;
    void paint_picking(QPainter& painter, const Scene& scene) const;

    Measurements& measurements_;
    QAction* distance_;
    QAction* angle_;
    bool shown_ = false;
    std::vector<PickedPlace> picked_;
    std::optional<PickedPlace> hovered_;
};

}  // namespace hitos::window
