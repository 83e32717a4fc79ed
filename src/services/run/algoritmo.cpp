#include "hitos/services/run/algoritmo.hpp"

#include <utility>

#include "hitos/base/error.hpp"
#include "hitos/capture/archivo.hpp"
#include "hitos/slam/filters.hpp"

namespace hitos {

Algoritmo::Algoritmo(const Configuracion& configuration, std::unique_ptr<Fuente> fuente,
                     const AlgoritmoOptions& options)
    : configuration_(configuration), options_(options), step_grid_(configuration.grid) {
    check(configuration_);
    assemble(std::move(fuente));
}

Algoritmo::~Algoritmo() = default;
Algoritmo::Algoritmo(Algoritmo&&) noexcept = default;
Algoritmo& Algoritmo::operator=(Algoritmo&&) noexcept = default;

void Algoritmo::assemble(std::unique_ptr<Fuente> fuente) {
    auto procesador = std::make_unique<Procesador>(std::move(fuente), configuration_.source.read);
    extractor_ = make_extractor(configuration_.extraction, configuration_.run.seed);
    filter_ =
        make_filter(configuration_.filter, configuration_.run.seed, configuration_.run.threads);
    controls_ = std::make_unique<ControlTrack>(
        [reader = procesador.get()] { return reader->next_odometry(); });
    procesador_ = std::move(procesador);
    step_grid_.clear();
    line_extents_.clear();
    uncertainty_.clear();
    scan_ = {};
    observation_.clear();
    odometry_pose_ = {};
    odometry_.clear();
    finished_ = false;
}

bool Algoritmo::step() {
    if (finished_) return false;
    auto scan = procesador_->next_scan();
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
                fuente().name(), 0,
                problem + "; expected at least one scan: check the file and its format");
        }
        return false;
    }
    scan_ = std::move(*scan);
    controls_->controls_until(scan_, step_controls_);
    extractor_->extract(scan_, observation_);
    filter_->step({scan_, step_controls_, observation_});
    line_extents_.note(*filter_, observation_);
    if (options_.uncertainty) uncertainty_.note(scan_.time_s, filter_->best_map());

    for (const Control& control : step_controls_) {
        odometry_pose_ = compose(odometry_pose_, displacement(control.twist, control.duration_s));
    }
    odometry_.push_back({scan_.time_s, odometry_pose_});
    if (options_.step_grid) step_grid_.add(scan_, filter_->best_pose());
    return true;
}

void Algoritmo::restart() {
    assemble(procesador_->fuente().reopen());
}

double Algoritmo::duration_s() const {
    return odometry_.empty() ? 0.0 : odometry_.back().time_s - odometry_.front().time_s;
}

Trajectory Algoritmo::best_trajectory() const {
    const std::vector<Pose> poses = filter_->best_history();
    Trajectory trajectory;
    trajectory.reserve(poses.size());
    for (std::size_t i = 0; i < poses.size(); ++i) {
        trajectory.push_back({odometry_[i].time_s, poses[i]});
    }
    return trajectory;
}

GridBuilder::GridBuilder(const Configuracion& configuration, std::unique_ptr<Fuente> fuente,
                         Trajectory trajectory)
    : procesador_(std::make_unique<Procesador>(std::move(fuente), configuration.source.read)),
      trajectory_(std::move(trajectory)),
      grid_(configuration.grid) {}

GridBuilder::~GridBuilder() = default;

bool GridBuilder::step() {
    if (next_ == trajectory_.size()) return false;
    const auto scan = procesador_->next_scan();
    if (!scan) return false;
    grid_.add(*scan, trajectory_[next_++].pose);
    return true;
}

double GridBuilder::progress() const {
    return trajectory_.empty()
               ? 1.0
               : static_cast<double>(next_) / static_cast<double>(trajectory_.size());
}

Grid build_grid(const Configuracion& configuration, const Fuente& fuente, Trajectory trajectory) {
    GridBuilder builder(configuration, fuente.reopen(), std::move(trajectory));
    while (builder.step()) {
    }
    return builder.grid();
}

std::unique_ptr<Fuente> open_source(const SourceParams& source) {
    if (source.file.empty()) {
        throw ConfigError("source.file", "found no file name; expected the path of a log");
    }
    return open_log(source.file, source.format);
}

}  // namespace hitos
