// SPDX-License-Identifier: GPL-3.0-or-later
#include "recordings/db3_leaves.hpp"

#include <algorithm>
#include <array>

namespace hitos {
namespace {

constexpr char kTableLeaf = 13;

/// Takes numbers off the front of a cell; what is beyond its end fails.
struct Bytes {
    std::string_view left;
    bool good = true;

    std::string_view take(std::uint64_t count) {
        good = good && count <= left.size();
        const std::string_view taken = left.substr(0, good ? count : 0);
        left.remove_prefix(taken.size());
        return taken;
    }
    /// Seven bits a byte, the greatest first; the ninth byte has eight.
    std::uint64_t varint() {
        std::uint64_t value = 0;
        for (int i = 0; i < 9; ++i) {
            const std::uint64_t byte = big_endian(take(1));
            if (i == 8) return value << 8 | byte;
            value = value << 7 | (byte & 0x7fU);
            if (byte < 0x80) break;
        }
        return value;
    }
    /// A whole number of SQLite's type 1 … 6, 8 or 9.
    std::int64_t whole(std::uint64_t type) {
        constexpr std::array<std::uint64_t, 7> kSizes = {0, 1, 2, 3, 4, 6, 8};
        if (type == 8 || type == 9) return static_cast<std::int64_t>(type - 8);
        good = good && type > 0 && type < kSizes.size();
        if (!good) return 0;
        const std::uint64_t bits = 8 * kSizes[type];
        return static_cast<std::int64_t>(big_endian(take(kSizes[type])) << (64 - bits)) >>
               (64 - bits);
    }
};

}  // namespace

std::optional<Db3Leaves::Row> Db3Leaves::next() {
    const std::string_view page = page_;
    for (;;) {
        const std::size_t head = number_ == 1 ? 100 : 0;  // the file's own
        while (cell_ < cells_) {
            const std::size_t at = head + 8 + 2 * cell_++;
            if (const auto row = row_at(big_endian(page.substr(at, 2)))) return row;
        }
        if (number_ >= pages_.last_page()) return std::nullopt;
        cells_ = cell_ = 0;
        ++number_;
        const std::size_t begin = number_ == 1 ? 100 : 0;
        if (!pages_.read((number_ - 1) * page_.size(), page_) || page[begin] != kTableLeaf)
            continue;
        cells_ = std::min<std::size_t>(big_endian(page.substr(begin + 3, 2)),
                                       (page.size() - begin - 8) / 2);
    }
}

std::optional<Db3Leaves::Row> Db3Leaves::row_at(std::size_t place) {
    const std::uint64_t usable = page_.size() - pages_.reserved();
    if (place >= usable) return std::nullopt;
    Row row;
    Bytes cell{std::string_view(page_).substr(place, usable - place)};
    const std::uint64_t size = cell.varint();
    row.id = static_cast<std::int64_t>(cell.varint());
    // How much of a cell stands in the page itself [fileformat2, "B-tree Pages"].
    std::uint64_t local = size;
    if (size > usable - 35) {
        const std::uint64_t least = (usable - 12) * 32 / 255 - 23;
        local = least + (size - least) % (usable - 4);
        if (local > usable - 35) local = least;
    }
    Bytes content{cell.take(local)};
    chain_ = local < size ? big_endian(cell.take(4)) : 0;
    const std::uint64_t whole = content.left.size();
    const std::uint64_t header = content.varint();
    std::array<std::uint64_t, 4> types{};
    for (std::uint64_t& type : types) type = content.varint();
    const bool four = whole - content.left.size() == header;
    row.topic = content.whole(types[1]);
    row.time_ns = content.whole(types[2]);
    if (!cell.good || !content.good || !four || types[0] != 0 || types[3] < 12 ||
        types[3] % 2 != 0) {
        return std::nullopt;
    }
    row.length = (types[3] - 12) / 2;
    if (whole - content.left.size() + row.length != size) return std::nullopt;
    length_ = row.length;
    here_ = content.left;
    return row;
}

std::optional<std::string_view> Db3Leaves::data() {
    data_ = here_;
    std::string page(page_.size(), '\0');
    while (data_.size() < length_) {
        if (chain_ == 0 || chained_left_ == 0) return std::nullopt;
        --chained_left_;
        if (!pages_.read((chain_ - 1) * page.size(), page)) return std::nullopt;
        chain_ = big_endian(std::string_view(page).substr(0, 4));
        const std::uint64_t room = page.size() - pages_.reserved() - 4;
        data_.append(page, 4, std::min(room, length_ - data_.size()));
    }
    return data_;
}

}  // namespace hitos
