// SPDX-License-Identifier: GPL-3.0-or-later
#include "hitos/services/grid/grid_builder.hpp"

#include <utility>

namespace hitos {

GridBuilder::GridBuilder(const GridParams& params, std::unique_ptr<TourReader> reader)
    : reader_(std::move(reader)),
      controls_([from = reader_.get()] { return from->next_odometry(); }),
      grid_(params) {}

GridBuilder::GridBuilder(const GridParams& params, std::unique_ptr<TourReader> reader,
                         Trajectory path)
    : GridBuilder(params, std::move(reader)) {
    given_ = std::move(path);
}

bool GridBuilder::step() {
    if (given_ && steps_ == given_->size()) return false;
    const std::optional<Scan> scan = reader_->next_scan();
    if (!scan) return false;
    if (given_) {
        grid_.add(*scan, (*given_)[steps_].pose);
    } else {
        controls_.controls_until(*scan, step_controls_);
        odometry_.add(scan->stamp_s(), step_controls_);
        grid_.add(*scan, odometry_.trajectory().back().pose);
    }
    ++steps_;
    return true;
}

Trajectory GridBuilder::path() const {
    const Trajectory& whole = given_ ? *given_ : odometry_.trajectory();
    return {whole.begin(), whole.begin() + static_cast<std::ptrdiff_t>(steps_)};
}

double GridBuilder::progress() const {
    if (!given_) return reader_->progress().value_or(0.0);
    return given_->empty() ? 1.0
                           : static_cast<double>(steps_) / static_cast<double>(given_->size());
}

Grid build_grid(const GridParams& params, const TourReader& reader, Trajectory path) {
    GridBuilder builder(params, reader.reopen(), std::move(path));
    while (builder.step()) {
    }
    return builder.take_grid();
}

}  // namespace hitos
