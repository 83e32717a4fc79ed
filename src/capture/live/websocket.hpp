// SPDX-License-Identifier: GPL-3.0-or-later
// A connection by WebSocket [RFC 6455].
#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <utility>

#include "hitos/base/error.hpp"
#include "hitos/base/message.hpp"

namespace hitos {

/// "ws://robot:8765/path", "ws://[::1]:8765".
struct WebSocketAddress {
    std::string host;
    std::string port = "8765";
    std::string path = "/";

    /// Throws ConfigError where it is none, or asks for what is not there (wss).
    explicit WebSocketAddress(const std::string& url);
};

/// What becomes of a connection, and of one that does not come about.
class ConnectionError : public FileError {
  public:
    ConnectionError(const std::string& url, Message why)
        : FileError(url, why), why_(std::move(why)) {}
    /// Without the address.
    const Message& why() const { return why_; }

  private:
    Message why_;
};

class WebSocket {
  public:
    /// Whether one that is being waited for is to go on.
    using GoesOn = std::function<bool()>;

    /// Connects and agrees on one of the protocols ("a, b"), which may take some seconds. Throws
    /// ConnectionError, also where it is not to go on.
    WebSocket(const WebSocketAddress& address, const std::string& url, const std::string& protocols,
              const GoesOn& goes_on);
    ~WebSocket();
    WebSocket(const WebSocket&) = delete;
    WebSocket& operator=(const WebSocket&) = delete;

    static const std::uint64_t kLargest;
    struct Frame {
        std::string_view bytes;  ///< valid until the next call
        bool text = false;
        /// Beyond kLargest `bytes` are its first ones alone; the others were passed over.
        std::uint64_t size = 0;
        bool whole() const { return size == bytes.size(); }
    };
    /// What has come; nothing where nothing comes within some milliseconds. Throws
    /// ConnectionError where it is lost.
    std::optional<Frame> next();
    /// Throws ConnectionError where it cannot be sent.
    void send(const std::string& text);

  private:
    struct Connection;
    std::unique_ptr<Connection> connection_;
};

}  // namespace hitos
