// The maps of all particles: landmarks by kind in columns, maps shared until written.
#pragma once

#include <algorithm>
#include <cstdint>
#include <utility>
#include <vector>

#include "hitos/slam/ekf.hpp"

namespace hitos {

/// The landmarks of one kind in one map: a column of doubles for each quantity, so that loops over
/// landmarks run on contiguous memory. A view of a block of LandmarkTable.
template <int Columns>
class LandmarkColumns {
  public:
    static constexpr std::size_t kColumns = Columns;

    LandmarkColumns(double* values, std::int32_t* observations, std::uint32_t* size,
                    std::size_t capacity)
        : values_(values), observations_(observations), size_(size), capacity_(capacity) {}

    std::size_t size() const { return *size_; }
    double* column(int index) { return values_ + static_cast<std::size_t>(index) * capacity_; }
    const double* column(int index) const {
        return values_ + static_cast<std::size_t>(index) * capacity_;
    }
    std::int32_t& observations(std::size_t i) { return observations_[i]; }
    std::int32_t observations(std::size_t i) const { return observations_[i]; }

    /// Adds a landmark without values; returns its index. The table must have the room.
    std::size_t append() {
        observations_[*size_] = 0;
        return (*size_)++;
    }

  private:
    double* values_;
    std::int32_t* observations_;
    std::uint32_t* size_;
    std::size_t capacity_;
};

/// Lines of one map. Cosine and sine of theta are kept beside it: the filter asks for them at
/// every step, and they change only when the landmark does.
class LineColumns : public LandmarkColumns<7> {
  public:
    enum Column { rho, theta, cosine, sine, p00, p01, p11 };
    using LandmarkColumns::LandmarkColumns;

    LandmarkEstimate<SensorRecta> get(std::size_t i) const {
        LandmarkEstimate<SensorRecta> estimate{{column(rho)[i], column(theta)[i]}, covariance(i)};
        return estimate;
    }
    Matrix2 covariance(std::size_t i) const {
        Matrix2 p;
        p << column(p00)[i], column(p01)[i], column(p01)[i], column(p11)[i];
        return p;
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
    using LandmarkColumns::LandmarkColumns;

    LandmarkEstimate<SensorEsquina> get(std::size_t i) const {
        LandmarkEstimate<SensorEsquina> estimate{{column(x)[i], column(y)[i]}, covariance(i)};
        return estimate;
    }
    Matrix2 covariance(std::size_t i) const {
        Matrix2 p;
        p << column(p00)[i], column(p01)[i], column(p01)[i], column(p11)[i];
        return p;
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

/// The landmarks of one kind in all maps, one block of equal capacity after the other in a single
/// piece of memory: thousands of small maps in memory of their own cost more in cache and page
/// misses than in arithmetic.
template <class View>
class LandmarkTable {
  public:
    View operator[](std::size_t block) {
        return {values_.data() + block * View::kColumns * capacity_,
                observations_.data() + block * capacity_, &sizes_[block], capacity_};
    }

    /// For reading only: the view of a const table cannot be told from another's.
    const View operator[](std::size_t block) const {      // NOLINT(readability-const-return-type)
        return const_cast<LandmarkTable&>(*this)[block];  // NOLINT(*-const-cast)
    }

    std::size_t size(std::size_t block) const { return sizes_[block]; }
    std::size_t blocks() const { return sizes_.size(); }

    void add_block() {
        sizes_.push_back(0);
        values_.resize(sizes_.size() * View::kColumns * capacity_);
        observations_.resize(sizes_.size() * capacity_);
    }
    void clear(std::size_t block) { sizes_[block] = 0; }

    void copy(std::size_t from, std::size_t to) {
        View source = (*this)[from];
        View target = (*this)[to];
        sizes_[to] = sizes_[from];
        for (std::size_t c = 0; c < View::kColumns; ++c) {
            std::copy_n(source.column(static_cast<int>(c)), source.size(),
                        target.column(static_cast<int>(c)));
        }
        if (source.size() > 0) {
            std::copy_n(&source.observations(0), source.size(), &target.observations(0));
        }
    }

    /// Room for `extra` more landmarks in every block. Invalidates views.
    void reserve_more(std::size_t extra) {
        std::size_t largest = 0;
        for (const std::uint32_t size : sizes_) largest = std::max<std::size_t>(largest, size);
        if (largest + extra <= capacity_) return;
        LandmarkTable larger;
        larger.capacity_ = std::max(largest + extra, capacity_ + capacity_ / 2 + 8);
        larger.sizes_ = sizes_;
        larger.values_.resize(sizes_.size() * View::kColumns * larger.capacity_);
        larger.observations_.resize(sizes_.size() * larger.capacity_);
        for (std::size_t block = 0; block < sizes_.size(); ++block) {
            View source = (*this)[block];
            View target = larger[block];
            for (int c = 0; c < static_cast<int>(View::kColumns); ++c) {
                std::copy_n(source.column(c), source.size(), target.column(c));
            }
            std::copy_n(observations_.data() + block * capacity_, source.size(),
                        larger.observations_.data() + block * larger.capacity_);
        }
        *this = std::move(larger);
    }

  private:
    std::vector<double> values_;
    std::vector<std::int32_t> observations_;
    std::vector<std::uint32_t> sizes_;
    std::size_t capacity_ = 0;
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
        lines_.clear(handle);
        corners_.clear(handle);
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
    void copy(Handle from, Handle to) {
        lines_.copy(from, to);
        corners_.copy(from, to);
    }

    /// Room for that many more landmarks in every map, so that parallel writers need none.
    void reserve_more(std::size_t lines, std::size_t corners) {
        lines_.reserve_more(lines);
        corners_.reserve_more(corners);
    }

    LineColumns lines(Handle handle) { return lines_[handle]; }
    CornerColumns corners(Handle handle) { return corners_[handle]; }
    const LineColumns lines(Handle handle) const {  // NOLINT(readability-const-return-type)
        return lines_[handle];
    }
    const CornerColumns corners(Handle handle) const {  // NOLINT(readability-const-return-type)
        return corners_[handle];
    }
    std::size_t blocks() const { return references_.size(); }

  private:
    Handle take() {
        if (free_.empty()) {
            lines_.add_block();
            corners_.add_block();
            references_.push_back(1);
            return static_cast<Handle>(references_.size() - 1);
        }
        const Handle handle = free_.back();
        free_.pop_back();
        references_[handle] = 1;
        return handle;
    }

    LandmarkTable<LineColumns> lines_;
    LandmarkTable<CornerColumns> corners_;
    std::vector<std::uint32_t> references_;
    std::vector<Handle> free_;
};

}  // namespace hitos
