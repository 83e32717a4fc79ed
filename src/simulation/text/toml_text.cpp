// SPDX-License-Identifier: GPL-3.0-or-later
#include "toml_text.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "hitos/base/text_input.hpp"

namespace hitos {
namespace {

/// Entries that have headers of their own: [[people]].
bool has_headers(const toml::node& node, const TomlPlaces& places) {
    const auto* list = node.as_array();
    return list != nullptr && list->is_array_of_tables() &&
           places.text().compare(places.begin(node), 2, "[[") == 0;
}

bool under_header(const toml::table& table, const TomlPlaces& places) {
    return !table.is_inline() && places.text()[places.begin(table)] == '[';
}

/// Where the last value ends that stands in the table itself, under no further header.
std::optional<std::size_t> last_value(const toml::table& table, const TomlPlaces& places) {
    std::optional<std::size_t> last;
    for (const auto& [key, node] : table) {
        std::optional<std::size_t> end;
        if (const auto* inner = node.as_table(); inner != nullptr && !inner->is_inline()) {
            if (!under_header(*inner, places)) end = last_value(*inner, places);
        } else if (!has_headers(node, places)) {
            end = places.end(node);
        }
        if (end && (!last || *end > *last)) last = end;
    }
    return last;
}

/// Where what belongs to a header begins: at the comments right above it, unless the file begins
/// with them.
std::size_t before_header(std::size_t header, const TomlPlaces& places) {
    std::size_t begin = places.line_begin(header);
    std::size_t at = begin;
    while (at > 0) {
        at = places.line_begin(at - 1);
        if (places.text()[at + places.indent(at).size()] != '#') return begin;
        begin = at;
    }
    return at == 0 ? places.line_begin(header) : begin;
}

/// The lines of a table with a header: from it to behind its last value.
std::pair<std::size_t, std::size_t> block_of(const toml::table& table, const TomlPlaces& places) {
    const std::size_t header = places.begin(table);
    return {places.line_begin(header),
            places.next_line(last_value(table, places).value_or(header))};
}

/// "people" of "[[people]]".
std::string header_name(const toml::table& table, const TomlPlaces& places) {
    const std::string& text = places.text();
    const std::size_t begin = text.find_first_not_of("[ \t", places.begin(table));
    const std::string_view name =
        std::string_view(text).substr(begin, text.find(']', begin) - begin);
    return std::string(name.substr(0, name.find_last_not_of(" \t") + 1));
}

std::string block_text(const std::string& name, const TomlValue& value,
                       const std::string& newline) {
    std::string text = fmt::format("[[{}]]{}", name, newline);
    for (const TomlValue::Member& member : value.table) {
        if (member.may_be_left_out) continue;
        text += fmt::format("{} = {}{}", member.key, written(member.value, newline), newline);
    }
    return text;
}

void rewrite_block(TomlEdits& edits, const toml::table& table, const TomlValue& value,
                   const TomlPlaces& places) {
    if (reads_as(table, value)) return;
    for (const auto& [key, node] : table) {
        const bool wanted =
            std::ranges::find(value.table, key.str(), &TomlValue::Member::key) != value.table.end();
        if (!wanted) {
            edits.remove(places.line_begin(places.at(key.source().begin)),
                         places.next_line(places.end(node)));
        }
    }
    std::string fresh;
    for (const TomlValue::Member& member : value.table) {
        if (const toml::node* old = table.get(member.key)) {
            edits.rewrite(*old, member.value);
        } else if (!member.may_be_left_out) {
            fresh += fmt::format("{}{} = {}", places.newline(), member.key,
                                 written(member.value, places.newline()));
        }
    }
    if (!fresh.empty()) edits.insert(places.line_end(places.begin(table)), std::move(fresh));
}

/// Entries with headers: those that stay keep their lines.
void rewrite_blocks(TomlEdits& edits, const toml::array& list, const std::vector<TomlValue>& wanted,
                    const TomlPlaces& places) {
    auto stays = staying(list, wanted);
    stays.emplace_back(list.size(), wanted.size());
    std::size_t i = 0;
    std::size_t k = 0;
    for (const auto& [old, now] : stays) {
        for (; i < old && k < now; ++i, ++k)
            rewrite_block(edits, *list[i].as_table(), wanted[k], places);
        for (; i < old; ++i) {
            const auto [begin, end] = block_of(*list[i].as_table(), places);
            edits.remove(begin, end);
        }
        for (; k < now; ++k) {
            const toml::table& near = *list[i > 0 ? i - 1 : 0].as_table();
            const auto [begin, end] = block_of(near, places);
            const std::string text =
                block_text(header_name(near, places), wanted[k], places.newline());
            if (i > 0) {
                const bool open_end = end > 0 && places.text()[end - 1] != '\n';
                edits.insert(end, (open_end ? places.newline() : "") + places.newline() + text);
            } else {
                edits.insert(begin, text + places.newline());
            }
        }
        i = old + 1;
        k = now + 1;
    }
}

class KeyEdit {
  public:
    KeyEdit(const std::string& text, std::string_view table, std::string_view key)
        : places_(text),
          edits_(places_),
          document_(toml::parse(text)),
          table_(table),
          key_(key),
          owner_(table.empty() ? &document_ : document_[table].as_table()),
          node_(owner_ != nullptr ? owner_->get(key) : nullptr) {}

    std::string set(const TomlValue& value) {
        if (node_ == nullptr) {
            add(written(value, places_.newline()));
        } else if (has_headers(*node_, places_) && value.kind == TomlValue::Kind::list) {
            rewrite_blocks(edits_, *node_->as_array(), value.list, places_);
        } else {
            edits_.rewrite(*node_, value);
        }
        return edits_.applied();
    }

    std::string remove() {
        if (node_ == nullptr) return places_.text();
        if (has_headers(*node_, places_)) {
            for (const toml::node& entry : *node_->as_array()) {
                const auto [begin, end] = block_of(*entry.as_table(), places_);
                edits_.remove(begin, end);
            }
        } else if (owner_->is_inline()) {
            remove_inline();
        } else {
            edits_.remove(places_.line_begin(places_.begin(*node_)),
                          places_.next_line(places_.end(*node_)));
        }
        return edits_.applied();
    }

  private:
    void add(const std::string& value) {
        const std::string line = fmt::format("{} = {}", key_, value);
        if (owner_ == nullptr) {
            append(fmt::format("[{}]{}{}", table_, places_.newline(), line));
        } else if (owner_ == &document_) {
            add_to_document(line);
        } else if (owner_->is_inline()) {
            const std::size_t close = places_.end(*owner_) - 1;
            const auto last = last_value(*owner_, places_);
            edits_.insert(last.value_or(close), (last ? ", " : " ") + line + (last ? "" : " "));
        } else if (!under_header(*owner_, places_)) {
            add_line(*last_value(*owner_, places_), fmt::format("{}.{}", table_, line));
        } else if (header_name(*owner_, places_) == table_) {
            add_line(last_value(*owner_, places_).value_or(places_.begin(*owner_)), line);
        } else {  // only tables inside it have headers
            const std::string& newline = places_.newline();
            edits_.insert(before_header(places_.begin(*owner_), places_),
                          fmt::format("[{}]{}{}{}{}", table_, newline, line, newline, newline));
        }
    }

    void add_line(std::size_t behind, const std::string& line) {
        edits_.insert(places_.line_end(behind), places_.newline() + line);
    }

    void add_to_document(const std::string& line) {
        if (const auto last = last_value(document_, places_)) {
            add_line(*last, line);
            return;
        }
        std::optional<std::size_t> header;
        for (const auto& [key, node] : document_) {
            const std::size_t begin = places_.begin(node);
            header = std::min(header.value_or(begin), begin);
        }
        if (header) {
            edits_.insert(before_header(*header, places_),
                          line + places_.newline() + places_.newline());
        } else {
            append(line);
        }
    }

    void append(const std::string& lines) {
        const std::string& text = places_.text();
        const bool blank = text.empty() || text == input::kByteOrderMark;
        const std::string& newline = places_.newline();
        std::string gap = blank ? "" : newline;
        if (!blank && text.back() != '\n') gap += newline;
        edits_.insert(text.size(), gap + lines + newline);
    }

    void remove_inline() {
        const std::size_t begin = places_.begin(*node_);
        std::optional<std::size_t> before;  // end of the value in front
        std::optional<std::size_t> after;   // begin of the key behind
        for (const auto& [key, node] : *owner_) {
            if (places_.begin(node) < begin)
                before = std::max(before.value_or(0), places_.end(node));
            if (const std::size_t at = places_.at(key.source().begin); at > begin)
                after = std::min(after.value_or(at), at);
        }
        const std::size_t open = places_.begin(*owner_) + 1;
        if (before || !after) {
            edits_.remove(before.value_or(open), places_.end(*node_));
        } else {
            edits_.replace(open, *after, " ");
        }
    }

    TomlPlaces places_;
    TomlEdits edits_;
    toml::table document_;
    std::string table_;
    std::string key_;
    const toml::table* owner_;
    const toml::node* node_;
};

}  // namespace

TomlPlaces::TomlPlaces(const std::string& text) : text_(text), newline_("\n") {
    lines_.push_back(text.starts_with(input::kByteOrderMark) ? input::kByteOrderMark.size() : 0);
    for (std::size_t at = text.find('\n'); at != std::string::npos; at = text.find('\n', at + 1))
        lines_.push_back(at + 1);
    if (const std::size_t first = text.find('\n');
        first != std::string::npos && first > 0 && text[first - 1] == '\r')
        newline_ = "\r\n";
}

std::size_t TomlPlaces::at(const toml::source_position& position) const {
    std::size_t at = lines_.at(position.line - 1);
    // Columns count code points.
    for (toml::source_index column = 1; column < position.column && at < text_.size(); ++column) {
        ++at;
        while (at < text_.size() && (static_cast<unsigned char>(text_[at]) & 0xc0U) == 0x80U) ++at;
    }
    return at;
}

std::size_t TomlPlaces::line_begin(std::size_t at) const {
    const auto next = std::ranges::upper_bound(lines_, at);
    return next == lines_.begin() ? lines_.front() : *(next - 1);
}

std::size_t TomlPlaces::line_end(std::size_t at) const {
    const std::size_t end = std::min(text_.find('\n', at), text_.size());
    return end > at && end < text_.size() && text_[end - 1] == '\r' ? end - 1 : end;
}

std::size_t TomlPlaces::next_line(std::size_t at) const {
    const std::size_t end = text_.find('\n', at);
    return end == std::string::npos ? text_.size() : end + 1;
}

std::string TomlPlaces::indent(std::size_t at) const {
    const std::size_t begin = line_begin(at);
    return text_.substr(begin,
                        std::min(text_.find_first_not_of(" \t", begin), text_.size()) - begin);
}

bool TomlPlaces::nothing_follows(std::size_t at) const {
    const std::size_t next = text_.find_first_not_of(" \t\r", at);
    return next == std::string::npos || text_[next] == '\n' || text_[next] == '#';
}

std::optional<std::size_t> TomlPlaces::comma_after(std::size_t at) const {
    while ((at = text_.find_first_not_of(" \t\r\n", at)) != std::string::npos) {
        if (text_[at] == ',') return at;
        if (text_[at] != '#') break;
        at = std::min(text_.find('\n', at), text_.size());
    }
    return std::nullopt;
}

void TomlText::set(std::string_view table, std::string_view key, const TomlValue& value) {
    text_ = KeyEdit(text_, table, key).set(value);
}

std::optional<double> TomlText::number(std::string_view table, std::string_view key,
                                       std::size_t entry) const {
    return toml::parse(text_)[table][key][entry].value<double>();
}

void TomlText::remove(std::string_view table, std::string_view key) {
    text_ = KeyEdit(text_, table, key).remove();
}

}  // namespace hitos
