// SPDX-License-Identifier: GPL-3.0-or-later
// Pictures of walls, and the files that tell where they lie.
#include <cmath>
#include <string>

#include "hitos/services/tracing/occupancy_picture.hpp"
#include "laws.hpp"
#include "targets.hpp"

namespace hitos::fuzz {
namespace {

void require_sound(const OccupancyPicture& picture) {
    require(picture.columns > 0 && picture.rows > 0, "a picture has pixels");
    require(picture.occupied.size() ==
                static_cast<std::size_t>(picture.columns) * static_cast<std::size_t>(picture.rows),
            "a picture is as large as it says");
    require(picture.resolution_m > 0.0 && std::isfinite(picture.resolution_m) &&
                is_finite({picture.origin.x, picture.origin.y}) &&
                std::isfinite(picture.origin.theta),
            "a picture lies somewhere");
}

}  // namespace

bool check_map_server(std::string_view input) {
    static const ScratchFolder scratch;
    static const std::filesystem::path picture = scratch.put("map.pgm", "P2\n2 1\n255\n0 254\n");
    const std::filesystem::path yaml = scratch.put("map.yaml", input);
    const auto read = unless_refused([&] { return read_map_server(yaml); });
    if (read) require_sound(*read);
    return read.has_value();
}

bool check_picture(std::string_view input) {
    const std::filesystem::path& file = file_of(input);
    constexpr double kMetres = 0.05;
    const auto read = unless_refused([&] { return read_wall_picture(file, kMetres); });
    if (read) require_sound(*read);
    return read.has_value();
}

}  // namespace hitos::fuzz
