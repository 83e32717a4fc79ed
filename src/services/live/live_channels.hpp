// SPDX-License-Identifier: GPL-3.0-or-later
// What clients can subscribe to: topics, their schemas, and how each is told of a snapshot.
#pragma once

#include <cstddef>
#include <cstdint>
#include <nlohmann/json.hpp>
#include <optional>
#include <span>
#include <string>
#include <string_view>

#include "hitos/services/run/run_worker.hpp"

namespace hitos::live {

/// What is told of.
struct LiveState {
    const Snapshot& snapshot;
    std::optional<double> behind_s;
};

struct Channel {
    std::string_view topic;
    std::string_view schema_name;
    nlohmann::json (*schema)();
    /// The message in JSON; empty where there is nothing to tell.
    std::string (*message)(const LiveState& state);
};

/// A channel's id is its place.
std::span<const Channel> channels();
/// The place of /grid, which is great and changes slowly.
std::size_t grid_channel();

/// Of the scan [ns], as all messages have it: from 0 on, whatever the stamp is.
std::uint64_t time_ns(const Snapshot& snapshot);

std::string server_info(const std::string& name, const std::string& session);
std::string advertisement();

}  // namespace hitos::live
