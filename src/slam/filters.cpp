// SPDX-License-Identifier: GPL-3.0-or-later
#include "hitos/slam/filters.hpp"

#include "ekf/ekf_slam.hpp"
#include "fastslam/filtro_particulas.hpp"
#include "graph/graph_slam.hpp"
#include "hitos/slam/filter_parameters.hpp"
#include "hitos/slam/robot.hpp"

namespace hitos {

Registry<SlamAlgorithmEntry>& slam_algorithms() {
    static Registry<SlamAlgorithmEntry> registry(
        "SLAM algorithm", "filter.algorithm",
        {fastslam_algorithm(), ekf_slam_algorithm(), graph_slam_algorithm()});
    return registry;
}

std::unique_ptr<SlamFilter> make_filter(const FilterParams& params, std::uint64_t seed,
                                        int threads) {
    check(params);
    return slam_algorithms().find(params.algorithm).make(params, seed, threads);
}

bool needs_registration(const FilterParams& params) {
    const SlamAlgorithmEntry& algorithm = slam_algorithms().find(params.algorithm);
    return algorithm.registered || (slam_algorithms().reads(params.algorithm, "motion.model") &&
                                    motion_models().find(params.motion.model).registered);
}

std::size_t hypothesis_count(const FilterParams& params) {
    return slam_algorithms().reads(params.algorithm, "filter.particles")
               ? static_cast<std::size_t>(params.particles)
               : 1;
}

}  // namespace hitos
