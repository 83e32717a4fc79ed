#include "filtro_particulas.hpp"

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include "hitos/slam/robot.hpp"

namespace hitos {
namespace {

/// What of a step concerns its updates.
struct UpdateContext {
    std::uint32_t scan = 0;
    bool extents = false;  ///< whether anything asks for the landmarks' extents
    LandmarkParams params;
};

/// Whether two features of one scan lie beside each other along the first: then both may be pieces
/// of one wall, while of two that overlap one stands before the other.
template <Sensor S>
bool parted(const SeenFeature& a, const SeenFeature& b) {
    const auto line = S::inverse({}, a.measured.z);
    return S::placed(a.reach, {}, line).gap(S::placed(b.reach, {}, line)) > 0.0;
}

/// Of a pose from another, the short way round.
Eigen::Vector3d away_from(const Pose& origin, const Pose& pose) {
    return {pose.x - origin.x, pose.y - origin.y, wrap_angle(pose.theta - origin.theta)};
}

/// Of the hypotheses, reckoned from one of them.
Pose mean_of(const std::vector<WeightedPose>& hypotheses, const Pose& origin) {
    Eigen::Vector3d mean = Eigen::Vector3d::Zero();
    for (const WeightedPose& hypothesis : hypotheses) {
        if (hypothesis.weight == 0.0) continue;  // its pose may be no number
        mean += hypothesis.weight * away_from(origin, hypothesis.pose);
    }
    return {origin.x + mean(0), origin.y + mean(1), wrap_angle(origin.theta + mean(2))};
}

template <Sensor S>
void apply(Decision& decision, typename S::Columns& landmarks, const Pose& pose,
           const SeenFeature& seen, const UpdateContext& context) {
    if (decision.outcome == Association::Outcome::ignored) return;
    const EKF<S> ekf(seen.measured.r);
    const Vector2& z = seen.measured.z;
    if (decision.outcome == Association::Outcome::created) {
        const std::size_t index = landmarks.append();
        const LandmarkEstimate<S> first = ekf.first(pose, z);
        landmarks.set(index, first);
        if (context.extents) {
            landmarks.set_extent(index, S::placed(seen.reach, pose, first.mean));
        }
        landmarks.record(index) = {1, context.scan, context.scan,
                                   static_cast<float>(context.params.hit)};
        decision.landmark = static_cast<std::uint32_t>(index);
        return;
    }
    const std::size_t index = decision.landmark;
    auto estimate = landmarks.get(index);
    const auto before = estimate.mean;
    ekf.update(estimate, landmarks.innovation(index, z, pose));
    landmarks.set(index, estimate);
    if (context.extents) {
        landmarks.set_extent(index, S::carried(landmarks.extent(index), before, estimate.mean)
                                        .joined(S::placed(seen.reach, pose, estimate.mean)));
    }
    LandmarkRecord& record = landmarks.record(index);
    ++record.observations;
    decision.unseen = context.scan - record.last_seen;
    record.last_seen = context.scan;
    record.existence = static_cast<float>(
        std::min(static_cast<double>(record.existence) + context.params.hit, context.params.limit));
}

}  // namespace

FiltroParticulas::FiltroParticulas(const FilterParams& params, std::uint64_t seed, int threads)
    : params_(params),
      seed_(seed),
      threads_(threads),
      proposal_(proposals().find(params.proposal).make(params)),
      associator_(params.association),
      twins_(params.association, true),
      resampler_(make_resampler(params.resampling)),
      resampling_(resampling_methods().find(params.resampling.method).make(params.resampling)),
      registered_(motion_models().find(params.motion.model).registered),
      heeds_extents_(registered_ || params.association.segments || params.landmarks.vanish),
      reviews_(params.association.segments || params.landmarks.vanish ||
               params.landmarks.probation > 1),
      for_each_(threads),
      particles_(static_cast<std::size_t>(params.particles)) {
    // All particles start as copies of one: same pose, same empty map.
    const MapStore::Handle empty = maps_.create();
    for (std::size_t i = 0; i < particles_.size(); ++i) {
        particles_[i].map = empty;
        particles_[i].weight_before = 1.0 / static_cast<double>(particles_.size());
        particles_[i].from = static_cast<std::uint32_t>(i);
        if (i > 0) maps_.share(empty);
    }
    statistics_.neff = static_cast<double>(particles_.size());
}

void FiltroParticulas::step(const SlamInput& input) {
    statistics_.resampled = statistics_.best_changed = false;
    propose(input);
    observe(input.observation);
    if (params_.landmarks.vanish) free_space_.set(input.scan);
    if (input.record != nullptr) begin_record(*input.record);
    if (!seen_.empty() || reviews_) {
        detach_maps();
        for_each_(particles_.size(), seen_.size() * (maps_.size(particles_[best_].map) + 8),
                  [&](std::size_t i) {
                      const auto decisions =
                          std::span(decisions_).subspan(i * seen_.size(), seen_.size());
                      std::span<RecordedFeature> recorded;
                      if (input.record == nullptr) {
                          associate(i, decisions, Unwatched());
                      } else {
                          associate(i, decisions, Watched(input.record->hypotheses[i]));
                          recorded = input.record->hypotheses[i];
                      }
                      update(particles_[i], decisions);
                      weigh(particles_[i], decisions);
                      if (reviews_) review(particles_[i], decisions, recorded);
                  });
    }
    if (!seen_.empty()) choose_best();  // else nothing is weighed or resampled
    statistics_.searches_cut = searches_cut_;
    note_associations();
    if (input.record != nullptr) end_record(*input.record);
    remember_poses();
    if (!seen_.empty()) resample();
    ++steps_;
}

void FiltroParticulas::propose(const SlamInput& input) {
    proposal_->begin(input, steps_ == 0);
    for_each_(particles_.size(), 10, [&](std::size_t i) {
        Particula& particle = particles_[i];
        RandomStream random(seed_, RandomPurpose::motion, steps_, static_cast<std::uint32_t>(i));
        const ParticleMap map(maps_, particle.map);
        const ProposedPose drawn = proposal_->draw({particle.pose, map}, random);
        particle.pose = drawn.pose;
        particle.log_weight += drawn.log_weight;
    });
}

void FiltroParticulas::observe(const Observation& observation) {
    measure(observation, params_.observation, measurements_);
    const bool segments = params_.association.segments;
    if (heeds_extents_) note_reaches(observation, segments, reaches_);
    twins_.find(measurements_, segments ? &reaches_ : nullptr);
    seen_.clear();
    for_each_kind([&]<class S>() {
        std::size_t i = 0;
        for (const Measurement& measured : measurements_.of<S>()) {
            SeenFeature seen = associator_.seen(measured);
            if (heeds_extents_) seen.reach = reaches_.of<S>()[i];
            seen_.add<S>(seen);
            ++i;
        }
    });
    decisions_.resize(seen_.size() * particles_.size());
}

void FiltroParticulas::detach_maps() {
    copies_.clear();
    for (Particula& particle : particles_) {
        const MapStore::Handle source = maps_.detach(particle.map);
        if (source != particle.map) copies_.emplace_back(source, particle.map);
    }
    for_each_kind([&]<class S>() { maps_.reserve_more<S>(seen_.of<S>().size()); });
    for_each_(copies_.size(), 20,
              [&](std::size_t i) { maps_.copy(copies_[i].first, copies_[i].second); });
}

template <class Watch>
void FiltroParticulas::associate(std::size_t place, std::span<Decision> decisions,
                                 const Watch& watch) {
    const Particula& particle = particles_[place];
    if (params_.association.method == AssociationMethod::joint_compatibility) {
        associate_together(particle, decisions, watch);
        return;
    }
    RandomStream random(seed_, RandomPurpose::association, steps_,
                        static_cast<std::uint32_t>(place));
    RandomStream* const drawn = params_.association.hypotheses ? &random : nullptr;
    for_each_kind([&]<class S>() {
        const auto landmarks = maps_.landmarks<S>(particle.map);
        std::size_t next = seen_.first<S>();
        for (const SeenFeature& seen : seen_.of<S>()) {
            decisions[next] = associator_.decide<S>(
                landmarks, particle.pose, prepare(seen, particle.pose), drawn, watch.feature(next));
            ++next;
        }
        if (params_.association.exclusive) exclude<S>(decisions);
    });
}

template <Sensor S>
void FiltroParticulas::exclude(std::span<Decision> decisions) const {
    const std::size_t first = seen_.first<S>();
    const std::span<const SeenFeature> seen = seen_.of<S>();
    for (std::size_t i = 0; i < seen.size(); ++i) {
        for (std::size_t j = i + 1; j < seen.size(); ++j) {
            Decision& a = decisions[first + i];
            Decision& b = decisions[first + j];
            if (a.outcome != Association::Outcome::matched ||
                b.outcome != Association::Outcome::matched || a.landmark != b.landmark) {
                continue;
            }
            if (params_.association.segments && parted<S>(seen[i], seen[j])) continue;
            Decision& loser = b.log_likelihood > a.log_likelihood ? a : b;
            loser = associator_.kept_out(loser.log_likelihood, Association::Reason::taken);
        }
    }
}

template <class Watch>
void FiltroParticulas::associate_together(const Particula& particle, std::span<Decision> decisions,
                                          const Watch& watch) {
    // A search of each thread's own: what it keeps from call to call is memory, never a result.
    thread_local JointAssociation joint;
    joint.begin(params_.association.joint_probability);
    for_each_kind([&]<class S>() {
        const auto landmarks = maps_.landmarks<S>(particle.map);
        std::size_t next = seen_.first<S>();
        for (const SeenFeature& seen : seen_.of<S>()) {
            joint.add<S>(associator_, landmarks, particle.pose, prepare(seen, particle.pose),
                         watch.feature(next++));
        }
    });
    if (!joint.decide(associator_, decisions)) ++searches_cut_;
}

void FiltroParticulas::update(Particula& particle, std::span<Decision> decisions) {
    using Outcome = Association::Outcome;
    const UpdateContext context{static_cast<std::uint32_t>(steps_), heeds_extents_,
                                params_.landmarks};
    for_each_kind([&]<class S>() {
        auto landmarks = maps_.landmarks<S>(particle.map);
        std::size_t next = seen_.first<S>();
        for (const SeenFeature& seen : seen_.of<S>()) {
            Decision& decision = decisions[next];
            if (decision.outcome == Outcome::created) {
                const auto twin = twins_.of(
                    next, [&](std::size_t i) { return decisions[i].outcome == Outcome::created; });
                if (twin) {
                    decision.outcome = Outcome::matched;
                    decision.reason = Association::Reason::twin;
                    decision.landmark = decisions[*twin].landmark;
                }
            }
            ++next;
            apply<S>(decision, landmarks, particle.pose, seen, context);
        }
    });
}

void FiltroParticulas::weigh(Particula& particle, std::span<const Decision> decisions) {
    for (const Decision& decision : decisions) particle.log_weight += decision.log_likelihood;
}

void FiltroParticulas::choose_best() {
    log_weights_.resize(particles_.size());
    const PoseHistory::Node before = particles_[best_].history;
    best_ = 0;
    for (std::size_t i = 0; i < particles_.size(); ++i) {
        log_weights_[i] = particles_[i].log_weight;
        if (log_weights_[i] > log_weights_[best_]) best_ = i;
    }
    statistics_.best_changed = particles_[best_].history != before;
    normalize_log_weights(log_weights_, weights_);
    for (std::size_t i = 0; i < particles_.size(); ++i) {
        particles_[i].weight_before = weights_[i];
        particles_[i].from = static_cast<std::uint32_t>(i);
    }
    statistics_.neff = effective_particles(weights_);
    statistics_.best_log_weight = log_weights_[best_];
}

void FiltroParticulas::remember_poses() {
    for (Particula& particle : particles_) {
        particle.history = history_.append(particle.history, particle.pose);
    }
}

void FiltroParticulas::resample() {
    if (!resampler_->wants(statistics_.neff)) return;
    statistics_.resampled = true;
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
        const Particula& particle = particles_[i];
        poses.push_back({particle.pose, weights[i], particle.weight_before, particle.from});
    }
    return poses;
}

Pose FiltroParticulas::mean_pose() const {
    return mean_of(hypotheses(), best_pose());
}

Matrix3 FiltroParticulas::pose_covariance() const {
    const std::vector<WeightedPose> all = hypotheses();
    const Pose mean = mean_of(all, best_pose());
    Matrix3 covariance = Matrix3::Zero();
    for (const WeightedPose& hypothesis : all) {
        if (hypothesis.weight == 0.0) continue;
        const Eigen::Vector3d away = away_from(mean, hypothesis.pose);
        covariance += hypothesis.weight * (away * away.transpose());
    }
    return covariance;
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
                   "association.joint_probability",
                   "association.segments",
                   "association.segment_margin",
                   "association.exclusive",
                   "association.hypotheses",
                   "landmarks.vanish",
                   "landmarks.hit",
                   "landmarks.miss",
                   "landmarks.limit",
                   "landmarks.probation",
                   "landmarks.probation_scans",
                   "resampling.rule",
                   "resampling.neff_threshold",
                   "resampling.method"};
    entry.make = [](const FilterParams& params, std::uint64_t seed, int threads) {
        return std::make_unique<FiltroParticulas>(params, seed, threads);
    };
    return entry;
}

}  // namespace hitos
