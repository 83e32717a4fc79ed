#include "thesis_world.hpp"

#include <fmt/format.h>

#include <memory>
#include <utility>

#include "hitos/base/digest.hpp"
#include "hitos/simulation/drive/simulated_tour_reader.hpp"
#include "hitos/simulation/worlds/odometry_noise.hpp"
#include "hitos/workbench/open_tour.hpp"
#include "hitos/workbench/reproduction.hpp"
#include "hitos/workbench/shipped_data.hpp"

namespace hitos {

World thesis_world(const std::string& name, const Reading& reading) {
    World world = read_world(find_world(name));
    world.laser.sigma_m = kReproductionLaserSigma;
    world.odometry.noise = kReproductionOdometryNoise;
    world.odometry.noise_kind = OdometryNoiseKind::relative_sigma;
    apply(reading, world);
    return world;
}

StudySource driven_through(World world) {
    StudySource source;
    source.open = [world = std::move(world)](const SourceParams&, std::uint64_t seed) {
        World noisy = world;
        noisy.seed = seed;
        return std::make_unique<SimulatedTourReader>(
            std::make_shared<const SimulatedTour>(std::move(noisy)));
    };
    source.seeded = [](const SourceParams&) { return true; };
    return source;
}

std::string world_setting(const World& world, const Reading& reading) {
    Digest content;
    for (const std::filesystem::path& file : tour_files(world.file)) content.add_file(file);
    return fmt::format("simulated, laser sigma {}, odometry noise {} relative sigma\n{}{}",
                       kReproductionLaserSigma, kReproductionOdometryNoise, text_of(reading),
                       content.text());
}

}  // namespace hitos
