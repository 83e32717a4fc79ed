// SPDX-License-Identifier: GPL-3.0-or-later
#include "joint_compatibility.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace hitos {

double joint_gate(double probability, std::size_t pairs) {
    // P(d^2 > g) = exp(-g / 2) sum over j < pairs of (g / 2)^j / j!, which falls with g.
    const auto above = [pairs](double half) {
        double term = std::exp(-half);
        double sum = term;
        for (std::size_t j = 1; j < pairs; ++j) {
            term *= half / static_cast<double>(j);
            sum += term;
        }
        return sum;
    };
    const double wanted = 1.0 - probability;
    double low = 0.0;
    double high = 1.0;
    while (above(high) > wanted) high *= 2.0;
    constexpr int kHalvings = 100;  // more than a double has digits
    for (int i = 0; i < kHalvings; ++i) {
        const double middle = 0.5 * (low + high);
        (above(middle) > wanted ? low : high) = middle;
    }
    return low + high;
}

void JointSearch::begin(double probability) {
    if (probability != probability_) gates_.clear();
    probability_ = probability;
    candidates_.clear();
    begins_.clear();
    best_.clear();
    best_pairs_ = 0;
    best_distance_ = 0.0;
    nodes_ = 0;
}

std::span<const JointCandidate> JointSearch::candidates(std::size_t observation) const {
    return std::span(candidates_)
        .subspan(begins_[observation], end_of(observation) - begins_[observation]);
}

const JointCandidate* JointSearch::paired(std::size_t observation) const {
    return best_[observation] == kNone ? nullptr : &candidates_[best_[observation]];
}

void JointSearch::prepare() {
    const std::size_t count = begins_.size();
    possible_.assign(count + 1, 0);
    for (std::size_t i = count; i-- > 0;) {
        const auto begin = candidates_.begin() + static_cast<std::ptrdiff_t>(begins_[i]);
        const auto end = candidates_.begin() + static_cast<std::ptrdiff_t>(end_of(i));
        std::sort(begin, end, [](const JointCandidate& a, const JointCandidate& b) {
            return a.distance != b.distance ? a.distance < b.distance : a.landmark < b.landmark;
        });
        possible_[i] = possible_[i + 1] + (begin == end ? 0 : 1);
    }
    if (gates_.empty()) gates_.push_back(0.0);
    gates_.reserve(possible_[0] + 1);
    while (gates_.size() <= possible_[0]) {
        gates_.push_back(joint_gate(probability_, gates_.size()));
    }
    chosen_.assign(count, kNone);
    best_.assign(count, kNone);
    best_pairs_ = 0;
    best_distance_ = 0.0;
    nodes_ = 0;
    cut_ = false;
}

bool JointSearch::run(JointDistance& distance, std::uint64_t most_nodes) {
    most_nodes_ = most_nodes;
    prepare();
    take_nearest(distance);
    visit(0, 0.0, distance);
    return !cut_;
}

void JointSearch::take_nearest(JointDistance& joint) {
    for (std::size_t observation = 0; observation < begins_.size(); ++observation) {
        for (std::size_t i = begins_[observation]; i < end_of(observation); ++i) {
            if (taken(candidates_[i].landmark)) continue;
            const double together = joint.push(candidates_[i]);
            if (together <= gates_[best_pairs_ + 1]) {
                chosen_[observation] = i;
                ++best_pairs_;
                best_distance_ = together;
                break;
            }
            joint.pop();
        }
    }
    for (std::size_t i = 0; i < best_pairs_; ++i) joint.pop();
    best_ = chosen_;
    chosen_.assign(begins_.size(), kNone);
}

void JointSearch::visit(std::size_t observation, double distance, JointDistance& joint) {
    if (cut_) return;
    if (++nodes_ > most_nodes_) {
        cut_ = true;
        return;
    }
    // Whatever comes can add no more pairs than this, and never lessens the distance.
    const std::size_t reachable = pairs_ + possible_[observation];
    if (reachable < best_pairs_ || (reachable == best_pairs_ && distance >= best_distance_)) return;
    if (distance > gates_[reachable]) return;
    if (possible_[observation] == 0) {
        if (pairs_ > best_pairs_ || (pairs_ == best_pairs_ && distance < best_distance_)) {
            best_ = chosen_;
            best_pairs_ = pairs_;
            best_distance_ = distance;
        }
        return;
    }
    for (std::size_t i = begins_[observation]; i < end_of(observation); ++i) {
        if (taken(candidates_[i].landmark)) continue;
        const double together = joint.push(candidates_[i]);
        chosen_[observation] = i;
        ++pairs_;
        visit(observation + 1, together, joint);
        --pairs_;
        chosen_[observation] = kNone;
        joint.pop();
    }
    visit(observation + 1, distance, joint);
}

bool JointSearch::taken(std::uint64_t landmark) const {
    return std::ranges::any_of(
        chosen_, [&](std::size_t i) { return i != kNone && candidates_[i].landmark == landmark; });
}

}  // namespace hitos
