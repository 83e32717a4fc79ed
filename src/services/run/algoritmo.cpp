#include "hitos/services/run/algoritmo.hpp"

#include <utility>

#include "hitos/base/error.hpp"
#include "hitos/slam/filters.hpp"

namespace hitos {

Algoritmo::Algoritmo(const Configuracion& configuration, std::unique_ptr<TourReader> reader,
                     const AlgoritmoOptions& options)
    : configuration_(configuration),
      options_(options),
      reader_(std::move(reader)),
      step_grid_(configuration.grid) {
    check(configuration_);
    begin();
}

Algoritmo::~Algoritmo() = default;
Algoritmo::Algoritmo(Algoritmo&&) noexcept = default;
Algoritmo& Algoritmo::operator=(Algoritmo&&) noexcept = default;

void Algoritmo::begin() {
    extractor_ = make_extractor(configuration_.extraction, configuration_.run.seed);
    filter_ =
        make_filter(configuration_.filter, configuration_.run.seed, configuration_.run.threads);
    controls_ =
        std::make_unique<ControlTrack>([from = reader_.get()] { return from->next_odometry(); });
    step_grid_.clear();
    line_extents_.clear();
    suitability_.clear();
    uncertainty_.clear();
    scan_ = {};
    observation_.clear();
    odometry_ = {};
    finished_ = false;
}

bool Algoritmo::step() {
    if (finished_) return false;
    auto scan = reader_->next_scan();
    if (!scan) {
        finished_ = true;
        if (steps() == 0) {
            const ReadReport& log = report();
            std::string problem = "found no readable scan";
            if (!log.examples.empty()) {
                problem += "; " + std::to_string(log.skipped) +
                           " damaged lines were skipped, the " + "first is line " +
                           std::to_string(log.examples.front().line) + ": " +
                           log.examples.front().reason;
            }
            throw FormatError(
                reader().name(), 0,
                problem + "; expected at least one scan: check the file and its format");
        }
        return false;
    }
    scan_ = std::move(*scan);
    controls_->controls_until(scan_, step_controls_);
    extractor_->extract(scan_, observation_);
    filter_->step({scan_, step_controls_, observation_});
    line_extents_.note(*filter_, observation_);
    suitability_.note(step_controls_, observation_, filter_->associations());
    if (options_.uncertainty) uncertainty_.note(scan_.time_s, filter_->best_map());

    odometry_.add(scan_.time_s, step_controls_);
    if (options_.step_grid) step_grid_.add(scan_, filter_->best_pose());
    return true;
}

void Algoritmo::restart() {
    reader_->restart();
    begin();
}

double Algoritmo::duration_s() const {
    const Trajectory& path = odometry_trajectory();
    return path.empty() ? 0.0 : path.back().time_s - path.front().time_s;
}

Trajectory Algoritmo::best_trajectory() const {
    return stamped(filter_->best_history());
}

Trajectory Algoritmo::trajectory_of(std::size_t hypothesis) const {
    return stamped(filter_->history(hypothesis));
}

Trajectory Algoritmo::stamped(const std::vector<Pose>& poses) const {
    Trajectory trajectory;
    trajectory.reserve(poses.size());
    for (std::size_t i = 0; i < poses.size(); ++i) {
        trajectory.push_back({odometry_trajectory()[i].time_s, poses[i]});
    }
    return trajectory;
}

}  // namespace hitos
