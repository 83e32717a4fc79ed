// Builds a grid from a log and a path on a thread of its own, and shows how it grows.
#pragma once

#include <QObject>
#include <QTimer>
#include <memory>
#include <mutex>
#include <thread>

#include "hitos/services/run/algoritmo.hpp"
#include "hitos/services/run/grid_tiles.hpp"

namespace hitos::window {

class MapBuilder final : public QObject {
    Q_OBJECT

  public:
    explicit MapBuilder(QObject* parent = nullptr);
    ~MapBuilder() override;

    /// Builds the map along the path.
    void build(const Configuracion& configuration, Trajectory path);
    /// Builds the map of the whole log along the odometry, which is read as it goes.
    void build_from_odometry(const Configuracion& configuration);
    void stop();

    struct State {
        GridTiles tiles;
        Trajectory path;  ///< as far as the map has come
        double progress = 0.0;
        bool running = false;
        bool stopped = false;  ///< by the user, before the end
        QString error;
    };
    const State& state() const { return state_; }

  signals:
    void changed();
    void finished();

  private:
    template <class Work>
    void start(Work work);
    void publish(const Grid& grid, const Trajectory& path, double progress, bool last);
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
