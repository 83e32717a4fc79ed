// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include "hitos/base/error.hpp"
#include "live/websocket.hpp"

namespace hitos {
namespace {

TEST(WebSocketAddress, HasItsPartsOrIsRefused) {
    const WebSocketAddress plain("ws://robot");
    EXPECT_EQ(plain.host + " " + plain.port + " " + plain.path, "robot 8765 /");
    const WebSocketAddress whole("ws://[::1]:81/a/b");
    EXPECT_EQ(whole.host + " " + whole.port + " " + whole.path, "::1 81 /a/b");
    for (const char* bad : {"ws://", "ws://:80", "ws://a:", "ws://a:0", "ws://a:65536", "ws://a:8x",
                            "ws://[::1", "ws://[::1]x", "ws://::1:80", "ws://[a]:80", "ws://[]",
                            "ws://a b", "wss://a", "http://a", "ws://a:1.5", "ws://a\n"}) {
        EXPECT_THROW(WebSocketAddress{bad}, ConfigError) << bad;
    }
}

}  // namespace
}  // namespace hitos
