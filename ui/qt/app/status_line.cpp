// SPDX-License-Identifier: GPL-3.0-or-later
#include "status_line.hpp"

#include <QLabel>
#include <QStatusBar>
#include <algorithm>
#include <utility>

#include "hitos/workbench/presets.hpp"
#include "look/named.hpp"
#include "look/parameter_text.hpp"
#include "look/words_of.hpp"
#include "session/incoming_tour.hpp"
#include "views/canvas_view.hpp"

namespace hitos::window {
namespace {

constexpr int kNoticeMs = 6000;  // at the least, and of one that is longer to read more
constexpr int kLetterMs = 70;
constexpr qsizetype kKept = 4;
constexpr int kMargin = 6;

/// Room for what it may say; never less than before.
void widen(QLabel& label, const QString& longest) {
    const int needed = QFontMetrics(label.font()).horizontalAdvance(longest) + 2 * kMargin;
    label.setFixedWidth(std::max(needed, label.minimumWidth()));
}

QString preset_to_try(const Advice& advice) {
    return StatusLine::tr("Try Configuration → Presets → %1.")
        .arg(translated("Preset", find_preset(advice.preset).label));
}

QString status_words(const Advice& advice) {
    const QString words = words_of(advice);
    return advice.preset.empty() ? words : words + ' ' + preset_to_try(advice);
}

/// Why a run stopped by itself; empty where it did not.
QString status_words(const Progress& p) {
    switch (p.stopped_by) {
        case StopReason::none:
            return {};
        case StopReason::time:
            return StatusLine::tr("Stopped at the time asked for.");
        case StopReason::neff:
            return StatusLine::tr("Stopped: Neff fell to %1.").arg(p.statistics.neff, 0, 'f', 1);
        case StopReason::landmark_born:
            return StatusLine::tr("Stopped: a landmark was born.");
        case StopReason::seen_again:
            return StatusLine::tr("Stopped: a landmark was seen again.");
        case StopReason::loop_closed:
            return StatusLine::tr("Stopped: a loop was closed.");
        case StopReason::best_changed:
            return StatusLine::tr("Stopped: another particle is the best.");
        case StopReason::error:
            return StatusLine::tr("Stopped: the position error has passed its limit.");
    }
    return {};
}

}  // namespace

StatusLine::StatusLine(QStatusBar* bar, Session& session)
    : QObject(bar), session_(session), bar_(bar) {
    bar->setSizeGripEnabled(false);
    state_ = named(new QLabel, "status_state");
    state_->setContentsMargins(8, 2, 8, 2);
    bar->addPermanentWidget(state_);  // no message hides it
    place_ = named(new QLabel, "status_place");
    place_->setProperty("role", "muted");
    place_->setSizePolicy(QSizePolicy::Ignored, QSizePolicy::Preferred);
    bar->addWidget(place_, 1);
    skipped_ = add("status_skipped", tr("Skipped %1").arg(10000));
    scan_ = add("status_scan", tr("Scan %1 of %2").arg(99999).arg(99999));
    time_ = add("status_time", tr("Time %1 s").arg("10000.0"));
    speed_ = add("status_speed", tr("%1 steps/s").arg(10000));
    neff_ = add("status_neff", tr("Neff %1").arg("10000.0"));
    landmarks_ = add("status_landmarks", tr("Landmarks %1").arg(9999));
    skipped_->setTextInteractionFlags(Qt::LinksAccessibleByMouse | Qt::LinksAccessibleByKeyboard);
    skipped_->setFocusPolicy(Qt::TabFocus);
    skipped_->setToolTip(tr("List what is damaged"));
    connect(skipped_, &QLabel::linkActivated, this, &StatusLine::skipped_wanted);
    connect(bar, &QStatusBar::messageChanged, bar, &QWidget::setToolTip);
    connect(&session, &Session::progress_changed, this, &StatusLine::refresh);
    connect(&session, &Session::snapshot_changed, this, &StatusLine::show_advice);
    connect(&session, &Session::snapshot_changed, this, &StatusLine::show_find);
    refresh();
}

/// A label whose size does not change with its text: ten times a second the whole window would be
/// laid out anew.
QLabel* StatusLine::add(const char* name, const QString& longest) {
    auto* label = named(new QLabel, name);
    label->setContentsMargins(kMargin, 2, kMargin, 2);
    label->setFixedHeight(QFontMetrics(label->font()).height() + 6);
    widen(*label, longest);
    label->setAlignment(Qt::AlignLeft | Qt::AlignVCenter);
    bar_->addPermanentWidget(label);
    return label;
}

void StatusLine::set_total(std::optional<quint64> scans) {
    total_ = scans;
    if (scans) widen(*scan_, tr("Scan %1 of %2").arg(*scans).arg(*scans));
    refresh();
}

void StatusLine::show_place(QPointF world_m) {
    place_->setText(place_words(world_m));
}

void StatusLine::clear_place() {
    place_->clear();
}

void StatusLine::notice(const QString& text) {
    bar_->showMessage(text, std::max(kNoticeMs, kLetterMs * static_cast<int>(text.size())));
    said_.removeOne(text);
    said_.prepend(text);
    while (said_.size() > kKept) said_.removeLast();
    show_tool_tip();
}

void StatusLine::lasting(const QString& text) {
    bar_->showMessage(text);
}

void StatusLine::show_doubts(const std::vector<TourFinding>& findings) {
    QStringList sentences;
    for (const TourFinding& finding : findings) sentences << set_apart(words_of(finding));
    doubts_ = sentences.join('\n');
    refresh();
}

void StatusLine::show_reference_doubts(const std::vector<Advice>& doubts) {
    const bool told = !of_references_.isEmpty();
    QStringList sentences;
    for (const Advice& doubt : doubts) sentences << words_of(doubt);
    of_references_ = sentences.join('\n');
    if (!sentences.isEmpty() && !told) notice(sentences.front());
    refresh();
}

/// The reasons are long, and stand in the tool tip of the state.
void StatusLine::show_advice() {
    const std::shared_ptr<const Snapshot> snapshot = session_.snapshot();
    QStringList sentences;
    if (snapshot) {
        for (const Advice& advice : snapshot->advice) sentences << status_words(advice);
    }
    const QString said = sentences.join(' ');
    if (said == advice_) return;
    advice_ = said;
    refresh();
}

/// Of a tour that goes on with a map.
void StatusLine::show_find() {
    const std::shared_ptr<const Snapshot> snapshot = session_.snapshot();
    if (!snapshot || snapshot->later_tours.empty()) {
        found_.reset();
        return;
    }
    const SecondTour& tour = snapshot->later_tours.back();
    if (tour.found == std::exchange(found_, tour.found) || !found_) return;
    notice(
        tr("Found in the map after %1 m, at scan %2").arg(tour.way_m, 0, 'f', 1).arg(*found_ + 1));
}

/// What there is to doubt, and the last notices, which were perhaps not read in time.
void StatusLine::show_tool_tip() {
    QStringList parts;
    if (!warnings_.isEmpty()) parts << warnings_;
    if (!said_.isEmpty()) parts << tr("Said last:") + '\n' + said_.join('\n');
    state_->setToolTip(parts.join("\n\n"));
}

/// Of a tour that comes in how it stands with that.
QString StatusLine::running_words(const Progress& progress) const {
    const auto& tour = session_.incoming_tour();
    if (!tour || !session_.is_live()) return tr("Running");
    if (!tour->source().link().connected) return tr("Connection lost");
    const double behind_s = tour->waiting_s(progress.steps).value_or(0.0);
    if (behind_s >= LiveSource::kWorthSaying)
        return tr("Live, %1 s behind").arg(behind_s, 0, 'f', 0);
    const double silent_s = tour->silent_s();
    if (silent_s >= LiveSource::kWorthSaying)
        return tr("Live, no scan for %1 s").arg(silent_s, 0, 'f', 0);
    return tr("Live");
}

void StatusLine::refresh() {
    using State = Progress::State;
    const Progress p = session_.progress();
    if (!session_.has_source()) {
        state_->setText(tr("No data source"));
    } else if (p.state == State::ready) {
        state_->setText(tr("Ready"));
    } else if (p.state == State::running) {
        state_->setText(running_words(p));
    } else if (p.state == State::paused) {
        const auto& tour = session_.incoming_tour();
        const bool lost = tour && session_.is_live() && !tour->source().link().connected;
        state_->setText(lost                         ? tr("Stopped, connection lost")
                        : tour && session_.is_live() ? tr("Stopped, the tour goes on")
                                                     : tr("Stopped"));
    } else if (p.state == State::finished) {
        state_->setText(tr("End of the log"));
    } else {
        state_->setText(tr("Failed"));
    }
    if (p.stopped_by != std::exchange(stopped_by_, p.stopped_by) &&
        p.stopped_by != StopReason::none) {
        notice(status_words(p));
    }
    QStringList told{doubts_, of_references_, advice_};
    told.removeAll(QString());
    const QString warnings = told.join('\n');
    if (!warnings.isEmpty()) state_->setText(state_->text() + QString::fromUtf8(" ⚠"));
    warnings_ = warnings;
    show_tool_tip();
    state_->setProperty("role", p.state == State::failed ? "error" : "value");
    scan_->setText(total_ ? tr("Scan %1 of %2").arg(p.steps).arg(*total_)
                          : tr("Scan %1").arg(p.steps));
    time_->setText(tr("Time %1 s").arg(p.duration_s, 0, 'f', 1));
    // At the end it would be that of the last few steps.
    speed_->setText(p.steps_per_second <= 0.0 || p.state == State::finished
                        ? QString()
                        : tr("%1 steps/s").arg(p.steps_per_second, 0, 'f', 0));
    neff_->setVisible(has_particles(session_.configuration()));
    neff_->setText(tr("Neff %1").arg(p.statistics.neff, 0, 'f', 1));
    landmarks_->setText(tr("Landmarks %1").arg(p.lines + p.corners));
    landmarks_->setToolTip(tr("Lines %1, corners %2").arg(p.lines).arg(p.corners));
    skipped_->setVisible(p.skipped_lines > 0);
    skipped_->setText("<a href='skipped'>" + tr("Skipped %1").arg(p.skipped_lines) + "</a>");
}

}  // namespace hitos::window
