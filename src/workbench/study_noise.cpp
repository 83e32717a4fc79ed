#include "hitos/workbench/study_noise.hpp"

#include <fmt/format.h>

#include "hitos/simulation/noisy_reader.hpp"
#include "hitos/workbench/open_tour.hpp"

namespace hitos {

void set_study_source(Study& study, double level, OdometryNoiseKind kind) {
    static_cast<void>(OdometryNoise(level, kind, 0));  // throws for an impossible level
    if (level == 0.0) {
        study.source = [](const StudyJob& job) { return open_tour(job.configuration); };
        return;
    }
    study.setting = fmt::format("odometry noise {} {}",
                                kOdometryNoiseKinds.at(static_cast<std::size_t>(kind)).word, level);
    study.source = [level, kind](const StudyJob& job) {
        const std::uint64_t tour_seed = job.configuration.source.tour_seed;
        return make_noisy_reader(open_tour(job.configuration), level, kind,
                                 tour_seed != 0 ? tour_seed : job.seed);
    };
}

}  // namespace hitos
