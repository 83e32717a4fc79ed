// SPDX-License-Identifier: GPL-3.0-or-later
// Where something is on a network, as people write it.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

namespace hitos {

/// HOST or HOST:PORT; an address of IPv6 stands in brackets there, and without them in `host`.
struct HostPort {
    std::string host;
    std::optional<std::uint16_t> port;  ///< where one is named
    friend bool operator==(const HostPort&, const HostPort&) = default;
};

/// Nothing where it is none.
std::optional<HostPort> host_and_port(std::string_view text);

/// The host as it stands before a port: an address of IPv6 in brackets.
std::string bracketed(std::string_view host);

}  // namespace hitos
