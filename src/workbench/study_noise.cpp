// SPDX-License-Identifier: GPL-3.0-or-later
#include "hitos/workbench/study_noise.hpp"

#include <fmt/format.h>

#include "hitos/simulation/drive/noisy_reader.hpp"
#include "hitos/simulation/drive/perturbed_reader.hpp"
#include "hitos/workbench/open_tour.hpp"

namespace hitos {

void set_study_source(Study& study, double level, OdometryNoiseKind kind) {
    static_cast<void>(OdometryNoise(level, kind, 0));  // throws for an impossible level
    study.inputs = [read = study.configuration.source](const std::string& log) {
        SourceParams source = read;
        source.file = log;
        return tour_files(source);
    };
    study.source.open = [](const SourceParams& source, std::uint64_t seed) {
        return open_tour(source, seed);
    };
    study.source.seeded = [](const SourceParams& source) {
        return is_world_file(source.file) && source.tour_seed == 0;
    };
    if (level == 0.0) {
        return;
    }
    study.setting = fmt::format("odometry noise {} {}",
                                kOdometryNoiseKinds.at(static_cast<std::size_t>(kind)).word, level);
    study.source.change = [level, kind](std::unique_ptr<TourReader> tour, const StudyJob& job) {
        const SourceParams& source = job.configuration.source;
        std::uint64_t seed = job.seed;
        if (is_world_file(source.file)) {
            // A world's odometry has noise of the same seed already: what comes on top is drawn
            // from another, or it would be the same noise twice.
            constexpr std::uint64_t kOther = 0x9e3779b97f4a7c15;
            seed = (source.tour_seed != 0 ? source.tour_seed : job.seed) ^ kOther;
        }
        return make_noisy_reader(std::move(tour), level, kind, seed);
    };
}

void set_study_copies(Study& study, int copies) {
    if (copies == 0) return;
    study.setting +=
        fmt::format("{}{} perturbed copies", study.setting.empty() ? "" : ", ", copies);
    study.source.seeded = [](const SourceParams& /*source*/) { return true; };
    study.source.open = [open = study.source.open, number = static_cast<std::uint64_t>(copies)](
                            const SourceParams& source, std::uint64_t seed) {
        return make_perturbed_reader(open(source, seed), 1 + (seed + number - 1) % number);
    };
}

}  // namespace hitos
