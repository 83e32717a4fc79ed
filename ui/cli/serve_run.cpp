// SPDX-License-Identifier: GPL-3.0-or-later
#include "serve_run.hpp"

#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cstdint>
#include <cstdio>
#include <filesystem>

#include "hitos/base/error.hpp"
#include "hitos/base/host_port.hpp"
#include "hitos/base/text_input.hpp"

namespace hitos::cli {
namespace {

/// [HOST:]PORT, an address of IPv6 in brackets; nothing where it is none.
std::optional<LiveServer::Address> address_in(const std::string& text) {
    constexpr std::uint64_t kGreatest = 65535;
    if (const auto port = input::parse_whole(text); port && *port <= kGreatest)
        return LiveServer::Address{.port = static_cast<std::uint16_t>(*port)};
    const auto place = host_and_port(text);
    if (!place || !place->port) return std::nullopt;
    return LiveServer::Address{place->host, *place->port};
}

std::string complaint_of_address(const std::string& text) {
    return address_in(text) ? ""
                            : "found " + on_one_line(text) +
                                  "; expected PORT or HOST:PORT with a port from 0 (any free one) "
                                  "to 65535, as 8765, 0.0.0.0:8765 or [::1]:8765";
}

/// For links: what stands for all addresses of this machine leads to none.
std::string host_in_links(const std::string& host) {
    if (host == "0.0.0.0" || host == "::") {
        std::array<char, 256> name{};
        if (::gethostname(name.data(), name.size() - 1) == 0) return name.data();
    }
    return bracketed(host);
}

}  // namespace

void add_serve_option(CLI::App& command, std::string& address) {
    command
        .add_option("--serve", address,
                    "Show the map as it grows: a page for browsers, and the data for Foxglove, at "
                    "this port of this machine, or at HOST:PORT; 0 takes any free port, 0.0.0.0 as "
                    "host lets other machines look")
        ->type_name("[HOST:]PORT")
        ->check(&complaint_of_address);
}

ServeRun::ServeRun(const std::string& address, const std::string& log) {
    const LiveServer::Address where = *address_in(address);
    const std::string name =
        log == "-" ? "standard input" : std::filesystem::path(log).filename().string();
    try {
        server_ = std::make_unique<LiveServer>(where, "Hitos: " + (name.empty() ? log : name));
    } catch (const Error& error) {
        throw ConfigError("--serve", error.message());
    }
    const std::string link = fmt::format("{}:{}", host_in_links(where.host), server_->port());
    fmt::print(stderr, "the map as it grows: http://{0} (Foxglove: ws://{0})\n", on_one_line(link));
}

void ServeRun::look(RunWorker& worker, std::optional<double> behind_s) {
    if (server_->clients() == 0) return;
    std::shared_ptr<const Snapshot> latest = worker.latest_snapshot();
    if (latest && latest != shown_) {
        shown_ = std::move(latest);
        server_->show(shown_, behind_s);
    }
    const auto now = std::chrono::steady_clock::now();
    // Where the robot stands still there is nothing new to be made.
    const bool shows_it =
        shown_ && !shown_->grid_behind && shown_->revision == worker.progress().revision;
    if (now < due_ || shows_it) return;
    worker.request_snapshot();
    constexpr std::chrono::duration<double> kPause(0.1);
    constexpr double kTimesItself = 20.0;  // so that pictures take a twentieth of the run's time
    const std::chrono::duration<double> cost(shown_ ? kTimesItself * shown_->seconds : 0.0);
    due_ = now +
           std::chrono::duration_cast<std::chrono::steady_clock::duration>(std::max(kPause, cost));
}

void ServeRun::look_at_end(RunWorker& worker) {
    if (server_->clients() == 0) return;
    worker.request_snapshot();
    worker.wait();
    server_->show(worker.latest_snapshot(), std::nullopt);
}

}  // namespace hitos::cli
