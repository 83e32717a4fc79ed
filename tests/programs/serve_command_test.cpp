// SPDX-License-Identifier: GPL-3.0-or-later
// hitos-cli run --serve: who looks sees the run to its end, and the run does not mind.
#include <fcntl.h>
#include <fmt/format.h>
#include <gmock/gmock.h>
#include <sys/stat.h>
#include <unistd.h>

#include <array>
#include <boost/asio/io_context.hpp>
#include <boost/asio/ip/tcp.hpp>
#include <boost/beast/core.hpp>
#include <boost/beast/websocket.hpp>
#include <cstdint>
#include <cstdio>
#include <filesystem>
#include <map>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <string_view>
#include <thread>

#include "program.hpp"

namespace hitos::test {
namespace {

namespace asio = boost::asio;
namespace beast = boost::beast;
namespace websocket = beast::websocket;
using nlohmann::json;
using ::testing::HasSubstr;

/// Subscribes to everything, and keeps what came last of each topic.
class Onlooker {
  public:
    explicit Onlooker(std::uint16_t port) {
        beast::get_lowest_layer(stream_).connect({asio::ip::address_v4::loopback(), port});
        stream_.set_option(websocket::stream_base::decorator([](websocket::request_type& request) {
            request.set(beast::http::field::sec_websocket_protocol, "foxglove.websocket.v1");
        }));
        stream_.read_message_max(std::size_t{64} << 20U);
        stream_.handshake("localhost", "/");
    }

    /// False at the end of the connection.
    bool read() {
        beast::flat_buffer buffer;
        beast::error_code error;
        stream_.read(buffer, error);
        if (error) return false;
        const std::string message = beast::buffers_to_string(buffer.data());
        if (stream_.got_binary()) {
            last_[topics_.at(static_cast<unsigned char>(message[1]))] =
                json::parse(message.substr(13));
            return true;
        }
        const json text = json::parse(message);
        if (text["op"] != "advertise") return true;
        json wanted = json::array();
        for (const json& channel : text["channels"]) {
            topics_[channel["id"].get<unsigned>()] = channel["topic"].get<std::string>();
            wanted.push_back({{"id", channel["id"]}, {"channelId", channel["id"]}});
        }
        const json request = {{"op", "subscribe"}, {"subscriptions", wanted}};
        stream_.write(asio::buffer(request.dump()));
        return true;
    }
    bool has(const std::string& topic) const { return last_.count(topic) > 0; }
    const json& last(const std::string& topic) const { return last_.at(topic); }
    bool told_that_it_is_over() const {
        return stream_.reason().code == websocket::close_code::going_away;
    }

  private:
    asio::io_context context_;
    websocket::stream<asio::ip::tcp::socket> stream_{context_};
    std::map<unsigned, std::string> topics_;
    std::map<std::string, json> last_;
};

class ServeCommand : public ProgramTest {
  protected:
    std::string run_of(std::string_view log, std::string_view more, std::string_view out) const {
        return fmt::format("{} run {} --set filter.particles=20 --hashes {}.csv --out {} {}", cli_,
                           log, path(out), path(out), more);
    }
};

TEST_F(ServeCommand, WhoLooksSeesTheRunToItsEndWhichIsTheSameWithout) {
    // Through a pipe that waits, so that the run is not over before somebody looks.
    ASSERT_EQ(::mkfifo(path("pipe").c_str(), 0600), 0);
    const std::string tour = run_command("zcat " + log_).output;
    ASSERT_GT(tour.size(), 1000000U);
    const std::string line = run_of("- --follow", "--serve 0", "seen") + " < " + path("pipe");
    std::FILE* program = ::popen(("exec 2>&1; " + line).c_str(), "r");
    ASSERT_NE(program, nullptr);
    const int feed = ::open(path("pipe").c_str(), O_WRONLY | O_CLOEXEC);
    ASSERT_GE(feed, 0);
    const auto put = [feed](std::string_view bytes) {
        while (!bytes.empty()) {
            const ssize_t count = ::write(feed, bytes.data(), bytes.size());
            if (count <= 0) return;
            bytes.remove_prefix(static_cast<std::size_t>(count));
        }
    };
    std::string said;
    std::array<char, 4096> buffer{};
    const std::string_view sign = "the map as it grows: http://127.0.0.1:";
    while (said.find(sign) == std::string::npos || said.back() != '\n') {
        ASSERT_NE(std::fgets(buffer.data(), static_cast<int>(buffer.size()), program), nullptr);
        said += buffer.data();
    }
    const auto port =
        static_cast<std::uint16_t>(std::stoi(said.substr(said.find(sign) + sign.size())));
    EXPECT_THAT(said, HasSubstr(fmt::format("(Foxglove: ws://127.0.0.1:{})", port)));
    Onlooker onlooker(port);
    std::jthread rest_of_words([&] {  // else the program waits for its words to be read
        while (std::fgets(buffer.data(), static_cast<int>(buffer.size()), program) != nullptr) {
        }
    });
    const std::size_t half = tour.rfind('\n', tour.size() / 2) + 1;
    std::jthread feeder([&] { put(std::string_view(tour).substr(0, half)); });
    while (!onlooker.has("/run") && onlooker.read()) {
    }
    feeder.join();
    feeder = std::jthread([&] {
        put(std::string_view(tour).substr(half));
        ::close(feed);
    });
    while (onlooker.read()) {
    }
    feeder.join();
    rest_of_words.join();
    EXPECT_EQ(::pclose(program), 0);
    EXPECT_TRUE(onlooker.told_that_it_is_over());
    for (const char* topic : {"/tf", "/pose", "/path", "/particles", "/covariance", "/landmarks",
                              "/loops", "/scan", "/grid", "/run"}) {
        EXPECT_TRUE(onlooker.has(topic)) << topic;
    }
    ASSERT_TRUE(onlooker.has("/run"));
    EXPECT_EQ(onlooker.last("/run")["scans"], 1050);

    const std::string received = path("seen.received.log");
    const Outcome alone = shell(run_of(received, "--config " + path("seen/config.cfg"), "alone"));
    ASSERT_EQ(alone.status, 0) << alone.output;
    EXPECT_EQ(content(path("seen.csv")), content(path("alone.csv")));
    for (const char* name : {"/map.txt", "/trajectory.tum", "/grid_best.png", "/segments.txt"}) {
        EXPECT_EQ(content(path("seen") + name), content(path("alone") + name)) << name;
    }
}

TEST_F(ServeCommand, NobodyNeedsToLook) {
    const Outcome seen = shell(run_of(log_, "--serve 0", "seen"));
    ASSERT_EQ(seen.status, 0) << seen.output;
    const Outcome alone = shell(run_of(log_, "", "alone"));
    ASSERT_EQ(alone.status, 0) << alone.output;
    EXPECT_EQ(content(path("seen.csv")), content(path("alone.csv")));
    EXPECT_EQ(content(path("seen/map.txt")), content(path("alone/map.txt")));
}

TEST_F(ServeCommand, AddressesAreLookedAtFirst) {
    for (const char* address : {"x", "70000", "-1", ":8765", "a:b", "1:2:3", "::1:8765", "[::1]",
                                "[a]:80", "[::1]:70000", "8765x"}) {
        const Outcome outcome = shell(run_of(log_, fmt::format("--serve={}", address), "out"));
        EXPECT_EQ(outcome.status, 64) << address;
        EXPECT_THAT(outcome.output, HasSubstr("expected PORT or HOST:PORT")) << address;
    }
    const Outcome nowhere = shell(run_of(log_, "--serve 192.0.2.1:0", "out"));
    EXPECT_EQ(nowhere.status, 1);
    EXPECT_THAT(nowhere.output, HasSubstr("--serve: nothing can be served at 192.0.2.1:0: this "
                                          "machine has no such address"));
    EXPECT_FALSE(fs::exists(path("out")));
}

}  // namespace
}  // namespace hitos::test
