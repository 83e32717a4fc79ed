// SPDX-License-Identifier: GPL-3.0-or-later
#include "disturb_bar.hpp"

#include <QComboBox>
#include <QCoreApplication>
#include <QDoubleSpinBox>
#include <QHBoxLayout>
#include <QLabel>
#include <QPushButton>
#include <cmath>

#include "look/named.hpp"

namespace hitos::window {
namespace {

QString translated(std::string_view text) {
    return QCoreApplication::translate("Disturbance", std::string(text).c_str());
}

bool of_doors(DisturbanceKind kind) {
    return kind == DisturbanceKind::open || kind == DisturbanceKind::close;
}

}  // namespace

DisturbBar::DisturbBar(QWidget* parent) : QWidget(parent) {
    auto* row = new QHBoxLayout(this);
    row->setContentsMargins(0, 0, 0, 0);
    kinds_ = named(new QComboBox(this), "disturbance");
    kinds_->setAccessibleName(tr("What happens"));
    row->addWidget(kinds_);
    for (std::size_t i = 0; i < values_.size(); ++i) {
        names_[i] = new QLabel(this);
        values_[i] = new QDoubleSpinBox(this);
        values_[i]->setObjectName(QStringLiteral("disturbance_value_%1").arg(i));
        values_[i]->setDecimals(2);
        row->addWidget(names_[i]);
        row->addWidget(values_[i]);
    }
    auto* now = named(new QPushButton(tr("Now"), this), "button_disturb");
    now->setAutoDefault(false);
    now->setToolTip(tr("Let it happen to the robot now"));
    row->addWidget(now);
    row->addStretch(1);
    connect(kinds_, &QComboBox::currentIndexChanged, this, &DisturbBar::offer_values);
    connect(now, &QPushButton::clicked, this, [this] { emit wanted(chosen()); });
    set_tour(nullptr);
}

void DisturbBar::set_tour(const std::shared_ptr<const SimulatedTour>& tour) {
    tour_ = tour;
    offer_kinds();
    setEnabled(tour_ != nullptr);
}

/// A world without doors has none to open.
void DisturbBar::offer_kinds() {
    const int before = kinds_->currentData().toInt();
    kinds_->clear();
    for (std::size_t i = 0; i < kDisturbances.size(); ++i) {
        const bool doors = tour_ && !tour_->world().doors.empty();
        if (of_doors(static_cast<DisturbanceKind>(i)) && !doors) continue;
        kinds_->addItem(translated(kDisturbances[i].label), static_cast<int>(i));
        kinds_->setItemData(kinds_->count() - 1, translated(kDisturbances[i].meaning),
                            Qt::ToolTipRole);
    }
    kinds_->setCurrentIndex(std::max(0, kinds_->findData(before)));
    offer_values();
}

void DisturbBar::offer_values() {
    const Disturbance empty = chosen();
    const DisturbanceFacts& facts = empty.facts();
    kinds_->setToolTip(translated(facts.meaning));
    for (std::size_t i = 0; i < values_.size(); ++i) {
        const bool used = i < facts.count;
        names_[i]->setVisible(used);
        values_[i]->setVisible(used);
        if (!used) continue;
        const DisturbanceValue& value = facts.values[i];
        names_[i]->setText(translated(value.name));
        values_[i]->setAccessibleName(names_[i]->text());
        values_[i]->setRange(value.least, value.greatest);
        values_[i]->setValue(value.usual);
    }
    if (of_doors(empty.kind) && tour_) {
        values_[0]->setRange(1.0, static_cast<double>(tour_->world().doors.size()));
    }
    if (empty.kind == DisturbanceKind::box && tour_) {  // in the robot's way
        constexpr double kAhead = 1.0;
        const Pose robot = tour_->pose_now();
        values_[0]->setValue(robot.x + kAhead * std::cos(robot.theta));
        values_[1]->setValue(robot.y + kAhead * std::sin(robot.theta));
    }
}

Disturbance DisturbBar::chosen() const {
    Disturbance disturbance;
    disturbance.kind = static_cast<DisturbanceKind>(kinds_->currentData().toInt());
    for (std::size_t i = 0; i < values_.size(); ++i) disturbance.values[i] = values_[i]->value();
    for (std::size_t i = disturbance.facts().count; i < disturbance.values.size(); ++i) {
        disturbance.values[i] = 0.0;
    }
    return disturbance;
}

}  // namespace hitos::window
