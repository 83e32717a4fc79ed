#include "filtro_particulas.hpp"

#include <tbb/blocked_range.h>
#include <tbb/info.h>
#include <tbb/parallel_for.h>

#include <algorithm>
#include <cmath>
#include <string>

namespace hitos {
namespace {

/// Below this many particle x landmark x observation evaluations a step gains nothing from a
/// second thread (measured with tests/bench).
constexpr std::size_t kParallelWork = 30000;
constexpr std::size_t kGrain = 32;

PreparedObservation prepare(const SeenFeature& seen, const Pose& pose) {
    const double angle_world = seen.measured.z(1) + pose.theta;
    return {seen, std::cos(angle_world), std::sin(angle_world)};
}

template <class Filter, class Columns>
void apply(const Decision& decision, Columns& landmarks, const Pose& pose,
           const Measurement& measured) {
    if (decision.outcome == Association::Outcome::ignored) return;
    const Filter ekf(measured.r);
    const Vector2& z = measured.z;
    if (decision.outcome == Association::Outcome::created) {
        const std::size_t index = landmarks.append();
        landmarks.set(index, ekf.first(pose, z));
        landmarks.observations(index) = 1;
        return;
    }
    auto estimate = landmarks.get(decision.landmark);
    ekf.update(estimate, landmarks.innovation(decision.landmark, z, pose));
    landmarks.set(decision.landmark, estimate);
    ++landmarks.observations(decision.landmark);
}

}  // namespace

FiltroParticulas::FiltroParticulas(const FilterParams& params, std::uint64_t seed, int threads)
    : params_(params),
      seed_(seed),
      proposal_(proposals().find(params.proposal).make(params)),
      associator_(params.association),
      resampler_(make_resampler(params.resampling)),
      resampling_(resampling_methods().find(params.resampling.method).make(params.resampling)),
      arena_(threads > 0 ? threads : tbb::task_arena::automatic),
      particles_(static_cast<std::size_t>(params.particles)) {
    if (threads > tbb::info::default_concurrency()) {
        more_threads_.emplace(tbb::global_control::max_allowed_parallelism,
                              static_cast<std::size_t>(threads));
    }
    // All particles start as copies of one: same pose, same empty map.
    const MapStore::Handle empty = maps_.create();
    for (std::size_t i = 0; i < particles_.size(); ++i) {
        particles_[i].map = empty;
        if (i > 0) maps_.share(empty);
    }
    statistics_.neff = static_cast<double>(particles_.size());
}

void FiltroParticulas::step(const SlamInput& input) {
    const Observation& observation = input.observation;
    propose(input);
    associations_.clear();
    statistics_.resampled = false;
    if (observation.empty()) {
        remember_poses();  // nothing was observed: weights and particles stay as they are
        ++steps_;
        return;
    }

    measurements_.take(observation, params_.observation);
    lines_seen_.clear();
    corners_seen_.clear();
    for (const Measurement& line : measurements_.lines) {
        lines_seen_.push_back(associator_.seen(line));
    }
    for (const Measurement& corner : measurements_.corners) {
        corners_seen_.push_back(associator_.seen(corner));
    }
    const std::size_t seen = measurements_.size();
    decisions_.resize(seen * particles_.size());

    detach_maps();
    const auto landmarks =
        static_cast<std::size_t>(best_count(FeatureKind::line) + best_count(FeatureKind::corner));
    for_each(particles_.size(), seen * (landmarks + 8), [&](std::size_t i) {
        const std::span<Decision> decisions(&decisions_[i * seen], seen);
        associate(particles_[i], decisions);
        update(particles_[i], decisions);
        weigh(particles_[i], decisions);
    });

    choose_best();
    note_associations();
    remember_poses();
    resample();
    ++steps_;
}

void FiltroParticulas::propose(const SlamInput& input) {
    proposal_->begin(input, steps_ == 0);
    for_each(particles_.size(), 10, [&](std::size_t i) {
        RandomStream random(seed_, RandomPurpose::motion, steps_, static_cast<std::uint32_t>(i));
        const ProposedPose drawn = proposal_->draw(particles_[i].pose, random);
        particles_[i].pose = drawn.pose;
        particles_[i].log_weight += drawn.log_weight;
    });
}

void FiltroParticulas::detach_maps() {
    copies_.clear();
    for (Particula& particle : particles_) {
        const MapStore::Handle source = maps_.detach(particle.map);
        if (source != particle.map) copies_.emplace_back(source, particle.map);
    }
    maps_.reserve_more(lines_seen_.size(), corners_seen_.size());
    for_each(copies_.size(), 20,
             [&](std::size_t i) { maps_.copy(copies_[i].first, copies_[i].second); });
}

void FiltroParticulas::associate(const Particula& particle, std::span<Decision> decisions) const {
    const auto& lines = maps_.lines(particle.map);
    const auto& corners = maps_.corners(particle.map);
    std::size_t next = 0;
    for (const SeenFeature& line : lines_seen_) {
        decisions[next++] = associator_.decide(lines, particle.pose, prepare(line, particle.pose));
    }
    for (const SeenFeature& corner : corners_seen_) {
        decisions[next++] =
            associator_.decide(corners, particle.pose, prepare(corner, particle.pose));
    }
}

void FiltroParticulas::update(Particula& particle, std::span<Decision> decisions) {
    auto lines = maps_.lines(particle.map);
    auto corners = maps_.corners(particle.map);
    std::size_t next = 0;
    for (const SeenFeature& line : lines_seen_) {
        Decision& decision = decisions[next++];
        if (decision.outcome == Association::Outcome::created) {
            decision.landmark = static_cast<std::uint32_t>(lines.size());
        }
        apply<EKF<SensorRecta>>(decision, lines, particle.pose, line.measured);
    }
    for (const SeenFeature& corner : corners_seen_) {
        Decision& decision = decisions[next++];
        if (decision.outcome == Association::Outcome::created) {
            decision.landmark = static_cast<std::uint32_t>(corners.size());
        }
        apply<EKF<SensorEsquina>>(decision, corners, particle.pose, corner.measured);
    }
}

void FiltroParticulas::weigh(Particula& particle, std::span<const Decision> decisions) {
    for (const Decision& decision : decisions) particle.log_weight += decision.log_likelihood;
}

void FiltroParticulas::choose_best() {
    log_weights_.resize(particles_.size());
    best_ = 0;
    for (std::size_t i = 0; i < particles_.size(); ++i) {
        log_weights_[i] = particles_[i].log_weight;
        if (log_weights_[i] > log_weights_[best_]) best_ = i;
    }
    normalize_log_weights(log_weights_, weights_);
    statistics_.neff = effective_particles(weights_);
    statistics_.best_log_weight = log_weights_[best_];
}

void FiltroParticulas::note_associations() {
    const std::size_t seen = lines_seen_.size() + corners_seen_.size();
    const auto lines = static_cast<std::int32_t>(maps_.lines(particles_[best_].map).size());
    for (std::size_t k = 0; k < seen; ++k) {
        const Decision& decision = decisions_[best_ * seen + k];
        const bool is_line = k < lines_seen_.size();
        Association association;
        association.kind = is_line ? FeatureKind::line : FeatureKind::corner;
        association.observed = static_cast<std::uint32_t>(is_line ? k : k - lines_seen_.size());
        association.outcome = decision.outcome;
        if (decision.outcome != Association::Outcome::ignored) {
            association.landmark =
                static_cast<std::int32_t>(decision.landmark) + (is_line ? 0 : lines);
        }
        associations_.push_back(association);
    }
}

void FiltroParticulas::remember_poses() {
    for (Particula& particle : particles_) {
        particle.history = history_.append(particle.history, particle.pose);
    }
}

void FiltroParticulas::resample() {
    if (!resampler_->wants(statistics_.neff)) return;
    RandomStream random(seed_, RandomPurpose::resampling, steps_, 0);
    resampling_->select(weights_, random, selected_);

    resampled_.clear();
    std::size_t new_best = 0;
    std::size_t next_source = 0;
    for (std::size_t m = 0; m < selected_.size(); ++m) {
        const std::size_t source = selected_[m];
        for (; next_source < source; ++next_source) {  // passed over: gone
            maps_.release(particles_[next_source].map);
            history_.release(particles_[next_source].history);
        }
        if (m > 0 && selected_[m - 1] == source) {
            maps_.share(particles_[source].map);
            history_.share(particles_[source].history);
        } else {
            if (source == best_) new_best = m;
            next_source = source + 1;
        }
        resampled_.push_back(particles_[source]);
        resampled_.back().log_weight = 0.0;
    }
    for (; next_source < particles_.size(); ++next_source) {
        maps_.release(particles_[next_source].map);
        history_.release(particles_[next_source].history);
    }
    particles_.swap(resampled_);
    best_ = new_best;
    statistics_.resampled = true;
}

LandmarkMap FiltroParticulas::best_map() const {
    LandmarkMap map;
    map.reserve(
        static_cast<std::size_t>(best_count(FeatureKind::line) + best_count(FeatureKind::corner)));
    const auto add = [&map](const auto& landmarks) {
        for (std::size_t i = 0; i < landmarks.size(); ++i) {
            const auto estimate = landmarks.get(i);
            map.push_back({estimate.mean, estimate.covariance, landmarks.observations(i)});
        }
    };
    add(maps_.lines(particles_[best_].map));
    add(maps_.corners(particles_[best_].map));
    return map;
}

std::vector<Pose> FiltroParticulas::best_history() const {
    return history_.path(particles_[best_].history);
}

int FiltroParticulas::best_count(FeatureKind kind) const {
    const MapStore::Handle map = particles_[best_].map;
    return static_cast<int>(kind == FeatureKind::line ? maps_.lines(map).size()
                                                      : maps_.corners(map).size());
}

std::vector<WeightedPose> FiltroParticulas::hypotheses() const {
    std::vector<double> log_weights;
    log_weights.reserve(particles_.size());
    for (const Particula& particle : particles_) log_weights.push_back(particle.log_weight);
    std::vector<double> weights;
    normalize_log_weights(log_weights, weights);
    std::vector<WeightedPose> poses;
    poses.reserve(particles_.size());
    for (std::size_t i = 0; i < particles_.size(); ++i) {
        poses.push_back({particles_[i].pose, weights[i]});
    }
    return poses;
}

Matrix3 FiltroParticulas::pose_covariance() const {
    const Pose best = best_pose();
    Eigen::Vector3d mean = Eigen::Vector3d::Zero();
    Matrix3 second = Matrix3::Zero();
    for (const WeightedPose& hypothesis : hypotheses()) {
        const Eigen::Vector3d away(hypothesis.pose.x - best.x, hypothesis.pose.y - best.y,
                                   wrap_angle(hypothesis.pose.theta - best.theta));
        mean += hypothesis.weight * away;
        second += hypothesis.weight * (away * away.transpose());
    }
    return second - mean * mean.transpose();
}

template <class Body>
void FiltroParticulas::for_each(std::size_t count, std::size_t work_each, const Body& body) {
    if (arena_.max_concurrency() == 1 || count * work_each < kParallelWork) {
        for (std::size_t i = 0; i < count; ++i) body(i);
        return;
    }
    arena_.execute([&] {
        tbb::parallel_for(tbb::blocked_range<std::size_t>(0, count, kGrain),
                          [&](const tbb::blocked_range<std::size_t>& range) {
                              for (std::size_t i = range.begin(); i < range.end(); ++i) body(i);
                          });
    });
}

SlamAlgorithmEntry fastslam_algorithm() {
    SlamAlgorithmEntry entry;
    entry.word = "fastslam";
    entry.label = HITOS_TEXT("ParameterChoice", "FastSLAM 1.0");
    entry.purpose = "particles with one small filter per landmark";
    entry.reads = {"filter.particles",
                   "filter.proposal",
                   "association.method",
                   "association.p0",
                   "association.gate_probability",
                   "resampling.rule",
                   "resampling.neff_threshold",
                   "resampling.method"};
    entry.make = [](const FilterParams& params, std::uint64_t seed, int threads) {
        return std::make_unique<FiltroParticulas>(params, seed, threads);
    };
    return entry;
}

}  // namespace hitos
