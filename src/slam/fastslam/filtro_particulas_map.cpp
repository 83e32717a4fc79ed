// SPDX-License-Identifier: GPL-3.0-or-later
// What becomes of the particles' maps besides updates, and what is told of the best one.

#include <algorithm>
#include <array>
#include <numeric>
#include <utility>

#include "association/map_correction.hpp"
#include "filtro_particulas.hpp"
#include "hitos/base/validate.hpp"

namespace hitos {
namespace {

/// Makes decisions of a kind name the places where the landmarks are now.
void follow(std::span<Decision> decisions, const NewPlaces& places) {
    for (Decision& decision : decisions) {
        if (decision.outcome == Association::Outcome::ignored) continue;
        decision.landmark = places[decision.landmark];
        if (decision.landmark == LineColumns::kGone) {
            decision.outcome = Association::Outcome::ignored;
            decision.reason = Association::Reason::gone;
        }
    }
}

void follow(std::span<RecordedFeature> recorded, const NewPlaces& places) {
    for (RecordedFeature& feature : recorded) {
        for (ComparedLandmark& compared : feature.compared) {
            if (compared.landmark < 0) continue;
            const std::uint32_t place = places[static_cast<std::size_t>(compared.landmark)];
            compared.landmark = place == LineColumns::kGone ? -1 : static_cast<std::int32_t>(place);
        }
    }
}

}  // namespace

void FiltroParticulas::review(std::size_t place, MapStore::Worker& worker,
                              std::span<Decision> decisions, std::span<RecordedFeature> recorded) {
    const LandmarkParams& params = params_.landmarks;
    const auto now = static_cast<std::uint32_t>(steps_);
    const Pose laser = free_space_.laser(particles_[place].pose);
    thread_local NewPlaces places;
    for_each_kind([&]<class S>() {
        auto landmarks = landmarks_of<S>(place, worker);
        const auto goes = [&](std::size_t i) {
            const LandmarkRecord record = std::as_const(landmarks).record(i);
            if (!confirmed(record) &&
                now - record.first_seen >= static_cast<std::uint32_t>(params.probation_scans)) {
                return true;
            }
            if (!params.vanish || record.last_seen == now) return false;
            if (free_space_.sight(laser, landmarks.mean(i), landmarks.extent(i)) !=
                Sight::missing) {
                return record.existence < 0.0F;
            }
            LandmarkRecord& missed = landmarks.record(i);
            missed.existence += static_cast<float>(params.miss);
            return missed.existence < 0.0F;
        };
        const std::span own = decisions.subspan(seen_.first<S>(), seen_.of<S>().size());
        const auto all_follow = [&] {
            follow(own, places);
            if (recorded.empty()) return;
            follow(recorded.subspan(seen_.first<S>(), seen_.of<S>().size()), places);
        };
        if (S::kKind == FeatureKind::line && params_.association.segments) {
            std::vector<std::uint32_t> seen;
            for (const Decision& decision : own) {
                if (decision.outcome == Association::Outcome::matched) {
                    seen.push_back(decision.landmark);
                }
            }
            const double margin = params_.association.segment_margin_m;
            if (grow_together<S>(landmarks, seen, margin, places)) all_follow();
        }
        if (landmarks.take_out(goes, places)) all_follow();
    });
}

/// What a step needs besides is set by its first lines.
std::unique_ptr<SlamFilter> FiltroParticulas::clone() const {
    auto copy = std::make_unique<FiltroParticulas>(params_, seed_, threads_);
    copy->particles_ = particles_;
    copy->maps_ = maps_;
    copy->selected_ = selected_;
    std::vector<PoseHistory::Node*> newest;
    newest.reserve(particles_.size());
    for (Particula& particle : copy->particles_) newest.push_back(&particle.history);
    copy->history_.assign_held(history_, newest);
    copy->best_ = best_;
    copy->steps_ = steps_;
    copy->statistics_ = statistics_;
    copy->searches_cut_ = searches_cut_.load();
    copy->noted_ = noted_;
    copy->associations_ = associations_;
    if constexpr (kValidates) copy->check_structures();
    return copy;
}

void FiltroParticulas::check_structures() {
    std::vector<PoseHistory::Node> leaves;
    leaves.reserve(particles_.size());
    for (const Particula& particle : particles_) leaves.push_back(particle.history);
    history_.check(leaves, steps_);
    std::vector<MapStore::Worker*> workers;
    workers.reserve(workers_.size());
    for (Worker& worker : workers_) workers.push_back(&worker);
    maps_.check(std::move(workers));
}

std::size_t FiltroParticulas::bytes() const {
    return maps_.bytes() + history_.bytes() + particles_.size() * sizeof(Particula);
}

void FiltroParticulas::correct(const PathCorrection& correction) {
    if (!registered_) return;  // its path is its own
    check(correction, steps_);
    std::vector<PoseHistory::Node> leaves;
    for (Particula& particle : particles_) {
        particle.pose = compose(correction.by_scan.back(), particle.pose);
        leaves.push_back(particle.history);
    }
    history_.move(leaves, correction.by_scan);
    if (correction.map_stays) return;
    std::array<NewPlaces, LandmarkKinds::kSize> best_places;
    const std::size_t landmarks_each = maps_.size(best_) + 8;
    // Maps that resampling has just copied are corrected once, and copied again.
    for_each_block(particles_.size(), landmarks_each * landmarks_each, [&](const Block& block) {
        for (std::size_t i = block.begin; i < block.end; ++i) {
            if (just_copied(i)) continue;
            for_each_kind([&]<class S>() {
                auto landmarks = landmarks_of<S>(i, block.worker);
                NewPlaces places = correct_landmarks<S>(landmarks, correction.by_scan);
                if (i == best_) best_places[LandmarkKinds::place<S>()] = std::move(places);
            });
        }
    });
    for (std::size_t i = 0; i < particles_.size(); ++i) {
        if (just_copied(i)) maps_.copy(i - 1, i);
    }
    for_each_kind([&]<class S>() {
        const NewPlaces& places = best_places[LandmarkKinds::place<S>()];
        for (Association& association : noted_) {
            if (association.kind != S::kKind || association.landmark < 0) continue;
            const auto landmark = static_cast<std::size_t>(association.landmark);
            // Resampling may have left no copy of the particle whose associations these are.
            association.landmark =
                landmark < places.size() ? static_cast<std::int32_t>(places[landmark]) : -1;
        }
    });
    publish_associations();
    if constexpr (kValidates) check_structures();
}

void FiltroParticulas::note_associations(std::size_t source) {
    noted_.clear();
    for_each_kind([&]<class S>() {
        for (std::size_t i = 0; i < seen_.of<S>().size(); ++i) {
            const Decision& decision = decisions_[source * seen_.size() + seen_.first<S>() + i];
            Association association{S::kKind, static_cast<std::uint32_t>(i), decision.outcome,
                                    decision.reason};
            if (decision.outcome != Association::Outcome::ignored) {
                association.landmark = static_cast<std::int32_t>(decision.landmark);
            }
            if (decision.outcome == Association::Outcome::matched) {
                association.unseen = decision.unseen;
            }
            noted_.push_back(association);
        }
    });
    publish_associations();
}

template <Sensor S>
std::vector<std::int32_t> FiltroParticulas::told(std::size_t particle, std::int32_t& next) const {
    const auto landmarks = landmarks_of<S>(particle);
    std::vector<std::int32_t> places(landmarks.size());
    if (params_.landmarks.probation <= 1) {  // then every landmark is told
        std::iota(places.begin(), places.end(), next);
        next += static_cast<std::int32_t>(places.size());
        return places;
    }
    for (std::size_t i = 0; i < landmarks.size(); ++i) {
        places[i] = confirmed(landmarks.record(i)) ? next++ : -1;
    }
    return places;
}

void FiltroParticulas::publish_associations() {
    associations_ = noted_;
    if (associations_.empty()) return;
    std::int32_t next = 0;  // kinds come one after the other in the map
    for_each_kind([&]<class S>() {
        const std::vector<std::int32_t> places = told<S>(best_, next);
        for (Association& association : associations_) {
            if (association.kind != S::kKind || association.landmark < 0) continue;
            const auto landmark = static_cast<std::size_t>(association.landmark);
            association.landmark = landmark < places.size() ? places[landmark] : -1;
        }
    });
}

void FiltroParticulas::begin_record(AssociationRecord& record) const {
    record = {};
    associator_.note_limits(record);
    record.hypotheses.assign(particles_.size(), std::vector<RecordedFeature>(seen_.size()));
}

void FiltroParticulas::end_record(AssociationRecord& record) const {
    record.best = best_;
    for (std::size_t particle = 0; particle < particles_.size(); ++particle) {
        std::int32_t next = 0;
        for_each_kind([&]<class S>() {
            const std::vector<std::int32_t> places = told<S>(particle, next);
            const auto place_of = [&](std::int64_t landmark) {
                return landmark < 0 ? -1 : places[static_cast<std::size_t>(landmark)];
            };
            for (std::size_t i = 0; i < seen_.of<S>().size(); ++i) {
                const std::size_t row = seen_.first<S>() + i;
                const Decision& decision = decisions_[particle * seen_.size() + row];
                RecordedFeature& feature = record.hypotheses[particle][row];
                const bool ignored = decision.outcome == Association::Outcome::ignored;
                feature.decision = {S::kKind, static_cast<std::uint32_t>(i), decision.outcome,
                                    decision.reason,
                                    place_of(ignored ? -1 : std::int64_t{decision.landmark})};
                for (ComparedLandmark& compared : feature.compared) {
                    compared.landmark = place_of(compared.landmark);
                }
            }
        });
    }
}

LandmarkMap FiltroParticulas::map(std::size_t hypothesis) const {
    LandmarkMap map;
    map.reserve(maps_.size(hypothesis));
    for_each_kind([&]<class S>() {
        const auto landmarks = landmarks_of<S>(hypothesis);
        for (std::size_t i = 0; i < landmarks.size(); ++i) {
            const LandmarkRecord& record = landmarks.record(i);
            if (!confirmed(record)) continue;
            const Extent extent = heeds_extents_ ? landmarks.extent(i) : Extent{};
            map.push_back({landmarks.mean(i), landmarks.covariance(i), record.observations,
                           extent.low, extent.high, record.first_seen, record.last_seen,
                           record.identity});
        }
    });
    return map;
}

std::vector<Pose> FiltroParticulas::best_history() const {
    return history_.path(particles_[best_].history);
}

std::vector<HistoryBranch> FiltroParticulas::ancestry() const {
    std::vector<PoseHistory::Node> leaves;
    leaves.reserve(particles_.size());
    for (const Particula& particle : particles_) leaves.push_back(particle.history);
    return history_.branches(leaves);
}

int FiltroParticulas::best_count(FeatureKind kind) const {
    int count = 0;
    for_each_kind([&]<class S>() {
        if (S::kKind != kind) return;
        const auto landmarks = landmarks_of<S>(best_);
        for (std::size_t i = 0; i < landmarks.size(); ++i) {
            if (confirmed(landmarks.record(i))) ++count;
        }
    });
    return count;
}

}  // namespace hitos
