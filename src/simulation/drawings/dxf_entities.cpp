// SPDX-License-Identifier: GPL-3.0-or-later
#include "dxf_entities.hpp"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <utility>

#include "hitos/base/error.hpp"
#include "hitos/base/text_input.hpp"

namespace hitos::dxf {
namespace {

constexpr std::size_t kMostEntities = 2'000'000;

/// The next line without white space at its ends; where there is none, nothing at the end. Points
/// into `rest` even where it is empty, to be told where it was.
std::string_view value_of(std::string_view& rest) {
    const std::string_view line = input::next_line(rest).value_or(rest);
    const std::string_view value = input::trimmed(line);
    return value.empty() ? line.substr(0, 0) : value;
}

/// The group code that a line is.
std::optional<int> code_of(std::string_view line) {
    const std::string_view word = input::trimmed(line);
    int code = 0;
    const auto [stop, error] = std::from_chars(word.data(), word.data() + word.size(), code);
    if (error != std::errc{} || stop != word.data() + word.size()) return std::nullopt;
    return code;
}

void append_utf8(std::string& out, unsigned code) {
    if (code < 0x80U) {
        out += static_cast<char>(code);
    } else if (code < 0x800U) {
        out += static_cast<char>(0xC0U | (code >> 6U));
        out += static_cast<char>(0x80U | (code & 0x3FU));
    } else {
        out += static_cast<char>(0xE0U | (code >> 12U));
        out += static_cast<char>(0x80U | ((code >> 6U) & 0x3FU));
        out += static_cast<char>(0x80U | (code & 0x3FU));
    }
}

bool is_utf8(std::string_view text) {
    std::size_t follow = 0;
    for (const char c : text) {
        const auto byte = static_cast<unsigned char>(c);
        if ((byte & 0xC0U) == 0x80U) {
            if (follow-- == 0) return false;
        } else {
            if (follow != 0) return false;
            if (byte >= 0xF5U || byte == 0xC0U || byte == 0xC1U) return false;
            follow = byte >= 0xF0U ? 3 : byte >= 0xE0U ? 2 : byte >= 0xC0U ? 1 : 0;
        }
    }
    return follow == 0;
}

/// Sheets, which AutoCAD calls *Paper_Space, *Paper_Space0 …, its release 12 $PAPER_SPACE.
bool is_sheet(std::string_view block_key) {
    return block_key.starts_with("*paper_space") || block_key.starts_with("$paper_space");
}

}  // namespace

std::string name_of(std::string_view value) {
    constexpr std::size_t kEscape = 7;  // \U+00C4
    const bool utf8 = is_utf8(value);
    std::string name;
    for (std::size_t i = 0; i < value.size(); ++i) {
        unsigned code = static_cast<unsigned char>(value[i]);
        if (value.substr(i).starts_with("\\U+") && i + kEscape <= value.size()) {
            const char* end = value.data() + i + kEscape;
            unsigned escaped = 0;
            const auto [stop, error] = std::from_chars(end - 4, end, escaped, 16);
            const bool surrogate = escaped >= 0xD800U && escaped < 0xE000U;
            if (error == std::errc{} && stop == end && !surrogate) {
                append_utf8(name, escaped);
                i += kEscape - 1;
                continue;
            }
        }
        if (utf8) {
            name += value[i];
        } else {
            append_utf8(name, code);
        }
    }
    return name;
}

std::string key_of(std::string_view value) {
    std::string key = name_of(input::trimmed(value));
    for (char& c : key) {
        if (c >= 'A' && c <= 'Z') c = static_cast<char>(c - 'A' + 'a');
    }
    return key;
}

int whole(double value) {
    constexpr double kGreatest = 2e9;
    return static_cast<int>(std::clamp(std::trunc(value), -kGreatest, kGreatest));
}

std::optional<Group> Groups::any() {
    const auto code = input::next_line(rest_);
    if (!code) return std::nullopt;
    return Group{code_of(*code).value_or(-1), value_of(rest_)};
}

std::optional<Group> Groups::next() {
    constexpr int kBraces = 102;
    auto group = any();
    while (group && group->code == kBraces && group->value.starts_with('{')) {
        do {
            group = any();
        } while (group && !(group->code == kBraces && group->value.starts_with('}')));
        group = any();
    }
    return group;
}

Fields::Fields(const Drawing& drawing, const Entity& entity) : drawing_(&drawing) {
    Groups groups(entity.text);
    while (const auto group = groups.next()) groups_.push_back(*group);
}

const Group* Fields::find(int code) const {
    const auto found = std::ranges::find(groups_, code, &Group::code);
    return found == groups_.end() ? nullptr : &*found;
}

double Fields::number(int code, double otherwise) const {
    const Group* group = find(code);
    return group == nullptr ? otherwise : drawing_->number(*group);
}

int Fields::integer(int code, int otherwise) const {
    return whole(number(code, otherwise));
}

std::string_view Fields::word(int code) const {
    const Group* group = find(code);
    return group == nullptr ? std::string_view{} : group->value;
}

Drawing::Drawing(std::string text, const std::filesystem::path& path)
    : text_(std::move(text)), path_(path.string()) {
    read();
}

void Drawing::fail(std::string_view at, MessageText<1> text) const {
    const auto line = 1 + std::count(text_.data(), at.data(), '\n');
    throw FormatError(path_, static_cast<std::uint64_t>(line), message(text, input::in_quotes(at)));
}

double Drawing::number(const Group& group) const {
    const auto value = input::parse_number(group.value);
    if (!value || !std::isfinite(*value))
        fail(group.value, HITOS_TEXT("Errors", "found %1, expected a finite number"));
    return *value;
}

void Drawing::read_table_entry(const Entity& entry, std::map<std::string, std::string>& sheets) {
    constexpr int kFrozen = 1;
    const Fields fields(*this, entry);
    const std::string_view name = fields.word(2);
    if (entry.type == "LAYER") {
        const bool frozen = (fields.integer(70, 0) & kFrozen) != 0;
        const bool off = fields.integer(62, 0) < 0;
        layers[key_of(name)] = {name_of(name), frozen || off, frozen};
    } else if (entry.type == "MLINESTYLE") {
        mline_flags[key_of(name)] = fields.integer(70, 0);
    } else if (entry.type == "BLOCK_RECORD") {
        if (is_sheet(key_of(name))) sheets[std::string(fields.word(5))] = key_of(name);
    }
}

void Drawing::read() {
    std::string_view rest = text_;
    if (rest.starts_with("\xEF\xBB\xBF")) rest.remove_prefix(3);
    if (rest.starts_with("AutoCAD Binary DXF"))
        fail(rest.substr(0, 18),
             HITOS_TEXT("Errors", "found %1, expected a drawing that is saved as ASCII DXF"));
    std::string_view section;
    std::string_view variable;
    std::map<std::string, std::string> sheets;  // by the handles of their records
    Block* block = nullptr;
    bool on_sheet = false;
    Entity entity;
    std::size_t count = 0;

    // What the groups since the last 0 are, now that the next one begins.
    const auto finish = [&] {
        const std::string_view type = entity.type;
        if (type.empty()) return;
        if (section == "TABLES" || section == "OBJECTS") {
            read_table_entry(entity, sheets);
        } else if (section == "BLOCKS" && type == "BLOCK") {
            const Fields fields(*this, entity);
            const std::string key = key_of(fields.word(2));
            block = &blocks[key];
            on_sheet = is_sheet(key);
            block->base = {fields.number(10, 0.0), fields.number(20, 0.0), fields.number(30, 0.0)};
            constexpr int kExternal = 4 | 8;
            if ((fields.integer(70, 0) & kExternal) != 0) block->external = name_of(fields.word(1));
        } else if (section == "BLOCKS" && type == "ENDBLK") {
            block = nullptr;
        } else if (section == "ENTITIES" || block != nullptr) {
            if (++count > kMostEntities) {
                throw FormatError(path_, 0,
                                  HITOS_TEXT("Errors",
                                             "holds more than %1 entities; save the layers of the "
                                             "walls as a drawing of their own"),
                                  kMostEntities);
            }
            // What a sheet's block holds is counted with what stands on the sheet itself.
            entity.paper = entity.paper || (block != nullptr && on_sheet);
            (block != nullptr && !on_sheet ? block->entities : entities).push_back(entity);
        }
    };

    bool in_braces = false;
    const char* begin = rest.data();
    while (true) {
        const std::string_view before = rest;
        const auto line = input::next_line(rest);
        if (!line || (input::trimmed(rest).empty() && input::trimmed(*line).empty())) break;
        const auto code = code_of(*line);
        if (!code)
            fail(line->substr(0, line->find('\r')),
                 HITOS_TEXT("Errors", "found %1, expected a group code of an ASCII DXF drawing"));
        const std::string_view value = value_of(rest);
        if (*code == 0) {
            entity.text = std::string_view(begin, static_cast<std::size_t>(before.data() - begin));
            finish();
            entity = {};
            in_braces = false;
            begin = rest.data();
            if (value == "EOF") {
                ended = true;
                break;
            }
            if (value == "ENDSEC") {
                section = {};
                block = nullptr;
            }
            if (value == "SECTION") section = "?";  // its name follows
            if (!section.empty() && section != "?") entity.type = value;
        } else if (section == "?" && *code == 2) {
            section = value;
        } else if (*code == 9) {
            variable = value;
        } else if (section == "HEADER" && variable == "$INSUNITS" && *code == 70) {
            insunits = whole(number({*code, value}));
        } else if (*code == 102) {
            in_braces = value.starts_with('{');
        } else if (*code == 8) {
            entity.layer = value;
        } else if (*code == 67) {
            entity.paper = entity.paper || whole(number({*code, value})) == 1;
        } else if (*code == 60 && section != "TABLES" && section != "OBJECTS") {
            entity.invisible = whole(number({*code, value})) == 1;
        } else if (*code == 330 && !in_braces) {
            entity.paper = entity.paper || sheets.contains(std::string(value));
        }
    }
    // Where the file breaks off, its last entity may be half of one: it is not taken.
    // Some programs keep the model's entities in its block.
    for (const char* model : {"*model_space", "$model_space"}) {
        const auto found = blocks.find(model);
        if (found == blocks.end()) continue;
        entities.insert(entities.end(), found->second.entities.begin(),
                        found->second.entities.end());
        found->second.entities.clear();
    }
}

}  // namespace hitos::dxf
