// SPDX-License-Identifier: GPL-3.0-or-later
#include "recordings/recording.hpp"

#include <utility>

#include "hitos/base/error.hpp"

namespace hitos {
Encoding encoding_of(std::string_view word) {
    if (word == "ros1") return Encoding::ros1;
    return word == "cdr" ? Encoding::cdr : Encoding::other;
}

Topic& Topics::of(std::string name, std::string type, std::string encoding) {
    constexpr std::string_view kRos2 = "/msg/";
    if (const std::size_t at = type.find(kRos2); at != std::string::npos) {
        type.replace(at, kRos2.size(), "/");
    }
    std::tuple key(name, type, encoding);
    if (const auto known = known_.find(key); known != known_.end()) return *known->second;
    if (topics_.size() == kMostTopics) {
        throw FormatError({}, 0, HITOS_TEXT("Errors", "more than %1 topics"), kMostTopics);
    }
    topics_.push_back({std::move(name), std::move(type), std::move(encoding)});
    known_.emplace(std::move(key), &topics_.back());
    topics_.back().wanted = wanted_(topics_.back());
    return topics_.back();
}

std::uint64_t Topics::count(Topic& topic) {
    ++topic.messages;
    return ++messages_;
}

std::optional<RecordingProblem> Recording::take_problem() {
    std::optional<std::pair<std::uint64_t, Message>> first = problems_.take();
    if (!first) return std::nullopt;
    return RecordingProblem{first->first, std::move(first->second)};
}

void Recording::note(std::uint64_t number, Message reason) {
    problems_.note(number, std::move(reason));
}

}  // namespace hitos
