// SPDX-License-Identifier: GPL-3.0-or-later
#include "ros/frame_choice.hpp"

#include <algorithm>

#include "hitos/base/error.hpp"
#include "hitos/base/text_input.hpp"
#include "hitos/capture/archivo.hpp"

namespace hitos {
namespace {

void join_frames(FrameTree& frames, std::string_view same) {
    for (const std::string_view pair : input::listed(same)) {
        const std::size_t equals = pair.find('=');
        const std::string_view a = input::trimmed(pair.substr(0, std::min(equals, pair.size())));
        const std::string_view b =
            equals < pair.size() ? input::trimmed(pair.substr(equals + 1)) : std::string_view{};
        if (a.empty() || b.empty() || a == b) {
            throw ConfigError(
                kSameFramesKey,
                HITOS_TEXT(
                    "Errors",
                    "found \"%1\", expected two frames that are one, as base_footprint=base_link"),
                pair);
        }
        frames.join(std::string(a), std::string(b));
    }
}

}  // namespace

std::string_view space_of(std::string_view topic) {
    const std::size_t slash = topic.rfind('/');
    return slash == std::string_view::npos ? std::string_view{} : topic.substr(0, slash + 1);
}

double apart(const Publishers::Told& a, const Publishers::Told& b) {
    constexpr double kOtherParent = 100.0;  // whatever the place
    return apart(a.transform, b.transform) + (a.parent == b.parent ? 0.0 : kOtherParent);
}

void Publishers::note(const StampedTransform& told) {
    watches_[told.child_frame].note({told.header.frame, told.transform});
}

std::uint64_t Publishers::returns(const std::string& frame) const {
    const auto watch = watches_.find(frame);
    return watch == watches_.end() ? 0 : watch->second.returns();
}

FrameChoice choose_frames(const std::map<std::string, TopicFrames>& said,
                          std::string_view laser_topic, const std::vector<std::string>& lasers,
                          std::string_view same) {
    FrameChoice choice;
    for (const auto& [topic, frames] : said) {
        if (laser_topic.starts_with(space_of(topic))) choice.topics.push_back(topic);
    }
    if (choice.topics.empty()) {
        choice.of_others = true;
        for (const auto& one : said) {
            const bool own_lasers = std::ranges::any_of(lasers, [&](const std::string& laser) {
                return laser.starts_with(space_of(one.first));
            });
            if (!own_lasers) choice.topics.push_back(one.first);
        }
    }
    for (const std::string& topic : choice.topics) choice.frames.complete(said.at(topic).frames);
    join_frames(choice.frames, same);
    return choice;
}

void check_agreement(const std::map<std::string, TopicFrames>& said, const FrameChoice& choice,
                     const std::vector<std::string>& frames, const std::string& path) {
    for (const std::string& name : frames) {
        const auto first = choice.topics.begin();
        for (auto a = first; a != choice.topics.end(); ++a) {
            const auto b = std::find_if(first, a + 1, [&](const std::string& other) {
                return other == *a ? said.at(*a).changed.contains(name)
                                   : said.at(*a).frames.differs(said.at(other).frames, name);
            });
            if (b == a + 1) continue;
            throw FormatError(
                path, 0,
                HITOS_TEXT("Errors",
                           "the place of the frame \"%1\" is told by %2 and by %3, differently, so "
                           "where the laser sits is not known; record those of one robot only, or "
                           "say where it sits (--laser-pose x,y,degrees)"),
                name, *b, *a);
        }
    }
}

}  // namespace hitos
