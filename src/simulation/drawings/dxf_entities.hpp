// SPDX-License-Identifier: GPL-3.0-or-later
// The sections of a DXF drawing: its entities as they stand in the file, its blocks and layers.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "hitos/base/message.hpp"

namespace hitos::dxf {

/// A group code and its value, a pair of lines.
struct Group {
    int code = 0;
    std::string_view value;
};

/// What stands between one group 0 and the next.
struct Entity {
    std::string_view type;
    std::string_view layer = "0";
    std::string_view text;   ///< the lines of its groups
    bool paper = false;      ///< on a sheet, not in the model
    bool invisible = false;  ///< as a dynamic block hides what is not chosen
};

struct Block {
    std::vector<Entity> entities;
    std::array<double, 3> base{};  ///< the point that an INSERT places [drawing units]
    std::string external;          ///< the file of an external reference (XREF)
};

struct Layer {
    std::string name;
    bool hidden = false;  ///< off or frozen
    bool frozen = false;  ///< with it goes what is inserted on it, of whatever layer
};

/// The name in UTF-8, its \U+00C4 resolved; what is no UTF-8 is taken as Latin-1.
std::string name_of(std::string_view value);
/// As names are compared: without regard to case.
std::string key_of(std::string_view value);

/// A drawing read into its parts, which keep pointing into its text.
class Drawing {
  public:
    /// Throws FormatError, with the line, for what is no ASCII DXF.
    Drawing(std::string text, const std::filesystem::path& path);
    Drawing(const Drawing&) = delete;
    Drawing& operator=(const Drawing&) = delete;

    std::vector<Entity> entities;
    std::map<std::string, Block> blocks;     ///< by key_of() the name
    std::map<std::string, Layer> layers;     ///< by key_of() the name
    std::map<std::string, int> mline_flags;  ///< of MLINESTYLE, by key_of() the name
    std::optional<int> insunits;             ///< nothing: the drawing does not say
    bool ended = false;                      ///< EOF was met

    /// The finite number that the value is. Throws FormatError with its line.
    double number(const Group& group) const;

  private:
    void read();
    void read_table_entry(const Entity& entry, std::map<std::string, std::string>& sheets);
    /// Throws FormatError with the line of what was found.
    [[noreturn]] void fail(std::string_view at, MessageText<1> text) const;

    std::string text_;
    std::string path_;
};

/// Goes through the groups of an entity, without those that programs put between braces (102).
class Groups {
  public:
    explicit Groups(std::string_view text) : rest_(text) {}
    std::optional<Group> next();

  private:
    std::optional<Group> any();
    std::string_view rest_;
};

/// An entity's groups by their codes.
class Fields {
  public:
    Fields(const Drawing& drawing, const Entity& entity);

    const std::vector<Group>& all() const { return groups_; }
    double number(const Group& group) const { return drawing_->number(group); }
    /// Of the first group of that code.
    double number(int code, double otherwise) const;
    int integer(int code, int otherwise) const;
    std::string_view word(int code) const;

  private:
    const Group* find(int code) const;
    const Drawing* drawing_;
    std::vector<Group> groups_;
};

/// A number of a drawing as a whole one; what no int holds is cut to its ends.
int whole(double value);

}  // namespace hitos::dxf
