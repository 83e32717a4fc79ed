// The figures of a study as text: CSV with every digit, Markdown and LaTeX for people.
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <iterator>
#include <nlohmann/json.hpp>

#include "hitos/base/plural.hpp"
#include "hitos/base/text_table.hpp"
#include "hitos/services/study/study_result.hpp"

namespace hitos {
namespace {

/// The shortest digits that read back the same; empty for nothing.
std::string exact(const std::optional<double>& value) {
    return value ? fmt::format("{}", *value) : "";
}

std::string mean(const std::optional<Spread>& spread) {
    return spread ? exact(spread->mean) : "";
}

std::string variance(const std::optional<Spread>& spread) {
    return spread ? exact(spread->variance) : "";
}

std::string rounded(const std::optional<double>& value, int decimals) {
    return value ? fmt::format("{:.{}f}", *value, decimals) : kNoFigure;
}

std::optional<double> mean_value(const std::optional<Spread>& spread) {
    return spread ? std::optional(spread->mean) : std::nullopt;
}

std::optional<double> variance_value(const std::optional<Spread>& spread) {
    return spread ? spread->variance : std::nullopt;
}

/// A column of the tables for people, with the digits that the thesis prints.
struct Column {
    const char* markdown;
    const char* latex;
    std::optional<Spread> StudyCell::*figures;
    bool variance;  ///< of the figures, else their mean
    int decimals;
    bool of_reference;  ///< stands wherever there is a reference map, even without a figure
};

constexpr std::array kPrintedColumns = {
    Column{"error (m)", "error (m)", &StudyCell::error_m, false, 3, true},
    Column{"variance (m²)", "variance (m^2)", &StudyCell::error_m, true, 4, true},
    Column{"aligned error (m)", "aligned (m)", &StudyCell::aligned_error_m, false, 3, true},
    Column{"ATE (m)", "ATE (m)", &StudyCell::trajectory_error_m, false, 3, false},
    Column{"odometry's ATE (m)", "odometry's ATE (m)", &StudyCell::odometry_error_m, false, 3,
           false},
    Column{"blur (m²)", "blur (m^2)", &StudyCell::blur_m2, false, 2, false},
    Column{"landmarks", "landmarks", &StudyCell::landmarks, false, 1, true},
    Column{"lines", "lines", &StudyCell::lines, false, 1, true},
    Column{"corners", "corners", &StudyCell::corners, false, 1, true}};

bool has_figures(std::span<const StudyCell> cells, std::optional<Spread> StudyCell::*figures) {
    return std::ranges::any_of(cells, [&](const StudyCell& c) { return (c.*figures).has_value(); });
}

TextTable pretty_table(const StudyPlan& plan, std::span<const StudyCell> cells,
                       const char* Column::*name) {
    TextTable table;
    for (const StudyPlan::Axis& axis : plan.axes) {
        for (std::size_t i = 0; i < axis.keys.size(); ++i) {
            const std::string& key = axis.keys.size() == 1 ? axis.name : axis.keys[i];
            table.head.push_back(axis.units[i].empty() ? key : key + " (" + axis.units[i] + ")");
        }
    }
    table.head.emplace_back("runs");
    std::vector<Column> columns;
    std::ranges::copy_if(kPrintedColumns, std::back_inserter(columns), [&](const Column& column) {
        return (column.of_reference && plan.has_reference()) || has_figures(cells, column.figures);
    });
    for (const Column& column : columns) table.head.emplace_back(column.*name);
    for (const StudyCell& cell : cells) {
        std::vector<std::string> row = cell.texts;
        row.push_back(cell.failed == 0
                          ? fmt::format("{}", cell.finished)
                          : fmt::format("{} of {}", cell.finished, cell.finished + cell.failed));
        for (const Column& column : columns) {
            const std::optional<Spread>& figures = cell.*column.figures;
            row.push_back(rounded(column.variance ? variance_value(figures) : mean_value(figures),
                                  column.decimals));
        }
        table.rows.push_back(std::move(row));
    }
    return table;
}

/// "line 17: …"; empty where nothing was skipped.
std::string first_damage(const ReadReport& report) {
    if (report.examples.empty()) return {};
    return report.placed(report.examples.front()).english();
}

/// Empty where no log is damaged.
std::string damage_sentence(std::span<const StudyCell> cells) {
    std::uint64_t skipped = 0;
    std::uint64_t backwards = 0;
    for (const StudyCell& cell : cells) {
        skipped = std::max(skipped, cell.skipped_lines);
        backwards = std::max(backwards, cell.stamps_backwards);
    }
    if (skipped + backwards == 0) return {};
    return fmt::format(
        " The log is damaged: {} skipped, {} that did not advance (of several logs, the most of "
        "one).",
        plural(skipped, "line"), plural(backwards, "stamp"));
}

std::string reference_sentence(const StudyPlan& plan, std::span<const StudyCell> cells) {
    if (!plan.has_reference()) {
        return std::string("Without a reference map.") +
               (has_figures(cells, &StudyCell::trajectory_error_m) ? " ATE: error of the path."
                                                                   : "") +
               " Blur: undecided area of the grid map; lower is crisper.";
    }
    return fmt::format("{} in the reference: {}, {}.",
                       plural(plan.reference_lines + plan.reference_corners, "landmark"),
                       plural(plan.reference_lines, "line"),
                       plural(plan.reference_corners, "corner"));
}

/// For CSV files; empty where there is no reference map.
std::string reference_count(const StudyPlan& plan) {
    return plan.has_reference() ? fmt::format("{}", plan.reference_lines + plan.reference_corners)
                                : "";
}

}  // namespace

std::optional<Spread> spread_of(std::span<const double> values) {
    if (values.empty()) return std::nullopt;
    Spread spread;
    spread.count = static_cast<int>(values.size());
    const auto n = static_cast<double>(values.size());
    double sum = 0.0;
    for (const double value : values) sum += value;
    spread.mean = sum / n;
    const auto [least, greatest] = std::minmax_element(values.begin(), values.end());
    spread.minimum = *least;
    spread.maximum = *greatest;
    if (values.size() > 1) {
        // About the mean: the difference of two sums would lose the digits of a small variance.
        double squares = 0.0;
        for (const double value : values) squares += (value - spread.mean) * (value - spread.mean);
        spread.variance = squares / (n - 1.0);
    }
    return spread;
}

std::vector<StudyCell> summarize(const StudyPlan& plan, std::span<const StudyRecord> records) {
    std::vector<StudyCell> cells;
    for (std::size_t cell = 0; cell < plan.cells(); ++cell) {
        StudyCell row;
        row.texts = plan.texts(cell);
        std::vector<double> errors;
        std::vector<double> aligned;
        std::vector<double> paths;
        std::vector<double> odometry;
        std::vector<double> blur;
        std::vector<double> landmarks;
        std::vector<double> lines;
        std::vector<double> corners;
        const auto seeds = static_cast<std::size_t>(plan.seeds);
        for (const StudyRecord& record : records.subspan(cell * seeds, seeds)) {
            if (!record.ok) {
                ++row.failed;
                continue;
            }
            ++row.finished;
            row.skipped_lines = std::max(row.skipped_lines, record.report.skipped);
            row.stamps_backwards = std::max(row.stamps_backwards, record.report.stamps_backwards);
            if (record.error_m) errors.push_back(*record.error_m);
            if (record.aligned_error_m) aligned.push_back(*record.aligned_error_m);
            if (record.trajectory_error_m) paths.push_back(*record.trajectory_error_m);
            if (record.odometry_error_m) odometry.push_back(*record.odometry_error_m);
            if (record.blur_m2) blur.push_back(*record.blur_m2);
            landmarks.push_back(record.lines + record.corners);
            lines.push_back(record.lines);
            corners.push_back(record.corners);
        }
        row.error_m = spread_of(errors);
        row.aligned_error_m = spread_of(aligned);
        row.trajectory_error_m = spread_of(paths);
        row.odometry_error_m = spread_of(odometry);
        row.blur_m2 = spread_of(blur);
        row.landmarks = spread_of(landmarks);
        row.lines = spread_of(lines);
        row.corners = spread_of(corners);
        cells.push_back(std::move(row));
    }
    return cells;
}

const StudyRecord* most_damaged(std::span<const StudyRecord> records) {
    const auto damage = [](const StudyRecord& record) {
        return std::pair(record.report.skipped, record.report.stamps_backwards);
    };
    const auto most = std::ranges::max_element(records, {}, damage);
    if (most == records.end() || damage(*most) == damage({})) return nullptr;
    return &*most;
}

std::string quality_csv(const StudyLayout& layout, const StudyPlan& plan,
                        std::span<const StudyRecord> records) {
    std::vector<std::string> head = plan.keys();
    for (const char* name :
         {"seed", "status", "error_m", "aligned_error_m", "landmarks", "lines", "corners",
          "reference_found", "reference_landmarks", "scans", "trajectory_error_m",
          "odometry_error_m", "blur_m2", "map", "problem", "skipped_lines", "stamps_backwards",
          "duplicate_scans", "first_damage"}) {
        head.emplace_back(name);
    }
    std::string text = csv_line(std::move(head));
    for (std::size_t run = 0; run < records.size(); ++run) {
        const StudyRecord& record = records[run];
        std::vector<std::string> row = plan.texts(plan.cell_of(run));
        row.push_back(fmt::format("{}", plan.seed_of(run)));
        if (record.ok) {
            row.insert(
                row.end(),
                {"ok", exact(record.error_m), exact(record.aligned_error_m),
                 fmt::format("{}", record.lines + record.corners), fmt::format("{}", record.lines),
                 fmt::format("{}", record.corners),
                 plan.has_reference() ? fmt::format("{}", record.reference_found) : std::string(),
                 reference_count(plan), fmt::format("{}", record.scans),
                 exact(record.trajectory_error_m), exact(record.odometry_error_m),
                 exact(record.blur_m2), layout.prefix + "maps/" + plan.file_stem(run) + ".map", "",
                 fmt::format("{}", record.report.skipped),
                 fmt::format("{}", record.report.stamps_backwards),
                 fmt::format("{}", record.report.duplicate_scans), first_damage(record.report)});
        } else {
            row.insert(row.end(), {"failed", "", "", "", "", "", "", "", "", "", "", "", "",
                                   record.problem.english(), "", "", "", ""});
        }
        text += csv_line(std::move(row));
    }
    return text;
}

std::string timing_csv(const StudyPlan& plan, std::span<const StudyRecord> records) {
    std::vector<std::string> head = plan.keys();
    head.insert(head.end(), {"seed", "seconds", "scans_per_second", "cpu_seconds"});
    std::string text = csv_line(std::move(head));
    for (std::size_t run = 0; run < records.size(); ++run) {
        const StudyRecord& record = records[run];
        std::vector<std::string> row = plan.texts(plan.cell_of(run));
        row.push_back(fmt::format("{}", plan.seed_of(run)));
        row.push_back(fmt::format("{:.6f}", record.seconds));
        row.push_back(
            record.ok && record.seconds > 0.0
                ? fmt::format("{:.1f}", static_cast<double>(record.scans) / record.seconds)
                : "");
        row.push_back(fmt::format("{:.6f}", record.cpu_seconds));
        text += csv_line(std::move(row));
    }
    return text;
}

std::string summary_csv(const StudyPlan& plan, std::span<const StudyCell> cells) {
    std::vector<std::string> head = plan.keys();
    for (const char* name : {"runs",
                             "failed",
                             "measured",
                             "error_m",
                             "error_variance_m2",
                             "error_minimum_m",
                             "error_maximum_m",
                             "aligned_error_m",
                             "aligned_error_variance_m2",
                             "landmarks",
                             "landmarks_variance",
                             "lines",
                             "lines_variance",
                             "corners",
                             "corners_variance",
                             "reference_landmarks",
                             "trajectory_error_m",
                             "trajectory_error_variance_m2",
                             "odometry_error_m",
                             "odometry_error_variance_m2",
                             "blur_m2",
                             "blur_variance_m4",
                             "skipped_lines",
                             "stamps_backwards"}) {
        head.emplace_back(name);
    }
    std::string text = csv_line(std::move(head));
    for (const StudyCell& cell : cells) {
        std::vector<std::string> row = cell.texts;
        row.push_back(fmt::format("{}", cell.finished));
        row.push_back(fmt::format("{}", cell.failed));
        row.push_back(fmt::format("{}", cell.error_m ? cell.error_m->count : 0));
        row.push_back(mean(cell.error_m));
        row.push_back(variance(cell.error_m));
        row.push_back(cell.error_m ? exact(cell.error_m->minimum) : "");
        row.push_back(cell.error_m ? exact(cell.error_m->maximum) : "");
        for (const std::optional<Spread>* spread :
             {&cell.aligned_error_m, &cell.landmarks, &cell.lines, &cell.corners}) {
            row.push_back(mean(*spread));
            row.push_back(variance(*spread));
        }
        row.push_back(reference_count(plan));
        for (const std::optional<Spread>* spread :
             {&cell.trajectory_error_m, &cell.odometry_error_m, &cell.blur_m2}) {
            row.push_back(mean(*spread));
            row.push_back(variance(*spread));
        }
        row.push_back(fmt::format("{}", cell.skipped_lines));
        row.push_back(fmt::format("{}", cell.stamps_backwards));
        text += csv_line(std::move(row));
    }
    return text;
}

std::string summary_markdown(const StudyPlan& plan, std::span<const StudyCell> cells) {
    return fmt::format("{}\n{}{}\n", markdown(pretty_table(plan, cells, &Column::markdown)),
                       reference_sentence(plan, cells), damage_sentence(cells));
}

std::string summary_latex(const StudyPlan& plan, std::span<const StudyCell> cells) {
    return fmt::format("{}% {}{}\n", latex(pretty_table(plan, cells, &Column::latex)),
                       reference_sentence(plan, cells), damage_sentence(cells));
}

namespace {

using nlohmann::ordered_json;

ordered_json json_of(const std::optional<Spread>& spread) {
    if (!spread) return nullptr;
    ordered_json json{{"measured", spread->count},
                      {"mean", spread->mean},
                      {"minimum", spread->minimum},
                      {"maximum", spread->maximum}};
    json["variance"] = spread->variance ? ordered_json(*spread->variance) : ordered_json();
    return json;
}

}  // namespace

std::string summary_json(const StudyPlan& plan, std::span<const StudyCell> cells) {
    ordered_json rows = ordered_json::array();
    const std::vector<std::string> keys = plan.keys();
    for (const StudyCell& cell : cells) {
        ordered_json values;
        for (std::size_t i = 0; i < keys.size(); ++i) values[keys[i]] = cell.texts[i];
        rows.push_back({{"values", values},
                        {"runs", cell.finished},
                        {"failed", cell.failed},
                        {"error_m", json_of(cell.error_m)},
                        {"aligned_error_m", json_of(cell.aligned_error_m)},
                        {"trajectory_error_m", json_of(cell.trajectory_error_m)},
                        {"odometry_error_m", json_of(cell.odometry_error_m)},
                        {"blur_m2", json_of(cell.blur_m2)},
                        {"landmarks", json_of(cell.landmarks)},
                        {"lines", json_of(cell.lines)},
                        {"corners", json_of(cell.corners)},
                        {"skipped_lines", cell.skipped_lines},
                        {"stamps_backwards", cell.stamps_backwards}});
    }
    ordered_json reference;
    if (plan.has_reference()) {
        reference = {{"lines", plan.reference_lines}, {"corners", plan.reference_corners}};
    }
    // Values of text parameters may be no UTF-8: replace what is not instead of failing.
    return ordered_json{{"reference", reference}, {"summary", rows}}.dump(
        2, ' ', false, ordered_json::error_handler_t::replace);
}

}  // namespace hitos
