// SPDX-License-Identifier: GPL-3.0-or-later
// Server and clients as they see each other. All of it is the server's thread's.
#pragma once

#include <chrono>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <string>
#include <string_view>

namespace hitos::live {

/// A message of a channel, shared by all that it goes to.
struct Payload {
    std::uint64_t time_ns = 0;
    std::string json;
};

/// A client as the server sees it.
class Client {
  public:
    virtual ~Client() = default;
    virtual bool wants(std::size_t channel) const = 0;
    /// Takes the place of what still waits of that channel.
    virtual void offer(std::size_t channel, std::shared_ptr<const Payload> payload) = 0;
    /// Says that it is over, once all that waits has been sent.
    virtual void end() = 0;
};

/// A connection that is no client, or not yet.
class Visitor {
  public:
    virtual ~Visitor() = default;
    /// Whether it has asked for nothing yet.
    virtual bool idle() const = 0;
    /// Others wait: it is told so, and is gone.
    virtual void give_way() = 0;
};

/// The server as its connections see it.
class Stage {
  public:
    virtual ~Stage() = default;
    virtual std::chrono::milliseconds patience() const = 0;
    virtual const std::string& server_info_text() const = 0;
    virtual const std::string& advertisement_text() const = 0;
    /// Whether a page may ask for this host: no foreign name is to lead to a server that is this
    /// machine's alone.
    virtual bool answers_to(std::string_view host) const = 0;
    virtual bool full() const = 0;
    virtual void joins(const std::shared_ptr<Client>& client) = 0;
    virtual void leaves(const std::shared_ptr<Client>& client) = 0;
    virtual void comes(Visitor& visitor) = 0;
    virtual void goes(Visitor& visitor) = 0;
    /// Of the state as it is; null where there is nothing to tell.
    virtual std::shared_ptr<const Payload> payload(std::size_t channel) = 0;
};

}  // namespace hitos::live
