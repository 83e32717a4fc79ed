// SPDX-License-Identifier: GPL-3.0-or-later
#include "association.hpp"

#include <Eigen/LU>
#include <cmath>

namespace hitos {

AssociationRule::AssociationRule(const AssociationParams& params)
    : gate_(chi_square_gate(params.gate_probability)),
      log_ratio_(std::log(params.ambiguity_ratio)),
      enabled_(params.ambiguity != AmbiguityRule::off) {}

Associator::Associator(const AssociationParams& params)
    : params_(params), rule_(params), log_p0_(std::log(params.p0)) {}

void Associator::note_limits(AssociationRecord& record) const {
    const bool by_likelihood = params_.method == AssociationMethod::maximum_likelihood;
    record.log_p0 = log_p0_;
    record.gate = by_likelihood ? std::nullopt : std::optional(rule_.gate());
    record.new_gate = std::nullopt;
}

SeenFeature Associator::seen(const Measurement& measured) const {
    const auto [sine, cosine] = elementary::sine_cosine(measured.z(1));
    if (!by_likelihood()) return {measured, rule_.gate(), {}, cosine, sine};
    // det Q >= det R, so ln likelihood <= -ln 2 pi - ln(det R) / 2 - d^2 / 2.
    const double greatest = -std::log(2.0 * kPi) - 0.5 * std::log(measured.r.determinant());
    return {measured, 2.0 * (greatest - log_p0_), {}, cosine, sine};
}

}  // namespace hitos
