#include "map_builder.hpp"

#include <cmath>
#include <exception>
#include <utility>

#include "background.hpp"
#include "hitos/capture/procesador.hpp"
#include "hitos/features/control.hpp"
#include "hitos/workbench/open_tour.hpp"

namespace hitos::window {
namespace {

constexpr int kRefreshMs = 33;

}  // namespace

MapBuilder::MapBuilder(QObject* parent) : QObject(parent) {
    timer_.setInterval(kRefreshMs);
    connect(&timer_, &QTimer::timeout, this, &MapBuilder::poll);
}

MapBuilder::~MapBuilder() {
    stop();
}

void MapBuilder::stop() {
    worker_.request_stop();
}

/// Runs `work(stop_token)`, which may throw.
template <class Work>
void MapBuilder::start(Work work) {
    worker_ = {};  // waits for an earlier one
    tiler_.clear();
    shared_ = {};
    shared_.running = true;
    state_ = shared_;
    worker_ = std::jthread([this, work = std::move(work)](const std::stop_token& stop) mutable {
        begin_background_work();
        QString error;
        try {
            work(stop);
        } catch (const std::exception& failure) {
            error = QString::fromUtf8(failure.what());
        }
        const std::scoped_lock lock(mutex_);
        shared_.running = false;
        shared_.stopped = stop.stop_requested();
        shared_.error = error;
        fresh_ = true;
    });
    timer_.start();
}

void MapBuilder::publish(const Grid& grid, const Trajectory& path, double progress, bool last) {
    const std::scoped_lock lock(mutex_);
    tiler_.note_change(grid.last_change());
    shared_.progress = progress;
    if (!wanted_ && !last) return;
    wanted_ = false;
    fresh_ = true;
    shared_.tiles = tiler_.tiles(grid);
    shared_.path = path;
}

void MapBuilder::build(const Configuracion& configuration, Trajectory path) {
    start([this, configuration, path = std::move(path)](const std::stop_token& stop) {
        GridBuilder builder(configuration, open_tour(configuration.source), path);
        const auto show = [&](bool last) {
            const auto done = static_cast<std::ptrdiff_t>(
                std::lround(builder.progress() * static_cast<double>(path.size())));
            publish(builder.grid(), {path.begin(), path.begin() + done}, builder.progress(), last);
        };
        while (!stop.stop_requested() && builder.step()) show(false);
        show(true);
    });
}

void MapBuilder::build_from_odometry(const Configuracion& configuration) {
    start([this, configuration](const std::stop_token& stop) {
        Procesador reader(open_tour(configuration.source), configuration.source.read);
        ControlTrack track([&reader] { return reader.next_odometry(); });
        Grid grid(configuration.grid);
        std::vector<Control> controls;
        Trajectory path;
        Pose pose;
        while (!stop.stop_requested()) {
            const auto scan = reader.next_scan();
            if (!scan) break;
            track.controls_until(*scan, controls);
            for (const Control& control : controls)
                pose = compose(pose, displacement(control.twist, control.duration_s));
            path.push_back({scan->time_s, pose});
            grid.add(*scan, pose);
            publish(grid, path, reader.fuente().progress().value_or(0.0), false);
        }
        publish(grid, path, stop.stop_requested() ? reader.fuente().progress().value_or(0.0) : 1.0,
                true);
    });
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
