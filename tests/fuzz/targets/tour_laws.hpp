// SPDX-License-Identifier: GPL-3.0-or-later
// The laws of whatever a log gives.
#pragma once

#include <filesystem>
#include <string_view>
#include <vector>

#include "hitos/capture/tour_reader.hpp"

namespace hitos::fuzz {

/// Everything that a log gives.
struct Tour {
    std::vector<Scan> scans;
    std::vector<Odometria> odometry;
    ReadReport report;
};

/// The order in which the two sequences are asked for.
enum class Order { scans_first, odometry_first, in_turns };

Tour read_tour(TourReader& reader, Order order = Order::scans_first);

/// Whether what is damaged in a line is all of it, or may be a part, as of a recording's message.
enum class DamageIs { whole, part };

/// Finite values, in order, and a report that agrees with them.
void require_sound(const Tour& tour, DamageIs damage = DamageIs::whole);

/// Reads the log and, for some inputs, in every order, again, and through the formats' writers.
/// Returns whether it is a log of the format.
bool check_log(std::string_view input, std::string_view format);

}  // namespace hitos::fuzz
