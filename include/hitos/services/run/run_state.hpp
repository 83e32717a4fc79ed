// SPDX-License-Identifier: GPL-3.0-or-later
// What a run is between two scans, as one value.
#pragma once

#include <memory>
#include <optional>
#include <utility>
#include <vector>

#include "hitos/capture/scan.hpp"
#include "hitos/features/control.hpp"
#include "hitos/features/observation.hpp"
#include "hitos/registration/registration.hpp"
#include "hitos/services/evaluation/suitability.hpp"
#include "hitos/services/evaluation/uncertainty.hpp"
#include "hitos/services/files/line_extents.hpp"
#include "hitos/services/files/trajectory_file.hpp"
#include "hitos/slam/slam_filter.hpp"

namespace hitos {

/// Owns what it points to; a copy owns a copy of it, and nothing where it cannot be copied.
template <class T>
class Owned {
  public:
    Owned() = default;
    Owned(std::unique_ptr<T> owned) : owned_(std::move(owned)) {}
    Owned(const Owned& other) : owned_(other.copy()) {}
    Owned(Owned&&) noexcept = default;
    Owned& operator=(const Owned& other) {
        *this = Owned(other);
        return *this;
    }
    Owned& operator=(Owned&&) noexcept = default;
    ~Owned() = default;

    T* get() const { return owned_.get(); }
    T& operator*() const { return *owned_; }
    T* operator->() const { return owned_.get(); }
    explicit operator bool() const { return owned_ != nullptr; }

  private:
    std::unique_ptr<T> copy() const {
        if (!owned_) return nullptr;
        if constexpr (requires { owned_->clone(); }) {
            return owned_->clone();
        } else {
            return std::make_unique<T>(*owned_);
        }
    }

    std::unique_ptr<T> owned_;
};

/// Copied whole, to come back to it and to begin anew: what a run keeps from scan to scan stands
/// here. Only what is drawn of it, and the place in the tour, stand beside it.
struct RunState {
    std::optional<ControlTrack> controls;
    Owned<Registration> registration;  ///< none where the algorithm asks for none
    Owned<SlamFilter> filter;          ///< a copy has none where the algorithm cannot be copied
    /// Those of registration, with the poses to draw them at.
    std::vector<std::shared_ptr<const Scan>> key_scans;
    std::vector<Pose> key_poses;
    Trajectory online;         ///< the best pose at every scan as it was then
    LineExtents line_extents;  ///< where lines were seen
    Suitability suitability;
    UncertaintyRecord uncertainty;
    Scan scan;                ///< the last one
    Observation observation;  ///< its features
    OdometryPath odometry;
    bool saw_points = false;     ///< of a laser
    bool saw_landmarks = false;  ///< that a sensor told by themselves
    bool held = false;           ///< the map, as the second of two tours finds it
    bool finished = false;
    double pauses_s = 0.0;  ///< between tours, which are no tour's time

    /// The filter's best pose at every scan so far.
    Trajectory best_trajectory() const;
    /// Any hypothesis' poses with the scans' stamps.
    Trajectory stamped(const std::vector<Pose>& poses) const;
    std::vector<SecondTour> later_tours() const;
    /// Memory that it takes, about.
    std::size_t bytes() const;
};

}  // namespace hitos
