// SPDX-License-Identifier: GPL-3.0-or-later
// Maps that have an index and pages, in whole filters.

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <random>
#include <vector>

#include "fastslam/filtro_particulas.hpp"
#include "hitos/base/vectorised.hpp"
#include "same_beliefs.hpp"

namespace hitos {
namespace {

/// Round a field of posts and of walls that touch circles about the origin, of which the robot sees
/// those that are near.
struct FieldTour {
    std::vector<Control> controls;
    std::vector<Observation> observations;
};

FieldTour make_field_tour(int steps) {
    std::mt19937 engine(61);
    std::normal_distribution<double> normal(0.0, 1.0);
    FieldTour tour;
    Pose pose;
    for (int k = 0; k < steps; ++k) {
        const Control control{{3.0, 0.0, 0.2}, k == 0 ? 0.0 : 0.5};
        pose = compose(pose, displacement(control.twist, control.duration_s));
        Control logged = control;
        logged.twist.w += 0.002 * normal(engine);
        tour.controls.push_back(logged);
        Observation seen;
        const Pose back = inverse(pose);
        for (int column = -12; column < 12; ++column) {
            for (int row = -5; row < 20; ++row) {
                Esquina local = transform(back, Esquina{2.1 * column, 2.1 * row});
                if (std::hypot(local.x, local.y) > 6.0) continue;
                local.x += 0.02 * normal(engine);
                local.y += 0.02 * normal(engine);
                seen.corners.push_back(local);
            }
        }
        for (int i = 0; i < 400; ++i) {
            Recta local = transform(back, Recta{0.05 * i, wrap_angle(2.4 * i)});
            if (local.rho > 5.0 || std::abs(local.theta) > 1.3) continue;
            local.rho = std::abs(local.rho + 0.01 * normal(engine));
            local.theta = wrap_angle(local.theta + 0.002 * normal(engine));
            seen.lines.push_back({local, 0, 0});
        }
        tour.observations.push_back(seen);
    }
    return tour;
}

FilterParams field_params(int particles) {
    FilterParams params;
    params.particles = particles;
    params.motion.sigma_x_m = params.motion.sigma_y_m = 0.01;
    params.motion.sigma_theta_rad = 0.003;
    params.observation = {0.0009, 0.0001};
    return params;
}

std::unique_ptr<FiltroParticulas> after(const FieldTour& tour, int particles, int threads,
                                        AssociationRecord* record = nullptr) {
    auto filter = std::make_unique<FiltroParticulas>(field_params(particles), 3, threads);
    const Scan scan;
    for (std::size_t k = 0; k < tour.controls.size(); ++k) {
        filter->step(
            {scan, std::span(&tour.controls[k], 1), tour.observations[k], nullptr, record});
    }
    return filter;
}

TEST(FiltroParticulas, SameBitsInALargeMapForAnyNumberOfThreads) {
    const FieldTour tour = make_field_tour(70);
    constexpr int kParticles = 150;
    const auto one = after(tour, kParticles, 1);
    // Or neither pages nor indices were there.
    EXPECT_GT(one->best_count(FeatureKind::corner), 192);
    EXPECT_GT(one->best_count(FeatureKind::line), 192);
    for (const int threads : {2, 7}) {
        expect_same(*after(tour, kParticles, threads), *one, kParticles);
    }
}

TEST(FiltroParticulas, SameBitsInALargeMapWithAnyVectorsAndAnybodyAsking) {
    const FieldTour tour = make_field_tour(70);
    constexpr int kParticles = 40;
    const auto plain = after(tour, kParticles, 1);
    AssociationRecord record;
    expect_same(*after(tour, kParticles, 1, &record), *plain, kParticles);
    for (const VectorTarget target : {VectorTarget::sse2, VectorTarget::avx2}) {
        if (use_vectors(target) != target) continue;  // this machine has none
        expect_same(*after(tour, kParticles, 1), *plain, kParticles);
    }
    use_vectors(VectorTarget::avx512);
}

TEST(FiltroParticulas, ACopyOfALargeMapIsAndGoesOnAsTheFirst) {
    constexpr int kParticles = 20;
    const FieldTour tour = make_field_tour(75);
    FieldTour most = tour;
    most.controls.resize(70);
    const auto first = after(most, kParticles, 1);
    ASSERT_GT(first->best_count(FeatureKind::corner), 192);
    const std::unique_ptr<SlamFilter> cloned = first->clone();
    auto* const copy = dynamic_cast<FiltroParticulas*>(cloned.get());
    ASSERT_NE(copy, nullptr);
    expect_same(*copy, *first, kParticles);
    const Scan scan;
    for (std::size_t k = 70; k < tour.controls.size(); ++k) {
        for (FiltroParticulas* filter : {first.get(), copy}) {
            filter->step(
                {scan, std::span(&tour.controls[k], 1), tour.observations[k], nullptr, nullptr});
        }
    }
    expect_same(*copy, *first, kParticles);
}

}  // namespace
}  // namespace hitos
