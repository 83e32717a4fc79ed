// SPDX-License-Identifier: GPL-3.0-or-later
// What a study consists of and what came out of it.
#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "hitos/base/geometry.hpp"
#include "hitos/base/message.hpp"
#include "hitos/capture/tour_reader.hpp"
#include "hitos/services/evaluation/run_measures.hpp"
#include "hitos/services/evaluation/suitability.hpp"
#include "hitos/services/run/stage_seconds.hpp"
#include "hitos/services/study/study_values.hpp"

namespace hitos {

/// Where the files of a study lie. All names begin with `prefix`, so that several studies can
/// share a folder.
struct StudyLayout {
    std::filesystem::path folder;
    std::string prefix;                   ///< empty, or such as "quality-"
    std::string quality = "quality.csv";  ///< the one name without prefix

    std::filesystem::path file(const std::string& name) const { return folder / (prefix + name); }
    std::filesystem::path quality_file() const { return folder / quality; }
};

/// A folder of its own.
StudyLayout study_in_folder(const std::filesystem::path& folder);
/// The quality file has this path, and everything else lies beside it under names that begin with
/// its own (without an ending such as .csv). Throws FileError for a path that names a folder or no
/// file.
StudyLayout study_beside(const std::filesystem::path& quality_file);

/// Which runs' grid maps are kept as pictures.
enum class StudyPictures {
    none,
    first,  ///< of every value the run with the first seed
    all
};
/// "none", "first" or "all"; the other way throws ConfigError under the name `option`.
std::string_view word_of(StudyPictures pictures);
StudyPictures parse_study_pictures(std::string_view word, const std::string& option);

/// The runs of a study: values (of no, one or two parameters) times seeds. Runs are numbered from
/// 0, values of the first parameter slowest and seeds fastest.
struct StudyPlan {
    /// A parameter, or several that change together, with the values that it takes.
    struct Axis {
        std::string name;
        std::vector<std::string> keys;
        std::vector<std::string> units;  ///< one for each key, empty where it has none
        std::vector<StudyValue> values;
        friend bool operator==(const Axis&, const Axis&) = default;
    };

    std::vector<Axis> axes;
    std::uint64_t first_seed = 1;
    int seeds = 5;        ///< runs of each cell
    std::string source;   ///< the log's file name, for people
    std::string setting;  ///< what the source is beyond its file, e.g. its noise
    std::string digest;   ///< of all that decides a result, but for values and seeds
    int reference_lines = 0;
    int reference_corners = 0;
    bool grid = false;  ///< every run draws the grid of its best particle and measures it
    StudyPictures pictures = StudyPictures::none;

    bool has_reference() const { return reference_lines + reference_corners > 0; }
    /// Whether the run's grid map is kept as a picture.
    bool pictured(std::size_t run) const {
        return pictures == StudyPictures::all ||
               (pictures == StudyPictures::first && seed_of(run) == first_seed);
    }
    /// A cell is one value of each parameter.
    std::size_t cells() const;
    std::size_t runs() const { return cells() * static_cast<std::size_t>(seeds); }
    /// More would take years and are a slip of the pen.
    static constexpr std::size_t kMostRuns = 1'000'000;
    /// Whether it has at least one run and no more than that.
    bool is_possible() const;
    std::size_t cell_of(std::size_t run) const { return run / static_cast<std::size_t>(seeds); }
    std::uint64_t seed_of(std::size_t run) const {
        return first_seed + run % static_cast<std::size_t>(seeds);
    }
    /// The cell's place along each axis.
    std::vector<std::size_t> places(std::size_t cell) const;
    /// The cell's value of every key, axis by axis.
    std::vector<std::string> texts(std::size_t cell) const;
    std::vector<std::string> keys() const;
    /// "dmax=0.02 seed 3", for people.
    std::string label(std::size_t run) const;
    /// "dmax=0.02 p=5"; empty for a study without parameter.
    std::string cell_label(std::size_t cell) const;
    /// "dmax-0.02-s3": the stem of the run's files, different for every run.
    std::string file_stem(std::size_t run) const;
    /// What a run's record must state to be this run's result.
    std::string run_digest(std::size_t run) const;

    friend bool operator==(const StudyPlan&, const StudyPlan&) = default;
};

/// A run's grid map, as its files hold it.
struct StudyPicture {
    std::string digest;  ///< of the files of map and path
    Point2 origin;       ///< of the picture's lower left corner [m]
    double m_per_pixel = 0.0;
};

/// The result of one run.
struct StudyRecord {
    bool ok = false;
    Message problem;     ///< why it failed; in English where it was read
    RunFigures figures;  ///< those of taken_measures(); none of a run that failed
    int reference_found = 0;
    std::uint64_t scans = 0;
    ReadReport report;         ///< of its log, with few examples; not of a run that failed
    double seconds = 0.0;      ///< wall time; these two are not reproducible
    double cpu_seconds = 0.0;  ///< of the run's thread, which other programs hardly lengthen
    std::optional<StageSeconds> stages = {};  ///< these, likewise; nothing of earlier versions
    std::size_t state_bytes = 0;  ///< memory that the run's state took at its end, about
    std::string map_digest;       ///< of the map file
    std::optional<StudyPicture> picture;
    /// Of its path's shape, see ReferenceFit; not of a run that was read.
    std::optional<Advice> reference_doubt = std::nullopt;
    /// What there is to doubt about its tour, where the run looked (see study::looks_at_tour()); in
    /// English where it was read.
    std::vector<Message> tour_doubts = {};
};

/// Those of all runs, each once.
std::vector<Message> tour_doubts(std::span<const StudyRecord> records);

/// The run whose log is the most damaged: lines skipped, or stamps that went backwards; null where
/// no log is.
const StudyRecord* most_damaged(std::span<const StudyRecord> records);

/// Mean and spread of a figure over runs.
struct Spread {
    int count = 0;
    double mean = 0.0;
    std::optional<double> variance;  ///< unbiased (n - 1); nothing below two values
    double minimum = 0.0;
    double maximum = 0.0;
};
/// Nothing without values.
std::optional<Spread> spread_of(std::span<const double> values);

/// One row of the summary: all runs of one value, or pair of values [T 10.3].
struct StudyCell {
    std::vector<std::string> texts;
    int finished = 0;
    int failed = 0;
    std::uint64_t skipped_lines = 0;        ///< of the log, in the run with the most
    std::uint64_t stamps_backwards = 0;     ///< likewise
    std::vector<Message> tour_doubts = {};  ///< of its runs, each once
    ByMeasure<Spread> figures;              ///< over the runs that have them
};
std::vector<StudyCell> summarize(const StudyPlan& plan, std::span<const StudyRecord> records);
/// Whether any cell has it.
bool has_figures(std::span<const StudyCell> cells, const Measure& measure);

/// The tables of a finished study as text.
std::string quality_csv(const StudyLayout& layout, const StudyPlan& plan,
                        std::span<const StudyRecord> records);
std::string timing_csv(const StudyPlan& plan, std::span<const StudyRecord> records);
std::string summary_csv(const StudyPlan& plan, std::span<const StudyCell> cells);
std::string summary_markdown(const StudyPlan& plan, std::span<const StudyCell> cells);
std::string summary_latex(const StudyPlan& plan, std::span<const StudyCell> cells);
/// The same with every digit, as one JSON object: "reference" (null where there is none) and
/// "summary", an object for each cell; null where nothing was measured.
std::string summary_json(const StudyPlan& plan, std::span<const StudyCell> cells);

}  // namespace hitos
