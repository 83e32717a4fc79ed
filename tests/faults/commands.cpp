// SPDX-License-Identifier: GPL-3.0-or-later
#include "commands.hpp"

#include <algorithm>

namespace hitos::test {
namespace {

/// `common` before and after; then what differs, and so the results.
Command command(const std::string& name, const Words& common, const Words& before,
                const Words& after, bool resumes = false) {
    Command command{name, common, common, resumes};
    command.before.insert(command.before.end(), before.begin(), before.end());
    command.words.insert(command.words.end(), after.begin(), after.end());
    return command;
}

}  // namespace

std::vector<Command> commands(const Workplace& place) {
    const std::string tour = place.path("tour.log");
    const auto with_small = [](Words words, const std::string& threads = "1") {
        const std::string quick = std::string(HITOS_SOURCE_DIR) + "/config/init.cfg";
        const Words small{"--config",           quick,   "--set",
                          "filter.particles=2", "--set", "grid.resolution=0.5",
                          "--threads",          threads};
        words.insert(words.end(), small.begin(), small.end());
        return words;
    };
    const Words run{"run",
                    tour,
                    "--replace",
                    "--uncertainty",
                    "--reference-trajectory",
                    place.path("truth.tum"),
                    "--out",
                    place.path("out")};
    return {
        command("run", with_small(run), {"--seed", "1"}, {"--seed", "2"}),
        // The same faults are not at the same place each time, but harmless all the same.
        command("run_by_threads", with_small(run, "3"), {"--seed", "1"}, {"--seed", "2"}),
        command("convert",
                {"convert", tour, "--to", "normalized", "--odometry-noise", "0.1", "--out",
                 place.path("tour.txt.gz")},
                {"--seed", "1"}, {"--seed", "2"}),
        command("simulate",
                {"simulate", place.path("room.toml"), "--out", place.path("made.log"), "--truth",
                 place.path("made.tum"), "--reference", place.path("made.map"), "--picture",
                 place.path("made.png")},
                {"--seed", "1"}, {"--seed", "2", "--laps", "2"}),
        command("study",
                with_small(
                    {"study", tour, "--runs", "1", "--pictures=all", "--out", place.path("study")}),
                {"--vary", "dmax=0.03,0.02"}, {"--vary", "dmax=0.01,0.02"}, true),
        command("reproduce",
                {"reproduce", "--only", "10.87", "--runs", "1", "--threads", "1", "--world",
                 "tour.laps=1", "--world", "laser.rays=45", "--set", "filter.particles=2", "--out",
                 place.path("reproduced")},
                {"--set", "split_merge.dmax=0.03"}, {"--set", "split_merge.dmax=0.02"}, true),
    };
}

Command command_named(const std::string& name, const Workplace& place) {
    const std::vector<Command> all = commands(place);
    return *std::ranges::find(all, name, &Command::name);
}

}  // namespace hitos::test
