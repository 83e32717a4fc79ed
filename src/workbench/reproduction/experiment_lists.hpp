// What the lists of experiments share.
#pragma once

#include <string>
#include <utility>
#include <vector>

#include "hitos/workbench/thesis_experiments.hpp"

namespace hitos::experiments {

using Place = ThesisExperiment::Place;
using Show = ThesisExperiment::Show;
using Settings = std::vector<std::string>;
using Claims = std::vector<ThesisClaim>;

inline constexpr const char* kDmax = "split_merge.dmax";
inline constexpr const char* kLength = "split_merge.min_length";
inline constexpr const char* kPoints = "split_merge.min_points";
inline constexpr const char* kColRho = "split_merge.collinear_rho";
inline constexpr const char* kColTheta = "split_merge.collinear_theta";
inline constexpr const char* kSigmaXy = "motion.sigma_x+motion.sigma_y";
inline constexpr const char* kSigmaTheta = "motion.sigma_theta";
inline constexpr const char* kVarRho = "observation.var_rho";
inline constexpr const char* kVarTheta = "observation.var_theta";
inline constexpr const char* kParticles = "filter.particles";
inline constexpr const char* kNeff = "resampling.neff_threshold";

/// Each key once: what is said later counts.
inline Settings with(Settings all, const Settings& more) {
    for (const std::string& setting : more) {
        const std::string key = setting.substr(0, setting.find('=') + 1);
        std::erase_if(all, [&](const std::string& known) { return known.starts_with(key); });
        all.push_back(setting);
    }
    return all;
}

/// Adds an experiment on a world that is shown by the maps of one run of each value.
inline void add_maps(std::vector<ThesisExperiment>& all, const char* figure, const char* parameter,
                     const char* key, const char* table, const char* name, Settings settings,
                     Claims claims, std::string_view remark) {
    all.push_back({figure, parameter, key, table, Place::world, name, Show::maps, 1,
                   std::move(settings), std::move(claims), remark});
}

/// Likewise by a table of counts over several runs.
inline void add_counts(std::vector<ThesisExperiment>& all, int runs, const char* figure,
                       const char* parameter, const char* key, const char* table, const char* name,
                       Settings settings, Claims claims, std::string_view remark) {
    all.push_back({figure, parameter, key, table, Place::world, name, Show::counts, runs,
                   std::move(settings), std::move(claims), remark});
}

/// The same questions to public recordings.
void add_recorded(std::vector<ThesisExperiment>& all);

}  // namespace hitos::experiments
