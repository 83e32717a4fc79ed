// SPDX-License-Identifier: GPL-3.0-or-later
#include "hitos/base/host_port.hpp"

#include <algorithm>
#include <limits>

#include "hitos/base/text_input.hpp"

namespace hitos {
namespace {

bool is_odd(char c) {
    return static_cast<unsigned char>(c) <= ' ' || c == '\x7f' || c == '[' || c == ']';
}

}  // namespace

std::optional<HostPort> host_and_port(std::string_view text) {
    const bool in_brackets = text.starts_with('[');
    const std::size_t end = text.find(in_brackets ? ']' : ':');
    if (in_brackets && end == std::string_view::npos) return std::nullopt;
    HostPort found;
    found.host = in_brackets ? text.substr(1, end - 1) : text.substr(0, end);
    const bool v6 = found.host.find(':') != std::string::npos;
    if (found.host.empty() || v6 != in_brackets || std::ranges::any_of(found.host, is_odd))
        return std::nullopt;
    text.remove_prefix(end == std::string_view::npos ? text.size() : end + (in_brackets ? 1 : 0));
    if (text.empty()) return found;
    const auto port = input::parse_whole(text.substr(1));  // of an address without brackets: none
    if (text.front() != ':' || !port || *port > std::numeric_limits<std::uint16_t>::max())
        return std::nullopt;
    found.port = static_cast<std::uint16_t>(*port);
    return found;
}

std::string bracketed(std::string_view host) {
    std::string text(host);
    return host.find(':') == std::string_view::npos ? text : "[" + text + "]";
}

}  // namespace hitos
