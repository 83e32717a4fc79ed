// SPDX-License-Identifier: GPL-3.0-or-later
// The figures of a study as text: CSV with every digit, Markdown and LaTeX for people.
#include <fmt/format.h>

#include <algorithm>
#include <nlohmann/json.hpp>

#include "calibration_table.hpp"
#include "hitos/base/plural.hpp"
#include "hitos/base/text_table.hpp"
#include "hitos/services/study/study_result.hpp"
#include "json_input.hpp"
#include "spread_json.hpp"

namespace hitos {
namespace {

/// The shortest digits that read back the same; empty for nothing.
std::string exact(const std::optional<double>& value) {
    return value ? fmt::format("{}", *value) : "";
}

/// A table that grows field by field.
class Rows {
  public:
    explicit Rows(std::vector<std::string> first_columns) {
        table_.head = std::move(first_columns);
    }

    void begin(std::vector<std::string> first_fields) {
        table_.rows.push_back(std::move(first_fields));
    }
    /// `column`: its head, the same in every row.
    template <class Field>
    void add(std::string column, const Field& field) {
        if (table_.rows.size() == 1) table_.head.push_back(std::move(column));
        table_.rows.back().push_back(fmt::format("{}", field));
    }
    const TextTable& table() const { return table_; }

  private:
    TextTable table_;
};

std::vector<std::string> columns_of(const StudyPlan& plan) {
    std::vector<std::string> keys;
    for (const StudyPlan::Axis& axis : plan.axes) {
        for (std::size_t i = 0; i < axis.keys.size(); ++i) {
            keys.push_back(
                with_unit(axis.keys.size() == 1 ? axis.name : axis.keys[i], axis.units[i]));
        }
    }
    return keys;
}

/// With the digits that the thesis prints. What belongs to a reference map stands wherever there is
/// one, even without a figure.
TextTable pretty_table(const StudyPlan& plan, std::span<const StudyCell> cells, bool in_latex) {
    std::vector<const Measure*> measures = taken_measures();
    std::erase_if(measures, [&](const Measure* measure) {
        return measure->detail || (!(measure->of_landmarks() && plan.has_reference()) &&
                                   !has_figures(cells, *measure));
    });
    const auto unit_of = [&](std::string unit) {
        return in_latex ? std::move(unit) : printed_unit(std::move(unit));
    };
    Rows rows(columns_of(plan));
    for (const StudyCell& cell : cells) {
        rows.begin(cell.texts);
        rows.add("runs", cell.failed == 0
                             ? fmt::format("{}", cell.finished)
                             : fmt::format("{} of {}", cell.finished, cell.finished + cell.failed));
        for (const Measure* measure : measures) {
            const auto& spread = cell.figures[*measure];
            const bool narrow = in_latex && !measure->latex_label.empty();
            rows.add(
                with_unit(narrow ? measure->latex_label : measure->label, unit_of(measure->unit)),
                spread ? measure->rounded(spread->mean, true) : kNoFigure);
            if (!measure->spread) continue;
            rows.add(with_unit("variance", unit_of(squared_unit(measure->unit))),
                     spread && spread->variance
                         ? fmt::format("{:.{}f}", *spread->variance, measure->decimals + 1)
                         : kNoFigure);
        }
    }
    return rows.table();
}

TextTable calibration_of(const StudyPlan& plan, std::span<const StudyCell> cells) {
    std::vector<study::CalibrationRow> rows;
    for (const StudyCell& cell : cells) rows.push_back({cell.texts, &cell.figures});
    return study::calibration_table(columns_of(plan), rows);
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

/// Empty where nobody doubts the tours.
std::string doubt_sentence(std::span<const StudyCell> cells) {
    std::vector<std::string> doubts;
    for (const StudyCell& cell : cells) {
        for (const Message& doubt : cell.tour_doubts) {
            if (std::ranges::count(doubts, doubt.english()) == 0) doubts.push_back(doubt.english());
        }
    }
    if (doubts.empty()) return {};
    return fmt::format(" Look at the log: {}.", fmt::join(doubts, ". "));
}

std::string reference_sentence(const StudyPlan& plan, std::span<const StudyCell> cells) {
    if (!plan.has_reference()) {
        return std::string("Without a reference map.") +
               (has_figures(cells, run_measures().find("trajectory_error_m"))
                    ? " ATE: error of the path."
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

/// In tables for programs those of landmarks stand before what the reference has of them.
template <class HasAny>
std::vector<const Measure*> taken_of_landmarks(bool of_landmarks, const HasAny& has_any) {
    std::vector<const Measure*> measures = taken_measures();
    std::erase_if(measures, [&](const Measure* measure) {
        return measure->of_landmarks() != of_landmarks || (measure->rare && !has_any(*measure));
    });
    return measures;
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

bool has_figures(std::span<const StudyCell> cells, const Measure& measure) {
    return std::ranges::any_of(
        cells, [&](const StudyCell& cell) { return cell.figures[measure].has_value(); });
}

std::vector<Message> tour_doubts(std::span<const StudyRecord> records) {
    std::vector<Message> doubts;
    for (const StudyRecord& record : records) {
        for (const Message& doubt : record.tour_doubts) {
            if (std::ranges::count(doubts, doubt.english(), &Message::english) == 0)
                doubts.push_back(doubt);
        }
    }
    return doubts;
}

std::vector<StudyCell> summarize(const StudyPlan& plan, std::span<const StudyRecord> records) {
    std::vector<StudyCell> cells;
    for (std::size_t cell = 0; cell < plan.cells(); ++cell) {
        StudyCell row;
        row.texts = plan.texts(cell);
        const auto seeds = static_cast<std::size_t>(plan.seeds);
        const auto runs = records.subspan(cell * seeds, seeds);
        for (const StudyRecord& record : runs) {
            if (!record.ok) {
                ++row.failed;
                continue;
            }
            ++row.finished;
            row.skipped_lines = std::max(row.skipped_lines, record.report.skipped);
            row.stamps_backwards = std::max(row.stamps_backwards, record.report.stamps_backwards);
        }
        row.tour_doubts = tour_doubts(runs);
        for (const Measure* measure : taken_measures()) {
            std::vector<double> values;
            for (const StudyRecord& record : runs) {
                if (const auto& value = record.figures[*measure]) values.push_back(*value);
            }
            row.figures[*measure] = spread_of(values);
        }
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
    const auto has_any = [&](const Measure& measure) {
        return std::ranges::any_of(records, [&](const StudyRecord& record) {
            return record.figures[measure].has_value();
        });
    };
    Rows rows(plan.keys());
    for (std::size_t run = 0; run < records.size(); ++run) {
        const StudyRecord& record = records[run];
        const auto add = [&](std::string column, const auto& of_one_that_is_ok) {
            rows.add(std::move(column), record.ok ? fmt::format("{}", of_one_that_is_ok) : "");
        };
        const auto add_figures = [&](bool of_landmarks) {
            for (const Measure* measure : taken_of_landmarks(of_landmarks, has_any))
                add(measure->word, exact(record.figures[*measure]));
        };
        rows.begin(plan.texts(plan.cell_of(run)));
        rows.add("seed", plan.seed_of(run));
        rows.add("status", record.ok ? "ok" : "failed");
        add_figures(true);
        add("reference_found",
            plan.has_reference() ? fmt::format("{}", record.reference_found) : "");
        add("reference_landmarks", reference_count(plan));
        add("scans", record.scans);
        add_figures(false);
        add("map", layout.prefix + "maps/" + plan.file_stem(run) + ".map");
        rows.add("problem", record.ok ? "" : record.problem.english());
        add("skipped_lines", record.report.skipped);
        add("stamps_backwards", record.report.stamps_backwards);
        add("duplicate_scans", record.report.duplicate_scans);
        add("first_damage", first_damage(record.report));
    }
    return csv(rows.table());
}

std::string timing_csv(const StudyPlan& plan, std::span<const StudyRecord> records) {
    Rows rows(plan.keys());
    for (std::size_t run = 0; run < records.size(); ++run) {
        const StudyRecord& record = records[run];
        const bool timed = record.ok && record.seconds > 0.0;
        rows.begin(plan.texts(plan.cell_of(run)));
        rows.add("seed", plan.seed_of(run));
        rows.add("seconds", fmt::format("{:.6f}", record.seconds));
        rows.add(
            "scans_per_second",
            timed ? fmt::format("{:.1f}", static_cast<double>(record.scans) / record.seconds) : "");
        rows.add("cpu_seconds", fmt::format("{:.6f}", record.cpu_seconds));
    }
    return csv(rows.table());
}

std::string summary_csv(const StudyPlan& plan, std::span<const StudyCell> cells) {
    const auto has_any = [&](const Measure& measure) { return has_figures(cells, measure); };
    std::vector<const ByMeasure<Spread>*> all;
    for (const StudyCell& cell : cells) all.push_back(&cell.figures);
    const study::IntervalColumns intervals(all);
    Rows rows(plan.keys());
    for (const StudyCell& cell : cells) {
        const auto add_figures = [&](bool of_landmarks) {
            for (const Measure* measure : taken_of_landmarks(of_landmarks, has_any)) {
                const auto& spread = cell.figures[*measure];
                rows.add(measure->word, spread ? exact(spread->mean) : "");
                rows.add(measure->word_of("variance", true), spread ? exact(spread->variance) : "");
                if (!measure->spread) continue;
                rows.add(measure->word_of("minimum"), spread ? exact(spread->minimum) : "");
                rows.add(measure->word_of("maximum"), spread ? exact(spread->maximum) : "");
            }
        };
        const auto& error = cell.figures["error_m"];
        rows.begin(cell.texts);
        rows.add("runs", cell.finished);
        rows.add("failed", cell.failed);
        rows.add("measured", error ? error->count : 0);
        add_figures(true);
        rows.add("reference_landmarks", reference_count(plan));
        add_figures(false);
        rows.add("skipped_lines", cell.skipped_lines);
        rows.add("stamps_backwards", cell.stamps_backwards);
        for (const auto& [column, limit] : intervals.of(cell.figures)) rows.add(column, limit);
    }
    return csv(rows.table());
}

std::string summary_markdown(const StudyPlan& plan, std::span<const StudyCell> cells) {
    return fmt::format("{}\n{}{}{}\n{}", markdown(pretty_table(plan, cells, false)),
                       reference_sentence(plan, cells), damage_sentence(cells),
                       doubt_sentence(cells), study::below(calibration_of(plan, cells), markdown));
}

std::string summary_latex(const StudyPlan& plan, std::span<const StudyCell> cells) {
    return fmt::format("{}% {}{}{}\n{}", latex(pretty_table(plan, cells, true)),
                       reference_sentence(plan, cells), damage_sentence(cells),
                       doubt_sentence(cells),
                       study::below(calibration_of(plan, cells), latex, "% "));
}

using nlohmann::ordered_json;

ordered_json spread_json(const std::optional<Spread>& spread) {
    if (!spread) return nullptr;
    ordered_json json{{"measured", spread->count},
                      {"mean", spread->mean},
                      {"minimum", spread->minimum},
                      {"maximum", spread->maximum}};
    json["variance"] = spread->variance ? ordered_json(*spread->variance) : ordered_json();
    return json;
}

std::string summary_json(const StudyPlan& plan, std::span<const StudyCell> cells) {
    ordered_json rows = ordered_json::array();
    const std::vector<std::string> keys = plan.keys();
    for (const StudyCell& cell : cells) {
        ordered_json values;
        for (std::size_t i = 0; i < keys.size(); ++i) values[keys[i]] = cell.texts[i];
        ordered_json row{{"values", values}, {"runs", cell.finished}, {"failed", cell.failed}};
        for (const Measure* measure : taken_measures())
            row[measure->word] = spread_json(cell.figures[*measure]);
        row["skipped_lines"] = cell.skipped_lines;
        row["stamps_backwards"] = cell.stamps_backwards;
        for (const Message& doubt : cell.tour_doubts) row["tour_doubts"].push_back(doubt.english());
        rows.push_back(std::move(row));
    }
    ordered_json reference;
    if (plan.has_reference()) {
        reference = {{"lines", plan.reference_lines}, {"corners", plan.reference_corners}};
    }
    return json_text({{"reference", reference}, {"summary", rows}});
}

}  // namespace hitos
