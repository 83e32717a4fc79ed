// SPDX-License-Identifier: GPL-3.0-or-later
#include "live/websocket.hpp"

#include <algorithm>
#include <boost/asio/connect.hpp>
#include <boost/asio/io_context.hpp>
#include <boost/asio/ip/tcp.hpp>
#include <boost/beast/core.hpp>
#include <boost/beast/websocket.hpp>
#include <chrono>
#include <filesystem>
#include <string>
#include <system_error>
#include <utility>

#include "hitos/base/host_port.hpp"
#include "hitos/base/message.hpp"
#include "hitos/base/translatable.hpp"
#include "hitos/capture/live_source.hpp"
#include "recordings/recording.hpp"

namespace hitos {
namespace {

namespace asio = boost::asio;
namespace beast = boost::beast;
namespace websocket = beast::websocket;
using boost::system::error_code;

constexpr std::string_view kScheme = "ws://";
constexpr std::string_view kSecureScheme = "wss://";
constexpr std::string_view kPage = "http://";
constexpr std::string_view kSecurePage = "https://";
constexpr std::chrono::seconds kPatience(5);  // to connect
constexpr std::chrono::seconds kSilence(10);  // after which a link that answers no ping is dead
constexpr std::chrono::milliseconds kLook(20);
constexpr std::size_t kFramePiece = std::size_t{1} << 16;  // that is read at once
constexpr std::size_t kFrameHead = 64;                     // that is kept of what is too large

/// However its letters are written.
bool begins(std::string_view url, std::string_view scheme) {
    const std::string_view head = url.substr(0, scheme.size());
    return beast::iequals({head.data(), head.size()}, {scheme.data(), scheme.size()});
}

[[noreturn]] void refuse(const std::string& url) {
    throw ConfigError(
        "log",
        HITOS_TEXT("Errors",
                   "found \"%1\", expected an address as ws://HOST:PORT, the port up to 65535"),
        url);
}

ConnectionError lost(const std::string& url, const error_code& error) {
    return {url,
            message(HITOS_TEXT("Errors", "the connection is lost: %1"), verbatim(error.message()))};
}

}  // namespace

bool is_websocket_address(std::string_view source) {
    for (const std::string_view scheme : {kScheme, kSecureScheme, kPage, kSecurePage})
        if (begins(source, scheme)) return true;
    // Whatever the number: no file is called so.
    const std::size_t colon = source.rfind(':');
    const bool numbered =
        colon != std::string_view::npos && colon > 0 && colon + 1 < source.size() &&
        std::ranges::all_of(source.substr(colon + 1), [](char c) { return c >= '0' && c <= '9'; });
    std::error_code unknown;
    return numbered && source.find('/') == std::string_view::npos &&
           !std::filesystem::exists(std::filesystem::path(source), unknown);
}

WebSocketAddress::WebSocketAddress(const std::string& url) {
    if (begins(url, kSecureScheme)) {
        throw ConfigError("log",
                          HITOS_TEXT("Errors",
                                     "found \"%1\"; encrypted connections are not spoken, expected "
                                     "ws://HOST:PORT, for instance through a tunnel of ssh"),
                          url);
    }
    std::string_view rest = url;
    const bool named = begins(rest, kScheme);
    if (named) rest.remove_prefix(kScheme.size());
    if (const std::size_t slash = rest.find('/'); slash != std::string_view::npos) {
        path = rest.substr(slash);
        rest = rest.substr(0, slash);
    }
    const bool odd = std::ranges::any_of(
        url, [](char c) { return static_cast<unsigned char>(c) <= ' ' || c == '\x7f'; });
    const auto place = host_and_port(rest);
    if (odd || !place || place->port == 0 || (!named && !place->port)) refuse(url);
    host = place->host;
    if (place->port) port = std::to_string(*place->port);
}

const std::uint64_t WebSocket::kLargest = kLargestMessage + kFrameHead;

struct WebSocket::Connection {
    std::string url;
    asio::io_context io;
    websocket::stream<beast::tcp_stream> stream{io};
    beast::flat_buffer buffer{WebSocket::kLargest + kFramePiece};
    std::string head;        // of a frame that is too large
    std::uint64_t size = 0;  // of what has come of the frame
    bool reading = false;
    bool read = false;  // a piece
    bool whole = false;
    error_code error;

    /// Until what was begun has come to its end, or nobody waits for it any more: then nobody may
    /// use the connection, which ends with it.
    template <class Begin>
    void wait(const Begin& begin, const GoesOn& goes_on) {
        bool done = false;
        begin([&](const error_code& came, auto&&...) {
            error = came;
            done = true;
        });
        while (!done) {
            io.restart();
            io.run_one_for(kLook);
            if (done || goes_on()) continue;
            error = asio::error::operation_aborted;
            return;
        }
    }
};

WebSocket::WebSocket(const WebSocketAddress& address, const std::string& url,
                     const std::string& protocols, const GoesOn& goes_on)
    : connection_(std::make_unique<Connection>()) {
    Connection& link = *connection_;
    link.url = url;
    const auto check = [&] {
        if (!link.error) return;
        throw ConnectionError(url, message(HITOS_TEXT("Errors", "cannot be connected to: %1"),
                                           verbatim(link.error.message())));
    };
    asio::ip::tcp::resolver resolver(link.io);
    const auto places = resolver.resolve(address.host, address.port, link.error);
    check();
    auto& tcp = beast::get_lowest_layer(link.stream);
    tcp.expires_after(kPatience);
    link.wait([&](auto done) { tcp.async_connect(places, done); }, goes_on);
    check();
    tcp.expires_never();  // from here on the stream's own times count
    websocket::stream_base::timeout times{};
    times.handshake_timeout = kPatience;
    times.idle_timeout = kSilence;
    times.keep_alive_pings = true;
    link.stream.set_option(times);
    link.stream.set_option(
        websocket::stream_base::decorator([&protocols](websocket::request_type& request) {
            request.set(beast::http::field::sec_websocket_protocol, protocols);
        }));
    link.stream.read_message_max(0);  // what is too large is passed over here
    websocket::response_type answer;
    link.wait(
        [&](auto done) {
            const std::string host = bracketed(address.host) + ":" + address.port;
            link.stream.async_handshake(answer, host, address.path, done);
        },
        goes_on);
    if (link.error == websocket::error::upgrade_declined) {
        throw ConnectionError(
            url,
            message(HITOS_TEXT("Errors",
                               "is no server of the Foxglove protocol: it answers \"%1\" where "
                               "a WebSocket is asked for"),
                    answer.result_int()));
    }
    check();
    const std::string agreed(answer[beast::http::field::sec_websocket_protocol]);
    if (agreed.empty() || protocols.find(agreed) == std::string::npos) {
        throw ConnectionError(
            url, message(HITOS_TEXT("Errors",
                                    "is no server of the Foxglove protocol: of %1 it speaks none"),
                         protocols));
    }
}

WebSocket::~WebSocket() = default;

std::optional<WebSocket::Frame> WebSocket::next() {
    Connection& link = *connection_;
    if (std::exchange(link.whole, false)) {
        link.buffer.clear();
        link.head.clear();
        link.size = 0;
    }
    const auto until = std::chrono::steady_clock::now() + kLook;
    while (!link.whole) {
        if (!link.reading) {
            link.reading = true;
            link.stream.async_read_some(link.buffer, kFramePiece,
                                        [&link](const error_code& came, std::size_t bytes) {
                                            link.error = came;
                                            link.size += bytes;
                                            link.reading = false;
                                            link.read = true;
                                        });
        }
        link.io.restart();
        while (!link.read && link.io.run_one_until(until) > 0) {
        }
        if (!std::exchange(link.read, false)) return std::nullopt;
        if (link.error) throw lost(link.url, link.error);
        if (link.size > kLargest) {
            const auto begin = link.buffer.cdata();
            if (link.head.empty())
                link.head.assign(static_cast<const char*>(begin.data()), kFrameHead);
            link.buffer.clear();
        }
        link.whole = link.stream.is_message_done();
    }
    const auto bytes = link.buffer.cdata();
    std::string_view kept(static_cast<const char*>(bytes.data()), bytes.size());
    if (link.size > kLargest) kept = link.head;
    return Frame{kept, link.stream.got_text(), link.size};
}

void WebSocket::send(const std::string& text) {
    Connection& link = *connection_;
    error_code error;
    link.stream.text(true);
    link.stream.write(asio::buffer(text), error);
    if (error) throw lost(link.url, error);
}

}  // namespace hitos
