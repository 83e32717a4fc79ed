#include "pace_control.hpp"

#include <QAction>
#include <QComboBox>
#include <QHBoxLayout>
#include <QSettings>
#include <QToolButton>
#include <array>

#include "look/icons.hpp"

namespace hitos::window {
namespace {

constexpr const char* kPaceKey = "run/pace";
constexpr const char* kFullKey = "run/full_speed";

constexpr std::array kRunPaces = {
    Pace{Pace::Kind::recorded, 0.25},  Pace{Pace::Kind::recorded, 1.0},
    Pace{Pace::Kind::recorded, 2.0},   Pace{Pace::Kind::recorded, 4.0},
    Pace{Pace::Kind::recorded, 10.0},  Pace{Pace::Kind::recorded, 25.0},
    Pace{Pace::Kind::recorded, 100.0}, Pace{Pace::Kind::scans, 1.0},
    Pace{Pace::Kind::scans, 5.0},      Pace{Pace::Kind::scans, 20.0},
    Pace{Pace::Kind::scans, 100.0},
};
constexpr int kFirstChoice = 4;

QString in_words(const Pace& pace) {
    const QString rate = QString::number(pace.rate);
    return pace.kind == Pace::Kind::recorded ? PaceControl::tr("recorded × %1").arg(rate)
                                             : PaceControl::tr("%1 scans/s").arg(rate);
}

}  // namespace

PaceControl::PaceControl(Session& session, QSettings& settings, QAction* full_speed,
                         QWidget* parent)
    : QWidget(parent), session_(session), settings_(settings), full_(full_speed) {
    auto* row = new QHBoxLayout(this);
    row->setContentsMargins(0, 0, 0, 0);
    row->setSpacing(4);
    paces_ = new QComboBox(this);
    paces_->setObjectName("pace");
    paces_->setToolTip(tr("How fast the run goes: against the time of the recording, or in scans"));
    paces_->setAccessibleName(tr("Pace"));
    for (const Pace& pace : kRunPaces) paces_->addItem(in_words(pace));
    const int saved = settings_.value(kPaceKey, kFirstChoice).toInt();
    paces_->setCurrentIndex(saved >= 0 && saved < paces_->count() ? saved : kFirstChoice);
    row->addWidget(paces_);
    full_->setIcon(icon(Glyph::full_speed));
    full_->setChecked(settings_.value(kFullKey, false).toBool());
    auto* full = new QToolButton(this);
    full->setObjectName("button_full_speed");
    full->setProperty("role", "view");
    full->setFocusPolicy(Qt::TabFocus);
    full->setDefaultAction(full_);
    row->addWidget(full);
    // Who chooses a pace wants it.
    connect(paces_, &QComboBox::activated, this, [this] {
        full_->setChecked(false);
        apply();
    });
    connect(full_, &QAction::toggled, this, &PaceControl::apply);
    apply();
}

void PaceControl::set_full_speed(QSettings& settings) {
    settings.setValue(kFullKey, true);
}

void PaceControl::apply() {
    const bool full = full_->isChecked();
    settings_.setValue(kPaceKey, paces_->currentIndex());
    settings_.setValue(kFullKey, full);
    session_.set_pace(full ? Pace{} : kRunPaces[static_cast<std::size_t>(paces_->currentIndex())]);
}

}  // namespace hitos::window
