// SPDX-License-Identifier: GPL-3.0-or-later
// Generated fields of landmarks: the robot drives the same small circle in the middle of each, sees
// the same number of features in every step and knows all landmarks before the clock starts.

#include <algorithm>
#include <cmath>
#include <random>

#include "speed_workloads.hpp"

namespace speed {
namespace {

using namespace hitos;

constexpr int kLap = 200;         // steps of the circle
constexpr double kRadius = 3.75;  // m, of the circle
constexpr double kTurn = 2.0 * kPi / kLap;
constexpr double kStepTime = 0.2;  // s

/// A wall of a pillar.
struct Wall {
    Point2 a;
    Point2 b;
};

struct Field {
    std::vector<Esquina> corners;
    std::vector<Wall> walls;
    Observation all;  ///< every landmark, from the robot's first place
    std::vector<Observation> seen;
};

/// Where the robot is after so many steps, in a field whose middle is the origin.
Pose place(int steps) {
    const double angle = kTurn * steps;
    return {kRadius * std::cos(angle), kRadius * std::sin(angle), wrap_angle(angle + kPi / 2.0)};
}

Control one_step() {
    return {{kRadius * kTurn / kStepTime, 0.0, kTurn / kStepTime}, kStepTime};
}

void see_corner(Observation& seen, const Pose& pose, const Esquina& corner, double dx, double dy) {
    Esquina local = transform(inverse(pose), corner);
    seen.corners.push_back({local.x + dx, local.y + dy});
}

/// A wall from end to end, moved along its normal and turned about its middle by that much.
void see_wall(Observation& seen, const Pose& pose, const Wall& wall, double moved, double turned) {
    const Pose back = inverse(pose);
    const Point2 a = transform(back, wall.a);
    const Point2 b = transform(back, wall.b);
    const double length = std::hypot(b.x - a.x, b.y - a.y);
    const Point2 normal{(a.y - b.y) / length, (b.x - a.x) / length};
    const double at_a = moved - 0.5 * turned * length;
    const double at_b = moved + 0.5 * turned * length;
    const Point2 from{a.x + at_a * normal.x, a.y + at_a * normal.y};
    const Point2 to{b.x + at_b * normal.x, b.y + at_b * normal.y};
    seen.lines.push_back(
        {line_through(from, to), static_cast<std::uint32_t>(seen.support.size()), 2});
    seen.support.push_back(from);
    seen.support.push_back(to);
}

/// Centres of places in a square about the origin, shifted at random.
std::vector<Point2> places(int count, double spacing, double most_shift, std::mt19937& engine) {
    std::uniform_real_distribution<double> shift(-most_shift, most_shift);
    const int side = static_cast<int>(std::ceil(std::sqrt(count)));
    std::vector<Point2> result;
    for (int i = 0; i < count; ++i) {
        const int column = i % side;
        const int row = i / side;
        const double x = spacing * (column - 0.5 * (side - 1)) + shift(engine);
        const double y = spacing * (row - 0.5 * (side - 1)) + shift(engine);
        result.push_back({x, y});
    }
    return result;
}

/// Square pillars of one metre, turned at random: four walls and four corners each.
void add_pillars(Field& field, int count, std::mt19937& engine) {
    std::uniform_real_distribution<double> direction(-kPi, kPi);
    for (const Point2& centre : places(count, 6.0, 2.0, engine)) {
        const Pose pose{centre.x, centre.y, direction(engine)};
        std::vector<Point2> ends;
        for (const Point2& end :
             {Point2{-0.5, -0.5}, Point2{0.5, -0.5}, Point2{0.5, 0.5}, Point2{-0.5, 0.5}}) {
            ends.push_back(transform(pose, end));
            field.corners.push_back({ends.back().x, ends.back().y});
        }
        for (std::size_t i = 0; i < 4; ++i) field.walls.push_back({ends[i], ends[(i + 1) % 4]});
    }
}

/// What the robot sees after so many steps: the nearest features, with noise.
Observation look(const Field& field, int steps, std::size_t features, std::mt19937& engine) {
    std::normal_distribution<double> noise(0.0, 0.01);
    const Pose pose = place(steps);
    struct Near {
        double distance;
        std::size_t index;
    };
    std::vector<Near> near;
    for (std::size_t i = 0; i < field.corners.size(); ++i) {
        const Esquina& corner = field.corners[i];
        near.push_back({std::hypot(corner.x - pose.x, corner.y - pose.y), i});
    }
    for (std::size_t i = 0; i < field.walls.size(); ++i) {
        const Wall& wall = field.walls[i];
        near.push_back(
            {std::hypot(0.5 * (wall.a.x + wall.b.x) - pose.x, 0.5 * (wall.a.y + wall.b.y) - pose.y),
             field.corners.size() + i});
    }
    const std::size_t count = std::min(features, near.size());
    std::partial_sort(near.begin(), near.begin() + static_cast<std::ptrdiff_t>(count), near.end(),
                      [](const Near& a, const Near& b) { return a.distance < b.distance; });
    Observation seen;
    for (const Near& n : std::span(near).first(count)) {
        const double first = noise(engine);
        const double second = noise(engine);
        if (n.index < field.corners.size()) {
            see_corner(seen, pose, field.corners[n.index], first, second);
        } else {
            see_wall(seen, pose, field.walls[n.index - field.corners.size()], first, second);
        }
    }
    return seen;
}

Field make_field(FieldKind kind, int landmarks, std::size_t features) {
    Field field;
    std::mt19937 engine(7);
    if (kind == FieldKind::corners) {
        for (const Point2& p : places(landmarks, 3.0, 0.5, engine)) {
            field.corners.push_back({p.x, p.y});
        }
    } else {
        add_pillars(field, (landmarks + 7) / 8, engine);
    }
    for (const Esquina& corner : field.corners) see_corner(field.all, place(0), corner, 0.0, 0.0);
    for (const Wall& wall : field.walls) see_wall(field.all, place(0), wall, 0.0, 0.0);
    // As sure as after many sightings from nearby; from afar, many would look like one.
    const Eigen::Matrix2d sure = 1e-6 * Eigen::Matrix2d::Identity();
    field.all.corner_covariances.assign(field.all.corners.size(), sure);
    field.all.line_covariances.assign(field.all.lines.size(), sure);
    // The step after the last of a lap is the first again.
    for (int k = 1; k <= kLap; ++k) field.seen.push_back(look(field, k, features, engine));
    return field;
}

FilterParams field_params(const Options& options) {
    FilterParams params;
    params.particles = options.particles;
    take_proportional_motion(params);
    params.observation = {0.0004, 0.0001};
    return params;
}

/// Drives a filter that knows the whole field.
class Drive {
  public:
    Drive(const Field& field, const FilterParams& params, int threads)
        : field_(field), filter_(make_filter(params, 1, threads)) {
        step(*filter_, scan_, {}, field.all);
    }
    void go(int steps) {
        for (int i = 0; i < steps; ++i) {
            step(*filter_, scan_, std::span(&control_, 1), field_.seen[next_]);
            next_ = (next_ + 1) % field_.seen.size();
        }
    }
    void go_blind(int steps) {
        for (int i = 0; i < steps; ++i) {
            step(*filter_, scan_, std::span(&control_, 1), nothing_);
        }
    }
    const SlamFilter& filter() const { return *filter_; }

  private:
    const Field& field_;
    Scan scan_;
    Control control_ = one_step();
    Observation nothing_;
    std::unique_ptr<SlamFilter> filter_;
    std::size_t next_ = 0;
};

/// Times steps that see features, then steps that see nothing.
void measure_drive(const Field& field, const FilterParams& params, const Options& options) {
    Drive drive(field, params, options.threads);
    drive.go(std::min(options.steps, 20));
    const Cost seeing = cheapest(
        options.seconds, [] {}, [&] { drive.go(options.steps); });
    print_per(seeing, options.steps, "step");
    print("landmarks", landmarks(drive.filter()), "1");
    print("features_per_step",
          static_cast<double>(field.seen.front().lines.size() + field.seen.front().corners.size()),
          "1");
    const Cost blind = cheapest(
        options.seconds / 4.0, [] {}, [&] { drive.go_blind(options.steps); });
    print_per(blind, options.steps, "blind_step");
}

/// Reads and writes every value once.
[[gnu::noinline]] void pass_over(std::span<double> values) {
    double* const data = values.data();
    const std::size_t count = values.size();
    for (std::size_t i = 0; i < count; ++i) data[i] += 1.0;
}

}  // namespace

void measure_field(FieldKind kind, const Options& options) {
    measure_drive(make_field(kind, options.landmarks, 10), field_params(options), options);
}

void measure_points(const Options& options) {
    FilterParams params = field_params(options);
    params.resampling.rule = ResamplingRule::neff;
    params.resampling.neff_threshold = 0.5 * options.particles;
    measure_drive(make_field(FieldKind::corners, 560, 17), params, options);
}

void measure_ekf(const Options& options) {
    FilterParams params = field_params(options);
    take_ekf_slam(params);
    measure_drive(make_field(FieldKind::corners, options.landmarks, 10), params, options);

    const std::size_t side = 2 * static_cast<std::size_t>(options.landmarks) + 3;
    std::vector<double> whole(side * side);
    std::vector<double> half(side * (side + 1) / 2);
    const Cost of_whole = cheapest(
        0.2, [] {}, [&] { pass_over(whole); });
    const Cost of_half = cheapest(
        0.2, [] {}, [&] { pass_over(half); });
    keep(whole);
    keep(half);
    print_per(of_whole, 1.0, "pass");
    print_per(of_half, 1.0, "half_pass");
}

}  // namespace speed
