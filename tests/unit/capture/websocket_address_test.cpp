// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include <string>

#include "hitos/base/error.hpp"
#include "hitos/capture/live_source.hpp"
#include "live/websocket.hpp"
#include "unit/capture/test_files.hpp"

namespace hitos {
namespace {

TEST(WebSocketAddress, HasItsPartsOrIsRefused) {
    const WebSocketAddress plain("ws://robot");
    EXPECT_EQ(plain.host + " " + plain.port + " " + plain.path, "robot 8765 /");
    const WebSocketAddress whole("ws://[::1]:81/a/b");
    EXPECT_EQ(whole.host + " " + whole.port + " " + whole.path, "::1 81 /a/b");
    const WebSocketAddress short_one("robot:81");
    EXPECT_EQ(short_one.host + " " + short_one.port + " " + short_one.path, "robot 81 /");
    EXPECT_EQ(WebSocketAddress("WS://robot").host, "robot");
    for (const char* bad : {"ws://",     "ws://:80",  "ws://a:",     "ws://a:0",    "ws://a:65536",
                            "ws://a:8x", "ws://[::1", "ws://[::1]x", "ws://::1:80", "ws://[a]:80",
                            "ws://[]",   "ws://a b",  "wss://a",     "http://a",    "ws://a:1.5",
                            "ws://a\n",  "a",         "a.log",       "http://a:80", "a b:80",
                            "WSS://a"}) {
        EXPECT_THROW(WebSocketAddress{bad}, ConfigError) << bad;
    }
}

TEST(WebSocketAddress, IsToldFromAFile) {
    const test::TempDir folder;
    for (const char* address : {"ws://robot", "WSS://robot", "robot:8765", "[::1]:8765"})
        EXPECT_TRUE(is_websocket_address(address)) << address;
    for (const std::string& file :
         {std::string("robot"), std::string("robot.log"), std::string("a/robot:8765"),
          std::string("robot:x"), folder.put("robot:8765", "").string()})
        EXPECT_FALSE(is_websocket_address(file)) << file;
}

}  // namespace
}  // namespace hitos
