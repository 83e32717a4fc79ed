// SPDX-License-Identifier: GPL-3.0-or-later
#include "association_inspector.hpp"

#include <QHBoxLayout>
#include <QLabel>
#include <QSpinBox>
#include <QVBoxLayout>
#include <chrono>
#include <cmath>

#include "association_words.hpp"
#include "look/flow_layout.hpp"
#include "look/named.hpp"
#include "look/parameter_text.hpp"
#include "look/words_of.hpp"
#include "views/landmark_painter.hpp"

namespace hitos::window {
namespace {

constexpr int kPollMs = 15;

QString kind_words(FeatureKind kind) {
    return kind == FeatureKind::line ? AssociationInspector::tr("Line")
                                     : AssociationInspector::tr("Corner");
}

}  // namespace

FeatureModel::FeatureModel(QObject* parent)
    : FiguresModel({tr("No."), tr("Kind"), tr("Outcome"), tr("ρ / range"), tr("θ / bearing")},
                   parent) {}

void FeatureModel::set_features(const std::shared_ptr<const Snapshot>& snapshot,
                                std::vector<Association> associations) {
    change(static_cast<int>(associations.size()), [&] {
        snapshot_ = snapshot;
        associations_ = std::move(associations);
    });
}

std::pair<double, double> FeatureModel::values(int row) const {
    const Association& association = associations_[static_cast<std::size_t>(row)];
    const Observation& seen = snapshot_->observation;
    if (association.kind == FeatureKind::line) {
        const Recta& recta = seen.lines[association.observed].recta;
        return {recta.rho, recta.theta};
    }
    const Esquina& corner = seen.corners[association.observed];
    return {std::hypot(corner.x, corner.y), std::atan2(corner.y, corner.x)};
}

/// That the sensor told; -1 of all others.
std::int32_t FeatureModel::identity(const Association& association) const {
    if (association.kind == FeatureKind::line) return -1;
    return snapshot_->observation.identity(association.observed);
}

QVariant FeatureModel::key(int row, int column) const {
    const Association& association = associations_[static_cast<std::size_t>(row)];
    switch (column) {
        case number:
            return row;
        case kind:
            return static_cast<int>(association.kind);
        case first:
            return values(row).first;
        case second:
            return values(row).second;
        default:
            return outcome_words(association, snapshot_->best_map, snapshot_->steps);
    }
}

QString FeatureModel::text(int row, int column) const {
    const Association& association = associations_[static_cast<std::size_t>(row)];
    switch (column) {
        case number:
            return QString::number(row + 1);
        case kind:
            if (const std::int32_t named = identity(association); named >= 0)
                return tr("Landmark %1").arg(named);
            return kind_words(association.kind);
        case first:
            return metre_words(values(row).first);
        case second:
            return degree_words(values(row).second);
        default:
            return outcome_words(association, snapshot_->best_map, snapshot_->steps);
    }
}

CandidateModel::CandidateModel(QObject* parent)
    : FiguresModel({tr("Landmark"), tr("Standing"), tr("Distance"), tr("ν ρ / range"),
                    tr("ν θ / bearing"), tr("ln p")},
                   parent) {}

void CandidateModel::set_feature(const RecordedFeature* feature) {
    RecordedFeature next = feature == nullptr ? RecordedFeature() : *feature;
    change(static_cast<int>(next.compared.size()), [&] { feature_ = std::move(next); });
}

QVariant CandidateModel::key(int row, int column) const {
    const ComparedLandmark& compared = feature_.compared[static_cast<std::size_t>(row)];
    switch (column) {
        case landmark:
            return compared.landmark;
        case first:
            return std::abs(compared.innovation(0));
        case second:
            return std::abs(compared.innovation(1));
        case distance:
            return compared.mahalanobis_squared;
        case log_likelihood:
            return compared.log_likelihood;
        default:
            return static_cast<int>(compared.standing);
    }
}

QString CandidateModel::text(int row, int column) const {
    const ComparedLandmark& compared = feature_.compared[static_cast<std::size_t>(row)];
    switch (column) {
        case landmark:
            return compared.landmark < 0 ? "–" : QString::number(compared.landmark + 1);
        case first:
            return metre_words(compared.innovation(0));
        case second:
            return degree_words(compared.innovation(1));
        case distance:
            return QString::number(std::sqrt(compared.mahalanobis_squared), 'f', 2);
        case log_likelihood:
            return QString::number(compared.log_likelihood, 'f', 2);
        default:
            return standing_words(compared.standing);
    }
}

bool CandidateModel::strong(int row) const {
    return feature_.decision.outcome == Association::Outcome::matched &&
           feature_.decision.landmark >= 0 &&
           feature_.compared[static_cast<std::size_t>(row)].landmark == feature_.decision.landmark;
}

AssociationInspector::AssociationInspector(Session& session, QWidget* parent)
    : QWidget(parent),
      session_(session),
      feature_model_(new FeatureModel(this)),
      candidate_model_(new CandidateModel(this)) {
    auto* sides = new QHBoxLayout(this);
    sides->setContentsMargins(4, 4, 4, 4);
    auto* seen = new QVBoxLayout;
    sides->addLayout(seen, 1);
    auto* why = new QVBoxLayout;
    sides->addLayout(why, 1);
    constexpr int kWide = 640;
    stack_when_narrow(*this, *sides, kWide);
    of_particle_ = new QWidget(this);
    auto* row = new QHBoxLayout(of_particle_);
    row->setContentsMargins(0, 0, 0, 0);
    auto* label = new QLabel(tr("Of particle"), of_particle_);
    particle_ = named(new QSpinBox(of_particle_), "association_particle");
    particle_->setSpecialValueText(tr("the best"));
    particle_->setRange(-1, -1);
    label->setBuddy(particle_);
    row->addWidget(label);
    row->addWidget(particle_);
    row->addStretch(1);
    seen->addWidget(of_particle_);
    features_ = named(new FiguresTable(feature_model_, this), "feature_table");
    features_->setAccessibleName(tr("Features of the scan"));
    seen->addWidget(features_, 1);
    words_ = named(new QLabel(this), "association_words");
    words_->setWordWrap(true);
    words_->setTextFormat(Qt::PlainText);
    why->addWidget(words_);
    candidates_ = named(new FiguresTable(candidate_model_, this), "candidate_table");
    candidates_->setAccessibleName(tr("Landmarks it was compared with"));
    candidates_->sortByColumn(CandidateModel::distance, Qt::AscendingOrder);
    why->addWidget(candidates_, 1);
    timer_.setInterval(kPollMs);
    connect(&timer_, &QTimer::timeout, this, &AssociationInspector::poll);
    connect(&session, &Session::restarted, this, [this] {
        asked_ = {};
        record_of_ = 0;
    });
    connect(&session, &Session::snapshot_changed, this, &AssociationInspector::refresh);
    connect(&session, &Session::progress_changed, this, &AssociationInspector::ask);
    connect(particle_, &QSpinBox::valueChanged, this, &AssociationInspector::show_record);
    connect(features_, &FiguresTable::row_chosen, this, &AssociationInspector::choose);
    connect(candidates_, &FiguresTable::row_chosen, this, [this](int candidate) {
        const std::int32_t landmark =
            candidate_model_->feature().compared[static_cast<std::size_t>(candidate)].landmark;
        const auto snapshot = session_.snapshot();
        // Another particle's landmarks have numbers of their own.
        if (landmark < 0 || particle_->value() >= 0 || !snapshot || renumbered()) return;
        const auto place = static_cast<std::size_t>(landmark);
        if (place < snapshot->best_map.size()) emit landmark_chosen({snapshot->best_map[place]});
    });
}

void AssociationInspector::showEvent(QShowEvent* event) {
    QWidget::showEvent(event);
    refresh();
}

void AssociationInspector::hideEvent(QHideEvent* event) {
    QWidget::hideEvent(event);
    if (!isVisible()) emit feature_chosen(-1);
}

void AssociationInspector::refresh() {
    if (!isVisible()) return;
    const auto snapshot = session_.snapshot();
    if (!snapshot || snapshot->steps != record_of_) {
        record_ = nullptr;
        record_of_ = 0;
    }
    of_particle_->setVisible(has_particles(session_.configuration()));
    particle_->setMaximum(snapshot ? static_cast<int>(snapshot->hypotheses.size()) - 1 : -1);
    show_record();
    ask();
}

/// While the run goes on there is no time to weigh a scan again.
void AssociationInspector::ask() {
    if (!isVisible() || asked_.valid() || !session_.up_to_date()) return;
    const Progress progress = session_.progress();
    if (progress.state == Progress::State::running || progress.steps == record_of_) return;
    record_of_ = progress.steps;
    asked_ = session_.worker()->weighed();
    timer_.start();
}

void AssociationInspector::poll() {
    if (!asked_.valid()) {
        timer_.stop();
        return;
    }
    if (asked_.wait_for(std::chrono::seconds(0)) != std::future_status::ready) return;
    timer_.stop();
    try {
        record_ = asked_.get();
    } catch (const std::exception&) {
        record_ = nullptr;  // there is nothing to tell, most likely for want of memory
    }
    const auto snapshot = session_.snapshot();
    if (!snapshot || snapshot->steps != record_of_) record_ = nullptr;
    show_record();
    ask();
}

const std::vector<RecordedFeature>* AssociationInspector::recorded() const {
    const auto snapshot = session_.snapshot();
    if (!record_ || !snapshot) return nullptr;
    const auto chosen = static_cast<std::size_t>(particle_->value());
    const std::size_t number =
        particle_->value() < 0 ? record_->best : snapshot->hypotheses.at(chosen).from;
    return number < record_->hypotheses.size() ? &record_->hypotheses[number] : nullptr;
}

/// Whether what was weighed has other numbers than the map that is shown.
bool AssociationInspector::renumbered() const {
    const auto snapshot = session_.snapshot();
    return record_ && snapshot && record_->landmarks != snapshot->best_map.size();
}

void AssociationInspector::show_record() {
    const auto snapshot = session_.snapshot();
    std::vector<Association> associations;
    const std::vector<RecordedFeature>* features = recorded();
    if (snapshot && particle_->value() < 0) {
        associations = snapshot->associations;  // those of the best are always told
    } else if (features != nullptr) {
        for (const RecordedFeature& feature : *features) associations.push_back(feature.decision);
    }
    feature_model_->set_features(snapshot, std::move(associations));
    if (chosen_ >= feature_model_->rowCount()) choose(-1);
    features_->choose(chosen_);
    show_feature();
}

void AssociationInspector::choose(int feature) {
    chosen_ = feature < feature_model_->rowCount() ? feature : -1;
    features_->choose(chosen_);
    show_feature();
    emit feature_chosen(chosen_);
}

void AssociationInspector::show_feature() {
    if (chosen_ < 0) {
        words_->setText(tr("Choose a feature here, or click one in the scan."));
        candidate_model_->set_feature(nullptr);
        return;
    }
    const auto row = static_cast<std::size_t>(chosen_);
    const Association& association = feature_model_->associations()[row];
    const QString outcome = feature_model_->index(chosen_, FeatureModel::outcome).data().toString();
    QStringList lines{outcome + ". " + reason_words(association.reason)};
    const auto snapshot = session_.snapshot();
    if (snapshot && particle_->value() < 0 &&
        taken_in(association, snapshot->best_map, snapshot->steps)) {
        lines << tr("It was merged with an older landmark then: it is none of its own.");
    }
    const std::vector<RecordedFeature>* features = recorded();
    if (features == nullptr || row >= features->size()) {
        candidate_model_->set_feature(nullptr);
        lines << (session_.progress().state == Progress::State::running
                      ? tr("The numbers come when the run is stopped.")
                  : asked_.valid() ? tr("Weighing the scan again…")
                                   : tr("This run cannot go back to weigh the scan again."));
    } else {
        candidate_model_->set_feature(&(*features)[row]);
        if (renumbered()) {
            lines << tr(
                "Landmarks were merged at this scan: the numbers of those that it was "
                "compared with are of before.");
        }
        if (record_->log_p0) {
            lines << tr("p0, of a new landmark: ln p0 = %1").arg(*record_->log_p0, 0, 'f', 2);
        }
        if (record_->gate) {
            lines << tr("Gate: distance %1").arg(std::sqrt(*record_->gate), 0, 'f', 2);
        }
        if (record_->new_gate) {
            lines << tr("New from distance %1 on").arg(std::sqrt(*record_->new_gate), 0, 'f', 2);
        }
    }
    words_->setText(lines.join('\n'));
}

}  // namespace hitos::window
