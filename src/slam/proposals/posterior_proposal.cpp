// SPDX-License-Identifier: GPL-3.0-or-later
// FastSLAM 2.0's proposal: the pose given motion and observations (Montemerlo, Thrun, Koller and
// Wegbreit, 2003, "FastSLAM 2.0"; Thrun, Burgard and Fox, 2005, Probabilistic Robotics,
// table 13.3).

#include <Eigen/Cholesky>
#include <Eigen/LU>
#include <array>
#include <utility>

#include "association/association.hpp"
#include "association/measurement.hpp"
#include "hitos/registration/pose_algebra.hpp"
#include "hitos/slam/robot.hpp"
#include "models/gaussian.hpp"
#include "models/map_store.hpp"
#include "proposals.hpp"

namespace hitos {
namespace {

using Vector3 = Eigen::Vector3d;

/// The pose's distribution as it grows surer: x = origin + root * xi with xi ~ N(mean, covariance),
/// which before any observation is N(0, I). So a motion noise that leaves some direction without
/// any (a singular root) needs no care: nothing is ever moved there, and densities of xi stand for
/// those of x, whose common factor cancels.
class PosePosterior {
  public:
    PosePosterior(const Pose& origin, Matrix3 root) : origin_(origin), root_(std::move(root)) {}

    Pose pose() const { return at(mean_); }
    Matrix3 covariance() const { return root_ * covariance_ * root_.transpose(); }
    Pose at(const Vector3& xi) const { return shifted(origin_, root_ * xi); }

    /// Learns an innovation nu with its Jacobian by the pose and the rest of its covariance.
    void learn(const Vector2& nu, const Matrix23& by_pose, const Matrix2& rest) {
        const Matrix23 h = by_pose * root_;
        const Eigen::Matrix<double, 3, 2> ph = covariance_ * h.transpose();
        const Eigen::LLT<Matrix2> factor(h * ph + rest);
        if (factor.info() != Eigen::Success) return;
        mean_ += ph * factor.solve(nu);
        const Matrix3 reduced = covariance_ - ph * factor.solve(ph.transpose());
        covariance_ = 0.5 * (reduced + reduced.transpose());
    }

    ProposedPose draw(RandomStream& random) const {
        const Vector3 n = normal_triple(random);
        const Eigen::LLT<Matrix3> factor(covariance_);
        if (factor.info() != Eigen::Success) return {at(n)};  // of the motion model then
        const Matrix3 l = factor.matrixL();
        const Vector3 xi = mean_ + l * n;
        // ln N(xi; 0, I) - ln N(xi; mean, L L').
        return {at(xi),
                0.5 * (n.squaredNorm() - xi.squaredNorm()) + l.diagonal().array().log().sum()};
    }

  private:
    Pose origin_;
    Matrix3 root_;
    Vector3 mean_ = Vector3::Zero();
    Matrix3 covariance_ = Matrix3::Identity();
};

class PosteriorProposal final : public Proposal {
  public:
    explicit PosteriorProposal(const FilterParams& params)
        : params_(params),
          robot_(make_robot(params.motion)),
          associator_(params.association),
          rule_(params.association),
          log_p0_(std::log(params.association.p0)) {}

    void begin(const SlamInput& input, bool first) override {
        increment_ = motion_increment(input);
        first_ = first;
        measure(input.observation, params_.observation, measurements_, params_.association.known);
        note_reaches(input.observation, params_.association.segments, reaches_);
    }

    ProposedPose draw(const Hypothesis& before, RandomStream& random) const override {
        const Pose mean = robot_->mean(before.pose, increment_);
        if (first_) return {mean};
        const Matrix3 root = root_of(robot_->noise_covariance(before.pose, increment_));
        if (root.isZero(0.0)) return {mean};
        PosePosterior posterior(mean, root);
        for_each_kind([&]<class S>() {
            const auto landmarks = before.map.landmarks<S>();
            for (std::size_t i = 0; i < measurements_.of<S>().size(); ++i) {
                learn<S>(posterior, landmarks, measurements_.of<S>()[i], reaches_.of<S>()[i]);
            }
        });
        return posterior.draw(random);
    }

  private:
    /// What the best candidate says.
    struct Found {
        JointInnovation innovation;
        Matrix2 rest;  ///< H P H' of the landmark, and R
    };

    /// Associates an observation as the filter would, but at the posterior's mean and with its
    /// covariance in the innovation's, and learns it.
    template <Sensor S>
    void learn(PosePosterior& posterior, const typename S::Columns& landmarks,
               const Measurement& measured, const SeenReach& reach) const {
        const bool by_likelihood =
            params_.association.method == AssociationMethod::maximum_likelihood;
        const Pose pose = posterior.pose();
        const Matrix3 p = posterior.covariance();
        // For the quick rejection alone: as unsure as the pose can make any landmark's observation.
        SeenFeature loose = associator_.seen(measured);
        loose.measured.r.diagonal() += S::greatest_variances(p);
        const PreparedObservation prepared = prepare(loose, pose);
        const double unsure = 2.0 * std::sqrt(p(0, 0) + p(1, 1));
        BestTwo candidates;
        Found found;
        const bool known = measured.identity != kNameless;
        const auto compare = [&](std::uint32_t i) {
            if (!known && !associator_.beside<S>(landmarks, i, pose, reach, unsure)) return;
            const JointInnovation seen = S::joint_innovation(measured.z, pose, landmarks.mean(i));
            const Matrix2 rest =
                seen.by_landmark * landmarks.covariance(i) * seen.by_landmark.transpose() +
                measured.r;
            const Likelihood close =
                likelihood_of(seen.nu, seen.by_pose * p * seen.by_pose.transpose() + rest);
            const bool outside = by_likelihood ? !(close.log_likelihood > log_p0_)
                                               : !(close.mahalanobis_squared <= rule_.gate());
            if (outside && !known) return;
            const double score = by_likelihood ? close.log_likelihood : -close.mahalanobis_squared;
            if (candidates.offer(i, score, close.log_likelihood)) found = {seen, rest};
        };
        if (known) {
            if (const auto landmark = landmarks.identified(measured.identity)) compare(*landmark);
        } else {
            landmarks.each_near(pose, prepared, compare);
        }
        if (candidates.none() || rule_.ambiguous(candidates, log_p0_)) return;
        posterior.learn(found.innovation.nu, found.innovation.by_pose, found.rest);
    }

    FilterParams params_;
    std::unique_ptr<Robot> robot_;
    Associator associator_;
    AssociationRule rule_;
    double log_p0_;
    MotionIncrement increment_;
    bool first_ = true;
    Measurements measurements_;
    KindRow<SeenReach> reaches_;
};

}  // namespace

ProposalEntry posterior_proposal() {
    ProposalEntry entry;
    entry.word = "posterior";
    entry.label = HITOS_TEXT("ParameterChoice", "Motion and observations");
    entry.purpose = "poses are drawn given the scan's observations too, as in FastSLAM 2.0";
    entry.make = [](const FilterParams& p) { return std::make_unique<PosteriorProposal>(p); };
    return entry;
}

}  // namespace hitos
