// A tour read once and handed to many runs.
#pragma once

#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "hitos/capture/tour_reader.hpp"

namespace hitos {

/// All that a reader has to give; immutable and so safe to share between threads.
struct RecordedTour {
    /// Reads the reader, which must stand at its beginning, to its end.
    explicit RecordedTour(TourReader& reader);

    std::vector<Scan> scans;
    std::vector<Odometria> odometry;
    ReadReport report;
    std::optional<Truth> truth;
};

/// Reads a recorded tour, which is asked for at the first scan or reading.
class RecordedReader final : public TourReader {
  public:
    using Tour = std::shared_ptr<const RecordedTour>;

    RecordedReader(std::string name, std::string format, std::function<Tour()> open)
        : name_(std::move(name)), format_(std::move(format)), open_(std::move(open)) {}

    std::optional<Scan> next_scan() override;
    std::optional<Odometria> next_odometry() override;
    void restart() override;
    std::unique_ptr<TourReader> reopen() const override;
    const ReadReport& report() const override { return report_; }
    std::optional<double> progress() const override;
    std::string name() const override { return name_; }
    std::string format() const override { return format_; }
    /// Nothing before the first scan or reading.
    std::optional<Truth> truth() const override { return tour_ ? tour_->truth : std::nullopt; }

  private:
    const RecordedTour& tour();

    std::string name_;
    std::string format_;
    std::function<Tour()> open_;
    Tour tour_;
    ReadReport report_;
};

}  // namespace hitos
