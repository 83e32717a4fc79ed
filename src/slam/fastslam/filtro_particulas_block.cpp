// SPDX-License-Identifier: GPL-3.0-or-later
// What FastSLAM does with a block of particles at once: observation after observation, lane by
// lane.

#include <algorithm>
#include <array>
#include <bit>

#include "filtro_particulas.hpp"
#include "particle_block.hpp"

namespace hitos {
namespace {

/// Whether two features of one scan lie beside each other along the first: then both may be pieces
/// of one wall, while of two that overlap one stands before the other.
template <Sensor S>
bool parted(const SeenFeature& a, const SeenFeature& b) {
    const auto line = S::inverse({}, a.measured.z);
    return S::placed(a.reach, {}, line).gap(S::placed(b.reach, {}, line)) > 0.0;
}

}  // namespace

FiltroParticulas::BlockMemory& FiltroParticulas::block_memory() {
    thread_local BlockMemory memory;
    return memory;
}

void FiltroParticulas::step_block(const Block& block, AssociationRecord* record) {
    BlockMemory& memory = block_memory();
    if (record == nullptr && one_by_one_ && !identified_) {
        associate_block(block, memory);
    } else {
        for (std::size_t i = block.begin; i < block.end; ++i) {
            if (record == nullptr) {
                associate(i, decisions_of(i), Unwatched());
            } else {
                associate(i, decisions_of(i), Watched(record->hypotheses[i]));
            }
        }
    }
    update_block(block, memory);
    for (std::size_t i = block.begin; i < block.end; ++i) {
        weigh(particles_[i], decisions_of(i));
        if (!reviews_) continue;
        std::span<RecordedFeature> recorded;
        if (record != nullptr) recorded = record->hypotheses[i];
        review(i, block.worker, decisions_of(i), recorded);
    }
}

template <class Watch>
void FiltroParticulas::associate(std::size_t place, std::span<Decision> decisions,
                                 const Watch& watch) {
    if (params_.association.method == AssociationMethod::joint_compatibility) {
        associate_together(place, decisions, watch);
        return;
    }
    RandomStream random(seed_, RandomPurpose::association, steps_,
                        static_cast<std::uint32_t>(place));
    const Pose& pose = particles_[place].pose;
    RandomStream* const drawn = params_.association.hypotheses ? &random : nullptr;
    for_each_kind([&]<class S>() {
        const auto landmarks = landmarks_of<S>(place);
        std::size_t next = seen_.first<S>();
        for (const SeenFeature& seen : seen_.of<S>()) {
            decisions[next] = associator_.decide<S>(landmarks, pose, prepare(seen, pose), drawn,
                                                    watch.feature(next));
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
            const bool known_a = a.reason == Association::Reason::known;
            const bool known_b = b.reason == Association::Reason::known;
            if (known_a && known_b) continue;
            const bool a_loses = known_a == known_b ? b.log_likelihood > a.log_likelihood : known_b;
            Decision& loser = a_loses ? a : b;
            loser = associator_.kept_out(loser.log_likelihood, Association::Reason::taken);
        }
    }
}

template <class Watch>
void FiltroParticulas::associate_together(std::size_t place, std::span<Decision> decisions,
                                          const Watch& watch) {
    const Pose& pose = particles_[place].pose;
    // A search of each thread's own: what it keeps from call to call is memory, never a result.
    thread_local JointAssociation joint;
    joint.begin(params_.association.joint_probability);
    for_each_kind([&]<class S>() {
        const auto landmarks = landmarks_of<S>(place);
        std::size_t next = seen_.first<S>();
        for (const SeenFeature& seen : seen_.of<S>()) {
            joint.add<S>(associator_, landmarks, pose, prepare(seen, pose), seen_.of<S>(),
                         watch.feature(next++));
        }
    });
    if (!joint.decide(associator_, decisions)) ++searches_cut_;
}

void FiltroParticulas::associate_block(const Block& block, BlockMemory& memory) {
    for (std::size_t i = block.begin; i < block.end; ++i) {
        memory.heading[i - block.begin] = particles_[i].pose.theta;
    }
    memory.turn();
    for_each_kind([&]<class S>() {
        if (seen_.of<S>().empty()) return;
        find_near<S>(block, memory);
        for (std::size_t j = 0; j < seen_.of<S>().size(); ++j) decide_block<S>(block, j, memory);
        if (!params_.association.exclusive) return;
        for (std::size_t i = block.begin; i < block.end; ++i) exclude<S>(decisions_of(i));
    });
}

template <Sensor S>
void FiltroParticulas::find_near(const Block& block, BlockMemory& memory) const {
    using Columns = typename S::Columns;
    using Group = typename Columns::Group;
    constexpr std::size_t kLeaf = Columns::kLeaf;
    constexpr std::size_t kAhead = 6;  // particles whose maps memory has time to bring
    memory.queries.clear();
    memory.reaches.clear();
    for (const SeenFeature& seen : seen_.of<S>()) {
        memory.queries.push_back(near_query({seen, seen.cosine, seen.sine}));
        memory.reaches.push_back(NearReach::of(memory.queries.back()));
    }
    const std::size_t count = memory.queries.size();
    memory.candidates.resize(std::max(memory.candidates.size(), count));
    memory.near.resize(count);
    memory.regions.resize(count);
    for (std::size_t j = 0; j < count; ++j) memory.candidates[j].clear();
    for (std::size_t i = block.begin; i < std::min(block.begin + kAhead, block.end); ++i) {
        landmarks_of<S>(i).prefetch();
    }
    for (std::size_t i = block.begin; i < block.end; ++i) {
        if (i + kAhead < block.end) landmarks_of<S>(i + kAhead).prefetch();
        const Columns landmarks = landmarks_of<S>(i);
        const std::size_t lane = i - block.begin;
        const LanePose pose = lane_of(particles_[i].pose);
        const double cosine = memory.cosine[lane];
        const double sine = memory.sine[lane];
        if (landmarks.indexed()) {
            // What is near any of them first: most of what is in it is near several.
            IndexRegion all = IndexRegion::nowhere();
            for (std::size_t j = 0; j < count; ++j) {
                const NearQuery query = turned(memory.queries[j], cosine, sine);
                memory.regions[j] = IndexRegion::of(S::region(query, pose, memory.reaches[j]));
                all.join(memory.regions[j]);
            }
            if (!all.endless()) landmarks.find(all, memory.found);
            // Where so much is near, whole leaves are looked at faster.
            if (!all.endless() && memory.found.size() <= landmarks.leaves()) {
                for (std::size_t j = 0; j < count; ++j) {
                    const NearQuery query = turned(memory.queries[j], cosine, sine);
                    memory.add_found(j, lane, [&](std::uint32_t landmark) {
                        const double* const values = landmarks.first_of(landmark);
                        const double margin = S::margin(S::Lane::load(values, kLeaf), pose, query);
                        return margin > 0.0 ? values : nullptr;
                    });
                }
                continue;
            }
        }
        landmarks.each_group([&](const Group& group) {
            vectorised([&]() HITOS_INLINED {
                for (std::size_t j = 0; j < count; ++j) {
                    const NearQuery query = turned(memory.queries[j], cosine, sine);
                    memory.near[j] = Columns::near_in(group.values, group.count, pose, query);
                }
            });
            for (std::size_t j = 0; j < count; ++j) {
                for (std::uint64_t bits = memory.near[j] & group.there; bits != 0;
                     bits &= bits - 1) {
                    const auto bit = static_cast<std::size_t>(std::countr_zero(bits));
                    memory.candidates[j].push_back({group.values[bit / kLeaf] + bit % kLeaf,
                                                    static_cast<std::uint32_t>(lane),
                                                    group.landmark(bit)});
                }
            }
        });
    }
}

template <Sensor S>
void FiltroParticulas::decide_block(const Block& block, std::size_t observation,
                                    BlockMemory& memory) {
    const LaneObservation seen = lane_of(seen_.of<S>()[observation].measured);
    auto& batch = memory.batch<S>();
    std::array<BestTwo, ParticleLoop::kBlock> best;
    const std::vector<BlockCandidate>& candidates = memory.candidates[observation];
    for (std::size_t first = 0; first < candidates.size(); first += batch.kLanes) {
        const std::size_t count = std::min(batch.kLanes, candidates.size() - first);
        for (std::size_t k = 0; k < count; ++k) {
            const BlockCandidate& candidate = candidates[first + k];
            batch.load(k, candidate.values, particles_[block.begin + candidate.particle].pose);
        }
        batch.compare(count, seen);
        for (std::size_t k = 0; k < count; ++k) {
            const Likelihood close{batch.log_likelihoods[k], batch.distances[k]};
            if (associator_.outside(close)) continue;
            const BlockCandidate& candidate = candidates[first + k];
            associator_.offer(best[candidate.particle], candidate.landmark, close);
        }
    }
    const std::size_t row = seen_.first<S>() + observation;
    for (std::size_t i = block.begin; i < block.end; ++i) {
        decisions_of(i)[row] = associator_.resolve(best[i - block.begin]);
    }
}

void FiltroParticulas::update_block(const Block& block, BlockMemory& memory) {
    for_each_kind([&]<class S>() {
        for (std::size_t j = 0; j < seen_.of<S>().size(); ++j) update_block<S>(block, j, memory);
    });
}

template <Sensor S>
void FiltroParticulas::update_block(const Block& block, std::size_t observation,
                                    BlockMemory& memory) {
    using Outcome = Association::Outcome;
    const SeenFeature& seen = seen_.of<S>()[observation];
    const std::size_t row = seen_.first<S>() + observation;
    auto& batch = memory.batch<S>();
    std::array<std::uint32_t, ParticleLoop::kBlock> whose{};
    std::array<typename S::Columns::Leaf*, ParticleLoop::kBlock> leaves{};
    std::size_t count = 0;
    for (std::size_t i = block.begin; i < block.end; ++i) {
        Decision& decision = decisions_of(i)[row];
        if (decision.outcome == Outcome::ignored) continue;
        auto landmarks = landmarks_of<S>(i, block.worker);
        if (decision.outcome == Outcome::created &&
            create<S>(landmarks, particles_[i].pose, observation, decisions_of(i))) {
            continue;
        }
        auto& leaf = landmarks.own_leaf_of(decision.landmark);
        const double* const values = leaf.values.data() + decision.landmark % S::Columns::kLeaf;
        batch.load(count, values, particles_[i].pose);
        if (S::kExtended && heeds_extents_) batch.load_extent(count, values);
        LandmarkRecord& record = leaf.records[decision.landmark % S::Columns::kLeaf];
        note_seen(record, decision);
        if (record.identity == kNameless) record.identity = seen.measured.identity;
        leaves.at(count) = &leaf;
        whose.at(count++) = static_cast<std::uint32_t>(i);
    }
    batch.update(count, lane_of(seen.measured));
    if constexpr (S::kExtended) {
        if (heeds_extents_) batch.extend(count, seen.reach);
    }
    for (std::size_t k = 0; k < count; ++k) {
        const std::uint32_t landmark = decisions_of(whose.at(k))[row].landmark;
        double* const values = leaves.at(k)->values.data() + landmark % S::Columns::kLeaf;
        batch.store(k, values);
        if (S::kExtended && heeds_extents_) batch.store_extent(k, values);
        landmarks_of<S>(whose.at(k), block.worker).moved(landmark);
    }
}

template <Sensor S>
bool FiltroParticulas::create(typename S::Columns& landmarks, const Pose& pose,
                              std::size_t observation, std::span<Decision> decisions) const {
    using Outcome = Association::Outcome;
    const std::size_t row = seen_.first<S>() + observation;
    Decision& decision = decisions[row];
    const auto twin =
        twins_.of(row, [&](std::size_t i) { return decisions[i].outcome == Outcome::created; });
    if (twin) {
        decision.outcome = Outcome::matched;
        decision.reason = Association::Reason::twin;
        decision.landmark = decisions[*twin].landmark;
        return false;
    }
    const SeenFeature& seen = seen_.of<S>()[observation];
    const std::size_t index = landmarks.append();
    const LandmarkEstimate<S> first = EKF<S>(seen.measured.r).first(pose, seen.measured.z);
    landmarks.set(index, first);
    if (heeds_extents_) landmarks.set_extent(index, S::placed(seen.reach, pose, first.mean));
    const auto scan = static_cast<std::uint32_t>(steps_);
    landmarks.record(index) = {1, scan, scan, static_cast<float>(params_.landmarks.hit),
                               seen.measured.identity};
    decision.landmark = static_cast<std::uint32_t>(index);
    return true;
}

void FiltroParticulas::note_seen(LandmarkRecord& record, Decision& decision) const {
    const auto scan = static_cast<std::uint32_t>(steps_);
    ++record.observations;
    decision.unseen = scan - record.last_seen;
    record.last_seen = scan;
    record.existence = static_cast<float>(std::min(
        static_cast<double>(record.existence) + params_.landmarks.hit, params_.landmarks.limit));
}

}  // namespace hitos
