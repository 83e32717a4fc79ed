// SPDX-License-Identifier: GPL-3.0-or-later
// Tours and scans.
#pragma once

#include <cstdint>
#include <memory>
#include <mutex>
#include <optional>
#include <string>
#include <vector>

#include "bindings.hpp"
#include "hitos/capture/tour_reader.hpp"
#include "hitos/services/configuration/configuracion.hpp"

namespace hitos::python {

/// A scan, which its owner keeps as it is.
class ScanView {
  public:
    explicit ScanView(std::shared_ptr<const Scan> scan) : scan_(std::move(scan)) {}

    const std::shared_ptr<const Scan>& scan() const { return scan_; }
    /// Of every point from the laser: range [m] and bearing [rad], reckoned when first asked for.
    const std::shared_ptr<const std::vector<Point2>>& polar() const;

  private:
    std::shared_ptr<const Scan> scan_;
    mutable std::shared_ptr<const std::vector<Point2>> polar_;
};

/// A log, a recording or a world, not yet read.
class Tour {
  public:
    Tour(SourceParams source, std::uint64_t seed);

    const SourceParams& source() const { return source_; }
    const TourReader& reader() const { return *reader_; }
    /// At the beginning.
    std::unique_ptr<TourReader> reopened() const;
    /// Null where it is not known; always the same.
    std::shared_ptr<Truth> truth() const;

  private:
    SourceParams source_;
    std::unique_ptr<TourReader> reader_;
    mutable std::shared_ptr<Truth> truth_;
};

/// A tour, or the name of what hitos.open() opens.
struct TourArgument {
    /// Its file stands in `source`; where it was opened, so does how.
    SourceParams source;
    bool opened = false;
};
TourArgument tour_argument(const py::object& tour);
/// The configuration of a run of the tour.
Configuracion configuration_for(const TourArgument& tour, const py::object& given);

}  // namespace hitos::python
