#include "hint_bar.hpp"

#include <QHBoxLayout>
#include <QLabel>
#include <QPushButton>
#include <algorithm>

#include "dialogs/parameter_text.hpp"
#include "hitos/workbench/presets.hpp"

namespace hitos::window {

HintBar::HintBar(QWidget* parent) : QFrame(parent) {
    setProperty("role", "card");
    auto* row = new QHBoxLayout(this);
    row->setContentsMargins(12, 6, 8, 6);
    row->setSpacing(8);
    text_ = new QLabel;
    text_->setObjectName("hint_text");
    text_->setTextFormat(Qt::PlainText);
    text_->setWordWrap(true);
    row->addWidget(text_, 1);
    use_ = new QPushButton;
    use_->setObjectName("hint_use");
    row->addWidget(use_);
    auto* close = new QPushButton(tr("Close"));
    close->setObjectName("hint_close");
    row->addWidget(close);
    for (QPushButton* button : {use_, close}) button->setFocusPolicy(Qt::TabFocus);
    connect(use_, &QPushButton::clicked, this, [this] { emit preset_wanted(preset_); });
    connect(close, &QPushButton::clicked, this, [this] {
        closed_ = text_->text();
        hide();
    });
    hide();
}

void HintBar::set_session(Session& session) {
    connect(&session, &Session::configuration_changed, this, [this, &session] {
        closed_.clear();
        look(session);
    });
    connect(&session, &Session::snapshot_changed, this, [this, &session] {
        if (const auto snapshot = session.snapshot(); snapshot && !snapshot->advice.empty())
            show_advice(snapshot->advice);
    });
}

/// What can be said before the first scan.
void HintBar::look(const Session& session) {
    hide();
    if (!session.has_source()) return;
    // The run is new and at rest: the answer comes at once.
    show_advice(
        session.worker()->with_run([](const Algoritmo& run) { return run.advice(); }).get());
}

void HintBar::show_advice(const std::vector<Advice>& advice) {
    const auto mends =
        std::ranges::find_if(advice, [](const Advice& reason) { return !reason.preset.empty(); });
    if (mends == advice.end()) return;
    const QString words =
        translated("Advice", mends->text).arg(QString::fromStdString(mends->figure));
    if (words == closed_) return;
    preset_ = mends->preset;
    text_->setText(words);
    use_->setText(tr("Use “%1”").arg(translated("Preset", find_preset(preset_).label)));
    show();
}

}  // namespace hitos::window
