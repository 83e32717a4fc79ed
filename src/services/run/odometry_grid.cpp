#include "hitos/services/run/odometry_grid.hpp"

#include <exception>
#include <utility>

namespace hitos {

OdometryGridAhead::OdometryGridAhead(const GridParams& params, const TourReader& reader) {
    try {
        builder_ = std::make_unique<GridBuilder>(params, reader.reopen());
        thread_ = std::jthread([this](const std::stop_token& stop) { build(stop); });
    } catch (const std::exception&) {  // not ahead then
        builder_.reset();
    }
}

void OdometryGridAhead::build(const std::stop_token& stop) {
    try {
        while (!stop.stop_requested() && builder_->step()) ++scans_;
        whole_ = !stop.stop_requested();
    } catch (const std::exception&) {  // whole_ says so
    }
}

std::optional<Grid> OdometryGridAhead::take(std::uint64_t scans) {
    if (!builder_) return std::nullopt;
    if (thread_.joinable()) thread_.join();
    const std::unique_ptr<GridBuilder> builder = std::move(builder_);
    if (!whole_ || scans_ != scans) return std::nullopt;
    return builder->take_grid();
}

}  // namespace hitos
