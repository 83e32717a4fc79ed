// SPDX-License-Identifier: GPL-3.0-or-later
#include "scan_twins.hpp"

#include <algorithm>
#include <cmath>

namespace hitos {

ScanTwins::ScanTwins(const AssociationParams& params, bool has_p0)
    : margin_(params.segment_margin_m),
      log_p0_(std::log(params.p0)),
      gate_(chi_square_gate(params.gate_probability)),
      log_ratio_(std::log(params.ambiguity_ratio)),
      by_likelihood_(has_p0 && params.method == AssociationMethod::maximum_likelihood) {}

void ScanTwins::find(const Measurements& seen, const KindRow<SeenReach>* reaches) {
    pairs_.clear();
    for_each_kind([&]<class S>() {
        const std::span<const Measurement> row = seen.of<S>();
        for (std::size_t later = 1; later < row.size(); ++later) {
            if (row[later].identity != kNameless) {
                // One pair is enough: all further ones of its name are twins of the first.
                const auto first = std::ranges::find(row.first(later), row[later].identity,
                                                     &Measurement::identity);
                const auto place = static_cast<std::size_t>(first - row.begin());
                if (place < later)
                    pairs_.emplace_back(seen.first<S>() + place, seen.first<S>() + later);
                continue;
            }
            const EKF<S> ekf(row[later].r);
            for (std::size_t earlier = 0; earlier < later; ++earlier) {
                const auto known = EKF<S>(row[earlier].r).first({}, row[earlier].z).mean;
                if (reaches != nullptr) {
                    const Extent first = S::placed(reaches->of<S>()[earlier], {}, known);
                    const Extent second = S::placed(reaches->of<S>()[later], {}, known);
                    if (first.gap(second) > margin_) continue;
                }
                const Likelihood close =
                    ekf.likelihood(S::innovation(row[later].z, {}, known), Matrix2::Zero());
                if (plausible(close) && -0.5 * close.mahalanobis_squared > log_ratio_) {
                    pairs_.emplace_back(seen.first<S>() + earlier, seen.first<S>() + later);
                }
            }
        }
    });
}

bool ScanTwins::plausible(const Likelihood& close) const {
    return by_likelihood_ ? close.log_likelihood > log_p0_ : close.mahalanobis_squared <= gate_;
}

}  // namespace hitos
