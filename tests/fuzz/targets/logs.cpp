// SPDX-License-Identifier: GPL-3.0-or-later
// Logs of every format.

#include "hitos/capture/archivo.hpp"
#include "hitos/capture/procesador.hpp"
#include "laws.hpp"
#include "targets.hpp"
#include "tour_laws.hpp"

namespace hitos::fuzz {
namespace {

bool check_log_of(std::string_view format, std::string_view input) {
    // Whatever the file is, it is found out or refused.
    unless_refused([&] { return open_log(file_of(input)) != nullptr; });
    return check_log(input, format);
}

}  // namespace

bool check_player(std::string_view input) {
    return check_log_of("player", input);
}

bool check_radish(std::string_view input) {
    return check_log_of("radish", input);
}

bool check_normalized(std::string_view input) {
    return check_log_of("normalized", input);
}

bool check_carmen(std::string_view input) {
    return check_log_of("carmen", input);
}

bool check_rosbag(std::string_view input) {
    return check_log_of("rosbag", input);
}

bool check_mcap(std::string_view input) {
    return check_log_of("mcap", input);
}

bool check_db3(std::string_view input) {
    // SQLite opens no file without a name.
    static const ScratchFolder scratch;
    const std::filesystem::path file = scratch.put("input.db3", input);
    const std::optional<Tour> tour = unless_refused([&] {
        Procesador reader(open_log(file, "db3"));
        return read_tour(reader);
    });
    if (tour) require_sound(*tour, DamageIs::part);
    return tour.has_value();
}

}  // namespace hitos::fuzz
