#include "hitos/slam/filters.hpp"

#include <string>

#include "ekf_slam.hpp"
#include "filtro_particulas.hpp"
#include "hitos/base/error.hpp"

namespace hitos {
namespace {

void check_observation(const FilterParams& params) {
    if (!(params.observation.var_rho_m2 > 0.0 && params.observation.var_theta_rad2 > 0.0)) {
        throw ConfigError(
            "observation",
            "found var_rho " + std::to_string(params.observation.var_rho_m2) + " and var_theta " +
                std::to_string(params.observation.var_theta_rad2) + ", expected variances above 0");
    }
}

bool is_probability(double value) {
    return value > 0.0 && value < 1.0;
}

}  // namespace

std::unique_ptr<SlamFilter> make_fastslam(const FilterParams& params, std::uint64_t seed,
                                          int threads) {
    if (params.particles < 1) {
        throw ConfigError("filter.particles",
                          "found " + std::to_string(params.particles) + ", expected 1 or more");
    }
    if (!(params.association.p0 > 0.0)) throw ConfigError("association.p0", "expected above 0");
    check_observation(params);
    return std::make_unique<FiltroParticulas>(params, seed, threads);
}

std::unique_ptr<SlamFilter> make_ekf_slam(const FilterParams& params) {
    check_observation(params);
    const AssociationParams& a = params.association;
    if (!is_probability(a.gate_probability) || !is_probability(a.new_probability) ||
        a.new_probability < a.gate_probability) {
        throw ConfigError("association.new_probability",
                          "found " + std::to_string(a.new_probability) +
                              " with association.gate_probability " +
                              std::to_string(a.gate_probability) +
                              ", expected probabilities below 1, this one not the smaller");
    }
    return std::make_unique<EkfSlam>(params);
}

std::unique_ptr<SlamFilter> make_filter(const FilterParams& params, std::uint64_t seed,
                                        int threads) {
    if (params.algorithm == SlamAlgorithm::ekf_slam) return make_ekf_slam(params);
    return make_fastslam(params, seed, threads);
}

}  // namespace hitos
