// SPDX-License-Identifier: GPL-3.0-or-later
// The server as its clients meet it, on a port of this machine.
#include "hitos/services/live/live_server.hpp"

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <boost/asio/io_context.hpp>
#include <boost/asio/ip/tcp.hpp>
#include <boost/beast/core.hpp>
#include <boost/beast/http.hpp>
#include <boost/beast/websocket.hpp>
#include <chrono>
#include <map>
#include <memory>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <thread>
#include <utility>
#include <vector>

#include "hitos/base/error.hpp"
#include "live/live_channels.hpp"
#include "live/live_mailbox.hpp"
#include "shown_snapshots.hpp"
#include "support.hpp"

namespace hitos {
namespace {

namespace asio = boost::asio;
namespace beast = boost::beast;
namespace http = beast::http;
namespace websocket = beast::websocket;
using asio::ip::tcp;
using nlohmann::json;
using test::full_snapshot;
using test::shared;
using test::snapshot_after;
using ::testing::HasSubstr;
using namespace std::chrono_literals;

constexpr auto kLong = 1h;  // no test waits for it

tcp::endpoint at(std::uint16_t port) {
    return {asio::ip::address_v4::loopback(), port};
}

/// What one message with data holds.
struct Data {
    std::uint32_t subscription = 0;
    std::uint64_t time_ns = 0;
    json message;
};

/// A client that waits for whatever it asks for.
class WebClient {
  public:
    explicit WebClient(std::uint16_t port, const std::string& protocols = "foxglove.websocket.v1",
                       int receive_buffer = 0) {
        tcp::socket& socket = beast::get_lowest_layer(stream_);
        socket.open(tcp::v4());
        if (receive_buffer > 0) {
            socket.set_option(tcp::socket::receive_buffer_size(receive_buffer));
        }
        socket.connect(at(port));
        stream_.set_option(
            websocket::stream_base::decorator([protocols](websocket::request_type& request) {
                request.set(http::field::sec_websocket_protocol, protocols);
            }));
        stream_.read_message_max(std::size_t{64} << 20U);
        stream_.handshake(response_, fmt::format("127.0.0.1:{}", port), "/", error_);
    }

    bool connected() const { return !error_; }
    const websocket::response_type& response() const { return response_; }

    void send(const std::string& text, bool as_text = true) {
        stream_.text(as_text);
        stream_.write(asio::buffer(text));
    }
    void subscribe(std::uint32_t id, std::string_view topic) {
        std::size_t channel = 0;
        while (live::channels()[channel].topic != topic) ++channel;
        const json wanted = {{"id", id}, {"channelId", channel}};
        const json request = {{"op", "subscribe"}, {"subscriptions", json::array({wanted})}};
        send(request.dump());
    }

    /// The next message; nothing where the connection ended.
    std::optional<std::string> read() {
        buffer_.clear();
        stream_.read(buffer_, error_);
        if (error_) return std::nullopt;
        return beast::buffers_to_string(buffer_.data());
    }
    json text() {
        const auto message = read();
        EXPECT_TRUE(message && stream_.got_text()) << error_.message();
        return message ? json::parse(*message) : json();
    }
    std::optional<Data> next_data() {
        const auto message = read();
        if (!message) return std::nullopt;
        EXPECT_TRUE(stream_.got_binary());
        EXPECT_GE(message->size(), 13U);
        EXPECT_EQ(message->front(), 1);
        const auto number = [&](std::size_t from, unsigned bytes) {
            std::uint64_t value = 0;
            for (unsigned i = 0; i < bytes; ++i) {
                value |= std::uint64_t{static_cast<unsigned char>((*message)[from + i])}
                         << (8U * i);
            }
            return value;
        };
        return Data{static_cast<std::uint32_t>(number(1, 4)), number(5, 8),
                    json::parse(message->substr(13))};
    }
    Data data() {
        const auto found = next_data();
        EXPECT_TRUE(found) << error_.message();
        return found.value_or(Data{});
    }
    /// What is said to all.
    void pass_greeting() {
        EXPECT_EQ(text()["op"], "serverInfo");
        EXPECT_EQ(text()["op"], "advertise");
    }
    websocket::close_reason reason() const { return stream_.reason(); }
    void close() { stream_.close(websocket::close_code::normal); }

  private:
    asio::io_context context_;
    websocket::stream<tcp::socket> stream_{context_};
    beast::flat_buffer buffer_;
    websocket::response_type response_;
    beast::error_code error_;
};

http::response<http::string_body> answer(std::uint16_t port, http::verb method,
                                         const std::string& target, const std::string& host) {
    asio::io_context context;
    tcp::socket socket(context);
    socket.connect(at(port));
    http::request<http::empty_body> request{method, target, 11};
    request.set(http::field::host, host);
    http::write(socket, request);
    beast::flat_buffer buffer;
    http::response_parser<http::string_body> parser;
    if (method == http::verb::head) parser.skip(true);
    http::read(socket, buffer, parser);
    return parser.release();
}

/// What is said to who asks for a WebSocket and gets none.
http::response<http::string_body> refusal(std::uint16_t port, const std::string& protocols) {
    asio::io_context context;
    tcp::socket socket(context);
    socket.connect(at(port));
    http::request<http::empty_body> request{http::verb::get, "/", 11};
    request.set(http::field::host, "localhost");
    request.set(http::field::connection, "Upgrade");
    request.set(http::field::upgrade, "websocket");
    request.set(http::field::sec_websocket_version, "13");
    request.set(http::field::sec_websocket_key, "dGhlIHNhbXBsZSBub25jZQ==");
    request.set(http::field::sec_websocket_protocol, protocols);
    http::write(socket, request);
    beast::flat_buffer buffer;
    http::response<http::string_body> response;
    http::read(socket, buffer, response);
    return response;
}

http::response<http::string_body> page_of(const LiveServer& server, const std::string& target) {
    return answer(server.port(), http::verb::get, target, "localhost");
}

/// For a server's thread, which does what it does a moment later.
void wait_until(const auto& condition) {
    while (!condition()) std::this_thread::sleep_for(1ms);
}

TEST(LiveServerTest, GreetsThenTellsWhatIsSubscribedTo) {
    LiveServer server({}, "a tour", kLong);
    EXPECT_NE(server.port(), 0);
    EXPECT_EQ(server.clients(), 0U);
    WebClient client(server.port());
    ASSERT_TRUE(client.connected());
    EXPECT_EQ(client.response()[http::field::sec_websocket_protocol], "foxglove.websocket.v1");
    EXPECT_EQ(server.clients(), 1U);
    EXPECT_EQ(client.text()["name"], "a tour");
    EXPECT_EQ(client.text()["channels"].size(), live::channels().size());
    server.show(shared(full_snapshot()), 0.5);
    std::uint32_t id = 100;
    for (const live::Channel& channel : live::channels()) {
        client.subscribe(++id, channel.topic);
        const Data data = client.data();
        EXPECT_EQ(data.subscription, id);
        EXPECT_EQ(data.time_ns, 3000000000U);
        const json schema = channel.schema();
        for (const json& name : schema["required"]) {
            EXPECT_TRUE(data.message.contains(name.get<std::string>())) << channel.topic << name;
        }
    }
}

TEST(LiveServerTest, SpeaksEitherProtocolAndNoOther) {
    const LiveServer server({}, "a tour", kLong);
    EXPECT_EQ(WebClient(server.port(), "foxglove.sdk.v1").response()["Sec-WebSocket-Protocol"],
              "foxglove.sdk.v1");
    const WebClient both(server.port(), "foxglove.sdk.v1, foxglove.websocket.v1");
    EXPECT_EQ(both.response()["Sec-WebSocket-Protocol"], "foxglove.websocket.v1");
    EXPECT_FALSE(WebClient(server.port(), "chat").connected());
    EXPECT_EQ(refusal(server.port(), "chat").result(), http::status::bad_request);
}

TEST(LiveServerTest, SeveralClientsSeeTheSame) {
    LiveServer server({}, "a tour", kLong);
    WebClient first(server.port());
    WebClient second(server.port());
    for (WebClient* client : {&first, &second}) {
        client->pass_greeting();
        client->subscribe(1, "/run");
    }
    first.subscribe(2, "/tf");
    server.show(shared(snapshot_after(5)));
    std::map<std::uint32_t, json> seen;
    for (int i = 0; i < 2; ++i) {
        const Data data = first.data();
        seen[data.subscription] = data.message;
    }
    EXPECT_EQ(seen[1]["scans"], 5);
    EXPECT_EQ(seen[2]["translation"]["x"], 4.0);
    EXPECT_EQ(second.data().message, seen[1]);
}

TEST(LiveServerTest, WhatIsNotUnderstoodIsAnsweredAndTheConnectionStays) {
    LiveServer server({}, "a tour", kLong);
    WebClient client(server.port());
    client.pass_greeting();
    client.send(R"({"op":"getParameters"})");
    EXPECT_EQ(client.text()["level"], 1);
    client.send("{");
    EXPECT_EQ(client.text()["level"], 2);
    client.send("\x01\x02", false);
    EXPECT_EQ(client.text()["level"], 2);
    server.show(shared(snapshot_after(2)));
    client.subscribe(1, "/run");
    EXPECT_EQ(client.data().message["scans"], 2);
}

TEST(LiveServerTest, WhoTalksNonsenseOrTooLongIsClosed) {
    const LiveServer server({}, "a tour", kLong);
    WebClient talker(server.port());
    talker.pass_greeting();
    for (int i = 0; i <= live::Mailbox::kMostWrong; ++i) talker.send("?");
    wait_until([&] { return server.clients() == 0; });
    WebClient longer(server.port());
    longer.pass_greeting();
    longer.send(std::string(70000, ' '));
    wait_until([&] { return server.clients() == 0; });
}

TEST(LiveServerTest, WhoDoesNotReadHasTheNewestAloneWaiting) {
    constexpr std::uint64_t kStates = 60;
    constexpr std::uint64_t kPath = 1990;  // poses: some 200 kB each time
    LiveServer server({}, "a tour", kLong);
    WebClient slow(server.port(), "foxglove.websocket.v1", 32 * 1024);
    slow.pass_greeting();
    slow.subscribe(1, "/path");
    WebClient fast(server.port());
    fast.pass_greeting();
    fast.subscribe(1, "/run");
    std::weak_ptr<const Snapshot> former;
    for (std::uint64_t i = 1; i <= kStates; ++i) {
        const auto state = shared(snapshot_after(kPath + i));
        server.show(state);
        EXPECT_EQ(fast.data().message["scans"], kPath + i);
        if (i == kStates / 2) former = state;
    }
    EXPECT_TRUE(former.expired());
    // What the system's buffers took of the first ones, and what waits.
    std::uint64_t messages = 1;
    while (slow.data().time_ns != (kPath + kStates) * 1000000000) ++messages;
    EXPECT_LT(messages, kStates / 2);
}

TEST(LiveServerTest, WhoTakesNothingForLongIsClosed) {
    LiveServer server({}, "a tour", 100ms);
    WebClient idle(server.port());
    idle.subscribe(1, "/path");
    std::uint64_t scans = 1500;
    wait_until([&] {
        server.show(shared(snapshot_after(++scans)));
        return server.clients() == 0;
    });
}

TEST(LiveServerTest, MoreClientsThanThereMayBeAreRefused) {
    const LiveServer server({}, "a tour", kLong);
    std::vector<std::unique_ptr<WebClient>> clients;
    for (std::size_t i = 0; i < LiveServer::kMostClients; ++i) {
        clients.push_back(std::make_unique<WebClient>(server.port()));
        ASSERT_TRUE(clients.back()->connected());
    }
    EXPECT_FALSE(WebClient(server.port()).connected());
    EXPECT_EQ(refusal(server.port(), "foxglove.websocket.v1").result(),
              http::status::service_unavailable);
    EXPECT_EQ(page_of(server, "/").result(), http::status::ok);
    clients.pop_back();
    wait_until([&] { return server.clients() < LiveServer::kMostClients; });
    EXPECT_TRUE(WebClient(server.port()).connected());
}

TEST(LiveServerTest, ServesOnePageThatAsksForNothingElse) {
    const LiveServer server({}, "a tour", kLong);
    const auto page = page_of(server, "/");
    EXPECT_EQ(page.result(), http::status::ok);
    EXPECT_EQ(page[http::field::content_type], "text/html; charset=utf-8");
    EXPECT_EQ(page[http::field::cache_control], "no-store");
    EXPECT_EQ(page["X-Content-Type-Options"], "nosniff");
    const std::string policy(page["Content-Security-Policy"]);
    EXPECT_THAT(policy, HasSubstr("default-src 'none'"));
    EXPECT_THAT(policy, HasSubstr("connect-src 'self'"));
    const std::string nonce = policy.substr(policy.find("'nonce-") + 7, 32);
    EXPECT_THAT(page.body(), HasSubstr("<script nonce=\"" + nonce + "\">"));
    EXPECT_THAT(page.body(), HasSubstr("<style nonce=\"" + nonce + "\">"));
    EXPECT_THAT(page.body(), ::testing::Not(HasSubstr("NONCE")));
    EXPECT_THAT(page.body(), ::testing::Not(HasSubstr("src=")));
    EXPECT_THAT(page.body(), ::testing::Not(::testing::ContainsRegex("https?://")));
    EXPECT_THAT(page.body(), ::testing::EndsWith("</html>\n"));
    const std::string other(page_of(server, "/?")["Content-Security-Policy"]);
    EXPECT_THAT(other, ::testing::Not(HasSubstr(nonce)));
    for (const char* target : {"/favicon.ico", "/../etc/passwd", "//", "*"}) {
        EXPECT_EQ(page_of(server, target).result(), http::status::not_found) << target;
    }
    const auto head = answer(server.port(), http::verb::head, "/", "localhost");
    EXPECT_EQ(head.result(), http::status::ok);
    EXPECT_TRUE(head.body().empty());
    const auto post = answer(server.port(), http::verb::post, "/", "localhost");
    EXPECT_EQ(post.result(), http::status::method_not_allowed);
}

TEST(LiveServerTest, ForeignNamesDoNotLeadToThisMachine) {
    const LiveServer server({}, "a tour", kLong);
    for (const char* host : {"localhost", "LOCALHOST:1", "127.0.0.1:80", "[::1]:8765"}) {
        EXPECT_EQ(answer(server.port(), http::verb::get, "/", host).result(), http::status::ok);
    }
    for (const char* host :
         {"example.org", "127.0.0.1.example.org:8765", "", "[::1", "192.0.2.1"}) {
        EXPECT_EQ(answer(server.port(), http::verb::get, "/", host).result(),
                  http::status::forbidden)
            << host;
    }
    const LiveServer open({"0.0.0.0", 0}, "a tour", kLong);
    EXPECT_EQ(answer(open.port(), http::verb::get, "/", "example.org").result(), http::status::ok);
}

TEST(LiveServerTest, SaysWhyItCannotListen) {
    const LiveServer server({}, "a tour", kLong);
    const auto words = [](const LiveServer::Address& address) {
        return test::message_of<Error>([&] { const LiveServer other(address, "a tour"); });
    };
    EXPECT_THAT(
        words({"127.0.0.1", server.port()}),
        HasSubstr(fmt::format("127.0.0.1:{}: another program has this port", server.port())));
    EXPECT_THAT(words({"192.0.2.1", 0}),
                HasSubstr("192.0.2.1:0: this machine has no such address"));
    EXPECT_THAT(words({"no.such.host.invalid", 0}), HasSubstr("there is no host of this name"));
}

TEST(LiveServerTest, TheLastStateIsSentBeforeTheEnd) {
    auto server = std::make_unique<LiveServer>(LiveServer::Address{}, "a tour", kLong);
    WebClient client(server->port());
    client.pass_greeting();
    client.subscribe(1, "/run");
    client.subscribe(2, "/grid");
    Snapshot state = full_snapshot();
    server->show(shared(state));
    EXPECT_EQ(client.data().subscription, 1U);
    EXPECT_EQ(client.data().subscription, 2U);
    state.steps = 7;
    state.scan.time_s = 7.0;
    state.step_grid.area.end_row -= 1;  // another one, before a grid's time
    server->show(shared(state));
    std::jthread ending([&] { server.reset(); });
    std::map<std::uint32_t, std::uint64_t> last;
    while (const auto data = client.next_data()) last[data->subscription] = data->time_ns;
    EXPECT_THAT(last,
                ::testing::ElementsAre(std::pair(1U, 7000000000U), std::pair(2U, 7000000000U)));
    EXPECT_EQ(client.reason().code, websocket::close_code::going_away);
}

TEST(LiveServerTest, EndsWithClientsThatDoNotRead) {
    auto server = std::make_unique<LiveServer>(LiveServer::Address{}, "a tour", kLong);
    WebClient client(server->port());
    client.subscribe(1, "/path");
    for (std::uint64_t i = 0; i < 20; ++i) server->show(shared(snapshot_after(1500 + i)));
    server.reset();
}

}  // namespace
}  // namespace hitos
