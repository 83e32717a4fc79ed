// SPDX-License-Identifier: GPL-3.0-or-later
#include <Eigen/Cholesky>
#include <Eigen/LU>
#include <algorithm>
#include <cmath>
#include <utility>

#include "hitos/registration/laid_drawing.hpp"
#include "hitos/registration/odometry_step.hpp"
#include "hitos/registration/pose_algebra.hpp"
#include "hitos/registration/pose_graph_solver.hpp"
#include "key_graph.hpp"
#include "loop_closer.hpp"
#include "path_break.hpp"
#include "registration_impl.hpp"
#include "scan_matcher.hpp"
#include "step_matcher.hpp"
#include "surface_points.hpp"

namespace hitos {
namespace {

constexpr std::size_t kLoopEvery = 2;  // keys
constexpr double kKeySlip = 0.01;      // [m] added to a key's standard deviation
constexpr double kKeySlipRad = 0.002;  // [rad]

}  // namespace

RegisteredStep Registration::Impl::add(const Scan& scan, std::span<const Control> controls) {
    clock_.begin();
    corrections_.clear();
    RegisteredStep out;
    out.scan = placed_.size();
    editor_.check(out.scan, scan);
    out.before = now_;
    const DrivenWay way = driven_way(controls);
    out.path_m = way.path_m;
    out.turned_rad = way.turned_rad;
    const bool first = graph_.size() == 0;
    const bool wanted = editor_.needs_key(out.scan);
    const bool slipped = editor_.slipped(out.scan);
    const TourBegin* const begin = scan.begins_tour && !first ? &*scan.begins_tour : nullptr;
    const bool moved = way.moved() || slipped;
    if (first || moved || wanted || begin != nullptr) {  // else nothing to match, and no key due
        find_surface_points(scan, params_.range_m, points_);
        clock_.ends(RegistrationStage::points);
        if (begin != nullptr) {
            leave_first_tour();
        } else if (!first && moved) {
            step(way, slipped, out);
        }
        const bool due = first || begin != nullptr || key_due();
        out.key = due || wanted;
        if (!due && wanted) forced_keys_.push_back(out.scan);
    }
    out.pose = now_;
    if (out.key) add_key(out.scan, begin);
    const auto newest = static_cast<std::uint32_t>(graph_.size() - 1);
    placed_.push_back({newest, between(graph_.poses[newest].pose, now_)});
    if (out.key) {
        clock_.ends(RegistrationStage::matching);
        std::vector<KeyPose> before;  // of the first that moves the graph; empty: nothing has
        edit_graph(before);
        clock_.ends(RegistrationStage::closing);
        if (params_.loops && newest > static_cast<std::uint32_t>(params_.key_scans)) {
            if (newest % kLoopEvery == 0) close_loop(before);
            if (!carried_.empty()) find_piece(before);
        }
        if (!before.empty()) correct(before);
        tell_edges(!before.empty());
        clock_.ends(RegistrationStage::closing);
    }
    out.keys = graph_.poses;
    out.edges = told_edges();
    clock_.ends(RegistrationStage::matching);
    return out;
}

Registration::Impl::Guess Registration::Impl::placed_by(const Pose& step,
                                                        const Eigen::Vector3d& variances) const {
    const PosePrior prior{compose(now_, step),
                          step_information(variances, now_.theta + 0.5 * step.theta),
                          params_.robust_prior};
    const Eigen::Vector2d sigmas(std::sqrt(std::max(variances(0), variances(1))),
                                 std::sqrt(variances(2)));
    return {step, variances, prior.information, step_matcher_.match(points_, map_, prior, sigmas)};
}

/// Where the odometry began anew while the robot stood: it fits where it was.
std::optional<Registration::Impl::Guess> Registration::Impl::stood(const Pose& raw) const {
    constexpr double kLeap = 1.0;  // [m], [rad]: no more was driven unseen
    constexpr double kFits = 0.7;
    if (std::hypot(raw.x, raw.y) + std::abs(raw.theta) < kLeap) return std::nullopt;
    const Pose little{0.5, 0.0, 0.3};
    Guess guess = placed_by({}, odometry_variances(little, params_.odometry_scale));
    const bool fits = guess.matched.score > kFits && !breaks_path(points_, guess.matched, graph_);
    return fits ? std::optional(std::move(guess)) : std::nullopt;
}

void Registration::Impl::step(const DrivenWay& way, bool slipped, RegisteredStep& out) {
    const Pose before = now_;
    const Pose raw = way.pose_start_end;
    refresh_map(before);
    const Pose driven = params_.calibrate ? calibration_.corrected(raw) : raw;
    Guess guess = placed_by(
        driven, slipped ? slip_variances() : odometry_variances(driven, params_.odometry_scale));
    if (!slipped && breaks_path(points_, guess.matched, graph_)) {
        if (std::optional<Guess> other = stood(raw)) {
            guess = *std::move(other);
        } else {
            doubt(placed_.size());
        }
    }
    const MatchedStep& matched = guess.matched;
    Eigen::Matrix3d posterior = guess.information;
    if (matched.matched) posterior += matcher_.information() * matched.fine.h;
    out.covariance = turned(posterior.inverse(), -before.theta);
    out.matched = matched.matched;
    out.score = std::max(0.0, matched.score);
    ++figures_.scans;
    if (matched.matched) {
        figures_.mean_score += out.score;
        if (params_.calibrate && !slipped) learn(way, guess, before);
    } else {
        ++figures_.unmatched;
    }
    now_ = matched.pose;
    const Pose moved = between(before, now_);
    travelled_m_ += std::hypot(moved.x, moved.y);
    odometry_ = compose(odometry_, guess.step);
    odometry_variances_ += guess.variances;
    variance_m2_ += 0.5 * (out.covariance(0, 0) + out.covariance(1, 1));
    variance_rad2_ += out.covariance(2, 2);
}

/// Of the scan alone, without the odometry, where it says more of the way across than the odometry.
void Registration::Impl::learn(const DrivenWay& way, const Guess& guess, const Pose& before) {
    const MatchedStep& matched = guess.matched;
    const Eigen::Vector3d& variances = guess.variances;
    const Eigen::Matrix3d information =
        matcher_.information() * matched.fine.h + 1e-3 * Eigen::Matrix3d::Identity();
    const Eigen::Matrix3d covariance = information.inverse();
    if (turned(covariance, -before.theta)(1, 1) >= 0.5 * variances(1)) return;
    const Eigen::Vector3d step = -covariance * (matcher_.information() * matched.fine.b);
    const Pose alone = shifted(matched.pose, step);
    calibration_.learn(way.pose_start_end, between(before, alone).y - guess.step.y, variances(1));
}

void Registration::Impl::refresh_map(const Pose& about) {
    if (!map_stale_) return;
    const MapOfKeys map{graph_.size(), about, newest_in_map()};
    const OlderKeys older = older_keys(graph_, map, beside_, map.newest / 2);
    in_crowd_ = older.crowd;
    select_keys(graph_, map, older.keys, map_keys_);
    build_map(graph_, map_keys_, about, kMapHalf, map_);
    map_stale_ = false;
}

bool Registration::Impl::key_due() const {
    const Pose since = between(graph_.poses.back().pose, now_);
    return std::hypot(since.x, since.y) > params_.key_distance_m ||
           std::abs(since.theta) > params_.key_angle_rad;
}

void Registration::Impl::add_key(std::uint64_t scan, const TourBegin* begin) {
    // Of one that stood, the graph may have moved since.
    if (graph_.size() > 0 && begin == nullptr) refresh_map(now_);
    KeyScan key;
    key.hold(points_);
    key.travelled_m = travelled_m_;
    key.variance_m2 = variance_m2_ + kKeySlip * kKeySlip;
    key.variance_rad2 = variance_rad2_ + kKeySlipRad * kKeySlipRad;
    graph_.add({now_, scan}, std::move(key), in_crowd_ && begin == nullptr);
    if (graph_.thin_if_many_rest()) {
        told_.clear();
        told_of_ = 0;
    }
    const auto newest = static_cast<std::uint32_t>(graph_.size() - 1);
    if (begin != nullptr) {
        begin_second_tour(scan, *begin);
    } else if (newest > 0) {
        if (odometry_variances_.isZero())  // it stood
            odometry_variances_ = odometry_variances({}, params_.odometry_scale);
        graph_.edges.push_back({newest - 1, newest, odometry_,
                                step_information(odometry_variances_, 0.5 * odometry_.theta),
                                EdgeKind::odometry});
        by_source_.assign(map_keys_.size(), {});
        const Linearization l = matcher_.linearize(points_, map_, now_, kFineStage, 1, &by_source_);
        const std::size_t first = graph_.edges.size();
        if (l.matches >= kLeastMatches) {
            graph_.find_scan_edges(newest, now_, map_keys_, by_source_, matcher_.information(),
                                   newest_in_map(), graph_.edges);
        }
        for (std::size_t i = first; i < graph_.edges.size(); ++i) {
            const PoseEdge& edge = graph_.edges[i];
            if (edge.kind == EdgeKind::loop && !graph_.rests(edge.from))
                graph_.join(edge.from, newest);
        }
        believe_where_it_fits(by_source_);
    }
    odometry_ = {};
    odometry_variances_.setZero();
    variance_m2_ = variance_rad2_ = 0.0;
    map_stale_ = true;
}

/// `before` takes the keys as they were where it moves the graph and nothing has before.
void Registration::Impl::close_loop(std::vector<KeyPose>& before) {
    const std::size_t newest = graph_.size() - 1;
    ways_.begin(graph_, newest);
    // The robot goes on from there, until two more keys have passed.
    beside_ = ways_.beside(kBesideKey + 2.0 * params_.key_distance_m, kOldKeysWay);
    const auto found = closer_.search(graph_, ways_, refused_);
    clock_.ends(RegistrationStage::search);
    if (!found) return;
    LoopRecord record = found->record;
    std::vector<KeyPose> now = graph_.poses;
    record.refused_by = editor_.refuses(graph_, *found);
    record.verdict = record.refused_by ? LoopVerdict::by_hand : close(*found, record);
    closer_.forget();
    if (record.verdict != LoopVerdict::closed) {
        graph_.poses = std::move(now);
        refused_.push_back(record);
        return;
    }
    note_closed(record, std::move(now), before);
    believe(found->key);
}

/// `now`: the keys as they were; to move those from `corrected` on corrects nothing.
void Registration::Impl::note_closed(LoopRecord& record, std::vector<KeyPose> now,
                                     std::vector<KeyPose>& before, std::size_t corrected) {
    record.move_m =
        greatest_move(std::span(now).first(std::min(corrected, now.size())), graph_.poses);
    figures_.largest_correction_m = std::max(figures_.largest_correction_m, record.move_m);
    loops_.push_back(record);
    if (before.empty()) before = std::move(now);
}

/// Puts its edges into the graph and solves it. Of what is not closed no edge stays.
LoopVerdict Registration::Impl::close(const LoopFound& found, LoopRecord& record) {
    const std::size_t newest = graph_.size() - 1;
    // The newest scan against the earlier keys: the query's pose is the prior, to some decimetres.
    PointMap map;
    build_map(graph_, found.sources, graph_.poses[found.key].pose, kMapHalf, map);
    const std::span<const SurfacePoint> scan = graph_.scans[newest].points();
    const PosePrior prior{found.pose, 10.0 * Eigen::Matrix3d::Identity()};
    const Pose pose = matcher_.fit(scan, map, found.pose, prior);
    record.pose_earlier_scan = between(graph_.poses[found.key].pose, pose);
    by_source_.assign(found.sources.size(), {});
    matcher_.linearize(scan, map, pose, kFineStage, 1, &by_source_);
    const std::size_t first = graph_.edges.size();
    graph_.find_scan_edges(static_cast<std::uint32_t>(newest), pose, found.sources, by_source_,
                           matcher_.information(), 0, graph_.edges);
    if (graph_.edges.size() == first) return LoopVerdict::no_edge;
    // Both without robust weights, which let a slip stand as it is and would cut a large correction
    // off.
    const std::span known = std::span(graph_.edges).first(first);
    PoseGraphSolver solver(graph_.size(), graph_.edges);
    solver.solve(graph_.poses, solution(6, false), first);
    const double tension_before = tension(known);
    solver.solve(graph_.poses, solution(6, false));
    record.chi_square_limit = explained_chi_square(graph_.edges.size() - first);
    record.chi_square = tension(graph_.edges) - tension_before;
    if (*record.chi_square > *record.chi_square_limit) {
        graph_.edges.resize(first);
        return LoopVerdict::strained;
    }
    for (std::size_t i = first; i < graph_.edges.size(); ++i) {
        graph_.join(graph_.edges[i].from, graph_.edges[i].to);
    }
    solver.solve(graph_.poses, solution(6, true));
    return LoopVerdict::closed;
}

/// Sum of the squared Mahalanobis distances of edges.
double Registration::Impl::tension(std::span<const PoseEdge> edges) const {
    const auto drawing = laid_drawing(graph_.poses, edges);
    double sum = 0.0;
    for (const PoseEdge& edge : edges) sum += squared_distance(edge, drawing);
    return sum;
}

/// Mahalanobis distance, squared, of an edge; of an anchor where the drawing lies.
double Registration::Impl::squared_distance(const PoseEdge& edge,
                                            const std::optional<LaidDrawing>& drawing) const {
    const Pose& from = edge.kind == EdgeKind::anchor ? drawing->pose : graph_.poses[edge.from].pose;
    const Eigen::Vector3d error = edge_error(edge, from, graph_.poses[edge.to].pose).value;
    return error.dot(edge.information * error);
}

void Registration::Impl::correct(const std::vector<KeyPose>& keys_before) {
    std::vector<Pose> moves;
    for (std::size_t k = 0; k < graph_.size(); ++k) {
        moves.push_back(k < held_ ? Pose{}
                                  : compose(graph_.poses[k].pose, inverse(keys_before[k].pose)));
    }
    for (const Placed& placed : placed_) corrections_.push_back(moves[placed.key]);
    now_ = compose(graph_.poses[placed_.back().key].pose, placed_.back().pose_key_scan);
    map_stale_ = true;
}

/// Anchors are edges from the first key for who knows no drawing, as soon as they say anything of
/// how keys lie to each other. `anew` where more has changed than that edges came to the graph's.
void Registration::Impl::tell_edges(bool anew) {
    if (anchors_.empty()) return;
    const auto drawing = laid_drawing(graph_.poses, graph_.edges);
    if (anew || told_of_ > graph_.edges.size()) {
        told_.clear();
        told_of_ = 0;
    }
    const bool tie = drawing->firm && std::ranges::any_of(anchors_, [&](const NotedChange& one) {
                         return one.edit.scan.scan != anchors_.front().edit.scan.scan;
                     });
    for (; told_of_ < graph_.edges.size(); ++told_of_) {
        const PoseEdge& edge = graph_.edges[told_of_];
        if (edge.kind != EdgeKind::anchor) {
            told_.push_back(edge);
        } else if (tie && edge.to > 0) {
            told_.push_back(edge_from_first(edge, graph_.poses.front(), *drawing));
        }
    }
}

std::span<const PoseEdge> Registration::Impl::told_edges() const {
    return anchors_.empty() ? std::span<const PoseEdge>(graph_.edges) : told_;
}

std::vector<Pose> Registration::Impl::path() const {
    std::vector<Pose> poses;
    poses.reserve(placed_.size());
    for (const Placed& placed : placed_) {
        poses.push_back(compose(graph_.poses[placed.key].pose, placed.pose_key_scan));
    }
    return poses;
}

RegistrationFigures Registration::Impl::figures() const {
    RegistrationFigures figures = figures_;
    const std::uint64_t matched = figures.scans - figures.unmatched;
    if (matched > 0) figures.mean_score /= static_cast<double>(matched);
    figures.keys = graph_.size();
    figures.loop_searches = closer_.searches();
    figures.edits_unmet = editor_.unmet();
    figures.drawing = laid_drawing(graph_.poses, graph_.edges);
    figures.anchors = anchor_figures();
    figures.edits_covered = editor_.covered(graph_, refused_, placed_.size());
    figures.by_hand = editor_.counts();
    const auto strained =
        std::ranges::find_if(fixes_, [](const NotedChange& fix) { return fix.bent > fix.limit; });
    if (strained != fixes_.end()) figures.strained_fix = number_of(strained->edit) - 1;
    figures.loops_refused = static_cast<std::uint64_t>(std::ranges::count_if(
        refused_, [](const LoopRecord& loop) { return loop.verdict != LoopVerdict::alone; }));
    return figures;
}

}  // namespace hitos
