// SPDX-License-Identifier: GPL-3.0-or-later
#include "run_until_dialog.hpp"

#include <QCheckBox>
#include <QDialogButtonBox>
#include <QDoubleSpinBox>
#include <QFormLayout>
#include <QLabel>
#include <QPushButton>
#include <QSettings>
#include <QSpinBox>
#include <QVBoxLayout>
#include <algorithm>

#include "look/named.hpp"
#include "look/parameter_text.hpp"
#include "look/theme.hpp"

namespace hitos::window {
namespace {

constexpr int kMostScans = 100'000'000;
constexpr double kMostSeconds = 1e6;
constexpr double kMostMetres = 1e5;

QString key_of(const QObject& widget) {
    return "run_until/" + widget.objectName();
}

}  // namespace

RunUntilDialog::RunUntilDialog(Session& session, QSettings& settings, QWidget* parent)
    : QDialog(parent), session_(session), settings_(settings) {
    setObjectName("run_until");
    setWindowTitle(tr("Run until"));
    auto* column = new QVBoxLayout(this);
    hint_ = named(new QLabel(tr("The run stops at the first of these that is met."), this), "hint");
    hint_->setWordWrap(true);
    column->addWidget(hint_);
    form_ = new QFormLayout;
    column->addLayout(form_);
    more_scans_ = count_box(kMostScans);
    scan_ = count_box(kMostScans);
    time_s_ = value_box(kMostSeconds, 10.0, 1, tr(" s"));
    neff_below_ = value_box(kMostScans, 5.0, 1, {});
    again_s_ = value_box(kMostSeconds, 5.0, 1, tr(" s"));
    error_m_ = value_box(kMostMetres, 0.1, 2, tr(" m"));
    more_ = add("more", tr("so many scans further"), more_scans_);
    to_scan_ = add("to_scan", tr("this scan is reached, forwards or back"), scan_);
    to_time_ = add("to_time", tr("this time of the tour is reached, forwards or back"), time_s_);
    neff_ = add("neff", tr("Neff falls below"), neff_below_);
    born_ = add("born", tr("a landmark is born"));
    again_ = add("again", tr("a landmark is seen again that was out of sight for"), again_s_);
    loop_ = add("loop", tr("registration closes a loop"));
    best_ = add("best", tr("another particle becomes the best"));
    error_ = add("error", tr("the position error exceeds"), error_m_);
    error_->setToolTip(tr("Against the reference trajectory; both begin at the same place."));
    auto* buttons = new QDialogButtonBox(QDialogButtonBox::Cancel, this);
    QPushButton* run = buttons->addButton(tr("Run"), QDialogButtonBox::AcceptRole);
    run->setObjectName("run_until_run");
    run->setDefault(true);
    column->addStretch(1);
    column->addWidget(buttons);
    connect(buttons, &QDialogButtonBox::accepted, this, &RunUntilDialog::accept);
    connect(buttons, &QDialogButtonBox::rejected, this, &QDialog::reject);
    recall();
    const auto withhold = [](QCheckBox* rule, const QString& reason) {
        rule->setChecked(false);
        rule->setEnabled(false);
        rule->setToolTip(reason);
    };
    if (!session_.references().trajectory) {
        withhold(error_, tr("There is no reference trajectory to measure against."));
    }
    if (!has_particles(session_.configuration())) {
        const QString reason =
            tr("%1 has no particles.").arg(algorithm_of(session_.configuration()));
        withhold(neff_, reason);
        withhold(best_, reason);
    }
}

QSpinBox* RunUntilDialog::count_box(int most) const {
    auto* box = new QSpinBox;
    box->setRange(1, most);
    box->setValue(100);
    return box;
}

QDoubleSpinBox* RunUntilDialog::value_box(double most, double step, int decimals,
                                          const QString& unit) const {
    auto* box = new QDoubleSpinBox;
    box->setDecimals(decimals);
    box->setRange(0.0, most);
    box->setSingleStep(step);
    box->setValue(10.0 * step);
    box->setSuffix(unit);
    return box;
}

QCheckBox* RunUntilDialog::add(const char* name, const QString& text, QAbstractSpinBox* value) {
    auto* chosen = named(new QCheckBox(text, this), QString("until_") + name);
    if (value != nullptr) {
        value->setObjectName(QString("value_") + name);
        value->setAccessibleName(text);
        value->setEnabled(false);
        connect(chosen, &QCheckBox::toggled, value, &QWidget::setEnabled);
        form_->addRow(chosen, value);
    } else {
        form_->addRow(chosen);
    }
    lines_.push_back({chosen, value});
    return chosen;
}

void RunUntilDialog::recall() {
    for (const Line& line : lines_) {
        line.chosen->setChecked(settings_.value(key_of(*line.chosen), false).toBool());
        if (line.value == nullptr) continue;
        const QVariant saved = settings_.value(key_of(*line.value));
        if (saved.isValid()) line.value->setProperty("value", saved);
    }
}

void RunUntilDialog::remember() const {
    for (const Line& line : lines_) {
        settings_.setValue(key_of(*line.chosen), line.chosen->isChecked());
        if (line.value != nullptr) {
            settings_.setValue(key_of(*line.value), line.value->property("value"));
        }
    }
}

StopRules RunUntilDialog::rules() const {
    StopRules rules;
    if (to_time_->isChecked()) rules.time_s = time_s_->value();
    if (neff_->isChecked()) rules.neff_below = neff_below_->value();
    rules.landmark_born = born_->isChecked();
    if (again_->isChecked()) rules.seen_again_after_s = again_s_->value();
    rules.loop_closed = loop_->isChecked();
    rules.best_changed = best_->isChecked();
    if (error_->isChecked()) rules.position_error_above_m = error_m_->value();
    return rules;
}

std::optional<quint64> RunUntilDialog::behind(quint64 now) const {
    std::optional<quint64> scan;
    if (to_scan_->isChecked()) scan = static_cast<quint64>(scan_->value());
    if (to_time_->isChecked()) {
        const std::vector<StepFigures> figures = session_.worker()->figures_since(0);
        const auto at =
            std::ranges::lower_bound(figures, time_s_->value(), {}, &StepFigures::time_s);
        if (at != figures.end()) {
            const auto place = static_cast<quint64>(at - figures.begin()) + 1;
            scan = scan ? std::min(*scan, place) : place;
        }
    }
    return scan && *scan <= now ? scan : std::nullopt;
}

void RunUntilDialog::accept() {
    remember();
    const quint64 now = session_.progress().steps;
    if (const auto scan = behind(now)) {
        session_.seek(*scan);
    } else if (session_.progress().state == Progress::State::finished) {
        hint_->setText(
            tr("The tour is over: only scans and times before its end can be reached. "
               "Go back on the time line, or restart, for the others."));
        set_look(*hint_, "role", "error");
        return;
    } else {
        StopRules wanted = rules();
        const auto end_at = [&wanted](quint64 last) {
            wanted.scan = wanted.scan ? std::min<std::uint64_t>(*wanted.scan, last) : last;
        };
        if (more_->isChecked()) end_at(now + static_cast<quint64>(more_scans_->value()));
        if (to_scan_->isChecked()) end_at(static_cast<quint64>(scan_->value()));
        session_.run(wanted);
    }
    QDialog::accept();
}

}  // namespace hitos::window
