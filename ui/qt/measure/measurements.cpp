// SPDX-License-Identifier: GPL-3.0-or-later
#include "measurements.hpp"

#include <QFileInfo>
#include <algorithm>
#include <cmath>
#include <utility>

#include "hitos/base/atomic_file.hpp"
#include "look/words_of.hpp"

namespace hitos::window {
namespace {

/// The same however its path is written.
std::string log_of(const Session& session) {
    const QString named = QString::fromStdString(session.configuration().source.file);
    const QString found = QFileInfo(named).canonicalFilePath();
    return (found.isEmpty() ? named : found).toStdString();
}

bool for_file(const MeasuredRow& row) {
    return row.measurement.between_walls();
}

}  // namespace

std::optional<double> MeasuredRow::error() const {
    if (!slam.value || !truth) return std::nullopt;
    return *slam.value - *truth;
}

std::optional<double> MeasuredRow::error_percent() const {
    if (measurement.quantity == Quantity::angle || !error() || !(*truth > 0.0)) return std::nullopt;
    return 100.0 * std::abs(*error()) / *truth;
}

QString value_words(Quantity quantity, std::optional<double> value) {
    if (!value) return QStringLiteral("–");
    return quantity == Quantity::distance ? metre_words(*value) : degree_words(*value);
}

Measurements::Measurements(Session& session, QObject* parent)
    : QObject(parent), session_(session), log_(log_of(session)) {
    connect(&session, &Session::configuration_changed, this, &Measurements::change_log);
    connect(&session, &Session::snapshot_changed, this, &Measurements::refresh);
    connect(&session, &Session::references_changed, this, &Measurements::refresh);
}

void Measurements::change_log() {
    const std::string log = log_of(session_);
    if (log == log_) return;
    of_other_logs_[log_] = std::exchange(rows_, {});
    log_ = log;
    chosen_ = -1;
    emit log_changed();
    set(std::move(of_other_logs_[log_]));
}

MeasuredValue Measurements::value_of(const HandMeasurement& measurement) const {
    const auto snapshot = session_.snapshot();
    return measure(snapshot ? snapshot->best_map : LandmarkMap{}, measurement);
}

void Measurements::refresh() {
    if (!rows_.empty()) set(std::move(rows_));
}

void Measurements::set(std::vector<MeasuredRow> rows) {
    rows_ = std::move(rows);
    const std::optional<LandmarkMap>& reference = session_.references().map;
    for (MeasuredRow& row : rows_) {
        row.slam = value_of(row.measurement);
        row.truth = true_value(row.measurement, reference ? &*reference : nullptr);
    }
    emit changed();
}

void Measurements::choose(int row) {
    if (row == chosen_) return;
    chosen_ = row;
    emit changed();
}

bool Measurements::taken(const std::string& name) const {
    return std::ranges::any_of(
        rows_, [&](const MeasuredRow& row) { return row.measurement.name == name; });
}

void Measurements::add(HandMeasurement measurement) {
    const char* const letter = measurement.quantity == Quantity::distance ? "d" : "a";
    int number = 1;
    while (taken(letter + std::to_string(number))) ++number;
    measurement.name = letter + std::to_string(number);
    std::vector<MeasuredRow> rows = std::move(rows_);
    rows.push_back({std::move(measurement), {}, {}});
    chosen_ = static_cast<int>(rows.size()) - 1;
    set(std::move(rows));
}

void Measurements::remove(int row) {
    std::vector<MeasuredRow> rows = std::move(rows_);
    rows.erase(rows.begin() + row);
    chosen_ = std::min(chosen_, static_cast<int>(rows.size()) - 1);
    set(std::move(rows));
}

void Measurements::clear() {
    chosen_ = -1;
    set({});
}

bool Measurements::rename(int row, const QString& name) {
    const std::string word = name.toStdString();
    std::string& now = rows_[static_cast<std::size_t>(row)].measurement.name;
    if (word == now) return true;
    if (!is_distance_name(word) || taken(word)) return false;
    now = word;
    emit changed();
    return true;
}

void Measurements::set_truth(int row, std::optional<double> value) {
    rows_[static_cast<std::size_t>(row)].measurement.true_value = value;
    refresh();
}

void Measurements::open(const QString& path) {
    const std::vector<NamedDistance> distances = read_distances(path.toStdString());
    std::vector<MeasuredRow> rows = std::move(rows_);
    for (const NamedDistance& distance : distances) {
        std::erase_if(
            rows, [&](const MeasuredRow& row) { return row.measurement.name == distance.name; });
        rows.push_back({measurement_of(distance), {}, {}});
    }
    chosen_ = -1;
    set(std::move(rows));
}

void Measurements::save(const QString& path) const {
    std::vector<NamedDistance> distances;
    for (const MeasuredRow& row : rows_) {
        if (!for_file(row)) continue;
        distances.push_back(
            named_distance(row.measurement, row.truth ? row.truth : row.slam.value));
    }
    write_file(path.toStdString(), distances_text(distances));
}

int Measurements::distances() const {
    return static_cast<int>(std::ranges::count_if(rows_, for_file));
}

int Measurements::distances_without_truth() const {
    return static_cast<int>(std::ranges::count_if(
        rows_, [](const MeasuredRow& row) { return for_file(row) && !row.truth; }));
}

}  // namespace hitos::window
