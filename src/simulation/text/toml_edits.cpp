// SPDX-License-Identifier: GPL-3.0-or-later
// Values and lists of a TOML text, changed where they stand.
#include <fmt/format.h>

#include <algorithm>
#include <bit>
#include <cstdint>

#include "toml_text.hpp"

namespace hitos {
namespace {

constexpr std::size_t kWidth = 100;  // of lines that are written anew
constexpr std::size_t kMostCompared = 4'000'000;

bool same_number(double a, double b) {
    return std::bit_cast<std::uint64_t>(a) == std::bit_cast<std::uint64_t>(b);
}

std::string list_text(const TomlValue& value, const std::string& newline,
                      const std::string& indent) {
    std::string line;
    for (const TomlValue& entry : value.list) {
        line += (line.empty() ? "[" : ", ") + written(entry, newline, indent);
    }
    line += value.list.empty() ? "[]" : "]";
    if (!value.a_line_each && line.size() <= kWidth) return line;
    const std::string inner = indent + "    ";
    std::string text = "[";
    std::string now;
    const auto end_line = [&] {
        if (!now.empty()) text += newline + inner + now;
        now.clear();
    };
    for (const TomlValue& entry : value.list) {
        const std::string next = written(entry, newline, inner) + ",";
        if (value.a_line_each || now.size() + next.size() + inner.size() > kWidth) end_line();
        now += (now.empty() ? "" : " ") + next;
    }
    end_line();
    return text + newline + indent + "]";
}

}  // namespace

TomlValue TomlValue::of(double number) {
    TomlValue value;
    value.text = fmt::format("{}", number);
    if (value.text == "-0") value.text = "-0.0";  // an integer has no signed zero
    value.number = number;
    return value;
}

TomlValue TomlValue::word(std::string_view word) {
    TomlValue value;
    value.text = fmt::format("\"{}\"", word);
    return value;
}

TomlValue TomlValue::flag(bool on) {
    TomlValue value;
    value.text = on ? "true" : "false";
    return value;
}

TomlValue TomlValue::of(std::vector<TomlValue> list, bool a_line_each) {
    TomlValue value;
    value.kind = Kind::list;
    value.list = std::move(list);
    value.a_line_each = a_line_each;
    return value;
}

TomlValue TomlValue::of(std::vector<Member> table) {
    TomlValue value;
    value.kind = Kind::table;
    value.table = std::move(table);
    return value;
}

std::string written(const TomlValue& value, const std::string& newline, const std::string& indent) {
    if (value.kind == TomlValue::Kind::scalar) return value.text;
    if (value.kind == TomlValue::Kind::list) return list_text(value, newline, indent);
    std::string text = "{";
    for (const TomlValue::Member& member : value.table) {
        if (member.may_be_left_out) continue;
        TomlValue inside = member.value;
        inside.a_line_each = false;
        text += fmt::format("{}{} = {}", text.size() == 1 ? " " : ", ", member.key,
                            written(inside, newline, indent));
    }
    return text + " }";
}

bool reads_as(const toml::node& node, const TomlValue& value) {
    if (value.kind == TomlValue::Kind::scalar) {
        // A list of one number reads as the number.
        if (const auto* list = node.as_array(); list != nullptr && value.number) {
            return list->size() == 1 && list->front().is_number() && reads_as(list->front(), value);
        }
        if (value.number) {
            const auto number = node.value<double>();
            return number && same_number(*number, *value.number);
        }
        if (const auto* word = node.as_string())
            return fmt::format("\"{}\"", word->get()) == value.text || word->get() == value.text;
        return node.is_boolean() && (node.ref<bool>() ? "true" : "false") == value.text;
    }
    if (value.kind == TomlValue::Kind::list) {
        const auto* list = node.as_array();
        if (list == nullptr || list->size() != value.list.size()) return false;
        for (std::size_t i = 0; i < list->size(); ++i) {
            if (!reads_as((*list)[i], value.list[i])) return false;
        }
        return true;
    }
    const auto* table = node.as_table();
    if (table == nullptr) return false;
    std::size_t known = 0;
    for (const TomlValue::Member& member : value.table) {
        const toml::node* found = table->get(member.key);
        known += found != nullptr;
        if (found == nullptr ? !member.may_be_left_out : !reads_as(*found, member.value))
            return false;
    }
    return known == table->size();
}

std::vector<std::pair<std::size_t, std::size_t>> staying(const toml::array& old,
                                                         const std::vector<TomlValue>& wanted) {
    std::vector<std::pair<std::size_t, std::size_t>> pairs;
    std::size_t from = 0;
    while (from < old.size() && from < wanted.size() && reads_as(old[from], wanted[from])) {
        pairs.emplace_back(from, from);
        ++from;
    }
    std::size_t n = old.size() - from;
    std::size_t m = wanted.size() - from;
    const std::size_t n_all = n;
    while (n > 0 && m > 0 && reads_as(old[from + n - 1], wanted[from + m - 1])) --n, --m;
    if (n * m <= kMostCompared) {
        // Longest common subsequence: longest[i][k] of what is left from i and k on.
        std::vector<std::uint32_t> longest((n + 1) * (m + 1), 0);
        const auto at = [&](std::size_t i, std::size_t k) -> std::uint32_t& {
            return longest[i * (m + 1) + k];
        };
        std::vector<bool> same(n * m);
        for (std::size_t i = n; i-- > 0;) {
            for (std::size_t k = m; k-- > 0;) {
                same[i * m + k] = reads_as(old[from + i], wanted[from + k]);
                at(i, k) =
                    same[i * m + k] ? at(i + 1, k + 1) + 1 : std::max(at(i + 1, k), at(i, k + 1));
            }
        }
        for (std::size_t i = 0, k = 0; i < n && k < m;) {
            if (same[i * m + k]) {
                pairs.emplace_back(from + i++, from + k++);
            } else {
                (at(i + 1, k) >= at(i, k + 1) ? i : k) += 1;
            }
        }
    }
    for (std::size_t i = 0; i < n_all - n; ++i) pairs.emplace_back(from + n + i, from + m + i);
    return pairs;
}

void TomlEdits::replace(std::size_t begin, std::size_t end, std::string by) {
    edits_.push_back({begin, end, std::move(by)});
}

std::string TomlEdits::applied() const {
    std::vector<const Edit*> order;
    order.reserve(edits_.size());
    for (const Edit& edit : edits_) order.push_back(&edit);
    std::ranges::stable_sort(order, {}, [](const Edit* edit) { return edit->begin; });
    std::string text;
    std::size_t done = 0;
    for (const Edit* edit : order) {
        if (edit->begin > done) text.append(places_.text(), done, edit->begin - done);
        text += edit->by;
        done = std::max(done, edit->end);
    }
    return text.append(places_.text(), done);
}

void TomlEdits::rewrite(const toml::node& node, const TomlValue& value) {
    if (reads_as(node, value)) return;
    if (const auto* list = node.as_array(); list != nullptr &&
                                            value.kind == TomlValue::Kind::list && !list->empty() &&
                                            !value.list.empty()) {
        rewrite_list(*list, value.list);
        return;
    }
    if (const auto* table = node.as_table();
        table != nullptr && value.kind == TomlValue::Kind::table) {
        const bool all = std::ranges::all_of(value.table, [&](const TomlValue::Member& member) {
            return table->contains(member.key) || member.may_be_left_out;
        });
        const auto known = std::ranges::count_if(
            value.table, [&](const auto& member) { return table->contains(member.key); });
        if (all && static_cast<std::size_t>(known) == table->size()) {
            for (const TomlValue::Member& member : value.table) {
                if (const toml::node* old = table->get(member.key)) rewrite(*old, member.value);
            }
            return;
        }
    }
    const std::size_t begin = places_.begin(node);
    replace(begin, places_.end(node), written(value, places_.newline(), places_.indent(begin)));
}

void TomlEdits::rewrite_list(const toml::array& list, const std::vector<TomlValue>& wanted) {
    auto stays = staying(list, wanted);
    stays.emplace_back(list.size(), wanted.size());
    std::size_t i = 0;
    std::size_t k = 0;
    for (const auto& [old, now] : stays) {
        // Between entries that stay the first ones change, and the others go or come.
        for (; i < old && k < now; ++i, ++k) rewrite(list[i], wanted[k]);
        if (i < old) remove_entries(list, i, old);
        if (k < now) {
            const auto first = wanted.begin() + static_cast<std::ptrdiff_t>(k);
            insert_behind(list, static_cast<std::ptrdiff_t>(i) - 1,
                          {first, wanted.begin() + static_cast<std::ptrdiff_t>(now)});
        }
        i = old + 1;
        k = now + 1;
    }
}

void TomlEdits::insert_behind(const toml::array& list, std::ptrdiff_t entry,
                              const std::vector<TomlValue>& values) {
    const std::string& newline = places_.newline();
    const auto block = [&](const std::string& indent) {
        std::string text;
        for (const TomlValue& value : values)
            text += newline + indent + written(value, newline, indent) + ",";
        return text;
    };
    std::string row;
    for (const TomlValue& value : values)
        row += (row.empty() ? "" : ", ") + written(value, newline, "");
    if (entry < 0) {
        const std::size_t open = places_.begin(list);
        const std::size_t first = places_.begin(list.front());
        if (places_.same_line(open, first)) {
            insert(open + 1, row + ", ");
        } else {
            insert(places_.line_end(open), block(places_.indent(first)));
        }
        return;
    }
    const toml::node& before = list[static_cast<std::size_t>(entry)];
    const std::size_t end = places_.end(before);
    const auto comma = places_.comma_after(end);
    const std::size_t behind = comma ? *comma + 1 : end;
    const bool own_lines = places_.first_on_line(places_.begin(before)) &&
                           places_.nothing_follows(behind) && places_.same_line(end, behind);
    if (own_lines) {
        std::string text = block(places_.indent(places_.begin(before)));
        if (!comma) {
            insert(end, ",");
            text.pop_back();
        }
        insert(places_.line_end(behind), std::move(text));
    } else {
        insert(behind, comma ? " " + row + "," : ", " + row);
    }
}

void TomlEdits::remove_entries(const toml::array& list, std::size_t from, std::size_t to) {
    const std::size_t last = places_.end(list[to - 1]);
    if (from > 0 && !places_.comma_after(last)) {
        // The comma before the last entries goes with them where nothing but entries is between.
        const std::size_t begin = places_.end(list[from - 1]);
        bool plain = true;
        for (std::size_t i = from; i < to; ++i) {
            const std::size_t gap = places_.end(list[i - 1]);
            const std::string_view between =
                std::string_view(places_.text()).substr(gap, places_.begin(list[i]) - gap);
            plain = plain && between.find_first_of("#\n") == std::string_view::npos;
        }
        if (plain) {
            remove(begin, last);
            return;
        }
    }
    for (std::size_t i = from; i < to; ++i) {
        const std::size_t begin = places_.begin(list[i]);
        std::size_t group = i;  // the last one that goes from this line
        while (group + 1 < to &&
               places_.same_line(places_.end(list[group]), places_.begin(list[group + 1])))
            ++group;
        const auto behind = [&](std::size_t entry) {
            const std::size_t end = places_.end(list[entry]);
            const auto comma = places_.comma_after(end);
            return comma && places_.same_line(*comma, end) ? *comma + 1 : end;
        };
        const std::size_t rest = behind(group);
        if (places_.first_on_line(begin) && places_.nothing_follows(rest)) {
            remove(places_.line_begin(begin), places_.next_line(rest));
            if (const auto comma = places_.comma_after(rest);
                comma && rest == places_.end(list[group])) {
                remove(*comma, *comma + 1);  // on a line of its own
            }
            i = group;
            continue;
        }
        std::size_t end = behind(i);
        if (const auto comma = places_.comma_after(end); comma && end == places_.end(list[i]))
            remove(*comma, *comma + 1);
        end = std::min(places_.text().find_first_not_of(" \t", end), places_.text().size());
        remove(begin, end);
    }
}

}  // namespace hitos
