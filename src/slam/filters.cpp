#include "hitos/slam/filters.hpp"

#include "ekf_slam.hpp"
#include "filtro_particulas.hpp"
#include "hitos/slam/filter_parameters.hpp"

namespace hitos {

std::unique_ptr<SlamFilter> make_fastslam(const FilterParams& params, std::uint64_t seed,
                                          int threads) {
    check(params);
    return std::make_unique<FiltroParticulas>(params, seed, threads);
}

std::unique_ptr<SlamFilter> make_ekf_slam(const FilterParams& params) {
    check(params);
    return std::make_unique<EkfSlam>(params);
}

std::unique_ptr<SlamFilter> make_filter(const FilterParams& params, std::uint64_t seed,
                                        int threads) {
    if (params.algorithm == SlamAlgorithm::ekf_slam) return make_ekf_slam(params);
    return make_fastslam(params, seed, threads);
}

}  // namespace hitos
