// SPDX-License-Identifier: GPL-3.0-or-later
// The working memory of a block of particles.
#pragma once

#include <algorithm>
#include <array>
#include <cstdint>
#include <tuple>
#include <vector>

#include "filtro_particulas.hpp"
#include "hitos/base/vectorised.hpp"
#include "models/landmark_kinds.hpp"

namespace hitos {

/// Landmarks of a kind with the particles that they are of, side by side.
template <class S>
struct LaneBatch {
    using Lane = typename S::Lane;
    static constexpr std::size_t kLanes = ParticleLoop::kBlock;
    using Row = std::array<double, kLanes>;

    alignas(64) std::array<double, Lane::kSize * kLanes> landmarks;
    alignas(64) std::array<double, Lane::kSize * kLanes> updated;
    alignas(64) Row x;
    alignas(64) Row y;
    alignas(64) Row theta;
    alignas(64) Row log_likelihoods;
    alignas(64) Row distances;                           ///< squared Mahalanobis
    alignas(64) std::array<double, 3 * kLanes> extents;  ///< where they have one

    /// Lane k gets the landmark that begins at `from` in a leaf.
    void load(std::size_t k, const double* from, const Pose& pose) {
        constexpr std::size_t kLeaf = S::Columns::kLeaf;
        for (std::size_t c = 0; c < Lane::kSize; ++c) landmarks[c * kLanes + k] = from[c * kLeaf];
        x[k] = pose.x;
        y[k] = pose.y;
        theta[k] = pose.theta;
    }
    void store(std::size_t k, double* to) const {
        constexpr std::size_t kLeaf = S::Columns::kLeaf;
        for (std::size_t c = 0; c < Lane::kSize; ++c) to[c * kLeaf] = updated[c * kLanes + k];
    }
    void load_extent(std::size_t k, const double* from) {
        constexpr std::size_t kLeaf = S::Columns::kLeaf;
        for (std::size_t c = 0; c < 3; ++c)
            extents[c * kLanes + k] = from[(Lane::kSize + c) * kLeaf];
    }
    void store_extent(std::size_t k, double* to) const {
        constexpr std::size_t kLeaf = S::Columns::kLeaf;
        for (std::size_t c = 0; c < 3; ++c) to[(Lane::kSize + c) * kLeaf] = extents[c * kLanes + k];
    }

    void compare(std::size_t count, const LaneObservation& seen) {
        vectorised([&]() HITOS_INLINED {
            compare(landmarks.data(), x.data(), y.data(), theta.data(), seen, count,
                    log_likelihoods.data(), distances.data());
        });
    }
    void update(std::size_t count, const LaneObservation& seen) {
        vectorised([&]() HITOS_INLINED {
            update(landmarks.data(), x.data(), y.data(), theta.data(), seen, count, updated.data());
        });
    }
    /// Carries the extents from what was loaded to what it is now, and adds what was seen.
    void extend(std::size_t count, const SeenReach& reach) {
        vectorised([&]() HITOS_INLINED {
            extend(landmarks.data(), updated.data(), x.data(), y.data(), theta.data(), reach, count,
                   extents.data());
        });
    }

  private:
    // Everything by value: what loops load through references they do not make vectors of.
    HITOS_INLINE static void compare(const double* from, const double* px, const double* py,
                                     const double* pt, LaneObservation seen, std::size_t count,
                                     double* logs, double* squares) {
        HITOS_LANES
        for (std::size_t k = 0; k < count; ++k) {
            const Likelihood close = likelihood_of(
                S::innovation(Lane::load(from + k, kLanes), LanePose{px[k], py[k], pt[k]}, seen));
            logs[k] = close.log_likelihood;
            squares[k] = close.mahalanobis_squared;
        }
    }
    HITOS_INLINE static void update(const double* from, const double* px, const double* py,
                                    const double* pt, LaneObservation seen, std::size_t count,
                                    double* to) {
        HITOS_LANES
        for (std::size_t k = 0; k < count; ++k) {
            S::updated(Lane::load(from + k, kLanes), LanePose{px[k], py[k], pt[k]}, seen)
                .store(to + k, kLanes);
        }
    }
    HITOS_INLINE static void extend(const double* from, const double* to, const double* px,
                                    const double* py, const double* pt, SeenReach reach,
                                    std::size_t count, double* extents) {
        HITOS_LANES
        for (std::size_t k = 0; k < count; ++k) {
            const Lane now = Lane::load(to + k, kLanes);
            const Extent kept{extents[k], extents[kLanes + k], extents[2 * kLanes + k]};
            const Extent carried = S::carried(kept, Lane::load(from + k, kLanes), now);
            const Extent joined =
                carried.joined(S::placed(reach, LanePose{px[k], py[k], pt[k]}, now));
            extents[k] = joined.low;
            extents[kLanes + k] = joined.high;
            extents[2 * kLanes + k] = joined.side;
        }
    }
};

/// What an observation may be: a landmark of a particle, counted from the block's first.
struct BlockCandidate {
    const double* values;  ///< its first in its leaf
    std::uint32_t particle;
    std::uint32_t landmark;
};

struct FiltroParticulas::BlockMemory {
    using Row = std::array<double, ParticleLoop::kBlock>;
    alignas(64) Row heading{};
    alignas(64) Row cosine{};  ///< of the heading
    alignas(64) Row sine{};
    std::vector<NearQuery> queries;  ///< of the observations of a kind, in the robot's frame
    std::vector<NearReach> reaches;
    std::vector<std::uint64_t> near;
    std::vector<IndexRegion> regions;
    std::vector<IndexEntry> found;                        ///< near what a particle sees
    std::vector<std::vector<BlockCandidate>> candidates;  ///< of every observation
    LandmarkKinds::Tuple<LaneBatch> batches;

    template <class S>
    LaneBatch<S>& batch() {
        return std::get<LaneBatch<S>>(batches);
    }
    /// Makes candidates of what was found in the region of an observation, in the landmarks' order
    /// and each once; values_of(landmark) is where it begins in its leaf, or null where it cannot
    /// be it.
    template <class Values>
    void add_found(std::size_t observation, std::size_t particle, const Values& values_of) {
        std::vector<BlockCandidate>& all = candidates[observation];
        const auto first = static_cast<std::ptrdiff_t>(all.size());
        const IndexRegion region = regions[observation];
        for (const IndexEntry& entry : found) {
            if (!region.meets(entry)) continue;
            if (const double* const values = values_of(entry.id)) {
                all.push_back({values, static_cast<std::uint32_t>(particle), entry.id});
            }
        }
        const auto begin = all.begin() + first;
        std::sort(begin, all.end(), [](const BlockCandidate& a, const BlockCandidate& b) {
            return a.landmark < b.landmark;
        });
        const auto same = [](const BlockCandidate& a, const BlockCandidate& b) {
            return a.landmark == b.landmark;
        };
        all.erase(std::unique(begin, all.end(), same), all.end());
    }
    /// Reckons cosine and sine.
    void turn() {
        vectorised([&]() HITOS_INLINED { turn(heading.data(), cosine.data(), sine.data()); });
    }

  private:
    HITOS_INLINE static void turn(const double* angles, double* cosines, double* sines) {
        HITOS_LANES
        for (std::size_t k = 0; k < ParticleLoop::kBlock; ++k) {
            const elementary::SineCosine of = elementary::sine_cosine(angles[k]);
            cosines[k] = of.cosine;
            sines[k] = of.sine;
        }
    }
};

}  // namespace hitos
