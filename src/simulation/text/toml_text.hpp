// SPDX-License-Identifier: GPL-3.0-or-later
// A TOML text that is edited where it stands: what is not changed keeps every byte.
#pragma once

#include <toml++/toml.h>

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace hitos {

/// A value that shall stand in a TOML text.
struct TomlValue {
    enum class Kind { scalar, list, table };
    struct Member;

    Kind kind = Kind::scalar;
    std::string text;              ///< of a scalar, as it is written
    std::optional<double> number;  ///< of a scalar that is one
    std::vector<TomlValue> list;
    std::vector<Member> table;
    bool a_line_each = false;  ///< entries of a list that is written anew

    /// The number by the shortest digits that read back to its bits.
    static TomlValue of(double number);
    /// In quotes; only words of letters, digits and hyphens are written.
    static TomlValue word(std::string_view word);
    static TomlValue flag(bool on);
    static TomlValue of(std::vector<TomlValue> list, bool a_line_each = false);
    static TomlValue of(std::vector<Member> table);
};

struct TomlValue::Member {
    std::string key;
    TomlValue value;
    bool may_be_left_out = false;  ///< it is what the key's absence says
};

/// Whether the node reads as the value, numbers to the last bit.
bool reads_as(const toml::node& node, const TomlValue& value);

/// A text with the places that toml++ tells of it as offsets of bytes.
class TomlPlaces {
  public:
    explicit TomlPlaces(const std::string& text);

    std::size_t at(const toml::source_position& position) const;
    std::size_t begin(const toml::node& node) const { return at(node.source().begin); }
    std::size_t end(const toml::node& node) const { return at(node.source().end); }
    std::size_t line_begin(std::size_t at) const;
    /// Before the line's end, and behind it.
    std::size_t line_end(std::size_t at) const;
    std::size_t next_line(std::size_t at) const;
    bool same_line(std::size_t a, std::size_t b) const { return line_begin(a) == line_begin(b); }
    bool first_on_line(std::size_t at) const { return indent(at).size() == at - line_begin(at); }
    /// White space that the line begins with.
    std::string indent(std::size_t at) const;
    /// Whether only white space and a comment follow on the line.
    bool nothing_follows(std::size_t at) const;
    /// The comma that follows behind white space, line ends and comments, if one does.
    std::optional<std::size_t> comma_after(std::size_t at) const;
    /// What a line ends with in this text.
    const std::string& newline() const { return newline_; }
    const std::string& text() const { return text_; }

  private:
    const std::string& text_;
    std::vector<std::size_t> lines_;
    std::string newline_;
};

/// What changes in a text, gathered while the places of the old one still hold.
class TomlEdits {
  public:
    explicit TomlEdits(const TomlPlaces& places) : places_(places) {}

    void replace(std::size_t begin, std::size_t end, std::string by);
    void insert(std::size_t at, std::string text) { replace(at, at, std::move(text)); }
    void remove(std::size_t begin, std::size_t end) { replace(begin, end, {}); }
    /// Lets the node read as the value; what reads so already stays as it is written.
    void rewrite(const toml::node& node, const TomlValue& value);
    std::string applied() const;

  private:
    struct Edit {
        std::size_t begin;
        std::size_t end;
        std::string by;
    };
    void rewrite_list(const toml::array& list, const std::vector<TomlValue>& wanted);
    void insert_behind(const toml::array& list, std::ptrdiff_t entry,
                       const std::vector<TomlValue>& values);
    void remove_entries(const toml::array& list, std::size_t from, std::size_t to);

    const TomlPlaces& places_;
    std::vector<Edit> edits_;
};

/// The value as it is written anew, its lines indented under `indent`.
std::string written(const TomlValue& value, const std::string& newline,
                    const std::string& indent = {});

/// Which of the entries stay, for the fewest that do not: pairs (old, new), both rising. Where that
/// takes too long to find, those at both ends.
std::vector<std::pair<std::size_t, std::size_t>> staying(const toml::array& old,
                                                         const std::vector<TomlValue>& wanted);

/// Keys of tables one level deep, `table` empty for those of the document itself. Text that is no
/// TOML throws toml::parse_error.
class TomlText {
  public:
    explicit TomlText(std::string text) : text_(std::move(text)) {}

    const std::string& text() const { return text_; }
    /// A key that is not there goes behind the last one of its table, a table to the end.
    void set(std::string_view table, std::string_view key, const TomlValue& value);
    /// That entry of a list, where it is a number.
    std::optional<double> number(std::string_view table, std::string_view key,
                                 std::size_t entry) const;
    /// With its line, and the comment on it.
    void remove(std::string_view table, std::string_view key);

  private:
    std::string text_;
};

}  // namespace hitos
