// SPDX-License-Identifier: GPL-3.0-or-later
// Whose transforms are those of a laser, and what there is to doubt about them.
#pragma once

#include <map>
#include <optional>
#include <set>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "hitos/capture/to_and_fro.hpp"
#include "hitos/capture/tour_reader.hpp"
#include "ros/frame_tree.hpp"

namespace hitos {

/// Two senders who tell a frame in turns: its places go to and fro.
class Publishers {
  public:
    void note(const StampedTransform& told);
    /// How often the frame went back to where it was before the last message; 0 where that is no
    /// more than chance.
    std::uint64_t returns(const std::string& frame) const;

    struct Told {
        std::string parent;
        Transform transform;
        friend double apart(const Told& a, const Told& b);
    };

  private:
    std::map<std::string, ToAndFro<Told>> watches_;
};

/// What a topic of transforms says.
struct TopicFrames {
    FrameTree frames;  ///< of each frame the first transform, which may come after the first scan
    Publishers publishers;
    std::set<std::string> changed;  ///< frames of fixed transforms that were told differently later
};

/// The namespace of a topic: "/robot1/" of "/robot1/tf".
std::string_view space_of(std::string_view topic);

/// Topics of transforms, and what they say together.
struct FrameChoice {
    std::vector<std::string> topics;
    bool of_others = false;  ///< none is of the laser's namespace
    FrameTree frames;
};

/// The topics of the namespace of the laser's topic and of those it lies in; where none is, all but
/// those of a namespace with lasers of its own, which are another robot's. Frames that `same` says
/// are one ("a=b", several with commas between them) are joined. Throws ConfigError for words that
/// are no such pair.
FrameChoice choose_frames(const std::map<std::string, TopicFrames>& said,
                          std::string_view laser_topic, const std::vector<std::string>& lasers,
                          std::string_view same);

/// Throws FormatError where two of the chosen topics tell one of these frames differently.
void check_agreement(const std::map<std::string, TopicFrames>& said, const FrameChoice& choice,
                     const std::vector<std::string>& frames, const std::string& path);

}  // namespace hitos
