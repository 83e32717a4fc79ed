// SPDX-License-Identifier: GPL-3.0-or-later
// What the user measures in the map, with its values in the map as it is now.
#pragma once

#include <QObject>
#include <QString>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "hitos/services/evaluation/hand_measurement.hpp"
#include "session/session.hpp"

namespace hitos::window {

struct MeasuredRow {
    HandMeasurement measurement;
    MeasuredValue slam;
    std::optional<double> truth;  ///< [m] or [rad]: the user's, else the reference map's

    std::optional<double> error() const;          ///< slam - truth
    std::optional<double> error_percent() const;  ///< of a true distance, without sign, as [P]
};

/// "3.064 m", "89.71°"; of nothing a dash.
QString value_words(Quantity quantity, std::optional<double> value);

/// Belongs to the log, which its places lie in: with another one it goes, and comes back with it.
class Measurements final : public QObject {
    Q_OBJECT

  public:
    Measurements(Session& session, QObject* parent);

    const std::vector<MeasuredRow>& rows() const { return rows_; }
    /// Nothing is chosen: -1.
    int chosen() const { return chosen_; }
    void choose(int row);
    /// What the map as it is now makes of it.
    MeasuredValue value_of(const HandMeasurement& measurement) const;

    /// Gives it a name.
    void add(HandMeasurement measurement);
    void remove(int row);
    void clear();
    /// False where no distances file could hold the name, or another row has it.
    bool rename(int row, const QString& name);
    /// [m] or [rad]; nothing: the reference map's.
    void set_truth(int row, std::optional<double> value);
    /// Adds the distances of a file in the place of those with the same names. Throws hitos::Error.
    void open(const QString& path);
    /// Writes those between walls, where no truth is known with the distance measured. Throws
    /// hitos::Error.
    void save(const QString& path) const;
    /// How many of them a file can hold, and how many of those without a truth.
    int distances() const;
    int distances_without_truth() const;

  signals:
    void changed();
    /// They are those of another log.
    void log_changed();

  private:
    void change_log();
    void refresh();
    void set(std::vector<MeasuredRow> rows);
    bool taken(const std::string& name) const;

    Session& session_;
    std::vector<MeasuredRow> rows_;
    int chosen_ = -1;
    std::string log_;
    std::map<std::string, std::vector<MeasuredRow>> of_other_logs_;
};

}  // namespace hitos::window
