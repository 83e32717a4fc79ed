// SPDX-License-Identifier: GPL-3.0-or-later
#include "reproduction_parts.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <iterator>
#include <memory>
#include <system_error>
#include <utility>

#include "hitos/base/atomic_file.hpp"
#include "hitos/base/digest.hpp"
#include "hitos/base/error.hpp"
#include "hitos/base/folder_entries.hpp"
#include "hitos/simulation/drive/simulated_tour_reader.hpp"
#include "hitos/simulation/worlds/odometry_noise.hpp"
#include "hitos/workbench/open_tour.hpp"
#include "hitos/workbench/shipped_data.hpp"

namespace hitos {

namespace fs = std::filesystem;

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
    for (const fs::path& file : tour_files(world.file)) content.add_file(file);
    return fmt::format("simulated, laser sigma {}, odometry noise {} relative sigma\n{}{}",
                       kReproductionLaserSigma, kReproductionOdometryNoise, text_of(reading),
                       content.text());
}

Reading whole_reading(const ReproductionOptions& options) {
    Reading reading = options.reading;
    std::ranges::copy(options.world, std::back_inserter(reading.world));
    std::ranges::copy(options.settings, std::back_inserter(reading.settings));
    return reading;
}

std::vector<StudyOutcome> run_as_one(const std::vector<Study>& studies,
                                     const ReproductionOptions& options, const char* pictures) {
    StudyOptions how;
    how.threads = options.threads;
    how.tables = false;
    how.observer = options.observer;
    how.stop = options.stop;
    how.locks = false;  // its hundreds of studies are kept as one
    for (const char* folder : {".", pictures}) remove_leftovers(options.out / folder);
    std::vector<StudyOutcome> outcomes = run_studies(studies, how);
    check_whole(outcomes);
    return outcomes;
}

std::string text_or(const std::optional<double>& number, const char* format,
                    const char* otherwise) {
    return number ? fmt::format(fmt::runtime(format), *number) : otherwise;
}

void write_with_pictures(const fs::path& document, const fs::path& pictures,
                         const std::vector<std::string>& stems,
                         const std::function<std::string(const std::string&)>& text) {
    const fs::path folder = document.parent_path() / document.stem();
    std::error_code error;
    fs::create_directories(folder, error);
    if (error) {
        throw FileError(folder.string(), HITOS_TEXT("Errors", "cannot make this folder: %1"),
                        error.message());
    }
    for (const std::string& stem : stems) {
        const std::string picture = stem + ".png";
        if (!fs::exists(pictures / picture, error)) continue;
        fs::copy_file(pictures / picture, folder / picture, fs::copy_options::overwrite_existing,
                      error);
        if (error) {
            throw FileError((folder / picture).string(),
                            HITOS_TEXT("Errors", "cannot be written: %1"), error.message());
        }
    }
    write_file(document, text(document.stem().string()));
}

}  // namespace hitos
