// SPDX-License-Identifier: GPL-3.0-or-later
// The list of landmark kinds, from which the filters make all that they do kind by kind.
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <span>
#include <tuple>
#include <type_traits>
#include <vector>

#include "sensor_esquina.hpp"
#include "sensor_recta.hpp"

namespace hitos {

template <Sensor... Kinds>
struct KindList {
    static constexpr std::size_t kSize = sizeof...(Kinds);

    /// The place of a kind in the list.
    template <Sensor S>
    static constexpr std::size_t place() {
        constexpr std::array<bool, kSize> kSame{std::is_same_v<S, Kinds>...};
        return static_cast<std::size_t>(std::find(kSame.begin(), kSame.end(), true) -
                                        kSame.begin());
    }

    /// Calls body.operator()<S>() for every kind, in order.
    template <class Body>
    static void for_each(Body&& body) {
        (body.template operator()<Kinds>(), ...);
    }

    /// One Of<S> for every kind.
    template <template <class> class Of>
    using Tuple = std::tuple<Of<Kinds>...>;
};

/// Maps list landmarks in this order.
using LandmarkKinds = KindList<SensorRecta, SensorEsquina>;

template <class Body>
void for_each_kind(Body&& body) {
    LandmarkKinds::for_each(body);
}

/// Values of all kinds in one row, kind by kind.
template <class T>
class KindRow {
  public:
    std::size_t size() const { return values_.size(); }
    bool empty() const { return values_.empty(); }
    const T& operator[](std::size_t i) const { return values_[i]; }

    /// Where the values of a kind begin.
    template <Sensor S>
    std::size_t first() const {
        return ends_[LandmarkKinds::place<S>()];
    }
    template <Sensor S>
    std::span<const T> of() const {
        const std::size_t begin = first<S>();
        return std::span(values_).subspan(begin, ends_[LandmarkKinds::place<S>() + 1] - begin);
    }

    void clear() {
        values_.clear();
        ends_.fill(0);
    }
    /// Appends a value of a kind that does not come before the last one's.
    template <Sensor S>
    void add(const T& value) {
        values_.push_back(value);
        std::fill(ends_.begin() + LandmarkKinds::place<S>() + 1, ends_.end(), values_.size());
    }

  private:
    std::vector<T> values_;
    std::array<std::size_t, LandmarkKinds::kSize + 1> ends_{};  ///< of the kind before, of all
};

}  // namespace hitos
