// Landmarks of one kind in columns.
#pragma once

#include <cstdint>
#include <vector>

#include "sensor.hpp"

namespace hitos {

/// The landmarks of one kind in one map: a column of doubles for each quantity, so that loops over
/// landmarks run on contiguous memory. A view of a block of LandmarkTable. A kind may keep `Extra`
/// quantities beside state and covariance.
template <class S, int Extra>
class LandmarkColumns {
  public:
    static constexpr int kState0 = 0;
    static constexpr int kState1 = 1;
    static constexpr int kP00 = 2;
    static constexpr int kP01 = 3;
    static constexpr int kP11 = 4;
    static constexpr int kExtra = 5;
    static constexpr std::uint32_t kGone = UINT32_MAX;
    static constexpr std::size_t kColumns = kExtra + Extra;

    LandmarkColumns(double* values, LandmarkRecord* records, std::uint32_t* size,
                    std::size_t capacity)
        : values_(values), records_(records), size_(size), capacity_(capacity) {}

    std::size_t size() const { return *size_; }
    double* column(int index) { return values_ + static_cast<std::size_t>(index) * capacity_; }
    const double* column(int index) const {
        return values_ + static_cast<std::size_t>(index) * capacity_;
    }
    LandmarkRecord& record(std::size_t i) { return records_[i]; }
    const LandmarkRecord& record(std::size_t i) const { return records_[i]; }

    typename S::Landmark mean(std::size_t i) const {
        return S::from_state({column(kState0)[i], column(kState1)[i]});
    }
    Matrix2 covariance(std::size_t i) const {
        Matrix2 p;
        p << column(kP00)[i], column(kP01)[i], column(kP01)[i], column(kP11)[i];
        return p;
    }
    LandmarkEstimate<S> get(std::size_t i) const { return {mean(i), covariance(i)}; }
    void set(std::size_t i, const LandmarkEstimate<S>& estimate) {
        const Vector2 state = S::to_state(estimate.mean);
        column(kState0)[i] = state(0);
        column(kState1)[i] = state(1);
        column(kP00)[i] = estimate.covariance(0, 0);
        column(kP01)[i] = estimate.covariance(0, 1);
        column(kP11)[i] = estimate.covariance(1, 1);
    }

    /// Adds a landmark without values; returns its index. The table must have the room.
    std::size_t append() {
        records_[*size_] = {};
        return (*size_)++;
    }

    /// Landmark `to` becomes what landmark `from` is.
    void copy(std::size_t from, std::size_t to) {
        for (std::size_t c = 0; c < kColumns; ++c) {
            double* values = column(static_cast<int>(c));
            values[to] = values[from];
        }
        records_[to] = records_[from];
    }
    /// Takes out what `goes(i)` names; the others keep their order. `places` gets where each is
    /// then, kGone of those that are gone. False where none is.
    template <class Goes>
    bool take_out(const Goes& goes, std::vector<std::uint32_t>& places) {
        places.clear();
        std::uint32_t next = 0;
        for (std::uint32_t i = 0; i < size(); ++i) {
            const bool gone = goes(i);
            places.push_back(gone ? kGone : next);
            if (gone) continue;
            if (next != i) copy(i, next);
            ++next;
        }
        if (next == size()) return false;
        cut(next);
        return true;
    }
    /// Only the first `size` landmarks stay.
    void cut(std::size_t size) { *size_ = static_cast<std::uint32_t>(size); }

  private:
    double* values_;
    LandmarkRecord* records_;
    std::uint32_t* size_;
    std::size_t capacity_;
};

}  // namespace hitos
