// SPDX-License-Identifier: GPL-3.0-or-later
// hitos-cli relations: relations of a reference trajectory, to measure others by.

#include <fmt/core.h>

#include <algorithm>
#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "commands.hpp"
#include "hitos/base/atomic_file.hpp"
#include "hitos/base/error.hpp"
#include "hitos/base/input_files.hpp"
#include "hitos/base/plural.hpp"
#include "hitos/base/process.hpp"
#include "hitos/services/evaluation/relations.hpp"
#include "hitos/services/files/trajectory_file.hpp"
#include "options.hpp"
#include "report.hpp"
#include "spacing_options.hpp"

namespace hitos::cli {
namespace {

struct RelationsOptions {
    std::string trajectory;
    std::string out;
    std::optional<double> distance_m;
    std::optional<double> time_s;
    PairSpacing spacing;
    bool json = false;
};

void make_relations(RelationsOptions options) {
    options.trajectory = input_named(options.trajectory, "trajectory");
    const std::filesystem::path out = options.out;
    const std::filesystem::path in = options.trajectory;
    check_apart({&out, 1}, {&in, 1});
    if (options.time_s) {
        options.spacing.by = PairSpacing::By::time;
        options.spacing.length = *options.time_s;
    } else {
        options.spacing.length = options.distance_m.value_or(1.0);
    }
    Trajectory trajectory = read_trajectory(options.trajectory);
    std::ranges::stable_sort(trajectory, {}, &StampedPose::time_s);
    const std::vector<PoseRelation> relations =
        relations_of(trajectory, pose_pairs(trajectory, options.spacing));
    if (relations.empty()) {
        throw FormatError(
            options.trajectory, 0,
            verbatim(fmt::format("has no two poses that are {:g} {} apart; nothing is written",
                                 options.spacing.length, options.time_s ? "s" : "m of way")));
    }
    write_file(out, relations_text(relations));
    Report report(options.json);
    report.say("{} of {} in {}\n", plural(relations.size(), "relation"),
               plural(trajectory.size(), "pose"), on_one_line(options.out));
    report.object() = {
        {"file", options.out}, {"relations", relations.size()}, {"poses", trajectory.size()}};
    report.end();
}

}  // namespace

void add_relations(CLI::App& program) {
    auto options = std::make_shared<RelationsOptions>();
    CLI::App* command = program.add_subcommand(
        "relations",
        "Make relations of a reference trajectory, for evaluate --relations (docs/formats.md)");
    command->add_option("trajectory", options->trajectory, "Reference trajectory (TUM)")
        ->required();
    command->add_option("--out", options->out, "File to write")
        ->required()
        ->check(&complaint_of_output);
    CLI::Option* distance = command
                                ->add_option("--distance", options->distance_m,
                                             "Way between the poses of a relation [m] (default: 1)")
                                ->check(positive());
    command->add_option("--time", options->time_s, "Time between them [s], in place of the way")
        ->check(positive())
        ->excludes(distance);
    add_spacing_options(*command, "", options->spacing);
    add_report_option(*command, options->json);
    command->callback([options] { make_relations(*options); });
}

}  // namespace hitos::cli
