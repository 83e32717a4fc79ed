// SPDX-License-Identifier: GPL-3.0-or-later
// What registration's corrections do to EKF-SLAM.

#include <algorithm>
#include <numeric>

#include "ekf_slam.hpp"

namespace hitos {

std::size_t EkfSlam::bytes() const {
    return state_.bytes() + history_.size() * sizeof(Pose);
}

void EkfSlam::correct(const PathCorrection& correction) {
    if (!registered_) return;  // its path is its own
    check(correction, steps());
    for (std::size_t scan = 0; scan < history_.size(); ++scan) {
        history_[scan] = compose(correction.by_scan[scan], history_[scan]);
    }
    const Pose& last = correction.by_scan.back();
    Matrix3 by_pose = Matrix3::Identity();
    by_pose.topLeftCorner<2, 2>() = SensorEsquina::moved_jacobian(last, {});
    std::vector<JointState::Turn> turns;
    if (!correction.map_stays)
        for_each_kind([&]<class S>() { move<S>(correction.by_scan, turns); });
    std::ranges::sort(turns, {}, &JointState::Turn::at);
    state_.transform(by_pose, turns);
    state_.set_pose(compose(last, state_.pose()));
    normalize();
    if (correction.map_stays) return;

    std::array<NewPlaces, LandmarkKinds::kSize> places;
    std::array<std::size_t, LandmarkKinds::kSize> sizes{};
    for_each_kind([&]<class S>() {
        places[LandmarkKinds::place<S>()] = merge<S>();
        sizes[LandmarkKinds::place<S>()] = marks<S>().size();
    });
    follow(associations_, places, sizes);
}

template <Sensor S>
void EkfSlam::move(std::span<const Pose> by_scan, std::vector<JointState::Turn>& turns) {
    for (Mark& mark : marks<S>()) {
        const Pose& motion = by_scan[mark.record.last_seen];
        const auto before = S::from_state(state_.landmark(mark.at));
        mark.extent = S::moved(motion, before, extent<S>(mark));
        mark.extent_of = S::to_state(S::moved(motion, before));
        state_.set_landmark(mark.at, mark.extent_of);
        turns.push_back({mark.at, S::moved_jacobian(motion, before)});
    }
}

template <Sensor S>
NewPlaces EkfSlam::merge() {
    Marks& all = marks<S>();
    NewPlaces places(all.size());
    std::iota(places.begin(), places.end(), 0U);
    for (std::uint32_t i = 0; i < all.size(); ++i) {
        for (std::uint32_t j = i + 1; j < all.size();) {
            if (!same<S>(all[i], all[j])) {
                ++j;
                continue;
            }
            take_in<S>(all[i], all[j]);
            const Eigen::Index at = all[j].at;
            all.erase(all.begin() + j);
            remove(at);
            for (std::uint32_t& place : places) {
                if (place == j) {
                    place = i;
                } else if (place > j) {
                    --place;
                }
            }
        }
    }
    return places;
}

template <Sensor S>
bool EkfSlam::same(const Mark& a, const Mark& b) const {
    if (!may_be_one(a.record.identity, b.record.identity)) return false;
    const auto first = S::from_state(state_.landmark(a.at));
    const auto second = S::from_state(state_.landmark(b.at));
    const double sign = S::difference(first, second).sign;
    return S::same(first, extent<S>(a), second, extent<S>(b),
                   state_.difference_covariance(a.at, b.at, sign));
}

template <Sensor S>
void EkfSlam::take_in(Mark& mark, const Mark& other) {
    const auto first = S::from_state(state_.landmark(mark.at));
    const auto second = S::from_state(state_.landmark(other.at));
    const LandmarkDifference apart = S::difference(first, second);
    const Extent own = extent<S>(mark);
    const Extent others = S::carried(extent<S>(other), second, first);
    // What both share is in the joint state; that they are one is told to the whole of it.
    state_.join(mark.at, other.at, apart.nu, apart.sign, S::tolerance(first, own, others));
    mark.extent = own.joined(others);
    mark.extent_of = S::to_state(first);
    mark.record.observations += other.record.observations;
    mark.record.last_seen = std::max(mark.record.last_seen, other.record.last_seen);
    mark.record.first_seen = std::min(mark.record.first_seen, other.record.first_seen);
    mark.record.identity = std::max(mark.record.identity, other.record.identity);
    normalize();
}

void EkfSlam::remove(Eigen::Index at) {
    state_.remove(at);
    for (Marks& all : marks_) {
        for (Mark& mark : all) {
            if (mark.at > at) mark.at -= 2;
        }
    }
}

template <Sensor S>
Extent EkfSlam::extent(const Mark& mark) const {
    return S::carried(mark.extent, S::from_state(mark.extent_of),
                      S::from_state(state_.landmark(mark.at)));
}

template <Sensor S>
void EkfSlam::note_seen(Association& association) {
    Mark& mark = marks<S>()[static_cast<std::size_t>(association.landmark)];
    if (registered_) {
        const SeenReach& reach = reaches_.of<S>()[association.observed];
        const auto landmark = S::from_state(state_.landmark(mark.at));
        const Extent seen = S::placed(reach, state_.pose(), landmark);
        mark.extent = mark.record.observations == 0 ? seen : extent<S>(mark).joined(seen);
        mark.extent_of = S::to_state(landmark);
    }
    if (mark.record.observations > 0) {
        association.unseen = static_cast<std::uint32_t>(steps()) - mark.record.last_seen;
    }
    if (mark.record.identity == kNameless)
        mark.record.identity = measurements_.of<S>()[association.observed].identity;
    mark.record.last_seen = static_cast<std::uint32_t>(steps());
    if (++mark.record.observations == 1) mark.record.first_seen = mark.record.last_seen;
}

void EkfSlam::note_all_seen() {
    for_each_kind([&]<class S>() {
        for (Association& association : associations_) {
            if (association.kind == S::kKind && association.landmark >= 0) {
                note_seen<S>(association);
            }
        }
    });
}

template Extent EkfSlam::extent<SensorRecta>(const Mark&) const;
template Extent EkfSlam::extent<SensorEsquina>(const Mark&) const;

}  // namespace hitos
