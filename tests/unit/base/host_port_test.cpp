// SPDX-License-Identifier: GPL-3.0-or-later
#include "hitos/base/host_port.hpp"

#include <gtest/gtest.h>

#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace hitos {
namespace {

TEST(HostPort, HasItsParts) {
    const std::vector<std::pair<std::string, HostPort>> known{
        {"robot", {"robot", std::nullopt}}, {"robot:8765", {"robot", 8765}},
        {"127.0.0.1:0", {"127.0.0.1", 0}},  {"[::1]", {"::1", std::nullopt}},
        {"[::1]:65535", {"::1", 65535}},    {"[fe80::1%eth0]:80", {"fe80::1%eth0", 80}},
    };
    for (const auto& [text, parts] : known) {
        EXPECT_EQ(host_and_port(text), parts) << text;
        const std::string port = parts.port ? ":" + std::to_string(*parts.port) : "";
        EXPECT_EQ(bracketed(parts.host) + port, text);
    }
}

TEST(HostPort, ThatIsNoneIsNothing) {
    for (const char* text : {"",           ":80",       "robot:",  "robot:65536", "robot:8x",
                             "robot:-1",   "robot:1.5", "a:1:2",   "::1",         "::1:8765",
                             "[::1",       "[::1]x",    "[::1]80", "[::1]:",      "[]:80",
                             "[robot]:80", "a b",       "a]:80",   "a\n:80",      "[[::1]]:80"}) {
        EXPECT_FALSE(host_and_port(text)) << text;
    }
}

}  // namespace
}  // namespace hitos
