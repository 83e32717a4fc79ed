// SPDX-License-Identifier: GPL-3.0-or-later
// A benchmark's table: for people, papers, spreadsheets, browsers and programs.
#include "hitos/services/study/benchmark_table.hpp"

#include <fmt/format.h>

#include <nlohmann/json.hpp>

#include "calibration_plot.hpp"
#include "calibration_table.hpp"
#include "hitos/base/atomic_file.hpp"
#include "hitos/base/error.hpp"
#include "hitos/base/staged_files.hpp"
#include "hitos/base/text_input.hpp"
#include "json_input.hpp"
#include "spread_json.hpp"

namespace hitos {
namespace {

using nlohmann::ordered_json;

constexpr const char* kJson = "benchmark.json";
constexpr int kForm = 1;  // of benchmark.json
constexpr std::size_t kShortHash = 8;
constexpr const char* kCosts =
    "Processor time of the stages of a run, and memory of its state at the end:";

/// Those that a row of the table has; for people without details.
std::vector<const Measure*> told_measures(const BenchmarkTable& table, bool for_people) {
    std::vector<const Measure*> measures = taken_measures();
    std::erase_if(measures, [&](const Measure* measure) {
        const auto has = [&](const BenchmarkRow& row) { return row.figures[*measure].has_value(); };
        return (for_people && measure->detail) || std::ranges::none_of(table.rows, has);
    });
    return measures;
}

/// The mean, and of several runs' errors the greatest behind it.
std::string figure_words(const Measure& measure, const std::optional<Spread>& spread) {
    if (!spread) return kNoFigure;
    std::string mean = measure.rounded(spread->mean, true);
    if (spread->count < 2 || measure.unit.empty()) return mean;
    return fmt::format("{} ({})", mean, measure.rounded(spread->maximum, true));
}

std::string runs_words(const BenchmarkRow& row) {
    if (row.failed == 0) return fmt::format("{}", row.runs);
    return fmt::format("{} of {}", row.runs, row.runs + row.failed);
}

std::string in_html(std::string_view text) {
    std::string html;
    for (const char c : text) {
        switch (c) {
            case '<':
                html += "&lt;";
                break;
            case '>':
                html += "&gt;";
                break;
            case '&':
                html += "&amp;";
                break;
            case '"':
                html += "&quot;";
                break;
            default:
                html += c;
        }
    }
    return html;
}

double ms_per_scan(const BenchmarkRow& row, double seconds) {
    return row.scans > 0.0 ? 1e3 * seconds / row.scans : 0.0;
}

void add_table(std::string& html, const TextTable& table) {
    html += "<table>\n<tr>";
    for (const std::string& head : table.head) html += fmt::format("<th>{}</th>", in_html(head));
    html += "</tr>\n";
    for (const std::vector<std::string>& row : table.rows) {
        html += "<tr>";
        for (const std::string& field : row) html += fmt::format("<td>{}</td>", in_html(field));
        html += "</tr>\n";
    }
    html += "</table>\n";
}

std::string remarks(const BenchmarkTable& table) {
    std::string text = fmt::format(
        "Each row: {} runs, seeds from {}. Means, in brackets the worst run; ms/scan is processor "
        "time. Equal hashes: equal figures and maps, bit by bit.\n\nHitos {}, {}.\nOn {}.\n",
        table.runs, table.first_seed, table.version, table.program, table.machine);
    for (const BenchmarkRow& row : table.rows) {
        std::string setting = row.setting.value_or("");
        if (!setting.empty()) setting = fmt::format("with {}.", setting);
        for (const std::string& words : {setting, row.problem, row.remark}) {
            if (words.empty()) continue;
            text += fmt::format("\n{}, {}: {}\n", row.tour, row.algorithm, on_one_line(words));
        }
    }
    return text;
}

/// Of a path within the folder of the page.
std::string in_address(const std::filesystem::path& path) {
    std::string address;
    for (const char c : path.generic_string()) {
        const bool plain = (c >= '0' && c <= '9') || (c >= 'a' && c <= 'z') ||
                           (c >= 'A' && c <= 'Z') ||
                           std::string_view("/.-_").find(c) != std::string_view::npos;
        address +=
            plain ? std::string(1, c) : fmt::format("%{:02X}", static_cast<unsigned char>(c));
    }
    return address;
}

TextTable calibration_of(const BenchmarkTable& table) {
    std::vector<study::CalibrationRow> rows;
    for (const BenchmarkRow& row : table.rows)
        rows.push_back({{row.tour, row.algorithm}, &row.figures});
    return study::calibration_table({"tour", "algorithm"}, rows);
}

std::string costs_words(const BenchmarkTable& table) {
    const TextTable costs = benchmark_costs(table);
    if (costs.rows.empty()) return {};
    return fmt::format("\n{}\n\n{}", kCosts, markdown(costs));
}

std::string benchmark_html(const BenchmarkTable& table, const std::filesystem::path& out) {
    std::string html = fmt::format(
        "<!DOCTYPE html>\n<html lang=\"en\">\n<meta charset=\"utf-8\">\n"
        "<meta name=\"viewport\" content=\"width=device-width\">\n<title>{0}</title>\n<style>\n"
        "body {{ font: 15px/1.5 sans-serif; margin: 2em; color: #222; }}\n"
        "table {{ border-collapse: collapse; }}\n"
        "th, td {{ padding: .25em .7em; text-align: right; border-bottom: 1px solid #ddd; }}\n"
        "th:nth-child(-n+2), td:nth-child(-n+2) {{ text-align: left; }}\n"
        "figure {{ display: inline-block; margin: 1em 1em 0 0; max-width: 30em; }}\n"
        "figure img {{ max-width: 100%; }}\n</style>\n<h1>{0}</h1>\n",
        in_html(table.title));
    add_table(html, benchmark_table(table));
    std::string_view rest;
    const std::string all = remarks(table);
    for (rest = all; const auto line = input::next_line(rest);) {
        if (!line->empty()) html += fmt::format("<p>{}</p>\n", in_html(*line));
    }
    if (const TextTable costs = benchmark_costs(table); !costs.rows.empty()) add_table(html, costs);
    if (const TextTable truth = calibration_of(table); !truth.rows.empty()) {
        html += fmt::format("<p>{}</p>\n", in_html(study::kCalibrationWords));
        add_table(html, truth);
    }
    const std::string plot = std::string(study::kCalibrationPlot) + ".svg";
    if (std::error_code none; std::filesystem::exists(out / plot, none)) {
        html += fmt::format(
            "<p><img src=\"{}\" alt=\"Shares of the truth in the filters' regions\"></p>\n", plot);
    }
    for (const BenchmarkRow& row : table.rows) {
        if (row.map.empty()) continue;
        html += fmt::format(
            "<figure><img src=\"{0}\" alt=\"Grid map\"><figcaption>{1}, {2}</figcaption></figure>"
            "\n",
            in_address(row.map), in_html(row.tour), in_html(row.algorithm));
    }
    return html + "</html>\n";
}

/// A column for every statistic of every figure.
std::string benchmark_csv(const BenchmarkTable& table) {
    const std::vector<const Measure*> measures = told_measures(table, false);
    TextTable text;
    text.head = {"tour", "algorithm", "peer", "runs", "failed"};
    for (const Measure* measure : measures) {
        text.head.push_back(measure->word);
        text.head.push_back(measure->word_of("variance", true));
        text.head.push_back(measure->word_of("minimum"));
        text.head.push_back(measure->word_of("maximum"));
    }
    for (const char* word :
         {"reference_landmarks", "cpu_seconds", "scans", "hash", "problem", "remark"})
        text.head.emplace_back(word);
    for (const char* stage : kRunStages) text.head.push_back(fmt::format("{}_seconds", stage));
    text.head.emplace_back("state_bytes");
    std::vector<const ByMeasure<Spread>*> all;
    for (const BenchmarkRow& row : table.rows) all.push_back(&row.figures);
    const study::IntervalColumns intervals(all);
    for (auto& [column, none] : intervals.of({})) text.head.push_back(std::move(column));
    text.head.emplace_back("setting");
    for (const BenchmarkRow& row : table.rows) {
        std::vector<std::string> fields{row.tour, row.algorithm, row.peer ? "1" : "0",
                                        fmt::format("{}", row.runs), fmt::format("{}", row.failed)};
        for (const Measure* measure : measures) {
            const std::optional<Spread>& spread = row.figures[*measure];
            fields.push_back(spread ? fmt::format("{}", spread->mean) : "");
            fields.push_back(spread && spread->variance ? fmt::format("{}", *spread->variance)
                                                        : "");
            fields.push_back(spread ? fmt::format("{}", spread->minimum) : "");
            fields.push_back(spread ? fmt::format("{}", spread->maximum) : "");
        }
        fields.push_back(row.reference_landmarks ? fmt::format("{}", *row.reference_landmarks)
                                                 : "");
        fields.push_back(fmt::format("{:.6f}", row.cpu_seconds));
        fields.push_back(fmt::format("{}", row.scans));
        fields.push_back(row.hash);
        fields.push_back(row.problem);
        fields.push_back(row.remark);
        for (std::size_t i = 0; i < kRunStages.size(); ++i)
            fields.push_back(row.stages ? fmt::format("{:.6f}", row.stages->at(i)) : "");
        fields.push_back(row.stages ? fmt::format("{:.0f}", row.state_bytes) : "");
        for (auto& [column, limit] : intervals.of(row.figures)) fields.push_back(std::move(limit));
        fields.push_back(row.setting.value_or(""));
        text.rows.push_back(std::move(fields));
    }
    return csv(text);
}

std::optional<Spread> spread_in(const ordered_json& json) {
    if (json.is_null()) return std::nullopt;
    Spread spread{json.at("measured"), json.at("mean"), std::nullopt, json.at("minimum"),
                  json.at("maximum")};
    if (!json.at("variance").is_null()) spread.variance = json.at("variance").get<double>();
    return spread;
}

BenchmarkRow row_in(const ordered_json& json) {
    BenchmarkRow row;
    row.tour = json.at("tour");
    row.algorithm = json.at("algorithm");
    row.peer = json.at("peer");
    row.setting.reset();
    if (json.contains("setting")) row.setting = json.at("setting").get<std::string>();
    row.runs = json.at("runs");
    row.failed = json.at("failed");
    row.hash = json.at("hash");
    row.problem = json.at("problem");
    row.remark = json.at("remark");
    row.cpu_seconds = json.at("cpu_seconds");
    row.scans = json.at("scans");
    row.stages = stages_in(json);
    row.state_bytes = json.value("state_bytes", 0.0);
    if (!json.at("reference_landmarks").is_null()) {
        row.reference_landmarks = json.at("reference_landmarks").get<int>();
    }
    for (const Measure* measure : taken_measures()) {
        const auto figure = json.find(measure->word);  // of a later program there may be others
        if (figure != json.end()) row.figures[*measure] = spread_in(*figure);
    }
    return row;
}

}  // namespace

TextTable benchmark_table(const BenchmarkTable& table, bool for_latex) {
    const std::vector<const Measure*> measures = told_measures(table, true);
    const bool referenced = std::ranges::any_of(
        table.rows, [](const BenchmarkRow& row) { return row.reference_landmarks.has_value(); });
    TextTable text;
    text.head = {"tour", "algorithm", "runs"};
    for (const Measure* measure : measures)
        text.head.push_back(
            with_unit(measure->label, for_latex ? measure->unit : printed_unit(measure->unit)));
    if (referenced) text.head.emplace_back("true landmarks");
    text.head.emplace_back("ms/scan");
    text.head.emplace_back("hash");
    for (const BenchmarkRow& row : table.rows) {
        std::vector<std::string> fields{row.tour, row.algorithm, runs_words(row)};
        for (const Measure* measure : measures)
            fields.push_back(figure_words(*measure, row.figures[*measure]));
        if (referenced) {
            fields.push_back(row.reference_landmarks ? fmt::format("{}", *row.reference_landmarks)
                                                     : kNoFigure);
        }
        fields.push_back(row.scans > 0.0 ? fmt::format("{:.2f}", ms_per_scan(row, row.cpu_seconds))
                                         : kNoFigure);
        fields.push_back(row.hash.empty() ? kNoFigure : row.hash.substr(0, kShortHash));
        text.rows.push_back(std::move(fields));
    }
    return text;
}

TextTable benchmark_costs(const BenchmarkTable& table) {
    constexpr double kMebibyte = 1024.0 * 1024.0;
    TextTable text;
    text.head = {"tour", "algorithm"};
    for (const char* stage : kRunStages) text.head.push_back(fmt::format("{} [ms/scan]", stage));
    text.head.emplace_back("state [MiB]");
    for (const BenchmarkRow& row : table.rows) {
        if (!row.stages || row.scans <= 0.0) continue;
        std::vector<std::string> fields{row.tour, row.algorithm};
        for (const double seconds : *row.stages)
            fields.push_back(fmt::format("{:.3f}", ms_per_scan(row, seconds)));
        fields.push_back(fmt::format("{:.1f}", row.state_bytes / kMebibyte));
        text.rows.push_back(std::move(fields));
    }
    return text;
}

std::string benchmark_json(const BenchmarkTable& table) {
    ordered_json rows = ordered_json::array();
    for (const BenchmarkRow& row : table.rows) {
        ordered_json json{{"tour", row.tour},
                          {"algorithm", row.algorithm},
                          {"peer", row.peer},
                          {"setting", row.setting.value_or("")},
                          {"runs", row.runs},
                          {"failed", row.failed},
                          {"hash", row.hash},
                          {"problem", row.problem},
                          {"remark", row.remark},
                          {"cpu_seconds", row.cpu_seconds},
                          {"scans", row.scans},
                          {"stage_seconds", stages_json(row.stages)},
                          {"state_bytes", row.state_bytes}};
        json["reference_landmarks"] =
            row.reference_landmarks ? ordered_json(*row.reference_landmarks) : ordered_json();
        for (const Measure* measure : taken_measures())
            json[measure->word] = spread_json(row.figures[*measure]);
        rows.push_back(std::move(json));
    }
    return json_text({{"benchmark", kForm},
                      {"title", table.title},
                      {"version", table.version},
                      {"program", table.program},
                      {"machine", table.machine},
                      {"runs", table.runs},
                      {"first_seed", table.first_seed},
                      {"rows", rows}});
}

/// Of every algorithm, over the tours.
Message write_calibration(const BenchmarkTable& table, const std::filesystem::path& out) {
    std::vector<std::string> names;
    for (const BenchmarkRow& row : table.rows)
        if (std::ranges::count(names, row.algorithm) == 0) names.push_back(row.algorithm);
    std::vector<ByMeasure<Spread>> shares;
    for (const std::string& name : names) {
        std::vector<const ByMeasure<Spread>*> rows;
        for (const BenchmarkRow& row : table.rows)
            if (row.algorithm == name) rows.push_back(&row.figures);
        shares.push_back(study::mean_shares(rows));
    }
    std::vector<study::CalibrationCurve> curves;
    for (std::size_t i = 0; i < names.size(); ++i) curves.push_back({names[i], &shares[i]});
    return study::write_calibration(study_in_folder(out), curves);
}

Message write_benchmark(const BenchmarkTable& table, const std::filesystem::path& out) {
    for (const char* extension : {".dat", ".gp", ".png", ".svg"}) {  // of another table
        std::error_code none;
        std::filesystem::remove(out / (std::string(study::kCalibrationPlot) + extension), none);
    }
    Message problem = write_calibration(table, out);
    const TextTable words = benchmark_table(table);
    const std::string heading = fmt::format("# {}\n\n", on_one_line(table.title));
    const std::vector<std::pair<const char*, std::string>> texts{
        {"benchmark.csv", benchmark_csv(table)},
        {"benchmark.md", heading + markdown(words) + "\n" + remarks(table) + costs_words(table) +
                             study::below(calibration_of(table), markdown)},
        {"benchmark.tex",
         latex(benchmark_table(table, true)) + study::below(calibration_of(table), latex, "% ")},
        {"benchmark.html", benchmark_html(table, out)},
        {kJson, benchmark_json(table) + "\n"}};
    std::vector<std::filesystem::path> files;
    files.reserve(texts.size());
    for (const auto& [name, text] : texts) files.push_back(out / name);
    StagedFiles staged(files);
    staged.write([&] {
        for (const auto& [name, text] : texts) write_file(staged.staged(out / name), in_utf8(text));
    });
    staged.commit();
    return problem;
}

BenchmarkTable read_benchmark(const std::filesystem::path& out) {
    const std::string file = (out / kJson).string();
    const std::string text = input::read_text(file, input::kLargestSettings);
    try {
        const auto json = parsed<ordered_json>(text, file);
        if (json.at("benchmark") != kForm) {
            throw FormatError(file, 0, HITOS_TEXT("Errors", "is no table of a benchmark"));
        }
        BenchmarkTable table;
        table.title = json.at("title");
        table.version = json.at("version");
        table.program = json.at("program");
        table.machine = json.at("machine");
        table.runs = json.at("runs");
        table.first_seed = json.at("first_seed");
        for (const ordered_json& row : json.at("rows")) table.rows.push_back(row_in(row));
        return table;
    } catch (const ordered_json::exception& error) {
        throw FormatError(file, 0, verbatim(error.what()));
    }
}

}  // namespace hitos
