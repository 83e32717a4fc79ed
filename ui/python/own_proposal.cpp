// SPDX-License-Identifier: GPL-3.0-or-later
// A proposal that is a function of Python.

#include <pybind11/numpy.h>

#include <array>
#include <cmath>
#include <limits>
#include <span>
#include <utility>

#include "arrays.hpp"
#include "callables.hpp"
#include "hitos/base/error.hpp"
#include "hitos/base/random_row.hpp"
#include "hitos/slam/robot.hpp"
#include "python_calls.hpp"

namespace hitos::python {
namespace {

using Numbers = py::array_t<double, py::array::c_style | py::array::forcecast>;

/// Column after column: NumPy computes cosines of numbers with gaps between them in one of two
/// ways, by what lies behind them in memory, which would make runs differ in the last bit.
using Columns = py::array_t<double, py::array::f_style>;

/// Particles and their standard normal numbers, as arrays of their own.
struct Drawing {
    Columns poses;
    Columns normals;
};

Drawing drawing_of(std::span<const Pose> poses, const NormalRow& normals) {
    const auto count = static_cast<py::ssize_t>(poses.size());
    Drawing drawing{Columns({count, py::ssize_t{3}}), Columns({count, py::ssize_t{3}})};
    auto pose = drawing.poses.mutable_unchecked<2>();
    auto normal = drawing.normals.mutable_unchecked<2>();
    for (py::ssize_t i = 0; i < count; ++i) {
        const auto k = static_cast<std::size_t>(i);
        pose(i, 0) = poses[k].x;
        pose(i, 1) = poses[k].y;
        pose(i, 2) = poses[k].theta;
        normal(i, 0) = normals.n0[k];
        normal(i, 1) = normals.n1[k];
        normal(i, 2) = normals.n2[k];
    }
    return drawing;
}

void take_poses(const py::object& returned, std::span<Pose> poses) {
    const Numbers numbers(returned);
    const auto count = static_cast<py::ssize_t>(poses.size());
    if (numbers.ndim() != 2 || numbers.shape(0) != count || numbers.shape(1) != 3) {
        throw py::value_error(
            "a proposal returned the shape " + py::str(numbers.attr("shape")).cast<std::string>() +
            "; expected x, y, theta for each of " + std::to_string(count) + " particles");
    }
    const auto at = numbers.unchecked<2>();
    for (py::ssize_t i = 0; i < count; ++i) {
        if (!std::isfinite(at(i, 0)) || !std::isfinite(at(i, 1)) || !std::isfinite(at(i, 2))) {
            throw py::value_error("a proposal returned a pose that is not finite for particle " +
                                  std::to_string(i));
        }
        poses[static_cast<std::size_t>(i)] = {at(i, 0), at(i, 1), wrap_angle(at(i, 2))};
    }
}

double log_weight_of(const py::object& returned) {
    const Numbers numbers(returned);
    if (numbers.size() != 1) {
        throw py::value_error("a weighted proposal returned " + std::to_string(numbers.size()) +
                              " log weights for one particle");
    }
    const double weight = *numbers.data();
    // That a particle is impossible may be said; that nobody knows may not.
    if (std::isnan(weight) || weight == std::numeric_limits<double>::infinity()) {
        throw py::value_error("a weighted proposal returned the log weight " +
                              std::to_string(weight) + "; expected a number, or -inf");
    }
    return weight;
}

class OwnProposal final : public Proposal {
  public:
    OwnProposal(Function function, bool weighted) : function_(function), weighted_(weighted) {}

    void begin(const SlamInput& input, bool first) override {
        const MotionIncrement increment = motion_increment(input);
        auto motion = std::make_shared<Motion>();
        motion->displacement = increment.pose_start_end;
        motion->path_m = increment.path_m;
        motion->turned_rad = increment.turned_rad;
        motion->moved = increment.moved();
        motion->first = first;
        motion->controls.assign(input.controls.begin(), input.controls.end());
        motion->scan = std::make_shared<const Scan>(input.scan);
        motion_ = std::move(motion);
    }

    ProposedPose draw(const Hypothesis& before, RandomStream& random) const override {
        NormalRow normals{};
        if (!motion_->first) {
            const auto [n0, n1] = random.normal_pair();
            normals.n0[0] = n0;
            normals.n1[0] = n1;
            normals.n2[0] = random.normal_pair()[0];
        }
        std::array<Pose, 1> pose{before.pose};
        const double log_weight = propose(pose, normals);
        return {pose[0], log_weight};
    }

    bool draw_row(std::span<Pose> poses, const RandomRow& row) const override {
        if (weighted_) return false;
        NormalRow normals{};
        if (!motion_->first) draw_normals(row, poses.size(), normals);
        propose(poses, normals);
        return true;
    }

  private:
    /// Gives the logarithm of the weight, of a weighted one.
    double propose(std::span<Pose> poses, const NormalRow& normals) const {
        return with_python([&] {
            const Drawing drawing = drawing_of(poses, normals);
            const py::object returned =
                function_(drawing.poses, std::const_pointer_cast<Motion>(motion_), drawing.normals);
            if (!weighted_) {
                take_poses(returned, poses);
                return 0.0;
            }
            if (!py::isinstance<py::tuple>(returned) || py::len(returned) != 2) {
                throw py::value_error(
                    "a weighted proposal returned no pair of poses and log weights");
            }
            const auto pair = py::cast<py::tuple>(returned);
            take_poses(pair[0], poses);
            return log_weight_of(pair[1]);
        });
    }

    Function function_;
    bool weighted_;
    std::shared_ptr<const Motion> motion_;
};

}  // namespace

std::unique_ptr<Proposal> proposal_of(Function function, bool weighted) {
    return std::make_unique<OwnProposal>(function, weighted);
}

}  // namespace hitos::python
