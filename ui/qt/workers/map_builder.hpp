// SPDX-License-Identifier: GPL-3.0-or-later
// Builds a grid from a log and a path on a thread of its own, and shows how it grows.
#pragma once

#include <QObject>
#include <QTimer>
#include <memory>
#include <mutex>
#include <optional>
#include <thread>

#include "hitos/services/configuration/configuracion.hpp"
#include "hitos/services/grid/grid_tiles.hpp"

namespace hitos {
class GridBuilder;
class SimulatedTour;
class TourReader;
}  // namespace hitos

namespace hitos::window {

class MapBuilder final : public QObject {
    Q_OBJECT

  public:
    explicit MapBuilder(QObject* parent = nullptr);
    ~MapBuilder() override;

    /// Builds the map along the path; without one, of the whole tour along its odometry.
    /// `driven`: the tour that was driven by hand, where it is one; else the configuration's source
    /// is opened.
    void build(const Configuracion& configuration, std::optional<Trajectory> path,
               const std::shared_ptr<const SimulatedTour>& driven = nullptr);
    void stop();

    struct State {
        GridTiles tiles;
        Trajectory path;  ///< as far as the map has come
        double progress = 0.0;
        bool running = false;
        bool stopped = false;        ///< by the user, before the end
        std::uint64_t left_out = 0;  ///< as Grid::scans_left_out()
        QString error;
    };
    const State& state() const { return state_; }

  signals:
    void changed();
    void finished();

  private:
    void work(const Configuracion& configuration, std::unique_ptr<TourReader> reader,
              std::optional<Trajectory> path, const std::stop_token& stop);
    void publish(const GridBuilder& builder, bool last);
    void poll();

    QTimer timer_;
    std::mutex mutex_;
    // Written by the worker, under the mutex.
    GridTiler tiler_;
    State shared_;
    bool fresh_ = false;
    bool wanted_ = true;
    // Read by the window.
    State state_;

    std::jthread worker_;  // last: it uses everything above
};

}  // namespace hitos::window
