#include "recordings/recording.hpp"

#include <algorithm>

#include "hitos/base/error.hpp"

namespace hitos {
namespace {

/// Problems are for people; a file of nothing else costs no memory.
constexpr std::size_t kProblemsHeld = 256;

}  // namespace

Encoding encoding_of(std::string_view word) {
    if (word == "ros1") return Encoding::ros1;
    return word == "cdr" ? Encoding::cdr : Encoding::other;
}

Topic& Topics::of(std::string name, std::string type, std::string encoding) {
    constexpr std::string_view kRos2 = "/msg/";
    if (const std::size_t at = type.find(kRos2); at != std::string::npos) {
        type.replace(at, kRos2.size(), "/");
    }
    const auto known = std::ranges::find_if(topics_, [&](const Topic& topic) {
        return topic.name == name && topic.type == type && topic.encoding == encoding;
    });
    if (known != topics_.end()) return *known;
    if (topics_.size() == kMostTopics) {
        throw FormatError({}, 0, message(HITOS_TEXT("Errors", "more than %1 topics"), kMostTopics));
    }
    topics_.push_back({std::move(name), std::move(type), std::move(encoding)});
    topics_.back().wanted = wanted_(topics_.back());
    return topics_.back();
}

std::uint64_t Topics::count(Topic& topic) {
    ++topic.messages;
    return ++messages_;
}

std::optional<RecordingProblem> Recording::take_problem() {
    if (problems_.empty()) return std::nullopt;
    RecordingProblem first = std::move(problems_.front());
    problems_.pop_front();
    return first;
}

void Recording::note(std::uint64_t number, Message reason) {
    if (problems_.size() < kProblemsHeld) problems_.push_back({number, std::move(reason)});
}

}  // namespace hitos
