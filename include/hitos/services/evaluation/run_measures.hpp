// SPDX-License-Identifier: GPL-3.0-or-later
// The figures of a run: one entry for each.
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "hitos/base/registry.hpp"
#include "hitos/services/evaluation/measures.hpp"
#include "hitos/services/evaluation/relations.hpp"
#include "hitos/services/evaluation/relative_error.hpp"
#include "hitos/services/evaluation/run_evidence.hpp"
#include "hitos/services/evaluation/run_loops.hpp"

namespace hitos {

class Grid;
class SlamFilter;
struct Calibration;

/// Errors of a run against its references; nothing where there is none to compare with.
struct RunErrors {
    std::optional<MapError> map_error;
    std::optional<AlignedMapError> aligned_map_error;
    std::optional<TrajectoryError> trajectory_error;
    std::optional<TrajectoryError> odometry_error;
    std::optional<RelativeError> relative_error_1m;   ///< over every metre of the way
    std::optional<RelativeError> relative_error_10m;  ///< over every ten
    std::optional<RelationErrors> relation_errors;
};

/// A run as its figures are taken of it.
struct MeasuredRun {
    RunEvidence evidence;
    const SlamFilter& filter;
    const LandmarkMap& map;  ///< the best one
    const Trajectory& path;  ///< likewise
    const RunErrors& errors;
    const Grid* grid;  ///< along the path; null where nobody draws it, as for a summary
    /// Judged, where there is a reference; null where there was nothing to close any.
    const std::vector<RunLoop>* loops = nullptr;
    const Calibration* calibration = nullptr;  ///< null where the truth is not known
};

/// One figure of a run. What summaries, records, tables and plots of studies, comparisons, Python
/// and help texts say of it is made of its entry.
struct Measure {
    /// What it tells of: tables have them side by side.
    enum class About { map, path, grid, count, course };

    std::string word;   ///< as files and programs know it, its unit at the end: "error_m"
    std::string label;  ///< of its columns, for people: "error"
    About about = About::course;
    std::string unit = {};  ///< "m^2"; empty: none
    int decimals = 0;       ///< for people; the mean of a count has one more
    /// Where summary.json has it (RFC 6901); empty: nowhere.
    std::string place = {};
    /// Gives it, where the run has it. Null: only summary.json states it, and says so by itself.
    std::optional<double> (*take)(const MeasuredRun&) = nullptr;
    std::string purpose = {};  ///< half a sentence for help texts
    /// Beside the axis of its plot: HITOS_TEXT("Measure", "map error"); empty: none is drawn. Those
    /// of rare ones only the window draws.
    std::string plot = {};
    /// Tables tell its variance, minimum and maximum over several runs too [T 10.3].
    bool spread = false;
    /// Where runs are compared, and in LaTeX, if they are others.
    std::string compared_word = {};
    std::string compared_label = {};
    std::string latex_label = {};
    /// What it ought to be, where less is not better.
    std::optional<double> target = {};
    /// Only tables for programs have it: for people there would be too many.
    bool detail = false;
    /// Tables of studies have it only where a run does: others keep the bytes that they had before
    /// there was such a figure.
    bool rare = false;

    bool is_count() const { return about == About::count; }
    /// Of what a reference map is compared with.
    bool of_landmarks() const { return about == About::map || is_count(); }
    /// The word without its unit: "error".
    std::string stem() const;
    /// "error_minimum_m"; its square "error_variance_m2".
    std::string word_of(std::string_view statistic, bool squared = false) const;
    /// "0.123"; of a count's mean over several runs "12.5".
    std::string rounded(double value, bool of_several) const;
};

/// Figures by their words.
class MeasureRegistry : public Registry<Measure> {
  public:
    using Registry::Registry;
    /// Throws ConfigError too where tables, records or Python say its word of something else.
    void add(Measure measure);
};

/// All of them, in the order of tables for people.
MeasureRegistry& run_measures();
/// Those that are taken of every run.
std::vector<const Measure*> taken_measures();

/// Of "m^2": "m2", "m²", "m^4".
std::string plain_unit(std::string unit);
std::string printed_unit(std::string unit);
std::string squared_unit(const std::string& unit);

/// Of every measure a value, or nothing; asked for by the measure or its word. Throws ConfigError
/// where there is none of that word.
template <class Value>
class ByMeasure {
  public:
    template <class Key>
    const std::optional<Value>& operator[](const Key& key) const {
        return values_[place_of(key)];
    }
    template <class Key>
    std::optional<Value>& operator[](const Key& key) {
        return values_[place_of(key)];
    }
    friend bool operator==(const ByMeasure&, const ByMeasure&) = default;

  private:
    static std::size_t place_of(const Measure& measure) {
        return static_cast<std::size_t>(&measure - run_measures().entries().data());
    }
    static std::size_t place_of(std::string_view word) {
        return place_of(run_measures().find(word));
    }

    std::vector<std::optional<Value>> values_ =
        std::vector<std::optional<Value>>(run_measures().entries().size());
};
using RunFigures = ByMeasure<double>;

/// Takes them all.
RunFigures figures_of(const MeasuredRun& run);

}  // namespace hitos
