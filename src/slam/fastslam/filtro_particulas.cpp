// SPDX-License-Identifier: GPL-3.0-or-later
#include "filtro_particulas.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <string>
#include <vector>

#include "hitos/base/validate.hpp"
#include "hitos/slam/robot.hpp"

namespace hitos {
namespace {

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
      one_by_one_(params.association.method != AssociationMethod::joint_compatibility &&
                  !params.association.segments && !params.association.hypotheses),
      reviews_(params.association.segments || params.landmarks.vanish ||
               params.landmarks.probation > 1),
      for_each_(threads),
      particles_(static_cast<std::size_t>(params.particles)),
      maps_(heeds_extents_) {
    for (std::size_t i = 0; i < particles_.size(); ++i) {
        maps_.create();
        particles_[i].weight_before = 1.0 / static_cast<double>(particles_.size());
        particles_[i].from = static_cast<std::uint32_t>(i);
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
        const std::size_t work = seen_.size() * (maps_.size(best_) + 8);
        for_each_block(particles_.size(), work,
                       [&](const Block& block) { step_block(block, input.record); });
    }
    if (!seen_.empty()) choose_best();  // else nothing is weighed or resampled
    statistics_.searches_cut = searches_cut_;
    note_associations(best_);
    if (input.record != nullptr) end_record(*input.record);
    remember_poses();
    if (!seen_.empty()) resample();
    ++steps_;
    if constexpr (kValidates) check_structures();
}

void FiltroParticulas::begin_work(std::size_t particles, std::size_t work_each) {
    workers_.resize(std::max(workers_.size(), for_each_.blocks(particles, work_each)));
    const bool alone = !for_each_.parallel(particles, work_each);
    for (Worker& worker : workers_) {
        worker.alone(alone);
        worker.is_alone = alone;
    }
}

void FiltroParticulas::propose(const SlamInput& input) {
    proposal_->begin(input, steps_ == 0);
    static_assert(ParticleLoop::kBlock <= NormalRow::kMost);
    for_each_(particles_.size(), 15,
              [&](std::size_t /*number*/, std::size_t begin, std::size_t end) {
                  const RandomRow row{seed_, RandomPurpose::motion, steps_,
                                      static_cast<std::uint32_t>(begin)};
                  std::array<Pose, ParticleLoop::kBlock> poses;
                  for (std::size_t i = begin; i < end; ++i)
                      poses.at(i - begin) = particles_[i].pose;
                  if (proposal_->draw_row(std::span(poses).first(end - begin), row)) {
                      for (std::size_t i = begin; i < end; ++i)
                          particles_[i].pose = poses.at(i - begin);
                      return;
                  }
                  for (std::size_t i = begin; i < end; ++i) {
                      Particula& particle = particles_[i];
                      RandomStream random = row.stream(i - begin);
                      const ParticleMap map(maps_, i);
                      const ProposedPose drawn = proposal_->draw({particle.pose, map}, random);
                      particle.pose = drawn.pose;
                      particle.log_weight += drawn.log_weight;
                  }
              });
}

void FiltroParticulas::observe(const Observation& observation) {
    measure(observation, params_.observation, measurements_, params_.association.known);
    const bool segments = params_.association.segments;
    if (heeds_extents_) note_reaches(observation, segments, reaches_);
    twins_.find(measurements_, segments ? &reaches_ : nullptr);
    seen_.clear();
    identified_ = false;
    for_each_kind([&]<class S>() {
        std::size_t i = 0;
        for (const Measurement& measured : measurements_.of<S>()) {
            SeenFeature seen = associator_.seen(measured);
            identified_ = identified_ || measured.identity != kNameless;
            if (heeds_extents_) seen.reach = reaches_.of<S>()[i];
            seen_.add<S>(seen);
            ++i;
        }
    });
    decisions_.resize(seen_.size() * particles_.size());
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
    constexpr std::size_t kWork = 8;
    history_.begin_row(particles_.size());
    for_each_(particles_.size(), kWork,
              [&](std::size_t /*number*/, std::size_t begin, std::size_t end) {
                  for (std::size_t i = begin; i < end; ++i) {
                      Particula& particle = particles_[i];
                      particle.history = history_.append_in_row(i, particle.history, particle.pose);
                  }
              });
    history_.end_row();
}

void FiltroParticulas::resample() {
    if (!resampler_->wants(statistics_.neff)) return;
    RandomStream random(seed_, RandomPurpose::resampling, steps_, 0);
    resampling_->select(weights_, random, selected_);
    // What may fail comes first: maps and particles change places together.
    resampled_.resize(particles_.size());
    take_selected();
    statistics_.resampled = true;
    // Of the best there may be no copy; then the best of those that there are takes its place.
    const auto best = std::ranges::max_element(
        selected_, {}, [this](std::uint32_t source) { return log_weights_[source]; });
    const bool lost = *best != best_;
    best_ = static_cast<std::size_t>(best - selected_.begin());
    if (lost) note_associations(*best);
}

void FiltroParticulas::take_selected() {
    constexpr std::size_t kWork = 30;
    maps_.begin_selection();
    for_each_block(selected_.size(), kWork, [&](const Block& block) { draw(block); });
    // From here on nothing needs memory.
    for_each_block(selected_.size(), kWork, [&](const Block& block) { let_go(block); });
    maps_.end_selection();
    particles_.swap(resampled_);
    for (Worker& worker : workers_) history_.take_back(worker.freed);
}

void FiltroParticulas::draw(const Block& block) {
    for (std::size_t m = block.begin; m < block.end; ++m) {
        const std::size_t source = selected_[m];
        maps_.select(source, m, drawn_again(m), block.worker);
        resampled_[m] = particles_[source];
        resampled_[m].log_weight = 0.0;
        if (drawn_again(m)) continue;
        std::uint32_t again = 0;
        while (m + again + 1 < selected_.size() && selected_[m + again + 1] == source) ++again;
        history_.share(particles_[source].history, again);
    }
    block.worker.gone.clear();
    for_each_passed_over(block.begin, block.end, [&](std::size_t i) {
        block.worker.gone.push_back(particles_[i].history);
    });
}

void FiltroParticulas::let_go(const Block& block) {
    Worker& worker = block.worker;
    for (std::size_t m = block.begin; m < block.end; ++m) {
        if (!drawn_again(m)) maps_.take_over(selected_[m], m);
    }
    for_each_passed_over(block.begin, block.end,
                         [&](std::size_t i) { maps_.pass_over(i, worker); });
    history_.release(worker.gone, worker.freed, worker.is_alone);
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
