// The maps of all particles: landmarks by kind in columns, maps shared until written.
#pragma once

#include <cstdint>
#include <utility>
#include <vector>

#include "hitos/slam/ekf.hpp"

namespace hitos {

/// Landmarks of one kind, a column of doubles for each quantity, so that loops over landmarks run
/// on contiguous memory. Keeps its memory when it shrinks or is assigned.
template <int Columns>
class LandmarkColumns {
  public:
    std::size_t size() const { return size_; }
    double* column(int index) { return values_.data() + offset(index); }
    const double* column(int index) const { return values_.data() + offset(index); }
    std::int32_t& observations(std::size_t i) { return observations_[i]; }
    std::int32_t observations(std::size_t i) const { return observations_[i]; }

    /// Adds a landmark without values; returns its index.
    std::size_t append() {
        if (size_ == capacity_) grow(capacity_ == 0 ? 16 : 2 * capacity_);
        observations_[size_] = 0;
        return size_++;
    }

    void assign(const LandmarkColumns& other) {
        if (other.size_ > capacity_) grow(other.capacity_);
        size_ = other.size_;
        for (int c = 0; c < Columns; ++c) {
            std::copy_n(other.column(c), size_, column(c));
        }
        std::copy_n(other.observations_.data(), size_, observations_.data());
    }

    void clear() { size_ = 0; }

  private:
    std::size_t offset(int index) const { return static_cast<std::size_t>(index) * capacity_; }

    void grow(std::size_t capacity) {
        std::vector<double> larger(capacity * Columns);
        for (int c = 0; c < Columns; ++c) {
            std::copy_n(column(c), size_, larger.data() + static_cast<std::size_t>(c) * capacity);
        }
        values_ = std::move(larger);
        observations_.resize(capacity);
        capacity_ = capacity;
    }

    std::vector<double> values_;
    std::vector<std::int32_t> observations_;
    std::size_t size_ = 0;
    std::size_t capacity_ = 0;
};

/// Lines of one map. Cosine and sine of theta are kept beside it: the filter asks for them at
/// every step, and they change only when the landmark does.
class LineColumns : public LandmarkColumns<7> {
  public:
    enum Column { rho, theta, cosine, sine, p00, p01, p11 };

    LandmarkEstimate<SensorRecta> get(std::size_t i) const {
        LandmarkEstimate<SensorRecta> estimate{{column(rho)[i], column(theta)[i]}, {}};
        estimate.covariance << column(p00)[i], column(p01)[i], column(p01)[i], column(p11)[i];
        return estimate;
    }
    void set(std::size_t i, const LandmarkEstimate<SensorRecta>& estimate) {
        column(rho)[i] = estimate.mean.rho;
        column(theta)[i] = estimate.mean.theta;
        column(cosine)[i] = std::cos(estimate.mean.theta);
        column(sine)[i] = std::sin(estimate.mean.theta);
        column(p00)[i] = estimate.covariance(0, 0);
        column(p01)[i] = estimate.covariance(0, 1);
        column(p11)[i] = estimate.covariance(1, 1);
    }
    Innovation innovation(std::size_t i, const Vector2& z, const Pose& pose) const {
        return SensorRecta::innovation(z, pose, {column(rho)[i], column(theta)[i]},
                                       column(cosine)[i], column(sine)[i]);
    }
};

/// Corners of one map.
class CornerColumns : public LandmarkColumns<5> {
  public:
    enum Column { x, y, p00, p01, p11 };

    LandmarkEstimate<SensorEsquina> get(std::size_t i) const {
        LandmarkEstimate<SensorEsquina> estimate{{column(x)[i], column(y)[i]}, {}};
        estimate.covariance << column(p00)[i], column(p01)[i], column(p01)[i], column(p11)[i];
        return estimate;
    }
    void set(std::size_t i, const LandmarkEstimate<SensorEsquina>& estimate) {
        column(x)[i] = estimate.mean.x;
        column(y)[i] = estimate.mean.y;
        column(p00)[i] = estimate.covariance(0, 0);
        column(p01)[i] = estimate.covariance(0, 1);
        column(p11)[i] = estimate.covariance(1, 1);
    }
    Innovation innovation(std::size_t i, const Vector2& z, const Pose& pose) const {
        return SensorEsquina::innovation(z, pose, {column(x)[i], column(y)[i]});
    }
};

/// One particle's map.
struct MapBlock {
    LineColumns lines;
    CornerColumns corners;

    void assign(const MapBlock& other) {
        lines.assign(other.lines);
        corners.assign(other.corners);
    }
};

/// All maps of a filter. Resampling copies handles; before maps are written, detach() finds the
/// handles that share a block and says which copies are due. The copies themselves touch only
/// blocks that nobody else uses, so they can be made in parallel.
class MapStore {
  public:
    using Handle = std::uint32_t;

    /// A new, empty map.
    Handle create() {
        const Handle handle = take();
        blocks_[handle].lines.clear();
        blocks_[handle].corners.clear();
        return handle;
    }
    void share(Handle handle) { ++references_[handle]; }
    void release(Handle handle) {
        if (--references_[handle] == 0) free_.push_back(handle);
    }

    /// Makes `handle` the only reference to its block. Where it was shared, gives it a block of
    /// its own and returns the handle whose content must be copied there (copy()) before any
    /// block is written; else returns the handle itself.
    Handle detach(Handle& handle) {
        if (references_[handle] == 1) return handle;
        const Handle source = handle;
        --references_[source];
        handle = take();
        return source;
    }
    void copy(Handle from, Handle to) { blocks_[to].assign(blocks_[from]); }

    MapBlock& operator[](Handle handle) { return blocks_[handle]; }
    const MapBlock& operator[](Handle handle) const { return blocks_[handle]; }
    std::size_t blocks() const { return blocks_.size(); }

  private:
    Handle take() {
        if (free_.empty()) {
            blocks_.emplace_back();
            references_.push_back(1);
            return static_cast<Handle>(blocks_.size() - 1);
        }
        const Handle handle = free_.back();
        free_.pop_back();
        references_[handle] = 1;
        return handle;
    }

    std::vector<MapBlock> blocks_;
    std::vector<std::uint32_t> references_;
    std::vector<Handle> free_;
};

}  // namespace hitos
