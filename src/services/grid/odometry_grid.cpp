#include "hitos/services/grid/odometry_grid.hpp"

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
        while (scans_ < wanted_ && !stop.stop_requested() && builder_->step()) {
            ++scans_;
            if (builder_->grid().bytes() > kMostBytes) break;
        }
    } catch (const std::exception&) {
        failed_ = true;
    }
}

std::optional<Grid> OdometryGridAhead::take(std::uint64_t scans) {
    if (!builder_) return std::nullopt;
    wanted_ = scans;
    if (thread_.joinable()) thread_.join();
    const std::unique_ptr<GridBuilder> builder = std::move(builder_);
    if (failed_ || scans_ != scans) return std::nullopt;
    return builder->take_grid();
}

}  // namespace hitos
