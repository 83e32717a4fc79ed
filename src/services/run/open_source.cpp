// SPDX-License-Identifier: GPL-3.0-or-later
#include "hitos/services/run/open_source.hpp"

#include "hitos/base/error.hpp"
#include "hitos/capture/archivo.hpp"
#include "hitos/capture/procesador.hpp"
#include "hitos/registration/scan_odometry.hpp"

namespace hitos {

std::unique_ptr<TourReader> open_source(const SourceParams& source) {
    if (source.file.empty()) {
        throw ConfigError("source.file",
                          HITOS_TEXT("Errors", "found no file name; expected the path of a log"));
    }
    auto reader = std::make_unique<Procesador>(open_log(source.file, source.format, source.read),
                                               source.read);
    const bool from_scans = source.read.odometry == OdometryFrom::scans ||
                            (source.read.mend == Mend::all && !reader->has_odometry());
    if (!from_scans) return reader;
    std::unique_ptr<TourReader> beginning;
    if (source.read.opening_bytes > 0) {  // more may still have to come
        ReadOptions there = source.read;
        there.growth = nullptr;
        beginning = std::make_unique<Procesador>(
            open_log(source.file, source.format, there)->opening(), there);
    }
    return make_scan_odometry(std::move(reader), std::move(beginning));
}

}  // namespace hitos
