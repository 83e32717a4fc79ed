// SPDX-License-Identifier: GPL-3.0-or-later
#include "pace_control.hpp"

#include <QAbstractItemView>
#include <QAction>
#include <QComboBox>
#include <QHBoxLayout>
#include <QLabel>
#include <QSettings>
#include <array>

#include "look/icons.hpp"
#include "look/named.hpp"

namespace hitos::window {
namespace {

constexpr const char* kPaceKey = "run/chosen_pace";
constexpr const char* kFullKey = "run/full_speed";

constexpr std::array kRunPaces = {
    Pace{Pace::Kind::recorded, 0.25},   Pace{Pace::Kind::recorded, 1.0},
    Pace{Pace::Kind::recorded, 2.0},    Pace{Pace::Kind::recorded, 4.0},
    Pace{Pace::Kind::recorded, 10.0},   Pace{Pace::Kind::recorded, 25.0},
    Pace{Pace::Kind::recorded, 100.0},  Pace{Pace::Kind::recorded, 250.0},
    Pace{Pace::Kind::recorded, 1000.0}, Pace{Pace::Kind::scans, 1.0},
    Pace{Pace::Kind::scans, 5.0},       Pace{Pace::Kind::scans, 20.0},
    Pace{Pace::Kind::scans, 100.0},
};
constexpr int kFirstChoice = 4;

constexpr int kFullSpeed = static_cast<int>(kRunPaces.size());  // behind the paces

QString in_words(const Pace& pace) {
    const QString rate = QString::number(pace.rate);
    return pace.kind == Pace::Kind::recorded ? PaceControl::tr("recorded × %1").arg(rate)
                                             : PaceControl::tr("%1 scans/s").arg(rate);
}

/// The slowest from the recorded one on that takes at most half a minute for the whole tour, as far
/// as there is one.
int pace_for(double duration_s) {
    constexpr double kPatience = 30.0;  // [s]
    int fastest = kFirstChoice;
    for (int i = 0; i < kFullSpeed; ++i) {
        const Pace& pace = kRunPaces.at(static_cast<std::size_t>(i));
        if (pace.kind != Pace::Kind::recorded || pace.rate < 1.0) continue;
        if (duration_s <= kPatience * pace.rate) return i;
        fastest = i;
    }
    return fastest;
}

}  // namespace

PaceControl::PaceControl(Session& session, QSettings& settings, QAction* full_speed,
                         QWidget* parent)
    : QWidget(parent), session_(session), settings_(settings), full_(full_speed) {
    auto* row = new QHBoxLayout(this);
    row->setContentsMargins(0, 0, 0, 0);
    row->setSpacing(4);
    auto* label = new QLabel(tr("Speed"), this);
    label->setProperty("role", "muted");
    row->addWidget(label);
    paces_ = named(new QComboBox(this), "pace");
    paces_->setToolTip(
        tr("How fast the run goes: against the time of the recording, in scans, or "
           "as fast as possible (Ctrl+Space)"));
    paces_->setAccessibleName(tr("Speed"));
    label->setBuddy(paces_);
    paces_->setSizeAdjustPolicy(QComboBox::AdjustToMinimumContentsLengthWithIcon);
    constexpr int kShown = 12;  // characters; the list has all
    paces_->setMinimumContentsLength(kShown);
    paces_->view()->setTextElideMode(Qt::ElideNone);
    for (const Pace& pace : kRunPaces) paces_->addItem(in_words(pace));
    paces_->addItem(icon(Glyph::full_speed), tr("maximum"));
    chosen_ = settings_.value(kPaceKey, -1).toInt();
    if (chosen_ >= kFullSpeed) chosen_ = -1;
    pace_ = chosen_ < 0 ? kFirstChoice : chosen_;
    row->addWidget(paces_);
    setFocusProxy(paces_);
    full_->setChecked(settings_.value(kFullKey, false).toBool());
    // Who chooses a pace wants it.
    connect(paces_, &QComboBox::activated, this, [this](int index) {
        if (index < kFullSpeed) settings_.setValue(kPaceKey, chosen_ = pace_ = index);
        full_->setChecked(index == kFullSpeed);
        apply();
    });
    connect(full_, &QAction::toggled, this, &PaceControl::apply);
    connect(&session, &Session::restarted, this, &PaceControl::take_suited);
    apply();
}

void PaceControl::set_full_speed(QSettings& settings) {
    settings.setValue(kFullKey, true);
}

void PaceControl::suit(double duration_s) {
    suited_ = pace_for(duration_s);
    if (session_.progress().steps == 0) take_suited();  // no run changes its pace by itself
}

void PaceControl::take_suited() {
    if (chosen_ >= 0 || suited_ < 0) return;
    pace_ = suited_;
    apply();
}

void PaceControl::apply() {
    const bool full = full_->isChecked();
    settings_.setValue(kFullKey, full);
    const int index = full ? kFullSpeed : pace_;
    paces_->setCurrentIndex(index);
    session_.set_pace(index == kFullSpeed ? Pace{} : kRunPaces.at(static_cast<std::size_t>(index)));
}

}  // namespace hitos::window
