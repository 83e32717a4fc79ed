// SPDX-License-Identifier: GPL-3.0-or-later
// What one can do to the robot while it drives.
#pragma once

#include <QWidget>
#include <array>

#include "hitos/simulation/drive/simulated_tour.hpp"
#include "hitos/simulation/worlds/disturbance.hpp"

class QComboBox;
class QDoubleSpinBox;
class QLabel;

namespace hitos::window {

/// A kind of disturbance, its numbers, and a button that lets it happen: made from kDisturbances.
class DisturbBar final : public QWidget {
    Q_OBJECT

  public:
    explicit DisturbBar(QWidget* parent = nullptr);

    /// In which it would happen, for the numbers that are offered; null: nothing can happen.
    void set_tour(const std::shared_ptr<const SimulatedTour>& tour);
    Disturbance chosen() const;

  signals:
    void wanted(hitos::Disturbance disturbance);

  private:
    void offer_kinds();
    void offer_values();

    std::shared_ptr<const SimulatedTour> tour_;
    QComboBox* kinds_ = nullptr;
    std::array<QLabel*, 3> names_{};
    std::array<QDoubleSpinBox*, 3> values_{};
};

}  // namespace hitos::window
