// SPDX-License-Identifier: GPL-3.0-or-later
// The ready tour with few particles, for the tests of the run on a thread.
#pragma once

#include <filesystem>

#include "hitos/services/configuration/archivo_configuracion.hpp"
#include "hitos/services/run/open_source.hpp"
#include "hitos/services/run/run_worker.hpp"

namespace hitos::test {

inline const std::filesystem::path kRepository = HITOS_SOURCE_DIR;

inline Configuracion small_tour() {
    Configuracion configuration = ArchivoConfiguracion::read(kRepository / "config/thesis.cfg");
    configuration.source.file = kRepository / "data/bigloop.log.gz";
    configuration.filter.particles = 20;
    return configuration;
}

/// The best path of the same configuration, run on this thread.
inline Trajectory expected_path(int steps) {
    const Configuracion configuration = small_tour();
    Algoritmo run(configuration, open_source(configuration.source));
    for (int i = 0; i < steps && run.step(); ++i) {
    }
    return run.best_trajectory();
}

inline Trajectory path_of(RunWorker& worker) {
    return worker.with_run([](const Algoritmo& run) { return run.best_trajectory(); }).get();
}

}  // namespace hitos::test
