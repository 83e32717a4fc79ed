// SPDX-License-Identifier: GPL-3.0-or-later
// What others see of a registration.
#include <memory>
#include <span>
#include <string>
#include <vector>

#include "hitos/registration/registration.hpp"
#include "registration_impl.hpp"

namespace hitos {

Registration::Registration(const RegistrationParams& params, int threads)
    : impl_(std::make_unique<Impl>(params, threads)) {}
Registration::~Registration() = default;
Registration::Registration(Registration&&) noexcept = default;
Registration& Registration::operator=(Registration&&) noexcept = default;
Registration::Registration(const Registration& other)
    : impl_(std::make_unique<Impl>(*other.impl_)) {
    impl_->drop_pictures();
}

std::size_t Registration::bytes() const {
    const KeyGraph& graph = impl_->graph();
    return graph.size() * (sizeof(KeyPose) + sizeof(KeyScan) + sizeof(Pose)) +
           graph.edges.size() * sizeof(PoseEdge);
}

RegisteredStep Registration::add(const Scan& scan, std::span<const Control> controls) {
    return impl_->add(scan, controls);
}
std::optional<PathCorrection> Registration::correction() const {
    return impl_->correction();
}
void Registration::time_stages() {
    impl_->clock().set_going();
}
const RegistrationClock::Seconds& Registration::stages() const {
    return impl_->clock().seconds();
}
void Registration::finish(bool another_follows) {
    impl_->finish(another_follows);
}
void Registration::set_edits(const std::string& edits) {
    impl_->set_edits(edits);
}
bool Registration::foresee(const std::string& edits) {
    return impl_->foresee(edits);
}
LoopRecord Registration::fitted_loop(std::uint64_t scan, std::uint64_t earlier,
                                     const Pose& start) const {
    return impl_->fitted_loop(scan, earlier, start);
}
std::vector<Pose> Registration::path() const {
    return impl_->path();
}
const std::vector<LoopRecord>& Registration::loops() const {
    return impl_->loops();
}
const std::vector<LoopRecord>& Registration::refused_loops() const {
    return impl_->refused_loops();
}
std::span<const KeyPose> Registration::keys() const {
    return impl_->graph().poses;
}
std::span<const PoseEdge> Registration::edges() const {
    return impl_->told_edges();
}
double Registration::chi_square() const {
    return impl_->chi_square();
}
std::optional<LaidDrawing> Registration::drawing() const {
    return laid_drawing(impl_->graph().poses, impl_->graph().edges);
}
const std::vector<SecondTour>& Registration::later_tours() const {
    return impl_->later_tours();
}

RegistrationFigures Registration::figures() const {
    return impl_->figures();
}
std::vector<ChangedPlace> Registration::changes() const {
    return impl_->changes();
}

}  // namespace hitos
