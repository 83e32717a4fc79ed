// SPDX-License-Identifier: GPL-3.0-or-later
// What servers of the Foxglove WebSocket protocol say, and how what comes from them is received.
#include <gmock/gmock.h>

#include <atomic>
#include <boost/asio/ip/tcp.hpp>
#include <boost/beast/core.hpp>
#include <boost/beast/websocket.hpp>
#include <chrono>
#include <functional>
#include <mutex>
#include <string>
#include <thread>
#include <vector>

#include "hitos/capture/live_source.hpp"
#include "live/foxglove_frames.hpp"
#include "live/foxglove_receiver.hpp"
#include "live/websocket.hpp"
#include "unit/capture/recorded_messages.hpp"
#include "unit/capture/ros_tours.hpp"
#include "unit/capture/test_files.hpp"

namespace hitos {
namespace {

namespace asio = boost::asio;
namespace beast = boost::beast;
namespace websocket = beast::websocket;
using asio::ip::tcp;
using testing::HasSubstr;

constexpr const char* kAdvertise =
    R"({"op":"advertise","channels":[
        {"id":3,"topic":"/scan","encoding":"cdr","schemaName":"sensor_msgs/msg/LaserScan",
         "schema":"# text","schemaEncoding":"ros2msg"},
        {"id":4,"topic":"/image","encoding":"cdr","schemaName":"sensor_msgs/msg/Image","schema":""}
    ]})";

std::string data_frame(std::uint32_t subscription, std::uint64_t time_ns, std::string_view bytes) {
    return test::Bytes().u8(1).u32(subscription).u64(time_ns).raw(bytes).text();
}

TEST(FoxgloveFrames, AreReadAsTheProtocolSays) {
    EXPECT_EQ(foxglove_said(R"({"op":"serverInfo","name":"robot","capabilities":[]})").server,
              "robot");
    const FoxgloveSaid said = foxglove_said(kAdvertise);
    ASSERT_EQ(said.channels.size(), 2U);
    EXPECT_EQ(said.channels[0].id, 3U);
    EXPECT_EQ(said.channels[0].topic,
              (ReceivedTopic{"/scan", "cdr", "sensor_msgs/msg/LaserScan", "ros2msg", "# text"}));
    EXPECT_EQ(said.channels[1].topic.definition_encoding, "ros2msg");
    EXPECT_THAT(foxglove_said(R"({"op":"unadvertise","channelIds":[4,3]})").gone,
                testing::ElementsAre(4, 3));
    EXPECT_FALSE(foxglove_said(R"({"op":"status","level":0,"message":"fine"})").alarm);
    EXPECT_EQ(foxglove_said(R"({"op":"status","level":2,"message":"full"})").alarm, "full");
    EXPECT_TRUE(foxglove_said(R"({"op":"of a later version"})").channels.empty());
    EXPECT_EQ(
        foxglove_subscribe({{1, 3}, {2, 9}}),
        R"({"op":"subscribe","subscriptions":[{"channelId":3,"id":1},{"channelId":9,"id":2}]})");
    const std::string frame = data_frame(7, 123456789012, "payload");
    const auto message = foxglove_message(frame);
    ASSERT_TRUE(message);
    EXPECT_EQ(message->subscription, 7U);
    EXPECT_EQ(message->received_ns, 123456789012U);
    EXPECT_EQ(message->bytes, "payload");
    EXPECT_FALSE(foxglove_message(std::string("\2\0\0\0\0\0\0\0\0", 9)));  // a time
}

TEST(FoxgloveFrames, ThatAreNoneAreRefused) {
    const std::string deep(100'000, '[');
    for (const std::string& text :
         {std::string(), std::string("{"), std::string("[]"), std::string("3"), deep,
          std::string(R"({"op":7})"), std::string(R"({"op":"advertise"})"),
          std::string(R"({"op":"unadvertise","channelIds":["a"]})"),
          std::string(R"({"op":"status","level":"x"})"),
          R"({"op":")" + std::string(5000, 'a') + R"("})", std::string("{\"op\":\"\xff\"}")}) {
        EXPECT_THROW(foxglove_said(text), FormatError) << text.substr(0, 60);
    }
    EXPECT_THROW(foxglove_message(""), FormatError);
    for (std::size_t size = 1; size < 13; ++size) {
        EXPECT_THROW(foxglove_message(data_frame(1, 2, "x").substr(0, size)), FormatError) << size;
    }
}

TEST(FoxgloveFrames, LeaveOutAChannelThatIsNoneAndKeepTheOthers) {
    const std::string scan =
        R"({"id":3,"topic":"/scan","encoding":"cdr","schemaName":"sensor_msgs/msg/LaserScan","schema":""})";
    for (const std::string& bad :
         {std::string("3"), std::string(R"({"id":-1,"topic":"a"})"),
          R"({"id":4,"topic":"/a","encoding":"cdr","schemaName":"a","schema":")" +
              std::string((1 << 20) + 1, 'x') + "\"}"}) {
        std::string text = R"({"op":"advertise","channels":[)";
        text.append(bad).append(",").append(scan).append("]}");
        const FoxgloveSaid said = foxglove_said(text);
        EXPECT_EQ(said.channels.size(), 1U) << bad.substr(0, 60);
        EXPECT_EQ(said.problems.size(), 1U) << bad.substr(0, 60);
    }
}

/// Answers one connection after the other, each by the next of its manners, the last one for all
/// that follow.
class Server {
  public:
    using Socket = websocket::stream<tcp::socket>;
    using Manner = std::function<void(Socket&)>;

    explicit Server(std::vector<Manner> manners)
        : acceptor_(io_, {asio::ip::make_address("127.0.0.1"), 0}), manners_(std::move(manners)) {
        thread_ = std::thread([this] { serve(); });
    }
    ~Server() {
        over_ = true;
        boost::system::error_code ignored;
        tcp::socket last(io_);
        last.connect(acceptor_.local_endpoint(), ignored);  // so that it looks
        last.close(ignored);
        thread_.join();
    }
    Server(const Server&) = delete;
    Server& operator=(const Server&) = delete;
    std::string url() const {
        return "ws://127.0.0.1:" + std::to_string(acceptor_.local_endpoint().port());
    }
    int connections() const { return connections_; }

  private:
    void serve() {
        while (!over_) {
            boost::system::error_code error;
            tcp::socket socket(io_);
            acceptor_.accept(socket, error);
            if (error || over_) return;
            const auto which = std::min<std::size_t>(static_cast<std::size_t>(connections_++),
                                                     manners_.size() - 1);
            try {
                Socket stream(std::move(socket));
                stream.set_option(
                    websocket::stream_base::decorator([](websocket::response_type& answer) {
                        answer.set(beast::http::field::sec_websocket_protocol,
                                   "foxglove.websocket.v1");
                    }));
                manners_[which](stream);
            } catch (const boost::system::system_error&) {  // the client is gone
            }
        }
    }

    asio::io_context io_;
    tcp::acceptor acceptor_;
    std::vector<Manner> manners_;
    std::atomic<bool> over_{false};
    std::atomic<int> connections_{0};
    std::thread thread_;
};

void say(Server::Socket& stream, std::string_view text, bool binary = false) {
    stream.binary(binary);
    stream.write(asio::buffer(text.data(), text.size()));
}

std::string hear(Server::Socket& stream) {
    beast::flat_buffer buffer;
    stream.read(buffer);
    return beast::buffers_to_string(buffer.data());
}

/// The number by which the only subscription goes.
std::uint32_t subscribed(Server::Socket& stream) {
    const std::string asked = hear(stream);
    EXPECT_THAT(asked, HasSubstr("\"channelId\":3"));
    EXPECT_THAT(asked, testing::Not(HasSubstr("\"channelId\":4")));
    const std::size_t at = asked.find("\"id\":") + 5;
    return static_cast<std::uint32_t>(std::stoul(asked.substr(at)));
}

/// All that a receiver gives.
struct Received {
    std::string bytes;
    std::vector<std::string> news;
};

/// Until `enough` says so of what was put last, or the receiver gives up.
Received receive(const Server& server, std::chrono::seconds patience,
                 const std::function<bool(std::string_view put, const Received& all)>& enough) {
    Received all;
    std::stop_source stop;
    FoxgloveReceiver receiver(server.url(), patience);
    receiver.receive(
        stop.get_token(),
        [&](std::string_view bytes) {
            all.bytes += bytes;
            if (enough(bytes, all)) stop.request_stop();
        },
        [&](const Message& news) { all.news.push_back(news.english()); });
    return all;
}

std::vector<test::Said> messages_of(const Received& all) {
    const test::TempDir folder;
    const test::Read read = test::read(open_mcap, folder.put("a.mcap", all.bytes));
    EXPECT_TRUE(read.problems.empty());
    return read.all;
}

constexpr std::size_t kPayload = 1000;
constexpr std::chrono::seconds kPatience(60);

TEST(FoxgloveReceiver, KeepsWhatIsOfUseAndPassesOverWhatIsMalformed) {
    Server server({[](Server::Socket& stream) {
        stream.accept();
        say(stream, R"({"op":"serverInfo","name":"x","capabilities":[]})");
        say(stream, "{ not json");
        say(stream, kAdvertise);
        const std::uint32_t id = subscribed(stream);
        say(stream, "", true);
        say(stream, std::string("\1\0", 2), true);
        say(stream, data_frame(id + 1, 5, "of another"), true);
        say(stream, R"({"op":"status","level":1,"message":"slow reader"})");
        for (std::uint64_t i = 0; i < 20; ++i)
            say(stream, data_frame(id, 100 + i, std::string(kPayload, static_cast<char>('a' + i))),
                true);
        hear(stream);  // until the client goes
    }});
    const Received all = receive(server, kPatience, [](std::string_view, const Received& so_far) {
        return so_far.bytes.size() >= 20 * kPayload;
    });
    const std::vector<test::Said> messages = messages_of(all);
    ASSERT_EQ(messages.size(), 20U);
    for (std::size_t i = 0; i < messages.size(); ++i) {
        EXPECT_EQ(messages[i].topic, "/scan");
        EXPECT_EQ(messages[i].type, "sensor_msgs/LaserScan");
        EXPECT_EQ(messages[i].log_time_ns, 100 + i);
        EXPECT_EQ(messages[i].bytes, std::string(kPayload, static_cast<char>('a' + i)));
    }
    EXPECT_THAT(all.news, testing::Contains(HasSubstr("no JSON object")));
    EXPECT_THAT(all.news, testing::Contains(HasSubstr("receives /scan")));
    EXPECT_THAT(all.news, testing::Contains(HasSubstr("slow reader")));
}

/// A picture of a camera costs neither the connection nor what else comes.
TEST(FoxgloveReceiver, PassesOverWhatIsTooLargeAndSaysWhatItIs) {
    const Server server({[](Server::Socket& stream) {
        stream.accept();
        say(stream, kAdvertise);
        const std::uint32_t id = subscribed(stream);
        say(stream, data_frame(id, 1, "before"), true);
        for (int i = 0; i < 2; ++i)
            say(stream, data_frame(id, 2, std::string(kLargestMessage + 1000, 'x')), true);
        say(stream, data_frame(id, 3, std::string(kLargestMessage, 'y')), true);
        say(stream, std::string(kLargestMessage + 1000, ' '));
        say(stream, data_frame(id, 4, "behind"), true);
        hear(stream);
    }});
    const Received all = receive(server, kPatience, [](std::string_view put, const Received&) {
        return put.ends_with("behind");
    });
    const std::vector<test::Said> messages = messages_of(all);
    ASSERT_EQ(messages.size(), 3U);
    EXPECT_EQ(messages[0].bytes, "before");
    EXPECT_EQ(messages[1].bytes.size(), kLargestMessage);
    EXPECT_EQ(messages[2].bytes, "behind");
    ASSERT_EQ(all.news.size(), 3U);
    EXPECT_THAT(all.news[1], HasSubstr("/scan: a message of 16778229 bytes is passed over"));
    EXPECT_THAT(all.news[1], HasSubstr("more than 16777280"));
    EXPECT_THAT(all.news[2], HasSubstr("JSON: a message of 16778216 bytes"));
    EXPECT_EQ(server.connections(), 1);
}

/// Nobody looks at a screen where nothing happens.
TEST(FoxgloveReceiver, SaysWhatItWaitsForInVain) {
    std::atomic<bool> told{false};
    const Server server({[&told](Server::Socket& stream) {
        stream.accept();
        say(stream, R"({"op":"serverInfo","name":"x","capabilities":[]})");
        while (!told) std::this_thread::sleep_for(std::chrono::milliseconds(1));
        say(stream, kAdvertise);
        subscribed(stream);
        hear(stream);
    }});
    std::vector<std::string> news;
    std::stop_source stop;
    FoxgloveReceiver receiver(
        server.url(), kPatience, [] { return true; }, std::chrono::seconds(0));
    receiver.receive(
        stop.get_token(), [](std::string_view) {},
        [&](const Message& one) {
            news.push_back(one.english());
            told = true;
            if (news.size() == 3) stop.request_stop();
        });
    ASSERT_EQ(news.size(), 3U);
    EXPECT_THAT(news[0], HasSubstr("the server offers no topic yet"));
    EXPECT_THAT(news[1], HasSubstr("receives /scan"));
    EXPECT_THAT(news[2], HasSubstr("nothing has come yet"));
}

/// Whenever the connection breaks, and however: what had come stays, and what comes after joins on.
TEST(FoxgloveReceiver, LosesNothingThatCameInAHundredDisconnections) {
    std::vector<Server::Manner> manners;
    std::atomic<std::uint64_t> said{0};
    for (unsigned k = 0; k < 100; ++k) {
        manners.emplace_back([k, &said](Server::Socket& stream) {
            if (k % 10 == 3) return;  // before the handshake
            stream.accept();
            if (k % 10 == 7) return;  // before a word
            say(stream, kAdvertise);
            const std::uint32_t id = subscribed(stream);
            for (unsigned i = 0; i < k % 5; ++i)
                say(stream, data_frame(id, ++said, std::string(kPayload, 'x')), true);
            if (k % 2 == 0) {
                stream.close(websocket::close_code::going_away);
                return;
            }
            if (k % 3 == 0) stream.next_layer().set_option(asio::socket_base::linger(true, 1));
            // Half a frame: fewer bytes than its head says.
            const std::string half = std::string("\x82\x7e\x01\x00", 4) + "abc";
            asio::write(stream.next_layer(), asio::buffer(half));
        });
    }
    manners.emplace_back([&said](Server::Socket& stream) {
        stream.accept();
        say(stream, kAdvertise);
        const std::uint32_t id = subscribed(stream);
        say(stream, data_frame(id, ++said, std::string(100 * kPayload, 'e')), true);
        hear(stream);
    });
    Server server(std::move(manners));
    const Received all = receive(server, kPatience, [](std::string_view put, const Received&) {
        return put.size() > 50 * kPayload;
    });
    const std::vector<test::Said> messages = messages_of(all);
    ASSERT_EQ(messages.size(), said);
    for (std::size_t i = 0; i < messages.size(); ++i) EXPECT_EQ(messages[i].log_time_ns, i + 1);
    EXPECT_GE(server.connections(), 101);
}

/// Whoever takes connections and drops them does not keep anybody busy, nor for ever.
TEST(FoxgloveReceiver, GivesUpOnAServerThatNeverSaysAnything) {
    const Server server({[](Server::Socket& stream) { stream.accept(); }});
    const Received all = receive(server, std::chrono::seconds(1),
                                 [](std::string_view, const Received&) { return false; });
    EXPECT_THAT(all.news.back(), HasSubstr("the tour ends here"));
    EXPECT_LT(server.connections(), 30);
}

TEST(FoxgloveReceiver, SaysWhyThereIsNoConnection) {
    const auto words = [](const std::string& url) -> std::string {
        try {
            FoxgloveReceiver receiver(url, std::chrono::seconds(1));
        } catch (const FileError& error) {
            return error.what();
        }
        return {};
    };
    std::string nobody;
    {
        const Server gone({[](Server::Socket&) {}});
        nobody = gone.url();
    }
    EXPECT_THAT(words(nobody), HasSubstr(nobody + ": cannot be connected to"));
    const Server page({[](Server::Socket& stream) {
        const std::string answer = "HTTP/1.1 404 Not Found\r\nContent-Length: 0\r\n\r\n";
        asio::write(stream.next_layer(), asio::buffer(answer));
    }});
    EXPECT_THAT(words(page.url()), HasSubstr("is no server of the Foxglove protocol"));
    const Server other({[](Server::Socket& stream) {
        stream.set_option(websocket::stream_base::decorator([](websocket::response_type& answer) {
            answer.erase(beast::http::field::sec_websocket_protocol);
        }));
        stream.accept();
    }});
    EXPECT_THAT(words(other.url()), HasSubstr("it speaks none"));
}

TEST(FoxgloveReceiver, GivesUpAfterItsPatience) {
    std::optional<Server> server;
    server.emplace(std::vector<Server::Manner>{[](Server::Socket& stream) {
        stream.accept();
        say(stream, kAdvertise);
        subscribed(stream);
    }});
    FoxgloveReceiver receiver(server->url(), std::chrono::seconds(0));
    std::vector<std::string> news;
    std::string bytes;
    receiver.receive(
        std::stop_token(), [&](std::string_view put) { bytes += put; },
        [&](const Message& told) {
            news.push_back(told.english());
            if (server && news.back().find("looked for again") != std::string::npos) server.reset();
        });
    EXPECT_THAT(news.back(), HasSubstr("the tour ends here"));
    EXPECT_TRUE(messages_of({bytes, {}}).empty());
}

}  // namespace
}  // namespace hitos
