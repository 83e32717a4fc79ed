// SPDX-License-Identifier: GPL-3.0-or-later
// Joint compatibility branch and bound (Neira and Tardos, 2001, "Data association in stochastic
// mapping using the joint compatibility test").
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace hitos {

/// The squared Mahalanobis distance below which `pairs` pairings of two components each lie with
/// the probability: the quantile of the chi-square distribution with 2 * pairs degrees of freedom.
/// pairs >= 1.
double joint_gate(double probability, std::size_t pairs);

/// A landmark that an observation may belong to.
struct JointCandidate {
    std::uint64_t landmark =
        0;                    ///< the same number for the same landmark; it takes one observation
    double distance = 0.0;    ///< squared Mahalanobis distance of this pairing alone
    std::uint32_t place = 0;  ///< whatever the caller keeps of it
};

/// The squared Mahalanobis distance of a set of pairings, pairing by pairing.
class JointDistance {
  public:
    virtual ~JointDistance() = default;
    /// That of the pairings so far and this one, at least that of those so far; infinite where it
    /// cannot be computed.
    virtual double push(const JointCandidate& pairing) = 0;
    /// Takes the newest pairing back.
    virtual void pop() = 0;
};

/// Pairings that are independent of each other: their distances add up.
class IndependentDistance final : public JointDistance {
  public:
    double push(const JointCandidate& pairing) override {
        sums_.push_back((sums_.empty() ? 0.0 : sums_.back()) + pairing.distance);
        return sums_.back();
    }
    void pop() override { sums_.pop_back(); }

  private:
    std::vector<double> sums_;
};

/// Finds the greatest set of pairings that are compatible together, each landmark taking one
/// observation at most; of several that are as great the one of least joint distance, and of these
/// the one that takes nearest candidates first. Unlike in the original a part of the set need not
/// pass the gate of its own size, so that the result does not depend on the order of observations.
/// Reused from scan to scan. Not thread-safe.
class JointSearch {
  public:
    /// Nodes of the search tree after which the best found so far has to do. Ordinary scans need a
    /// few dozen.
    static constexpr std::uint64_t kMostNodes = 20000;

    /// Forgets all observations. Sets that lie together below the gate of this probability are
    /// compatible.
    void begin(double probability);
    /// The next observation, without candidates.
    void add_observation() { begins_.push_back(candidates_.size()); }
    /// A candidate of the newest observation that is compatible with it alone.
    void add(const JointCandidate& candidate) { candidates_.push_back(candidate); }

    /// Searches. False where the search was cut after `most_nodes`: the pairing is then compatible
    /// and at least as great as that of taking the nearest candidates in turn, maybe not the best.
    bool run(JointDistance& distance, std::uint64_t most_nodes = kMostNodes);

    std::size_t observations() const { return begins_.size(); }
    /// In the order of their distances once run.
    std::span<const JointCandidate> candidates(std::size_t observation) const;
    /// What the best set pairs the observation with; null where nothing.
    const JointCandidate* paired(std::size_t observation) const;
    std::size_t pairs() const { return best_pairs_; }
    double distance() const { return best_distance_; }
    std::uint64_t nodes() const { return nodes_; }

  private:
    static constexpr std::size_t kNone = SIZE_MAX;

    void prepare();
    /// A first pairing, against which the search is measured: in turn, the nearest candidate that
    /// is free and compatible with those before.
    void take_nearest(JointDistance& joint);
    void visit(std::size_t observation, double distance, JointDistance& joint);
    bool taken(std::uint64_t landmark) const;
    std::size_t end_of(std::size_t observation) const {
        return observation + 1 < begins_.size() ? begins_[observation + 1] : candidates_.size();
    }

    double probability_ = 0.0;
    std::vector<JointCandidate> candidates_;
    std::vector<std::size_t> begins_;    // of each observation's candidates
    std::vector<std::size_t> possible_;  // observations from each on that have candidates
    std::vector<double> gates_;          // by number of pairs
    std::vector<std::size_t> chosen_;    // candidate of each observation so far
    std::vector<std::size_t> best_;
    std::size_t pairs_ = 0;
    std::size_t best_pairs_ = 0;
    double best_distance_ = 0.0;
    std::uint64_t nodes_ = 0;
    std::uint64_t most_nodes_ = 0;
    bool cut_ = false;
};

}  // namespace hitos
