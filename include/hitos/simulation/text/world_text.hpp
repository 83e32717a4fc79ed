// SPDX-License-Identifier: GPL-3.0-or-later
// A world file as text, edited where it stands: comments, layout and what is not changed stay.
#pragma once

#include <filesystem>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "hitos/simulation/worlds/world.hpp"

namespace hitos {

/// The text of a world (docs/simulation.md) and the world that it says. What is set changes the
/// lines of its own key only; a value that stays changes no byte, entries of lists that stay keep
/// their comments. A key that is not there is written behind the last one of its group. Lengths in
/// metres, world frame. A text is always one that reads: what cannot be is refused with the
/// FormatError of parse_world() or a ConfigError, and nothing has changed then.
class WorldText {
  public:
    /// Of no walls. `path` stands in messages, and drawings are looked for beside it.
    explicit WorldText(std::filesystem::path path = {}) : WorldText({}, std::move(path)) {}
    /// Refuses what parse_world() refuses, but that there are no walls yet.
    WorldText(std::string text, std::filesystem::path path);
    /// As read_world().
    static WorldText read(const std::filesystem::path& path);
    /// The same of one that need not have walls yet.
    static WorldText read_unfinished(const std::filesystem::path& path);

    const std::string& text() const { return text_; }
    const std::filesystem::path& path() const { return path_; }
    const World& world() const { return world_; }

    /// Those of the file itself, without the ones of a drawing.
    std::vector<Polyline> walls() const;
    void set_walls(std::span<const Polyline> walls);
    void set_doors(std::span<const std::pair<Point2, Point2>> doors);
    void set_people(std::span<const Walker> people);
    /// The heading is written in degrees, by the shortest digits that read back to its bits where
    /// degrees have such, which those of files always do; else by the nearest.
    void set_start(const Pose& start);
    /// Way points and commands exclude each other: setting one to more than nothing takes the
    /// other out.
    void set_way_points(std::span<const Point2> way_points);
    void set_commands(std::span<const DriveCommand> commands);
    /// Boxes are events too (DisturbanceKind::box).
    void set_events(std::span<const Disturbance> events);
    /// A key of world_keys(), as set_world_value() takes it.
    void set_value(std::string_view key, std::string_view value);
    /// All that differs from `world`. The walls of a drawing that the text names stay what they
    /// are: other ones in their place are a ConfigError.
    void set(const World& world);

    /// The same world as a file at that path: where its drawing would not be found from there, the
    /// drawing's whole path stands in the text; where it is gone or another one by now, the walls.
    WorldText moved_to(const std::filesystem::path& path) const;

    /// Writes the text atomically; from then on the path is this one. Throws FileError.
    void save(const std::filesystem::path& path);

  private:
    class Change;

    std::filesystem::path path_;
    std::string text_;
    World world_;
};

/// Whether both say the same to the last bit, on whatever lines and in whatever files it stands.
bool same_world(const World& a, const World& b);

}  // namespace hitos
