// SPDX-License-Identifier: GPL-3.0-or-later
#include "incoming_tour.hpp"

#include <exception>
#include <string>
#include <utility>

#include "background.hpp"
#include "hitos/capture/derived_tour.hpp"
#include "hitos/features/control.hpp"
#include "hitos/registration/scan_odometry.hpp"
#include "hitos/workbench/open_tour.hpp"

namespace hitos::window {
namespace {

/// Who reads the tour anew, for its maps and figures, takes what is there and waits for nothing.
class IncomingReader final : public DerivedTour {
  public:
    IncomingReader(std::unique_ptr<TourReader> reader, Configuracion file)
        : DerivedTour(std::move(reader)), file_(std::move(file)) {}

    std::unique_ptr<TourReader> reopen() const override { return open_tour(file_); }
    ReadOptions options() const override { return file_.source.read; }

  private:
    Configuracion file_;
};

}  // namespace

IncomingTour::~IncomingTour() {
    source_->end();  // no reader waits any more
    readers_.clear();
}

bool IncomingTour::is_of(const Configuracion& configuration) const {
    return configuration.source.file == source_->file().string() &&
           configuration.source.read.opening_bytes > 0;
}

Configuracion IncomingTour::followed(Configuracion configuration) const {
    configuration.source.read.growth = source_->growth();
    return configuration;
}

std::unique_ptr<TourReader> IncomingTour::open(const Configuracion& configuration) const {
    return std::make_unique<IncomingReader>(open_tour(followed(configuration)), configuration);
}

void IncomingTour::count(const Configuracion& configuration) {
    const std::scoped_lock lock(mutex_);
    over_ = false;
    if (came_s_.size() > counted_s_.size()) counted_s_ = came_s_;
    came_s_.clear();
    readers_.emplace_back([this, configuration = followed(configuration), count = ++count_] {
        begin_background_work();
        read(configuration, count);
    });
}

void IncomingTour::read(const Configuracion& configuration, std::uint64_t count) {
    std::unique_ptr<TourReader> tour;
    ControlTrack odometry([&tour] { return tour->next_odometry(); });
    std::vector<Control> controls;
    for (bool more = true; more;) {
        try {
            if (!tour) tour = open_tour(configuration);
            const std::optional<Scan> scan = tour->next_scan();
            more = scan.has_value();
            // What scans say themselves is there with them.
            if (more && !is_scan_odometry(*tour)) odometry.controls_until(*scan, controls);
        } catch (const std::exception&) {  // which the run itself will tell
            more = false;
        }
        {
            const std::scoped_lock lock(mutex_);
            if (count != count_) return;  // another one counts now
            over_ = !more;
            if (more) {
                const float now_s = std::chrono::duration<float>(Clock::now() - begin_).count();
                const std::size_t scan = came_s_.size();
                came_s_.push_back(scan < counted_s_.size() ? counted_s_[scan] : now_s);
            }
        }
        arrived_();
    }
}

std::uint64_t IncomingTour::scans() const {
    const std::scoped_lock lock(mutex_);
    return came_s_.size();
}

bool IncomingTour::is_live() const {
    const std::scoped_lock lock(mutex_);
    return !over_;
}

std::optional<double> IncomingTour::waiting_s(std::uint64_t steps) const {
    const std::scoped_lock lock(mutex_);
    if (steps >= came_s_.size()) return std::nullopt;
    return std::chrono::duration<double>(Clock::now() - begin_).count() -
           static_cast<double>(came_s_[steps]);
}

double IncomingTour::silent_s() const {
    const std::scoped_lock lock(mutex_);
    return std::chrono::duration<double>(Clock::now() - begin_).count() -
           (came_s_.empty() ? 0.0 : static_cast<double>(came_s_.back()));
}

}  // namespace hitos::window
