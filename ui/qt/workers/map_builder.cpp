// SPDX-License-Identifier: GPL-3.0-or-later
#include "map_builder.hpp"

#include <exception>
#include <utility>

#include "hitos/services/grid/grid_builder.hpp"
#include "hitos/simulation/drive/simulated_tour_reader.hpp"
#include "hitos/workbench/open_tour.hpp"
#include "look/words_of.hpp"
#include "session/background.hpp"

namespace hitos::window {
namespace {

constexpr int kMapRefreshMs = 33;

}  // namespace

MapBuilder::MapBuilder(QObject* parent) : QObject(parent) {
    timer_.setInterval(kMapRefreshMs);
    connect(&timer_, &QTimer::timeout, this, &MapBuilder::poll);
}

MapBuilder::~MapBuilder() {
    stop();
}

void MapBuilder::stop() {
    worker_.request_stop();
}

void MapBuilder::build(const Configuracion& configuration, std::optional<Trajectory> path,
                       const std::shared_ptr<const SimulatedTour>& driven) {
    worker_ = {};  // waits for an earlier one
    tiler_.clear();
    shared_ = {};
    shared_.running = true;
    state_ = shared_;
    worker_ = std::jthread([this, configuration, driven,
                            path = std::move(path)](const std::stop_token& stop) mutable {
        begin_background_work();
        QString error;
        try {
            work(configuration,
                 driven ? std::make_unique<SimulatedTourReader>(driven) : open_tour(configuration),
                 std::move(path), stop);
        } catch (const std::exception& failure) {
            error = words_of(failure);
        }
        const std::scoped_lock lock(mutex_);
        shared_.running = false;
        shared_.stopped = stop.stop_requested();
        shared_.error = error;
        fresh_ = true;
    });
    timer_.start();
}

void MapBuilder::work(const Configuracion& configuration, std::unique_ptr<TourReader> reader,
                      std::optional<Trajectory> path, const std::stop_token& stop) {
    GridBuilder builder = path
                              ? GridBuilder(configuration.grid, std::move(reader), *std::move(path))
                              : GridBuilder(configuration.grid, std::move(reader));
    while (!stop.stop_requested() && builder.step()) publish(builder, false);
    publish(builder, true);
}

void MapBuilder::publish(const GridBuilder& builder, bool last) {
    const std::scoped_lock lock(mutex_);
    tiler_.note_change(builder.grid().last_change());
    shared_.progress = builder.progress();
    if (!wanted_ && !last) return;
    wanted_ = false;
    fresh_ = true;
    shared_.tiles = tiler_.tiles(builder.grid());
    shared_.path = builder.path();
    shared_.left_out = builder.grid().scans_left_out();
}

void MapBuilder::poll() {
    {
        const std::scoped_lock lock(mutex_);
        if (!fresh_) return;
        fresh_ = false;
        wanted_ = true;
        state_ = shared_;
    }
    emit changed();
    if (state_.running) return;
    timer_.stop();
    emit finished();
}

}  // namespace hitos::window
