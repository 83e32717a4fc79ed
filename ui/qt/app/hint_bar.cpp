// SPDX-License-Identifier: GPL-3.0-or-later
#include "hint_bar.hpp"

#include <QHBoxLayout>
#include <QLabel>
#include <QPushButton>
#include <algorithm>

#include "hitos/workbench/presets.hpp"
#include "look/named.hpp"
#include "look/parameter_text.hpp"
#include "look/words_of.hpp"

namespace hitos::window {

HintBar::HintBar(QWidget* parent) : QFrame(parent) {
    setProperty("role", "card");
    auto* row = new QHBoxLayout(this);
    row->setContentsMargins(12, 6, 8, 6);
    row->setSpacing(8);
    text_ = named(new QLabel, "hint_text");
    text_->setTextFormat(Qt::PlainText);
    text_->setWordWrap(true);
    row->addWidget(text_, 1);
    use_ = named(new QPushButton, "hint_use");
    row->addWidget(use_);
    auto* close = named(new QPushButton(tr("Close")), "hint_close");
    row->addWidget(close);
    for (QPushButton* button : {use_, close}) button->setFocusPolicy(Qt::TabFocus);
    connect(use_, &QPushButton::clicked, this, [this] { emit preset_wanted(preset_); });
    connect(close, &QPushButton::clicked, this, [this] {
        (text_->text() == doubt_ ? closed_doubt_ : closed_advice_) = text_->text();
        refresh();
    });
    hide();
}

void HintBar::set_session(Session& session) {
    connect(&session, &Session::configuration_changed, this, [this, &session] {
        closed_advice_.clear();
        look(session);
    });
    connect(&session, &Session::snapshot_changed, this, [this, &session] {
        if (const auto snapshot = session.snapshot(); snapshot && !snapshot->advice.empty())
            show_advice(snapshot->advice);
    });
}

/// What can be said before the first scan.
void HintBar::look(const Session& session) {
    advice_.clear();
    refresh();
    if (!session.has_source()) return;
    // The run is new and at rest: the answer comes at once.
    show_advice(
        session.worker()->with_run([](const Algoritmo& run) { return run.advice(); }).get());
}

void HintBar::show_advice(const std::vector<Advice>& advice) {
    const auto mends =
        std::ranges::find_if(advice, [](const Advice& reason) { return !reason.preset.empty(); });
    if (mends == advice.end()) return;
    advice_ = words_of(*mends);
    preset_ = mends->preset;
    refresh();
}

void HintBar::show_doubts(const std::vector<TourFinding>& findings) {
    doubt_.clear();
    closed_doubt_.clear();
    if (!findings.empty()) {
        doubt_ = tr("This recording looks wrong: %1").arg(words_of(findings.front()));
        if (findings.size() > 1) doubt_ += ' ' + tr("(and %1 more)").arg(findings.size() - 1);
    }
    refresh();
}

void HintBar::refresh() {
    const bool doubts = doubt_ != closed_doubt_;
    setVisible(doubts || advice_ != closed_advice_);
    if (isHidden()) return;
    text_->setText(doubts ? doubt_ : advice_);
    use_->setVisible(!doubts);
    if (!doubts) {
        use_->setText(tr("Use “%1”").arg(translated("Preset", find_preset(preset_).label)));
    }
}

}  // namespace hitos::window
