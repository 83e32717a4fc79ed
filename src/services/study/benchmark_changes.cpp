// SPDX-License-Identifier: GPL-3.0-or-later
// What has changed from one benchmark to the next.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "hitos/base/geometry.hpp"
#include "hitos/services/study/benchmark_table.hpp"

namespace hitos {
namespace {

using Verdict = BenchmarkChange::Verdict;

constexpr double kLevel = 0.05;

const char* word_of(Verdict verdict) {
    switch (verdict) {
        case Verdict::same:
            return "same bits";
        case Verdict::within:
            return "within chance";
        case Verdict::better:
            return "better";
        case Verdict::worse:
            return "worse";
        case Verdict::unknown:
            return "cannot be told of one run";
        case Verdict::gone:
            return "gone";
        case Verdict::appeared:
            return "new";
        case Verdict::other:
            return "another setting";
    }
    return "";
}

/// The integral of cos^power from `from` to pi/2, by Simpson's rule.
double tail_of_cosine(double power, double from) {
    constexpr int kSteps = 2000;  // even
    const double width = (kPi / 2.0 - from) / kSteps;
    const auto value = [&](int i) {
        return std::pow(std::max(std::cos(from + i * width), 0.0), power);
    };
    double sum = value(0) + (power > 0.0 ? 0.0 : 1.0);
    for (int i = 1; i < kSteps; ++i) sum += (i % 2 == 1 ? 4.0 : 2.0) * value(i);
    return sum * width / 3.0;
}

/// That a variable of Student's distribution is further from 0 than t: with t = sqrt(degrees) tan
/// phi its density is that of cos^(degrees - 1) phi.
double two_sided(double t, double degrees) {
    const double phi = std::atan(std::abs(t) / std::sqrt(degrees));
    return tail_of_cosine(degrees - 1.0, phi) / tail_of_cosine(degrees - 1.0, 0.0);
}

/// That the means of two spreads lie so far apart by chance; nothing where nobody can tell.
std::optional<double> chance_of(const Spread& a, const Spread& b) {
    constexpr double kRounding = 1e-9;
    const double apart = a.mean - b.mean;
    if (std::abs(apart) <= kRounding * std::max(std::abs(a.mean), std::abs(b.mean))) return 1.0;
    if (!a.variance || !b.variance) return std::nullopt;
    const double of_a = *a.variance / a.count;
    const double of_b = *b.variance / b.count;
    const double sum = of_a + of_b;
    if (sum == 0.0) return 0.0;
    const double degrees = sum * sum / (of_a * of_a / (a.count - 1) + of_b * of_b / (b.count - 1));
    return two_sided(apart / std::sqrt(sum), degrees);
}

/// How far from what it ought to be; nothing where nobody knows that.
std::optional<double> badness(const Measure& measure, double value, const BenchmarkRow& row) {
    if (measure.word == "odometry_error_m") return std::nullopt;
    if (measure.target) return std::abs(value - *measure.target);
    if (!measure.is_count()) return value;
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
    change.chance = chance_of(*old, *now);
    change.verdict = !change.chance             ? Verdict::unknown
                     : *bad_after > *bad_before ? Verdict::worse
                     : *bad_after < *bad_before ? Verdict::better
                                                : Verdict::within;
    changes.push_back(std::move(change));
}

/// Leaves of what is better or worse what is so beyond chance.
void judge(std::vector<BenchmarkChange>& changes) {
    std::vector<BenchmarkChange*> judged;
    for (BenchmarkChange& change : changes)
        if (change.chance) judged.push_back(&change);
    std::ranges::stable_sort(judged, {}, [](const BenchmarkChange* one) { return *one->chance; });
    bool beyond = true;
    for (std::size_t k = 0; k < judged.size(); ++k) {
        beyond = beyond && *judged[k]->chance <= kLevel / static_cast<double>(judged.size() - k);
        if (!beyond) judged[k]->verdict = Verdict::within;
    }
}

}  // namespace

std::vector<BenchmarkChange> compare_benchmarks(const BenchmarkTable& before,
                                                const BenchmarkTable& after) {
    std::vector<BenchmarkChange> changes;
    const auto twin = [](const BenchmarkTable& table, const BenchmarkRow& row) {
        const auto found = std::ranges::find_if(table.rows, [&](const BenchmarkRow& other) {
            return other.tour == row.tour && other.algorithm == row.algorithm &&
                   other.peer == row.peer;
        });
        return found == table.rows.end() ? nullptr : &*found;
    };
    for (const BenchmarkRow& row : after.rows) {
        const BenchmarkRow* old = twin(before, row);
        if (old == nullptr) {
            changes.push_back({row.tour, row.algorithm, "", Verdict::appeared});
        } else if (row.setting && old->setting && *row.setting != *old->setting) {
            changes.push_back({row.tour, row.algorithm, "", Verdict::other});
        } else if (!row.hash.empty() && row.hash == old->hash) {
            changes.push_back({row.tour, row.algorithm, "", Verdict::same});
        } else {
            for (const Measure* measure : taken_measures())
                compare_figure(*measure, *old, row, changes);
        }
    }
    for (const BenchmarkRow& row : before.rows) {
        if (twin(after, row) == nullptr)
            changes.push_back({row.tour, row.algorithm, "", Verdict::gone});
    }
    judge(changes);
    return changes;
}

TextTable changes_table(const std::vector<BenchmarkChange>& changes) {
    TextTable table;
    table.head = {"tour", "algorithm", "figure", "before", "now", "chance", ""};
    for (const BenchmarkChange& change : changes) {
        const auto number = [&](const std::optional<double>& value) {
            if (!value) return std::string(kNoFigure);
            return run_measures().find(change.measure).rounded(*value, true);
        };
        table.rows.push_back({change.tour, change.algorithm,
                              change.measure.empty() ? "all" : change.measure,
                              number(change.before), number(change.after),
                              change.chance ? fmt::format("{:.2g}", *change.chance) : kNoFigure,
                              word_of(change.verdict)});
    }
    return table;
}

}  // namespace hitos
