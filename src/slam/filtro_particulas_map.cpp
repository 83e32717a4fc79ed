// What becomes of the particles' maps besides updates, and what is told of the best one.

#include <algorithm>
#include <array>
#include <utility>

#include "filtro_particulas.hpp"
#include "map_correction.hpp"

namespace hitos {
namespace {

/// Makes decisions of a kind name the places where the landmarks are now.
void follow(std::span<Decision> decisions, const NewPlaces& places) {
    for (Decision& decision : decisions) {
        if (decision.outcome == Association::Outcome::ignored) continue;
        decision.landmark = places[decision.landmark];
        if (decision.landmark == LineColumns::kGone) {
            decision.outcome = Association::Outcome::ignored;
        }
    }
}

}  // namespace

void FiltroParticulas::review(const Particula& particle, std::span<Decision> decisions) {
    const LandmarkParams& params = params_.landmarks;
    const auto now = static_cast<std::uint32_t>(steps_);
    const Pose laser = free_space_.laser(particle.pose);
    thread_local NewPlaces places;
    for_each_kind([&]<class S>() {
        auto landmarks = maps_.landmarks<S>(particle.map);
        const auto goes = [&](std::size_t i) {
            LandmarkRecord& record = landmarks.record(i);
            if (!confirmed(record) &&
                now - record.first_seen >= static_cast<std::uint32_t>(params.probation_scans)) {
                return true;
            }
            if (!params.vanish || record.last_seen == now) return false;
            if (free_space_.sight(laser, landmarks.mean(i), landmarks.extent(i)) ==
                Sight::missing) {
                record.existence += static_cast<float>(params.miss);
            }
            return record.existence < 0.0F;
        };
        const std::span own = decisions.subspan(seen_.first<S>(), seen_.of<S>().size());
        if (S::kKind == FeatureKind::line && params_.association.segments) {
            std::vector<std::uint32_t> seen;
            for (const Decision& decision : own) {
                if (decision.outcome == Association::Outcome::matched) {
                    seen.push_back(decision.landmark);
                }
            }
            const double margin = params_.association.segment_margin_m;
            if (grow_together<S>(landmarks, seen, margin, places)) follow(own, places);
        }
        if (landmarks.take_out(goes, places)) follow(own, places);
    });
}

/// What a step needs besides is set by its first lines.
std::unique_ptr<SlamFilter> FiltroParticulas::clone() const {
    auto copy = std::make_unique<FiltroParticulas>(params_, seed_, threads_);
    copy->particles_ = particles_;
    copy->maps_ = maps_;
    copy->history_ = history_;
    copy->best_ = best_;
    copy->steps_ = steps_;
    copy->statistics_ = statistics_;
    copy->searches_cut_ = searches_cut_.load();
    copy->noted_ = noted_;
    copy->associations_ = associations_;
    return copy;
}

std::size_t FiltroParticulas::bytes() const {
    return maps_.bytes() + history_.bytes() + particles_.size() * sizeof(Particula);
}

void FiltroParticulas::correct(const PathCorrection& correction) {
    if (!registered_) return;  // its path is its own
    check(correction, steps_);
    std::vector<PoseHistory::Node> leaves;
    std::vector<MapStore::Handle> maps;
    for (Particula& particle : particles_) {
        particle.pose = compose(correction.by_scan.back(), particle.pose);
        leaves.push_back(particle.history);
        maps.push_back(particle.map);
    }
    history_.move(leaves, correction.by_scan);
    const MapStore::Handle best = particles_[best_].map;
    std::array<NewPlaces, LandmarkKinds::kSize> best_places;
    std::ranges::sort(maps);  // those that particles share once
    maps.erase(std::unique(maps.begin(), maps.end()), maps.end());
    const std::size_t landmarks_each = maps_.size(best) + 8;
    for_each_(maps.size(), landmarks_each * landmarks_each, [&](std::size_t i) {
        for_each_kind([&]<class S>() {
            auto landmarks = maps_.landmarks<S>(maps[i]);
            NewPlaces places = correct_landmarks<S>(landmarks, correction.by_scan);
            if (maps[i] == best) best_places[LandmarkKinds::place<S>()] = std::move(places);
        });
    });
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
}

void FiltroParticulas::note_associations() {
    noted_.clear();
    for_each_kind([&]<class S>() {
        for (std::size_t i = 0; i < seen_.of<S>().size(); ++i) {
            const Decision& decision = decisions_[best_ * seen_.size() + seen_.first<S>() + i];
            Association association{S::kKind, static_cast<std::uint32_t>(i), decision.outcome};
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

void FiltroParticulas::publish_associations() {
    associations_ = noted_;
    std::int32_t before = 0;  // landmarks of the kinds before, which come first in the map
    for_each_kind([&]<class S>() {
        const auto landmarks = maps_.landmarks<S>(particles_[best_].map);
        std::vector<std::int32_t> told;
        std::int32_t next = before;
        for (std::size_t i = 0; i < landmarks.size(); ++i) {
            told.push_back(confirmed(landmarks.record(i)) ? next++ : -1);
        }
        for (Association& association : associations_) {
            if (association.kind != S::kKind || association.landmark < 0) continue;
            const auto landmark = static_cast<std::size_t>(association.landmark);
            association.landmark = landmark < told.size() ? told[landmark] : -1;
        }
        before = next;
    });
}

LandmarkMap FiltroParticulas::map(std::size_t hypothesis) const {
    const MapStore::Handle handle = particles_[hypothesis].map;
    LandmarkMap map;
    map.reserve(maps_.size(handle));
    for_each_kind([&]<class S>() {
        const auto landmarks = maps_.landmarks<S>(handle);
        for (std::size_t i = 0; i < landmarks.size(); ++i) {
            const LandmarkRecord& record = landmarks.record(i);
            if (!confirmed(record)) continue;
            const Extent extent = heeds_extents_ ? landmarks.extent(i) : Extent{};
            map.push_back({landmarks.mean(i), landmarks.covariance(i), record.observations,
                           extent.low, extent.high, record.first_seen, record.last_seen});
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
        const auto landmarks = maps_.landmarks<S>(particles_[best_].map);
        for (std::size_t i = 0; i < landmarks.size(); ++i) {
            if (confirmed(landmarks.record(i))) ++count;
        }
    });
    return count;
}

}  // namespace hitos
