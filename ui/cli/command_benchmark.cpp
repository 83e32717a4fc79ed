// SPDX-License-Identifier: GPL-3.0-or-later
// hitos-cli benchmark: tours by algorithms, as one table that anybody can make again.

#include <fmt/core.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "commands.hpp"
#include "hitos/base/atomic_file.hpp"
#include "hitos/base/error.hpp"
#include "hitos/base/plural.hpp"
#include "hitos/base/process.hpp"
#include "hitos/workbench/benchmark.hpp"
#include "options.hpp"
#include "report.hpp"
#include "study_console.hpp"

namespace hitos::cli {
namespace {

struct BenchmarkArguments {
    std::string plan;
    std::string tours;
    std::string relations;
    std::string out;
    std::optional<int> runs;
    int threads = 0;
    std::vector<std::string> only;
    std::string shard;
    std::string compare;
    bool no_pictures = false;
    bool json = false;
};

/// Those of the tours that the folder has any of; to have none at all is a slip of the pen.
void take_relations(BenchmarkPlan& plan, const std::filesystem::path& folder) {
    if (!std::filesystem::is_directory(folder)) {
        throw FileError(folder.string(), verbatim("is no folder; expected one with files such as " +
                                                  plan.tours.front().name + ".relations"));
    }
    bool any = false;
    for (BenchmarkTour& tour : plan.tours) {
        for (const char* ending : {".relations", ".relations.gz"}) {
            const std::filesystem::path file = folder / (tour.name + ending);
            std::error_code ignored;
            if (!std::filesystem::exists(file, ignored)) continue;
            tour.relations = file.string();
            any = true;
            break;
        }
    }
    if (any) return;
    throw FileError(folder.string(),
                    verbatim("has no relations of any tour of the plan; expected files such as " +
                             plan.tours.front().name + ".relations"));
}

BenchmarkPlan plan_of(const BenchmarkArguments& options) {
    BenchmarkPlan plan = read_benchmark_plan(find_benchmark(options.plan), options.tours);
    if (options.runs) plan.runs = *options.runs;
    const auto named = [&](const std::string& name) {
        return std::ranges::count(options.only, name) > 0;
    };
    const auto known = [&](const std::string& name) {
        return std::ranges::count(plan.tours, name, &BenchmarkTour::name) +
                   std::ranges::count(plan.algorithms, name, &BenchmarkAlgorithm::name) +
                   std::ranges::count(plan.peers, name, &BenchmarkPeer::name) >
               0;
    };
    for (const std::string& name : options.only) {
        if (known(name)) continue;
        std::vector<std::string> names;
        for (const BenchmarkTour& tour : plan.tours) names.push_back(tour.name);
        for (const BenchmarkAlgorithm& algorithm : plan.algorithms) names.push_back(algorithm.name);
        for (const BenchmarkPeer& peer : plan.peers) names.push_back(peer.name);
        throw ConfigError("--only",
                          verbatim(fmt::format("found \"{}\"; expected a tour, an algorithm or "
                                               "a peer of the plan: {}",
                                               name, fmt::join(names, ", "))));
    }
    const auto any_of = [&](const auto& things) {
        return std::ranges::any_of(things, [&](const auto& thing) { return named(thing.name); });
    };
    const auto keep = [&](auto& things) {
        std::erase_if(things, [&](const auto& thing) { return !named(thing.name); });
    };
    if (any_of(plan.tours)) keep(plan.tours);
    if (any_of(plan.algorithms) || any_of(plan.peers)) {
        keep(plan.algorithms);
        keep(plan.peers);
    }
    std::erase_if(plan.peers, [&](const BenchmarkPeer& peer) {
        return std::ranges::count(plan.tours, peer.tour, &BenchmarkTour::name) == 0;
    });
    if (!options.relations.empty()) take_relations(plan, options.relations);
    return plan;
}

std::filesystem::path changes_file(const BenchmarkArguments& options) {
    return std::filesystem::path(options.out) / "changes.md";
}

/// Says what has changed, and whether anything is worse.
bool tell_changes(const BenchmarkTable& former, const BenchmarkTable& table,
                  const BenchmarkArguments& options, Report& report) {
    using Verdict = BenchmarkChange::Verdict;
    if (former.runs != table.runs || former.first_seed != table.first_seed) {
        report.note(fmt::format("{} has {} of each row, with seeds from {}", options.compare,
                                plural(former.runs, "run"), former.first_seed));
    }
    const std::vector<BenchmarkChange> changes = compare_benchmarks(former, table);
    const TextTable words = changes_table(changes);
    write_file(changes_file(options),
               fmt::format("Since {}\n\n{}", on_one_line(options.compare), markdown(words)));
    report.say("\n{}", markdown(words));
    const auto count = [&](Verdict verdict) {
        return std::ranges::count(changes, verdict, &BenchmarkChange::verdict);
    };
    report.object()["changes"] = {
        {"same", count(Verdict::same)},       {"within", count(Verdict::within)},
        {"better", count(Verdict::better)},   {"worse", count(Verdict::worse)},
        {"unknown", count(Verdict::unknown)}, {"gone", count(Verdict::gone)},
        {"new", count(Verdict::appeared)}};
    return count(Verdict::worse) > 0;
}

int benchmark(const BenchmarkArguments& arguments) {
    const BenchmarkPlan plan = plan_of(arguments);
    BenchmarkOptions options;
    options.out = arguments.out;
    options.threads = arguments.threads;
    options.pictures = !arguments.no_pictures;
    options.shard = arguments.shard.empty()
                        ? scheduler_shard(process_environment()).value_or(StudyShard{})
                        : parse_shard(arguments.shard);
    std::optional<BenchmarkTable> former;  // which may be where the new one is written
    if (!arguments.compare.empty()) {
        if (!options.shard.whole()) {
            throw ConfigError("--compare", verbatim("a part is compared with nothing; leave it out "
                                                    "until the command that makes the table"));
        }
        former = read_benchmark(arguments.compare);
    }
    StudyTeller teller;
    options.observer = teller.observer();
    const StopSource stop;
    options.stop = stop.token();
    const BenchmarkTable table = run_benchmark(plan, options);
    if (table.stopped) {
        teller.say("stopped; the same command goes on with the rest");
        return StopByRequest::status();
    }
    teller.finish();
    Report report(arguments.json);
    bool failed =
        std::ranges::any_of(table.rows, [](const BenchmarkRow& row) { return row.failed > 0; });
    if (!options.shard.whole()) {
        report.say(
            "part {} of {} done; when all are, the same command without --shard makes the "
            "table\n",
            options.shard.index, options.shard.count);
        report.object() = {{"shard", options.shard.index}, {"shards", options.shard.count}};
    } else {
        if (const Message problem = write_benchmark(table, options.out); !problem.empty())
            report.warn(problem.english());
        report.say("{}", markdown(benchmark_table(table)));
        report.object() = parsed_object(benchmark_json(table));
        std::error_code none;
        std::filesystem::remove(changes_file(arguments), none);  // those of another table
        if (former) failed = tell_changes(*former, table, arguments, report) || failed;
    }
    for (const BenchmarkRow& row : table.rows) {
        for (const std::string& words : {row.problem, row.remark}) {
            if (!words.empty())
                report.warn(fmt::format("{}, {}: {}", row.tour, row.algorithm, words));
        }
    }
    if (options.shard.whole()) report.say("{}\n", (options.out / "benchmark.html").string());
    report.end();
    return failed ? kSomeFailed : 0;
}

}  // namespace

void add_benchmark(CLI::App& program) {
    auto options = std::make_shared<BenchmarkArguments>();
    CLI::App* command = program.add_subcommand(
        "benchmark", "Tours by algorithms, several runs of each, as one table");
    command->footer(
        "Stopped, it goes on where it was when it is started again. Ends with status 2 where a\n"
        "row has a failed run, or with --compare a figure is worse. See docs/benchmark.md.");
    command
        ->add_option("plan", options->plan,
                     fmt::format("Plan (TOML), or the name of one that comes with Hitos: {}",
                                 fmt::join(shipped_benchmarks(), ", ")))
        ->required();
    command->add_option("--tours", options->tours,
                        "Folder in which the plan's files are looked for, before the plan's own");
    command->add_option("--relations", options->relations,
                        "Folder of relations between true poses (NAME.relations, or .gz): tours "
                        "that have a file there are measured by it, too");
    command
        ->add_option("--out", options->out,
                     "Folder for the table (benchmark.md, .csv, .tex, .html, .json) and the runs, "
                     "made if missing")
        ->required()
        ->check(&complaint_of_output);
    command
        ->add_option("--only", options->only,
                     "Only this tour, algorithm or peer, by its name in the plan; may be repeated")
        ->allow_extra_args(false);
    command->add_option("--runs", options->runs, "Runs of each row (default: as the plan says)")
        ->check(CLI::Range(1, 1000000));
    command
        ->add_option("--threads", options->threads,
                     "Runs at a time (default: as many as the machine has); results do not depend "
                     "on it")
        ->check(CLI::Range(0, 256));
    command->add_option("--shard", options->shard,
                        "Do part i of n only, e.g. 2/8 (default: what the job array says, else "
                        "all); all parts share the folder");
    command->add_option("--compare", options->compare,
                        "Folder of an earlier benchmark: say what has changed beyond the spread of "
                        "the seeds");
    command->add_flag("--no-pictures", options->no_pictures,
                      "Draw no grid maps: they cost about a fifth of a run (where a tour has no "
                      "reference map, they are measured all the same)");
    add_report_option(*command, options->json);
    command->callback([options] {
        const int status = benchmark(*options);
        if (status != 0) throw CLI::RuntimeError(status);
    });
}

}  // namespace hitos::cli
