// SPDX-License-Identifier: GPL-3.0-or-later
// Messages of a damaged SQLite file, found page by page where its tree leads no further: the pages
// above the leaves are written behind them, and so are the first to be cut off.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

#include "recordings/db3_pages.hpp"

namespace hitos {

/// Goes through the leaves in the order of the file, which is that of the rows in what is only
/// appended to.
class Db3Leaves {
  public:
    /// The pages must live longer.
    explicit Db3Leaves(const Db3Pages& pages)
        : pages_(pages), page_(pages.page_size(), '\0'), chained_left_(pages.last_page()) {}

    struct Row {
        std::int64_t id = 0;
        std::int64_t topic = 0;
        std::int64_t time_ns = 0;
        std::uint64_t length = 0;  ///< of the data
    };
    /// The next row that can be one of `messages`: of NULL, two whole numbers and a blob.
    std::optional<Row> next();
    /// The data of the row that next() gave last; nothing where some of them are missing. Valid
    /// until next() is called again.
    std::optional<std::string_view> data();

  private:
    std::optional<Row> row_at(std::size_t place);

    const Db3Pages& pages_;
    std::string page_;
    std::uint64_t number_ = 0;  ///< of the page
    std::size_t cells_ = 0;
    std::size_t cell_ = 0;
    std::uint64_t length_ = 0;    ///< of the row's data
    std::string_view here_;       ///< what of them stands in the page
    std::uint64_t chain_ = 0;     ///< the page that has what follows
    std::uint64_t chained_left_;  ///< pages belong to one chain: no more than there are
    std::string data_;
};

}  // namespace hitos
