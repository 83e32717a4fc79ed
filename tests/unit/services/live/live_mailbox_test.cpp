// SPDX-License-Identifier: GPL-3.0-or-later
// What a client says, and what then waits for it.
#include "live/live_mailbox.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "live/live_channels.hpp"

namespace hitos::live {
namespace {

using nlohmann::json;
using ::testing::HasSubstr;

/// Has the channel's number as the state.
class QuietStage final : public Stage {
  public:
    std::chrono::milliseconds patience() const override { return {}; }
    const std::string& server_info_text() const override { return text_; }
    const std::string& advertisement_text() const override { return text_; }
    bool answers_to(std::string_view /*host*/) const override { return true; }
    bool full() const override { return false; }
    void joins(const std::shared_ptr<Client>& /*client*/) override {}
    void leaves(const std::shared_ptr<Client>& /*client*/) override {}
    void comes(Visitor& /*visitor*/) override {}
    void goes(Visitor& /*visitor*/) override {}
    std::shared_ptr<const Payload> payload(std::size_t channel) override {
        return told ? std::make_shared<const Payload>(Payload{7, std::to_string(channel)})
                    : nullptr;
    }
    bool told = false;

  private:
    std::string text_;
};

class MailboxTest : public ::testing::Test {
  protected:
    /// What is said to that.
    json status_of(const std::string& text) {
        mailbox_.take(text);
        const auto message = mailbox_.next();
        if (!message || message->payload) {
            ADD_FAILURE() << "no words to " << text;
            return {};
        }
        return json::parse(message->text);
    }
    std::vector<std::string> payloads() {
        std::vector<std::string> found;
        while (const auto message = mailbox_.next()) {
            found.push_back(message->payload ? message->payload->json : message->text);
        }
        return found;
    }

    QuietStage stage_;
    Mailbox mailbox_{stage_};
};

std::shared_ptr<const Payload> of(const std::string& text) {
    return std::make_shared<const Payload>(Payload{0x0102030405060708, text});
}

TEST_F(MailboxTest, OnlyTheNewestOfAChannelWaits) {
    mailbox_.take(R"({"op":"subscribe","subscriptions":[{"id":9,"channelId":2}]})");
    EXPECT_TRUE(mailbox_.wants(2));
    EXPECT_FALSE(mailbox_.wants(3));
    for (const char* text : {"a", "b", "c"}) {
        mailbox_.offer(2, of(text));
        mailbox_.offer(3, of(text));
    }
    EXPECT_THAT(payloads(), ::testing::ElementsAre("c"));
}

TEST_F(MailboxTest, TheHeaderHasTheSubscriptionAndTheTime) {
    mailbox_.take(R"({"op":"subscribe","subscriptions":[{"id":4278255360,"channelId":0}]})");
    mailbox_.offer(0, of("x"));
    const auto message = mailbox_.next();
    ASSERT_TRUE(message);
    EXPECT_THAT(message->header,
                ::testing::ElementsAre(1, 0x00, 0xFF, 0x00, 0xFF, 8, 7, 6, 5, 4, 3, 2, 1));
}

TEST_F(MailboxTest, WhoSubscribesGetsTheStateAtOnce) {
    stage_.told = true;
    mailbox_.take(R"({"op":"subscribe","subscriptions":[{"id":1,"channelId":0},)"
                  R"({"id":2,"channelId":4}]})");
    EXPECT_THAT(payloads(), ::testing::ElementsAre("0", "4"));
    mailbox_.take(R"({"op":"unsubscribe","subscriptionIds":[1]})");
    EXPECT_FALSE(mailbox_.wants(0));
    mailbox_.take(R"({"op":"subscribe","subscriptions":[{"id":1,"channelId":1}]})");
    EXPECT_THAT(payloads(), ::testing::ElementsAre("1"));
}

TEST_F(MailboxTest, NoChannelWaitsForTheOthersForEver) {
    mailbox_.take(R"({"op":"subscribe","subscriptions":[{"id":1,"channelId":0},)"
                  R"({"id":2,"channelId":4}]})");
    std::vector<std::string> sent;
    for (int i = 0; i < 4; ++i) {
        mailbox_.offer(0, of("first"));
        mailbox_.offer(4, of("second"));
        sent.push_back(mailbox_.next()->payload->json);
    }
    EXPECT_THAT(sent, ::testing::ElementsAre("first", "second", "first", "second"));
}

TEST_F(MailboxTest, UnknownOpsAreAWarningAndNoMore) {
    for (const char* op : {"getParameters", "advertise", ""}) {
        const json answer = status_of(json({{"op", op}}).dump());
        EXPECT_EQ(answer["op"], "status");
        EXPECT_EQ(answer["level"], 1);
    }
    for (int i = 0; i < 1000; ++i) mailbox_.take(R"({"op":"x"})");
    EXPECT_FALSE(mailbox_.hopeless());
    EXPECT_EQ(payloads().size(), Mailbox::kMostTexts);
}

TEST_F(MailboxTest, NonsenseIsAnErrorInWords) {
    const std::string deep(5000, '[');
    const std::vector<std::string> nonsense{
        "",
        "{",
        "null",
        "7",
        "[]",
        "{}",
        R"({"op":3})",
        R"({"op":"subscribe"})",
        "\xff\xfe",
        R"({"op":"subscribe","subscriptions":[7]})",
        deep,
        R"({"op":"subscribe","subscriptions":"all"})",
        R"({"op":"subscribe","subscriptions":[{"id":1}]})",
        R"({"op":"subscribe","subscriptions":[{"id":-1,"channelId":0}]})",
        R"({"op":"subscribe","subscriptions":[{"id":1.5,"channelId":0}]})",
        R"({"op":"subscribe","subscriptions":[{"id":4294967296,"channelId":0}]})",
        R"({"op":"subscribe","subscriptions":[{"id":"1","channelId":0}]})",
        R"({"op":"subscribe","subscriptions":[{"id":1,"channelId":10}]})",
        R"({"op":"unsubscribe","subscriptionIds":[5]})",
        R"({"op":"unsubscribe","subscriptionIds":["5"]})"};
    for (const std::string& text : nonsense) {
        const json answer = status_of(text);
        EXPECT_EQ(answer["op"], "status") << text;
        EXPECT_EQ(answer["level"], 2) << text;
        EXPECT_FALSE(answer["message"].get<std::string>().empty()) << text;
    }
    EXPECT_FALSE(mailbox_.hopeless());
    for (std::size_t channel = 0; channel < channels().size(); ++channel) {
        EXPECT_FALSE(mailbox_.wants(channel));
    }
    EXPECT_TRUE(payloads().empty());
}

TEST_F(MailboxTest, IdsAreNotUsedTwice) {
    mailbox_.take(R"({"op":"subscribe","subscriptions":[{"id":1,"channelId":0}]})");
    EXPECT_THAT(status_of(R"({"op":"subscribe","subscriptions":[{"id":1,"channelId":2}]})")
                    .at("message")
                    .get<std::string>(),
                HasSubstr("subscription 1 is there already"));
    EXPECT_THAT(status_of(R"({"op":"subscribe","subscriptions":[{"id":2,"channelId":0}]})")
                    .at("message")
                    .get<std::string>(),
                HasSubstr("channel 0 is subscribed to already"));
}

TEST_F(MailboxTest, WhoGoesOnWithNonsenseIsHopeless) {
    for (int i = 0; i < Mailbox::kMostWrong; ++i) mailbox_.take("?");
    EXPECT_FALSE(mailbox_.hopeless());
    mailbox_.take("?");
    EXPECT_TRUE(mailbox_.hopeless());
    EXPECT_EQ(payloads().size(), Mailbox::kMostTexts);
}

TEST(LiveChannels, AreAdvertisedWithTheirSchemas) {
    const json advertised = json::parse(advertisement());
    EXPECT_EQ(advertised["op"], "advertise");
    ASSERT_EQ(advertised["channels"].size(), channels().size());
    for (std::size_t i = 0; i < channels().size(); ++i) {
        const json& channel = advertised["channels"][i];
        EXPECT_EQ(channel["id"], i);
        EXPECT_EQ(channel["topic"], channels()[i].topic);
        EXPECT_EQ(channel["encoding"], "json");
        EXPECT_EQ(channel["schemaEncoding"], "jsonschema");
        EXPECT_EQ(json::parse(channel["schema"].get<std::string>())["title"],
                  channel["schemaName"]);
    }
    const json info = json::parse(server_info("a \xff name", "3"));
    EXPECT_EQ(info["op"], "serverInfo");
    EXPECT_EQ(info["sessionId"], "3");
    EXPECT_TRUE(info["capabilities"].is_array());
}

}  // namespace
}  // namespace hitos::live
