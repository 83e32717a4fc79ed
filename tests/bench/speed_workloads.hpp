// SPDX-License-Identifier: GPL-3.0-or-later
// The workloads of the bench of speed. Each prints its figures.
#pragma once

#include <vector>

#include "speed_api.hpp"
#include "speed_measure.hpp"

namespace speed {

/// A tour in memory: its scans and the controls before each.
struct Tour {
    std::vector<hitos::Scan> scans;
    std::vector<std::vector<hitos::Control>> controls;
    hitos::Configuracion configuration;
};

/// bigloop2, complex or intel.
Tour read_tour(std::string_view name, const std::string& log);
/// The log of a recorded one; throws where it is not there.
std::string log_of(std::string_view name, const std::string& log);

/// From parsed scans to resampled particles.
void measure_tour(const Tour& tour, const Options& options);

/// Ten features of a field of corners, or of pillars with walls and corners, seen in every step.
enum class FieldKind { corners, pillars };
void measure_field(FieldKind kind, const Options& options);
/// Seventeen points seen of 560 that lie well apart.
void measure_points(const Options& options);
#ifndef HITOS_BASELINE
/// The same, where it is known which point each is: predictions, and likelihoods with updates.
void measure_kernels(const Options& options);
#endif
/// EKF-SLAM in a field of corners, and passes over as much memory as its covariance takes.
void measure_ekf(const Options& options);

void measure_reading(const Options& options);
void measure_extraction(const Tour& tour, const Options& options);
void measure_weights(const Options& options);
void measure_grid(const Tour& tour, const Options& options);
void measure_files(const Tour& tour, const Options& options);

}  // namespace speed
