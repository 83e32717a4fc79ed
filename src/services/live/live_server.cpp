// SPDX-License-Identifier: GPL-3.0-or-later
#include "hitos/services/live/live_server.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <atomic>
#include <boost/asio/io_context.hpp>
#include <boost/asio/ip/tcp.hpp>
#include <boost/asio/post.hpp>
#include <boost/asio/steady_timer.hpp>
#include <boost/system/system_error.hpp>
#include <cctype>
#include <exception>
#include <functional>
#include <limits>
#include <mutex>
#include <string_view>
#include <thread>
#include <utility>
#include <vector>

#include "hitos/base/error.hpp"
#include "hitos/base/host_port.hpp"
#include "live_channels.hpp"
#include "live_connection.hpp"

namespace hitos {
namespace {

namespace asio = boost::asio;
using asio::ip::tcp;
using Code = boost::system::error_code;
using Clock = asio::steady_timer::clock_type;

constexpr std::size_t kMostVisits = 32;  // of visitors
/// What encoding may take of a processor: one part in so many.
constexpr int kShare = 5;
constexpr std::chrono::milliseconds kFarewell{1000};
constexpr std::chrono::milliseconds kGridPause{1000};

std::string name_of(const LiveServer::Address& address) {
    return fmt::format("{}:{}", bracketed(on_one_line(address.host)), address.port);
}

Error cannot_listen(const LiveServer::Address& address, const Code& error) {
    const std::string name = name_of(address);
    if (error == asio::error::address_in_use) {
        return Error(message(HITOS_TEXT("Errors",
                                        "nothing can be served at %1: another program has this "
                                        "port; name another one, or 0 for any that is free"),
                             name));
    }
    if (error == asio::error::access_denied) {
        return Error(message(HITOS_TEXT("Errors",
                                        "nothing can be served at %1: this program has no right to "
                                        "it; name a port from 1024 on"),
                             name));
    }
    if (error == boost::system::errc::address_not_available) {
        return Error(message(HITOS_TEXT("Errors",
                                        "nothing can be served at %1: this machine has no such "
                                        "address; 127.0.0.1 is for itself alone, 0.0.0.0 for all "
                                        "that reach it"),
                             name));
    }
    return Error(
        message(HITOS_TEXT("Errors", "nothing can be served at %1: %2"), name, error.message()));
}

tcp::endpoint endpoint_of(asio::io_context& context, const LiveServer::Address& address) {
    Code error;
    const auto numeric = asio::ip::make_address(address.host, error);
    if (!error) return {numeric, address.port};
    tcp::resolver resolver(context);
    const auto found = resolver.resolve(address.host, "", tcp::resolver::passive, error);
    if (error || found.empty()) {
        throw Error(message(HITOS_TEXT("Errors",
                                       "nothing can be served at %1: there is no host of this "
                                       "name; 127.0.0.1 is this machine for itself alone, 0.0.0.0 "
                                       "for all that reach it"),
                            name_of(address)));
    }
    return {found.begin()->endpoint().address(), address.port};
}

tcp::acceptor listening(asio::io_context& context, const LiveServer::Address& address) {
    const tcp::endpoint endpoint = endpoint_of(context, address);
    tcp::acceptor acceptor(context);
    try {
        acceptor.open(endpoint.protocol());
        acceptor.set_option(tcp::acceptor::reuse_address(true));
        acceptor.bind(endpoint);
        acceptor.listen();
    } catch (const boost::system::system_error& error) {
        throw cannot_listen(address, error.code());
    }
    return acceptor;
}

std::string in_small_letters(std::string host) {
    std::ranges::transform(host, host.begin(),
                           [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
    return host;
}

bool same_picture(const GridTiles& a, const GridTiles& b) {
    return a.area == b.area && a.tiles == b.tiles;
}

}  // namespace

class LiveServer::Impl final : public live::Stage {
  public:
    Impl(const Address& address, const std::string& name, std::chrono::milliseconds patience)
        : patience_(patience),
          server_info_(live::server_info(
              name, std::to_string(std::chrono::system_clock::now().time_since_epoch().count()))),
          advertisement_(live::advertisement()),
          payloads_(live::channels().size()),
          acceptor_(listening(context_, address)),
          pace_(context_),
          grid_pace_(context_),
          accept_pace_(context_),
          farewell_(context_) {
        const tcp::endpoint endpoint = acceptor_.local_endpoint();
        port_ = endpoint.port();
        if (endpoint.address().is_loopback()) {
            const std::string own = endpoint.address().to_string();
            hosts_ = {"localhost", "127.0.0.1", "::1", own};
            if (address.host != own) hosts_.push_back(in_small_letters(address.host));
        }
        accept_next();
        thread_ = std::jthread([this] { serve(); });
    }

    ~Impl() override {
        asio::post(context_, [this] { end(); });
        thread_.join();
        clients_.clear();
    }
    Impl(const Impl&) = delete;
    Impl& operator=(const Impl&) = delete;

    std::uint16_t port() const { return port_; }
    std::size_t clients() const { return count_; }

    void show(std::shared_ptr<const Snapshot> snapshot, std::optional<double> behind_s) {
        if (!snapshot) return;
        const std::scoped_lock lock(mutex_);
        next_ = Shown{std::move(snapshot), behind_s};
        if (!std::exchange(announced_, true)) asio::post(context_, [this] { take_next(); });
    }

    std::chrono::milliseconds patience() const override { return patience_; }
    const std::string& server_info_text() const override { return server_info_; }
    const std::string& advertisement_text() const override { return advertisement_; }

    bool answers_to(std::string_view host) const override {
        if (hosts_.empty()) return true;
        const auto place = host_and_port(host);
        return place && std::ranges::count(hosts_, in_small_letters(place->host)) > 0;
    }

    bool full() const override { return clients_.size() >= kMostClients; }

    void joins(const std::shared_ptr<live::Client>& client) override {
        clients_.push_back(client);
        count_ = clients_.size();
    }

    void leaves(const std::shared_ptr<live::Client>& client) override {
        std::erase(clients_, client);
        count_ = clients_.size();
        if (ending_ && clients_.empty()) context_.stop();
    }

    void comes(live::Visitor& visitor) override { visitors_.push_back(&visitor); }
    void goes(live::Visitor& visitor) override { std::erase(visitors_, &visitor); }

    std::shared_ptr<const live::Payload> payload(std::size_t channel) override {
        if (!payloads_[channel] && shown_.snapshot) {
            const Snapshot& snapshot = *shown_.snapshot;
            std::string text = live::channels()[channel].message({snapshot, shown_.behind_s});
            if (text.empty()) return nullptr;
            payloads_[channel] = std::make_shared<const live::Payload>(
                live::Payload{live::time_ns(snapshot), std::move(text)});
            if (channel == live::grid_channel()) grid_ = snapshot.step_grid;
        }
        return payloads_[channel];
    }

  private:
    struct Shown {
        std::shared_ptr<const Snapshot> snapshot;
        std::optional<double> behind_s;
    };

    /// Whatever happens to it is not to end the run.
    void serve() {
        while (!context_.stopped()) {
            try {
                context_.run();
            } catch (const std::exception&) {
                // As for want of memory for a message, which then is not sent.
            }
        }
    }

    void accept_next() {
        acceptor_.async_accept([this](Code error, tcp::socket socket) {
            if (error == asio::error::operation_aborted) return;
            if (error) {  // as when there are no more files to open: some will be closed
                accept_pace_.expires_after(std::chrono::milliseconds(100));
                accept_pace_.async_wait([this](Code aborted) {
                    if (!aborted) accept_next();
                });
                return;
            }
            // What waits in the system's buffer is not the newest.
            constexpr int kBuffer = 256 * 1024;
            Code ignored;
            socket.set_option(tcp::socket::send_buffer_size(kBuffer), ignored);
            socket.set_option(tcp::no_delay(true), ignored);
            // Who means to ask has asked soon.
            if (visitors_.size() == kMostVisits) {
                auto oldest = std::ranges::find_if(visitors_, &live::Visitor::idle);
                if (oldest == visitors_.end()) oldest = visitors_.begin();
                live::Visitor* const visitor = *oldest;
                visitors_.erase(oldest);
                visitor->give_way();
            }
            live::begin_connection(std::move(socket), *this);
            accept_next();
        });
    }

    /// The newest state, not before its time.
    void take_next() {
        if (Clock::now() < due_ && !ending_) {
            pace_.expires_at(due_);
            pace_.async_wait([this](Code aborted) {
                if (!aborted) take_next();
            });
            return;
        }
        {
            const std::scoped_lock lock(mutex_);
            announced_ = false;
            if (!next_.snapshot) return;
            shown_ = std::exchange(next_, {});
        }
        const auto begin = Clock::now();
        for (std::size_t channel = 0; channel < payloads_.size(); ++channel) {
            if (channel == live::grid_channel()) continue;
            payloads_[channel].reset();
            offer(channel);
        }
        look_at_grid();
        const auto end = Clock::now();
        due_ = end + (kShare - 1) * (end - begin);
    }

    /// It is great: told where it has changed, and no oftener than its time allows.
    void look_at_grid() {
        const std::size_t channel = live::grid_channel();
        if (!shown_.snapshot || same_picture(grid_, shown_.snapshot->step_grid)) return;
        if (Clock::now() < grid_due_ && !ending_) {
            grid_pace_.expires_at(grid_due_);
            grid_pace_.async_wait([this](Code aborted) {
                if (!aborted) look_at_grid();
            });
            return;
        }
        payloads_[channel].reset();
        const auto begin = Clock::now();
        offer(channel);
        const auto end = Clock::now();
        grid_due_ = end + std::max<Clock::duration>(kGridPause, (kShare - 1) * (end - begin));
    }

    void offer(std::size_t channel) {
        if (std::ranges::none_of(clients_, [&](auto& client) { return client->wants(channel); })) {
            return;
        }
        const auto text = payload(channel);
        for (const auto& client : clients_) client->offer(channel, text);
    }

    /// Whatever has not been told yet is, and then it is over.
    void end() {
        ending_ = true;
        Code ignored;
        acceptor_.close(ignored);
        farewell_.expires_after(kFarewell);  // first, whatever fails
        farewell_.async_wait([this](Code) { context_.stop(); });
        take_next();
        look_at_grid();
        const std::vector<std::shared_ptr<live::Client>> all = clients_;
        for (const auto& client : all) client->end();
        if (clients_.empty()) context_.stop();
    }

    const std::chrono::milliseconds patience_;
    const std::string server_info_;
    const std::string advertisement_;
    std::uint16_t port_ = 0;
    std::vector<std::string> hosts_;  // that it answers to; empty: any
    std::atomic<std::size_t> count_ = 0;

    std::mutex mutex_;
    Shown next_;  // with announced_, the other threads' too
    bool announced_ = false;

    // The thread's own.
    Shown shown_;
    std::vector<std::shared_ptr<const live::Payload>> payloads_;  // of what is shown, by channel
    GridTiles grid_;                                              // that the payload is of
    Clock::time_point due_;
    Clock::time_point grid_due_;
    std::vector<live::Visitor*> visitors_;  // the oldest first
    bool ending_ = false;

    asio::io_context context_{1};  // with it go the connections, which use what is above
    tcp::acceptor acceptor_;
    asio::steady_timer pace_;
    asio::steady_timer grid_pace_;
    asio::steady_timer accept_pace_;
    asio::steady_timer farewell_;
    std::vector<std::shared_ptr<live::Client>> clients_;
    std::jthread thread_;  // last: it uses everything above
};

LiveServer::LiveServer(const Address& address, const std::string& name,
                       std::chrono::milliseconds patience)
    : impl_(std::make_unique<Impl>(address, name, patience)) {}

LiveServer::~LiveServer() = default;

std::uint16_t LiveServer::port() const {
    return impl_->port();
}

std::size_t LiveServer::clients() const {
    return impl_->clients();
}

void LiveServer::show(std::shared_ptr<const Snapshot> snapshot, std::optional<double> behind_s) {
    impl_->show(std::move(snapshot), behind_s);
}

}  // namespace hitos
