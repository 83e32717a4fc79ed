// SPDX-License-Identifier: GPL-3.0-or-later
// What a client says, which may be anything.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace hitos::live {

struct Request {
    /// By their own ids, the channels that are wanted.
    std::vector<std::pair<std::uint32_t, std::uint32_t>> subscribe;
    std::vector<std::uint32_t> unsubscribe;
    std::optional<std::string> unknown;  ///< the op, where it is none of these
    std::string wrong;                   ///< words to the client, where it is none at all
};

Request parsed_request(std::string_view text);

enum class StatusLevel { warning = 1, error = 2 };
std::string status(StatusLevel level, const std::string& words);

}  // namespace hitos::live
