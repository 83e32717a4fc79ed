// SPDX-License-Identifier: GPL-3.0-or-later
#include "live_request.hpp"

#include <fmt/format.h>

#include "hitos/base/error.hpp"
#include "json_input.hpp"

namespace hitos::live {
namespace {

constexpr const char* kWhose = "message";

using nlohmann::json;

std::uint32_t id_in(const json& object, const char* name) {
    return whole_number<std::uint32_t>(object, name, kWhose);
}

void take(const json& object, Request& request) {
    const auto op = object.at("op").get<std::string>();
    if (op == "subscribe") {
        for (const json& wanted : object.at("subscriptions")) {
            request.subscribe.emplace_back(id_in(wanted, "id"), id_in(wanted, "channelId"));
        }
    } else if (op == "unsubscribe") {
        for (const json& id : object.at("subscriptionIds")) {
            request.unsubscribe.push_back(id_in({{"subscriptionId", id}}, "subscriptionId"));
        }
    } else {
        request.unknown = op.substr(0, 100);
    }
}

}  // namespace

Request parsed_request(std::string_view text) {
    Request request;
    try {
        take(parsed<json>(std::string(text), kWhose), request);
    } catch (const json::exception&) {  // whose words are for programmers
        request.wrong = "a member is missing or of another kind";
    } catch (const Error& error) {
        request.wrong = error.what();
    }
    if (!request.wrong.empty()) {
        constexpr std::size_t kEnough = 300;
        request.wrong = fmt::format(
            "{}; expected a JSON object with an op as Foxglove's protocol "
            "has it",
            request.wrong.substr(0, kEnough));
    }
    return request;
}

std::string status(StatusLevel level, const std::string& words) {
    return json_text({{"op", "status"}, {"level", static_cast<int>(level)}, {"message", words}},
                     -1);
}

}  // namespace hitos::live
