// SPDX-License-Identifier: GPL-3.0-or-later
#include "calibration_table.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace hitos::study {
namespace {

const char* verdict(const NeesFigure& nees) {
    if (nees.mean > nees.interval.high) return "too sure";
    return nees.mean < nees.interval.low ? "too careful" : "within";
}

}  // namespace

TextTable calibration_table(std::vector<std::string> keys, std::span<const CalibrationRow> rows) {
    TextTable table{std::move(keys), {}};
    table.head.insert(table.head.end(), {"of", "runs"});
    for (const double region : kRegions)
        table.head.push_back(fmt::format("in {:.0f} %", 100.0 * region));
    table.head.insert(table.head.end(), {"NEES", "ought to be", "limits of 95 %", "verdict"});
    for (const CalibrationRow& row : rows) {
        for (const CalibrationKind& kind : kCalibrationKinds) {
            const std::optional<NeesFigure> nees = nees_figure(*row.figures, kind);
            if (!nees) continue;
            std::vector<std::string> fields = row.keys;
            fields.insert(fields.end(), {kind.name, fmt::format("{}", nees->runs)});
            for (const auto& share : shares_in_regions(*row.figures, kind))
                fields.push_back(share ? fmt::format("{:.3f}", *share) : kNoFigure);
            fields.push_back(fmt::format("{:.2f}", nees->mean));
            fields.push_back(fmt::format("{}", nees->degrees));
            fields.push_back(
                fmt::format("{:.2f} to {:.2f}", nees->interval.low, nees->interval.high));
            fields.emplace_back(verdict(*nees));
            table.rows.push_back(std::move(fields));
        }
    }
    return table;
}

std::string below(const TextTable& table, std::string (*form)(const TextTable&),
                  const char* remark) {
    if (table.rows.empty()) return {};
    return fmt::format("\n{}{}\n\n{}", remark, kCalibrationWords, form(table));
}

IntervalColumns::IntervalColumns(std::span<const ByMeasure<Spread>* const> all) {
    for (const CalibrationKind& kind : kCalibrationKinds) {
        const auto has = [&](const ByMeasure<Spread>* one) { return has_shares(*one, kind); };
        if (std::ranges::any_of(all, has)) kinds_.push_back(&kind);
    }
}

std::vector<std::pair<std::string, std::string>> IntervalColumns::of(
    const ByMeasure<Spread>& figures) const {
    std::vector<std::pair<std::string, std::string>> fields;
    for (const CalibrationKind* kind : kinds_) {
        const std::optional<NeesFigure> nees = nees_figure(figures, *kind);
        // Not with every digit: the last ones are the library's.
        const auto add = [&](const char* end, double NeesInterval::*limit) {
            fields.emplace_back(fmt::format("{}_nees_{}", kind->word, end),
                                nees ? fmt::format("{:.6f}", nees->interval.*limit) : "");
        };
        add("low", &NeesInterval::low);
        add("high", &NeesInterval::high);
    }
    return fields;
}

}  // namespace hitos::study
