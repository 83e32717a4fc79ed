#include "association.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace hitos {
namespace {

constexpr double kNothing = -std::numeric_limits<double>::infinity();
constexpr std::size_t kChunk = 64;

// Quick rejection. The squared Mahalanobis distance of both components is at least that of either
// alone, nu_i^2 / Q_ii, and |sin a| <= |a|; so a landmark that fails here cannot pass the exact
// test. Loops without branches over columns: the compiler vectorises them.

void mark_near(const LineColumns& lines, std::size_t begin, std::size_t end, const Pose& pose,
               const PreparedObservation& observed, unsigned char* near) {
    const double* rho = lines.column(LineColumns::rho);
    const double* cosine = lines.column(LineColumns::cosine);
    const double* sine = lines.column(LineColumns::sine);
    const double* p00 = lines.column(LineColumns::p00);
    const double* p01 = lines.column(LineColumns::p01);
    const double* p11 = lines.column(LineColumns::p11);
    const double cw = observed.cos_world;
    const double sw = observed.sin_world;
    const double z0 = observed.seen.measured.z(0);
    const double r0 = observed.seen.measured.r(0, 0);
    const double r1 = observed.seen.measured.r(1, 1);
    const double slack = observed.seen.slack;
    for (std::size_t i = begin; i < end; ++i) {
        const double sin_turn = sine[i] * cw - cosine[i] * sw;
        const double cos_turn = cosine[i] * cw + sine[i] * sw;
        const double h_rho = rho[i] - pose.x * cosine[i] - pose.y * sine[i];
        const double nu = cos_turn < 0.0 ? z0 + h_rho : z0 - h_rho;
        const double lever = pose.x * sine[i] - pose.y * cosine[i];
        const double q00 = p00[i] + lever * (2.0 * p01[i] + lever * p11[i]) + r0;
        const double q11 = p11[i] + r1;
        // At a right angle rounding may choose the other side than the exact test: let it through.
        const bool rho_near = (nu * nu < slack * q00) | (cos_turn * cos_turn < 1e-18);
        near[i - begin] =
            static_cast<unsigned char>(rho_near & (sin_turn * sin_turn < slack * q11));
    }
}

void mark_near(const CornerColumns& corners, std::size_t begin, std::size_t end, const Pose& pose,
               const PreparedObservation& observed, unsigned char* near) {
    const double* x = corners.column(CornerColumns::x);
    const double* y = corners.column(CornerColumns::y);
    const double* p00 = corners.column(CornerColumns::p00);
    const double* p01 = corners.column(CornerColumns::p01);
    const double* p11 = corners.column(CornerColumns::p11);
    const double cw = observed.cos_world;
    const double sw = observed.sin_world;
    const double z0 = observed.seen.measured.z(0);
    const double r0 = observed.seen.measured.r(0, 0);
    const double r1 = observed.seen.measured.r(1, 1);
    const double slack = observed.seen.slack;
    constexpr double kNearest2 = SensorEsquina::kNearest * SensorEsquina::kNearest;
    for (std::size_t i = begin; i < end; ++i) {
        const double dx = x[i] - pose.x;
        const double dy = y[i] - pose.y;
        const double range2 = dx * dx + dy * dy;
        const double clamped2 = std::max(range2, kNearest2);
        const double nu = z0 - std::sqrt(range2);
        const double q00 =
            (dx * dx * p00[i] + 2.0 * dx * dy * p01[i] + dy * dy * p11[i]) / clamped2 + r0;
        const double q11 =
            (dy * dy * p00[i] - 2.0 * dx * dy * p01[i] + dx * dx * p11[i]) / (clamped2 * clamped2) +
            r1;
        const double cross = dy * cw - dx * sw;
        const double dot = dx * cw + dy * sw;
        // Behind the ray the angle is over pi/2: its square is above 1, the greatest of the sine.
        const double sine2 = dot < 0.0 ? range2 : cross * cross;
        near[i - begin] =
            static_cast<unsigned char>((nu * nu < slack * q00) & (sine2 < slack * q11 * clamped2));
    }
}

}  // namespace

Associator::Associator(const AssociationParams& params)
    : params_(params),
      log_p0_(std::log(params.p0)),
      log_ratio_(std::log(params.ambiguity_ratio)),
      gate_(chi_square_gate(params.gate_probability)) {}

SeenFeature Associator::seen(const Measurement& measured) const {
    if (params_.method != AssociationMethod::maximum_likelihood) return {measured, gate_};
    // det Q >= det R, so ln likelihood <= -ln 2 pi - ln(det R) / 2 - d^2 / 2.
    const Matrix2& r = measured.r;
    const double det = r(0, 0) * r(1, 1) - r(0, 1) * r(1, 0);
    const double greatest = -std::log(2.0 * kPi) - 0.5 * std::log(det);
    return {measured, 2.0 * (greatest - log_p0_)};
}

template <class Filter, class Columns>
Decision Associator::decide_among(const Columns& landmarks, const Pose& pose,
                                  const PreparedObservation& observed) const {
    const Filter ekf(observed.seen.measured.r);
    const bool by_likelihood = params_.method == AssociationMethod::maximum_likelihood;
    std::uint32_t best = 0;
    double best_score = kNothing;  // what the method maximises
    double best_log = kNothing;
    double second_log = kNothing;
    std::array<unsigned char, kChunk> near{};
    for (std::size_t begin = 0; begin < landmarks.size(); begin += kChunk) {
        const std::size_t end = std::min(begin + kChunk, landmarks.size());
        mark_near(landmarks, begin, end, pose, observed, near.data());
        for (std::size_t i = begin; i < end; ++i) {
            if (near[i - begin] == 0) continue;
            const auto [log_likelihood, mahalanobis2] = ekf.likelihood(
                landmarks.innovation(i, observed.seen.measured.z, pose), landmarks.covariance(i));
            if (by_likelihood ? log_likelihood <= log_p0_ : mahalanobis2 > gate_) continue;
            const double score = by_likelihood ? log_likelihood : -mahalanobis2;
            if (score > best_score) {
                second_log = std::max(second_log, best_log);
                best = static_cast<std::uint32_t>(i);
                best_score = score;
                best_log = log_likelihood;
            } else {
                second_log = std::max(second_log, log_likelihood);
            }
        }
    }
    return resolve(best, best_log, second_log);
}

Decision Associator::resolve(std::uint32_t best, double best_log, double second_log) const {
    using Outcome = Association::Outcome;
    if (best_log == kNothing) return {Outcome::created, 0, log_p0_};
    const bool ambiguous = params_.ambiguity != AmbiguityRule::off && second_log > log_p0_ &&
                           second_log > best_log + log_ratio_;
    if (!ambiguous) return {Outcome::matched, best, best_log};
    switch (params_.ambiguity) {
        case AmbiguityRule::neutral:
            return {Outcome::ignored, 0, 0.0};
        case AmbiguityRule::new_landmark:
            return {Outcome::ignored, 0, log_p0_};
        default:
            return {Outcome::ignored, 0, std::max(best_log, second_log)};
    }
}

Decision Associator::decide(const LineColumns& lines, const Pose& pose,
                            const PreparedObservation& observed) const {
    return decide_among<EKF<SensorRecta>>(lines, pose, observed);
}

Decision Associator::decide(const CornerColumns& corners, const Pose& pose,
                            const PreparedObservation& observed) const {
    return decide_among<EKF<SensorEsquina>>(corners, pose, observed);
}

}  // namespace hitos
