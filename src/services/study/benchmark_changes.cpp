// What has changed from one benchmark to the next.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "hitos/services/study/benchmark_table.hpp"

namespace hitos {
namespace {

using Verdict = BenchmarkChange::Verdict;

constexpr double kSureness = 1.959964;  // of a normal variable, 95 of 100 lie within

const char* word_of(Verdict verdict) {
    switch (verdict) {
        case Verdict::same:
            return "same bits";
        case Verdict::within:
            return "within the spread";
        case Verdict::better:
            return "better";
        case Verdict::worse:
            return "worse";
        case Verdict::gone:
            return "gone";
        case Verdict::appeared:
            return "new";
    }
    return "";
}

/// Of the mean's square.
double variance_of_mean(const Spread& spread) {
    return spread.variance.value_or(0.0) / spread.count;
}

/// How far from what it ought to be; nothing where nobody knows that.
std::optional<double> badness(const Measure& measure, double value, const BenchmarkRow& row) {
    if (!measure.is_count())
        return measure.word == "odometry_error_m" ? std::nullopt : std::optional(value);
    if (measure.word != "landmarks" || !row.reference_landmarks) return std::nullopt;
    return std::abs(value - *row.reference_landmarks);
}

void compare_figure(const Measure& measure, const BenchmarkRow& before, const BenchmarkRow& after,
                    std::vector<BenchmarkChange>& changes) {
    const std::optional<Spread>& old = before.figures[measure];
    const std::optional<Spread>& now = after.figures[measure];
    if (!old && !now) return;
    BenchmarkChange change{after.tour, after.algorithm, measure.word};
    if (old) change.before = old->mean;
    if (now) change.after = now->mean;
    if (!old || !now) {
        change.verdict = old ? Verdict::gone : Verdict::appeared;
        changes.push_back(std::move(change));
        return;
    }
    const auto bad_before = badness(measure, old->mean, before);
    const auto bad_after = badness(measure, now->mean, after);
    if (!bad_before || !bad_after) return;
    change.spread = kSureness * std::sqrt(variance_of_mean(*old) + variance_of_mean(*now));
    const double worse_by = *bad_after - *bad_before;
    change.verdict = std::abs(now->mean - old->mean) <= change.spread ? Verdict::within
                     : worse_by > 0.0                                 ? Verdict::worse
                     : worse_by < 0.0                                 ? Verdict::better
                                                                      : Verdict::within;
    changes.push_back(std::move(change));
}

}  // namespace

std::vector<BenchmarkChange> compare_benchmarks(const BenchmarkTable& before,
                                                const BenchmarkTable& after) {
    std::vector<BenchmarkChange> changes;
    const auto twin = [](const BenchmarkTable& table, const BenchmarkRow& row) {
        const auto found = std::ranges::find_if(table.rows, [&](const BenchmarkRow& other) {
            return other.tour == row.tour && other.algorithm == row.algorithm;
        });
        return found == table.rows.end() ? nullptr : &*found;
    };
    for (const BenchmarkRow& row : after.rows) {
        const BenchmarkRow* old = twin(before, row);
        if (old == nullptr) {
            changes.push_back({row.tour, row.algorithm, "", Verdict::appeared});
        } else if (!row.hash.empty() && row.hash == old->hash) {
            changes.push_back({row.tour, row.algorithm, "", Verdict::same});
        } else {
            for (const Measure* measure : taken_measures())
                compare_figure(*measure, *old, row, changes);
        }
    }
    for (const BenchmarkRow& row : before.rows) {
        if (twin(after, row) == nullptr) {
            changes.push_back({row.tour, row.algorithm, "", Verdict::gone});
        }
    }
    return changes;
}

TextTable changes_table(const std::vector<BenchmarkChange>& changes) {
    TextTable table;
    table.head = {"tour", "algorithm", "figure", "before", "now", "spread", ""};
    for (const BenchmarkChange& change : changes) {
        const auto number = [&](const std::optional<double>& value) {
            if (!value) return std::string(kNoFigure);
            return run_measures().find(change.measure).rounded(*value, true);
        };
        const bool whole = change.measure.empty();
        table.rows.push_back({change.tour, change.algorithm, whole ? "all" : change.measure,
                              number(change.before), number(change.after),
                              whole ? std::string(kNoFigure) : number(change.spread),
                              word_of(change.verdict)});
    }
    return table;
}

}  // namespace hitos
