// SPDX-License-Identifier: GPL-3.0-or-later
#include "run_graph.hpp"

#include <Eigen/Geometry>
#include <Eigen/LU>
#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <utility>

#include "hitos/features/control.hpp"
#include "hitos/features/extractor.hpp"
#include "hitos/registration/graph_edit.hpp"
#include "hitos/registration/odometry_step.hpp"
#include "hitos/slam/robot.hpp"

namespace hitos {
namespace {

using Matrix3 = Eigen::Matrix3d;
using Matrix2 = Eigen::Matrix2d;
using Vector2 = Eigen::Vector2d;

constexpr double kLeastSigma = 1e-4;         // [m, rad] of a step, beside the model's
constexpr double kReach = 0.5;               // of a line's known part to what was seen of it [m]
const double kGate = -2.0 * std::log(0.01);  // 99 % of two degrees of freedom: 9.21

/// The pose `to` seen from `from`, with its information in the axes of z.
PlanarEdge step_edge(std::size_t from, std::size_t to, const Pose& z, const Matrix3& information) {
    PlanarEdge edge;
    edge.from = static_cast<std::uint32_t>(from);
    edge.to = static_cast<std::uint32_t>(to);
    edge.z << z.x, z.y, z.theta;
    edge.information = information;
    return edge;
}

/// What the motion model makes of the controls, and its noise; what is in the world's axes there is
/// in those of the step's end here.
PlanarEdge step_by_model(const Robot& robot, std::size_t to, const Pose& before,
                         std::span<const Control> controls) {
    const MotionIncrement increment = sum_controls(controls);
    const Pose after = robot.mean(before, increment);
    Matrix3 noise = robot.noise_covariance(before, increment);
    noise.diagonal().array() += kLeastSigma * kLeastSigma;
    return step_edge(to - 1, to, between(before, after), turned(noise, -after.theta).inverse());
}

/// What the wheels say, as sure as registration takes them to be.
PlanarEdge step_by_wheels(const RegistrationParams& params, std::span<const GraphEdit> edits,
                          std::size_t to, std::span<const Control> controls) {
    const Pose z = driven_way(controls).pose_start_end;
    const bool slipped = std::ranges::any_of(edits, [&](const GraphEdit& edit) {
        return edit.kind == GraphEdit::Kind::slip && edit.scan.scan == to;
    });
    const Eigen::Vector3d variances =
        slipped ? slip_variances() : odometry_variances(z, params.odometry_scale);
    // Along and across the mean heading; then in the axes of the end.
    return step_edge(to - 1, to, z, step_information(variances, -0.5 * z.theta));
}

/// What may be the same as a landmark.
struct Seen {
    ICaracteristica feature;  ///< robot frame, with its covariance
    Point2 a;                 ///< ends of what was seen of a line, robot frame
    Point2 b;
};

/// Whether a landmark may be what was seen, by what is known of both.
bool may_be(const Seen& seen, const ICaracteristica& landmark) {
    const std::int32_t one = seen.feature.identity;
    return landmark.kind() == seen.feature.kind() &&
           (one < 0 || landmark.identity < 0 || one == landmark.identity);
}

/// d(x, y)/d(range, bearing) at the corner.
Matrix2 by_range_and_bearing(const Esquina& corner) {
    const double range = std::max(std::hypot(corner.x, corner.y), 1e-3);
    Matrix2 j;
    j << corner.x / range, -corner.y, corner.y / range, corner.x;
    return j;
}

std::vector<Seen> seen_in(const Observation& observation, const ObservationParams& params,
                          bool identities) {
    const Matrix2 fixed = Vector2(params.var_rho_m2, params.var_theta_rad2).asDiagonal();
    std::vector<Seen> all;
    for (std::size_t i = 0; i < observation.lines.size(); ++i) {
        const DetectedLine& line = observation.lines[i];
        Seen& seen = all.emplace_back();
        seen.feature.value = line.recta;
        seen.feature.covariance =
            observation.line_covariances.empty() ? fixed : observation.line_covariances[i];
        const auto support = observation.support_of(line);
        if (support.empty()) continue;
        seen.a = support.front();
        seen.b = support.back();
    }
    for (std::size_t i = 0; i < observation.corners.size(); ++i) {
        const Esquina& corner = observation.corners[i];
        const Matrix2 j = by_range_and_bearing(corner);
        Seen& seen = all.emplace_back();
        seen.feature.value = corner;
        if (identities) seen.feature.identity = observation.identity(i);
        seen.feature.covariance = i < observation.corner_covariances.size()
                                      ? observation.corner_covariances[i]
                                      : Matrix2(j * fixed * j.transpose());
    }
    return all;
}

/// The feature as the landmark would have it, and how far it is from it: squared Mahalanobis
/// distance of z - h.
struct Comparison {
    ICaracteristica seen;
    double distance2 = std::numeric_limits<double>::infinity();
};

double distance2(const Vector2& nu, const Matrix2& q) {
    const double squared = nu.dot(q.inverse() * nu);
    return squared >= 0.0 ? squared : std::numeric_limits<double>::infinity();
}

/// h = (rho - x cos theta - y sin theta, theta - theta_r) [T eq 7.25], as g2o reckons it: without a
/// flip, so that a line seen from its other side has its normal turned instead.
std::optional<Comparison> compared(const Recta& line, const ICaracteristica& landmark,
                                   const Pose& pose, const Seen& seen) {
    Recta z = std::get<Recta>(seen.feature.value);
    Matrix2 r = seen.feature.covariance;
    double turn = wrap_angle(z.theta - line.theta + pose.theta);
    if (std::abs(turn) > kPi / 2.0) {
        z = {-z.rho, wrap_angle(z.theta + kPi)};
        r(0, 1) = -r(0, 1);
        r(1, 0) = -r(1, 0);
        turn = wrap_angle(z.theta - line.theta + pose.theta);
    }
    const PreparedRecta prepared(line);
    const double rho = -prepared.signed_distance({pose.x, pose.y});
    Matrix2 h;
    h << 1.0, pose.x * prepared.s - pose.y * prepared.c, 0.0, 1.0;
    const Matrix2 q = h * landmark.covariance * h.transpose() + r;
    // The angle alone says no less than both; this spares nearly all of the rest.
    if (turn * turn > 100.0 * kGate * q(1, 1)) return std::nullopt;
    const auto [low, high] = std::minmax(
        {prepared.along(transform(pose, seen.a)), prepared.along(transform(pose, seen.b))});
    if (high < landmark.from_m - kReach || low > landmark.to_m + kReach) return std::nullopt;
    ICaracteristica as_seen;
    as_seen.value = z;
    as_seen.covariance = r;
    return Comparison{as_seen, distance2({z.rho - rho, turn}, q)};
}

/// h = (x, y) of the corner in the robot's frame.
std::optional<Comparison> compared(const Esquina& corner, const ICaracteristica& landmark,
                                   const Pose& pose, const Seen& seen) {
    const auto& z = std::get<Esquina>(seen.feature.value);
    const Point2 h = transform(inverse(pose), Point2{corner.x, corner.y});
    const Matrix2 turn = Eigen::Rotation2Dd(-pose.theta).toRotationMatrix();
    const Matrix2 q = turn * landmark.covariance * turn.transpose() + seen.feature.covariance;
    return Comparison{seen.feature, distance2({z.x - h.x, z.y - h.y}, q)};
}

/// A landmark of the map as the robot saw it from a pose, in its frame, with the covariance of
/// (rho, theta) or (x, y) [m, rad]. A line has the normal that points as the landmark's does.
struct GraphSighting {
    std::size_t pose = 0;
    std::size_t landmark = 0;
    ICaracteristica seen;
};

/// Finds whose the features are, scan by scan.
class Sightings {
  public:
    explicit Sightings(const LandmarkMap& map)
        : map_(map),
          nearest_(map.size(), {std::numeric_limits<double>::infinity(), {}}),
          found_(map.size(), 0) {}

    void note(std::size_t scan, const Pose& pose, const std::vector<Seen>& all) {
        for (const Seen& seen : all) {
            std::optional<std::size_t> best;
            Comparison to_best;
            bool known = false;  // then nothing speaks against it
            for (std::size_t i = 0; i < map_.size(); ++i) {
                if (!may_be(seen, map_[i])) continue;
                const auto one = std::visit(
                    [&](const auto& landmark) { return compared(landmark, map_[i], pose, seen); },
                    map_[i].value);
                if (!one) continue;
                if (one->distance2 < nearest_[i].first) {
                    nearest_[i] = {one->distance2, {scan, i, one->seen}};
                }
                const bool named =
                    seen.feature.identity >= 0 && map_[i].identity == seen.feature.identity;
                if (named || (!known && one->distance2 < to_best.distance2)) {
                    best = i;
                    to_best = *one;
                    known = known || named;
                }
            }
            if (!best || (!known && to_best.distance2 > kGate)) continue;
            sightings_.push_back({scan, *best, to_best.seen});
            found_[*best] = 1;
        }
    }

    /// In the order of the scans.
    std::vector<GraphSighting> take() {
        for (std::size_t i = 0; i < map_.size(); ++i) {
            if (found_[i] == 0 && std::isfinite(nearest_[i].first)) {
                sightings_.push_back(nearest_[i].second);
            }
        }
        std::ranges::stable_sort(sightings_, {}, &GraphSighting::pose);
        return std::move(sightings_);
    }

  private:
    const LandmarkMap& map_;
    std::vector<std::pair<double, GraphSighting>> nearest_;
    std::vector<char> found_;
    std::vector<GraphSighting> sightings_;
};

void add_registration(const Registration& registration, std::vector<PlanarEdge>& steps) {
    const auto keys = registration.keys();
    for (const PoseEdge& told : registration.edges()) {
        if (told.kind == EdgeKind::odometry) continue;  // the steps between have it
        const PoseEdge edge = edge_of_origin(told, keys[told.from].pose, keys[told.to].pose);
        steps.push_back(step_edge(keys[edge.from].scan, keys[edge.to].scan, edge.z,
                                  turned(edge.information, -edge.z.theta)));
    }
}

void add_vertices(const std::vector<Pose>& poses, const LandmarkMap& map, PlanarGraph& graph) {
    const auto add = [&](PlanarVertex::Kind kind, const Eigen::Vector3d& at) {
        PlanarVertex& vertex = graph.vertices.emplace_back();
        vertex.kind = kind;
        vertex.id = graph.vertices.size() - 1;
        vertex.at = at;
    };
    for (const Pose& pose : poses) {
        add(PlanarVertex::Kind::pose, {pose.x, pose.y, pose.theta});
    }
    if (!poses.empty()) graph.vertices.front().fixed = true;
    for (const ICaracteristica& landmark : map) {
        if (const auto* corner = std::get_if<Esquina>(&landmark.value)) {
            add(PlanarVertex::Kind::point, {corner->x, corner->y, 0.0});
        } else {
            const auto& line = std::get<Recta>(landmark.value);
            add(PlanarVertex::Kind::line, {line.theta, line.rho, 0.0});
        }
    }
}

PlanarEdge sighting_edge(const GraphSighting& sighting, std::size_t poses) {
    PlanarEdge edge;
    edge.from = static_cast<std::uint32_t>(sighting.pose);
    edge.to = static_cast<std::uint32_t>(poses + sighting.landmark);
    const Matrix2 information = sighting.seen.covariance.inverse();
    if (const auto* corner = std::get_if<Esquina>(&sighting.seen.value)) {
        edge.kind = PlanarEdge::Kind::point;
        edge.z.head<2>() << corner->x, corner->y;
        edge.information.topLeftCorner<2, 2>() = information;
        return edge;
    }
    const auto& line = std::get<Recta>(sighting.seen.value);
    edge.kind = PlanarEdge::Kind::line;
    edge.z.head<2>() << line.theta, line.rho;
    edge.information.topLeftCorner<2, 2>() = information.reverse();
    return edge;
}

}  // namespace

PlanarGraph graph_of(const Algoritmo& run) {
    PlanarGraph graph;
    const std::vector<Pose> poses = run.filter().best_history();
    const LandmarkMap map = run.filter().best_map();
    add_vertices(poses, map, graph);
    const Configuracion& configuration = run.configuration();
    const std::unique_ptr<TourReader> reader = run.reader().reopen();
    const std::unique_ptr<Extractor> extractor =
        run.options().extractor ? run.options().extractor()
                                : make_extractor(configuration.extraction, configuration.run.seed);
    const std::unique_ptr<Robot> robot =
        run.registration() == nullptr ? make_robot(configuration.filter.motion) : nullptr;
    ControlTrack track([&reader] { return reader->next_odometry(); });
    std::vector<Control> controls;
    Observation observation;
    Sightings sightings(map);
    const std::vector<GraphEdit> edits = parse_graph_edits(configuration.registration.edits);
    for (std::size_t i = 0; i < poses.size(); ++i) {
        const std::optional<Scan> scan = reader->next_scan();
        if (!scan) break;
        track.controls_until(*scan, controls);
        if (i > 0 && !scan->begins_tour) {  // nothing was driven to there
            graph.edges.push_back(
                robot != nullptr ? step_by_model(*robot, i, poses[i - 1], controls)
                                 : step_by_wheels(configuration.registration, edits, i, controls));
        }
        extractor->go_to(i);
        extractor->extract(*scan, observation);
        sightings.note(i, poses[i],
                       seen_in(observation, configuration.filter.observation,
                               configuration.filter.association.known));
    }
    if (run.registration() != nullptr) add_registration(*run.registration(), graph.edges);
    for (const GraphSighting& sighting : sightings.take()) {
        graph.edges.push_back(sighting_edge(sighting, poses.size()));
    }
    return graph;
}

}  // namespace hitos
