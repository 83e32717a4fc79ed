// SPDX-License-Identifier: GPL-3.0-or-later
// The server and those who ask for nothing, for nonsense or for what is not there.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <boost/asio/buffer.hpp>
#include <boost/asio/io_context.hpp>
#include <boost/asio/ip/tcp.hpp>
#include <boost/asio/read.hpp>
#include <boost/asio/write.hpp>
#include <boost/system/error_code.hpp>
#include <chrono>
#include <cstddef>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "hitos/services/live/live_server.hpp"

namespace hitos {
namespace {

namespace asio = boost::asio;
using asio::ip::tcp;
using ::testing::HasSubstr;
using ::testing::StartsWith;
using namespace std::chrono_literals;

/// A connection without any protocol.
class Visitor {
  public:
    explicit Visitor(const LiveServer& server,
                     const asio::ip::address& address = asio::ip::address_v4::loopback()) {
        socket_.connect({address, server.port()});
    }
    void say(const std::string& text) {
        boost::system::error_code ignored;  // where it was answered before its end
        asio::write(socket_, asio::buffer(text), ignored);
    }
    void says_no_more() { socket_.shutdown(tcp::socket::shutdown_send); }
    /// All that comes until the end, which is to be one in good order.
    std::string answer() {
        std::string text;
        boost::system::error_code error;
        asio::read(socket_, asio::dynamic_buffer(text), error);
        EXPECT_EQ(error, asio::error::eof) << error.message();
        return text;
    }

  private:
    asio::io_context context_;
    tcp::socket socket_{context_};
};

std::string answer_to(const LiveServer& server, const std::string& text) {
    Visitor visitor(server);
    visitor.say(text);
    return visitor.answer();
}

constexpr const char* kPlain = "GET / HTTP/1.1\r\nHost: localhost\r\n\r\n";

TEST(LiveVisitors, ManyThatAskForNothingKeepNobodyOut) {
    const LiveServer server({}, "a tour", 1h);
    std::vector<std::unique_ptr<Visitor>> idle;
    for (int i = 0; i < 100; ++i) {
        idle.push_back(std::make_unique<Visitor>(server));
        if (i % 2 == 1) idle.back()->say("GET / HT");  // nor do those who never come to the end
    }
    for (int i = 0; i < 3; ++i) EXPECT_THAT(answer_to(server, kPlain), StartsWith("HTTP/1.1 200"));
    const std::string refused = idle.front()->answer();
    EXPECT_THAT(refused, StartsWith("HTTP/1.1 503"));
    EXPECT_THAT(refused, HasSubstr("Retry-After"));
}

TEST(LiveVisitors, ComeByAddressesOfIpv6Too) {
    const auto here = asio::ip::address_v6::loopback();
    asio::io_context context;
    boost::system::error_code error;
    tcp::acceptor probe(context);
    probe.open(tcp::v6(), error);
    if (!error) probe.bind({here, 0}, error);
    if (error) GTEST_SKIP() << "this machine has no IPv6: " << error.message();
    const LiveServer server({"::1", 0}, "a tour", 1h);
    for (const char* host : {"[::1]", "[::1]:8765", "localhost:8765"}) {
        Visitor visitor(server, here);
        visitor.say(std::string("GET / HTTP/1.1\r\nHost: ") + host + "\r\n\r\n");
        EXPECT_THAT(visitor.answer(), StartsWith("HTTP/1.1 200")) << host;
    }
    Visitor foreign(server, here);
    foreign.say("GET / HTTP/1.1\r\nHost: [::2]\r\n\r\n");
    EXPECT_THAT(foreign.answer(), StartsWith("HTTP/1.1 403"));
}

TEST(LiveVisitors, WhoAsksForNothingIsToldSo) {
    const LiveServer server({}, "a tour", 100ms);
    EXPECT_THAT(answer_to(server, ""), StartsWith("HTTP/1.1 408"));
    EXPECT_THAT(answer_to(server, "GET / HTTP/1.1\r\nHost: loc"), StartsWith("HTTP/1.1 408"));
    const LiveServer patient({}, "a tour", 1h);
    Visitor gone(patient);
    gone.says_no_more();
    EXPECT_EQ(gone.answer(), "");
}

TEST(LiveVisitors, WhatIsNoRequestIsAnsweredAllTheSame) {
    const LiveServer server({}, "a tour", 1h);
    const std::string host = " HTTP/1.1\r\nHost: localhost\r\n";
    const std::string much(std::size_t{1} << 20, 'a');
    const std::vector<std::pair<std::string, const char*>> requests{
        {"nonsense\r\n\r\n", "400"},
        {std::string("\0\x16\x03\x01\r\n\r\n", 8), "400"},  // as of TLS
        {"GET / HTTP/1.1\r\nno header\r\n\r\n", "400"},
        {"GET /a b HTTP/1.1\r\n\r\n", "400"},
        {"GET /" + much, "414"},
        {"GET /" + std::string(8000, 'a') + host + "\r\n", "414"},
        {"GET /" + host + "X: " + much, "431"},
        {"POST /" + host + "Content-Length: 1048576\r\n\r\n" + much, "405"},
        {"DELETE /" + host + "\r\n", "405"},
        {"BREW /" + host + "\r\n", "405"},
        {"GET /" + host + "Content-Length: 1048576\r\n\r\n" + much, "200"},
    };
    for (const auto& [text, status] : requests) {
        EXPECT_THAT(answer_to(server, text), StartsWith(std::string("HTTP/1.1 ") + status))
            << text.substr(0, 40);
    }
    Visitor half(server);
    half.say("GET / HTTP/1.1\r\nHo");
    half.says_no_more();
    EXPECT_THAT(half.answer(), StartsWith("HTTP/1.1 400"));
}

}  // namespace
}  // namespace hitos
