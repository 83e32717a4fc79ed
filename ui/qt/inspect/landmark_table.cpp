// SPDX-License-Identifier: GPL-3.0-or-later
#include "landmark_table.hpp"

#include <QVBoxLayout>
#include <algorithm>
#include <cmath>
#include <span>

#include "hitos/services/files/tour_time.hpp"
#include "look/named.hpp"
#include "look/words_of.hpp"

namespace hitos::window {
namespace {

bool is_line(const ICaracteristica& landmark) {
    return landmark.kind() == FeatureKind::line;
}

/// The landmark's two values [m, rad] or [m, m].
std::pair<double, double> values_of(const ICaracteristica& landmark) {
    if (const auto* recta = std::get_if<Recta>(&landmark.value)) return {recta->rho, recta->theta};
    const auto& esquina = std::get<Esquina>(landmark.value);
    return {esquina.x, esquina.y};
}

double sigma(const ICaracteristica& landmark, int component) {
    return std::sqrt(std::max(landmark.covariance(component, component), 0.0));
}

double correlation_of(const ICaracteristica& landmark) {
    const double both = sigma(landmark, 0) * sigma(landmark, 1);
    return both > 0.0 ? landmark.covariance(0, 1) / both : 0.0;
}

/// The second value, or its deviation: a line's is an angle.
QString second_words(const ICaracteristica& landmark, double value) {
    return is_line(landmark) ? degree_words(value) : metre_words(value);
}

/// A scan by its number, from 1, with the time since the first.
QString scan_words(const Snapshot& snapshot, std::uint32_t scan) {
    const Trajectory& path = snapshot.best_trajectory;
    if (scan >= path.size()) return {};
    return LandmarkModel::tr("%1 (%2 s)")
        .arg(scan + 1)
        .arg(tour_duration_s(std::span(path).first(scan + 1)), 0, 'f', 1);
}

}  // namespace

LandmarkModel::LandmarkModel(QObject* parent)
    : FiguresModel({tr("No."), tr("Kind"), "ρ / x", "θ / y", "σ ρ / x", "σ θ / y", tr("Corr."),
                    tr("Observed"), tr("First seen"), tr("Last seen")},
                   parent) {}

void LandmarkModel::set_snapshot(const std::shared_ptr<const Snapshot>& snapshot) {
    change(snapshot ? static_cast<int>(snapshot->best_map.size()) : 0,
           [&] { snapshot_ = snapshot; });
}

QVariant LandmarkModel::key(int row, int column) const {
    const ICaracteristica& landmark = snapshot_->best_map[static_cast<std::size_t>(row)];
    switch (column) {
        case number:
            return row;
        case kind:
            return static_cast<int>(landmark.kind());
        case first:
            return values_of(landmark).first;
        case second:
            return values_of(landmark).second;
        case sigma_1:
            return sigma(landmark, 0);
        case sigma_2:
            return sigma(landmark, 1);
        case correlation:
            return correlation_of(landmark);
        case seen:
            return landmark.observations;
        case born:
            return landmark.first_seen;
        default:
            return landmark.last_seen;
    }
}

QString LandmarkModel::text(int row, int column) const {
    const ICaracteristica& landmark = snapshot_->best_map[static_cast<std::size_t>(row)];
    switch (column) {
        case number:
            return QString::number(row + 1);
        case kind:
            if (landmark.identity >= 0) return name_of(landmark, row);
            return is_line(landmark) ? tr("Line") : tr("Corner");
        case first:
            return metre_words(values_of(landmark).first);
        case second:
            return second_words(landmark, values_of(landmark).second);
        case sigma_1:
            return metre_words(sigma(landmark, 0));
        case sigma_2:
            return second_words(landmark, sigma(landmark, 1));
        case correlation:
            return QString::number(correlation_of(landmark), 'f', 2);
        case seen:
            return QString::number(landmark.observations);
        case born:
            return scan_words(*snapshot_, landmark.first_seen);
        default:
            return scan_words(*snapshot_, landmark.last_seen);
    }
}

LandmarkTable::LandmarkTable(Session& session, QWidget* parent)
    : QWidget(parent), session_(session), model_(new LandmarkModel(this)) {
    auto* column = new QVBoxLayout(this);
    column->setContentsMargins(4, 4, 4, 4);
    table_ = named(new FiguresTable(model_, this), "landmark_table");
    table_->setAccessibleName(tr("Landmarks"));
    column->addWidget(table_);
    connect(&session, &Session::snapshot_changed, this, &LandmarkTable::refresh);
    // A snapshot holds what its run went back to: no view keeps that of a run which is gone.
    connect(&session, &Session::restarted, this, [this] { model_->set_snapshot(nullptr); });
    connect(table_, &FiguresTable::row_chosen, this, [this](int row) {
        emit landmark_chosen({model_->snapshot()->best_map[static_cast<std::size_t>(row)]});
    });
}

void LandmarkTable::set_highlight(const PickedLandmark& picked) {
    highlight_ = picked;
    mark();
}

void LandmarkTable::showEvent(QShowEvent* event) {
    QWidget::showEvent(event);
    refresh();
}

void LandmarkTable::refresh() {
    if (!isVisible()) return;
    model_->set_snapshot(session_.snapshot());
    mark();
}

void LandmarkTable::mark() {
    const auto& snapshot = model_->snapshot();
    table_->choose(snapshot ? find_same(snapshot->best_map, highlight_.landmark) : -1);
}

}  // namespace hitos::window
