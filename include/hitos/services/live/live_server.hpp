// SPDX-License-Identifier: GPL-3.0-or-later
// A run as it goes on, for whoever looks: Foxglove's WebSocket protocol and a page that draws what
// it tells, both on one port. Read only; docs/live.md has the topics.
#pragma once

#include <chrono>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <string>

#include "hitos/services/run/run_worker.hpp"

namespace hitos {

/// Serves on a thread of its own. Every member may be called from any thread.
class LiveServer {
  public:
    /// Where it listens; port 0 is any that is free.
    struct Address {
        std::string host = "127.0.0.1";  ///< a name or an address of this machine
        std::uint16_t port = 0;          ///< 0: any free one
    };
    /// More than these are refused.
    static constexpr std::size_t kMostClients = 32;
    /// A client that takes nothing for that long is closed.
    static constexpr std::chrono::milliseconds kPatience{10000};

    /// `name` is what clients call the server. Throws Error where it cannot listen there.
    LiveServer(const Address& address, const std::string& name,
               std::chrono::milliseconds patience = kPatience);
    /// Shows what was shown last to its end, which takes a second at the most, and says that it is
    /// over.
    ~LiveServer();
    LiveServer(const LiveServer&) = delete;
    LiveServer& operator=(const LiveServer&) = delete;

    std::uint16_t port() const;
    /// Those that are connected: where there are none, no snapshot needs to be made.
    std::size_t clients() const;
    /// Never waits for a client, of which each gets the newest that it can take. `behind_s`: how
    /// far the run is behind what comes in, where that is known.
    void show(std::shared_ptr<const Snapshot> snapshot, std::optional<double> behind_s = {});

  private:
    class Impl;
    std::unique_ptr<Impl> impl_;
};

}  // namespace hitos
