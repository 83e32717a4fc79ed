#include "hitos/workbench/tour_truth.hpp"

#include "hitos/simulation/fuente_simulada.hpp"

namespace hitos {

Trajectory true_trajectory(const SimulatedTour& tour) {
    Trajectory truth;
    truth.reserve(tour.scans());
    for (std::uint64_t k = 0; k < tour.scans(); ++k)
        truth.push_back({tour.scan_time(k), tour.true_pose(k)});
    return truth;
}

Walls true_walls(const SimulatedTour& tour) {
    const Pose pose_start_world = inverse(tour.world().tour.start);
    Walls walls;
    for (const WallSegment& wall : tour.world().walls) {
        walls.emplace_back(transform(pose_start_world, wall.a),
                           transform(pose_start_world, wall.b));
    }
    return walls;
}

const SimulatedTour* simulated_tour(const Fuente& fuente) {
    const auto* simulated = dynamic_cast<const FuenteSimulada*>(&fuente);
    return simulated == nullptr ? nullptr : &simulated->tour();
}

}  // namespace hitos
