// SPDX-License-Identifier: GPL-3.0-or-later
// rosbag2's SQLite files. A file is bad input like any other: what its schema could run is shut
// off, and rows must come in order, so that damage can neither repeat them without end nor blow
// memory up.
#include <fmt/format.h>
#include <fmt/ranges.h>
#include <sqlite3.h>

#include <algorithm>
#include <map>
#include <string>
#include <utility>
#include <vector>

#include "hitos/base/error.hpp"
#include "recordings/db3_leaves.hpp"
#include "recordings/db3_pages.hpp"
#include "recordings/recording.hpp"

namespace hitos {
namespace {

constexpr std::string_view kDb3Magic{"SQLite format 3\0", 16};

struct CloseDatabase {
    void operator()(sqlite3* database) const { sqlite3_close(database); }
};
struct CloseStatement {
    void operator()(sqlite3_stmt* statement) const { sqlite3_finalize(statement); }
};
using Statement = std::unique_ptr<sqlite3_stmt, CloseStatement>;

class Db3 final : public Recording {
  public:
    Db3(const std::filesystem::path& path, RecordingUse use)
        : path_(path), use_(std::move(use)), pages_(path) {
        open();
        require_table("topics");
        require_table("messages");
        read_topics();
        last_id_ = largest_id();
        rows_ = prepare(messages_query().c_str());
    }

    std::optional<RecordedMessage> next() override {
        while (rows_) {
            const int result = sqlite3_step(rows_.get());
            if (result == SQLITE_NOMEM) throw std::bad_alloc();
            if (result == SQLITE_DONE) {
                rows_.reset();
                break;
            }
            const sqlite3_int64 id =
                result == SQLITE_ROW ? sqlite3_column_int64(rows_.get(), 0) : 0;
            if (result != SQLITE_ROW || (any_ && id <= id_)) {
                if (!pages_.cut()) {
                    note(use_.topics.count_damage(),
                         message(HITOS_TEXT("Errors", "behind the row %1: %2"), id_,
                                 result == SQLITE_ROW
                                     ? message(HITOS_TEXT("Errors", "rows come out of order"))
                                     : verbatim(sqlite3_errmsg(database_.get()))));
                }
                rows_.reset();
                leaves_.emplace(pages_);
                break;
            }
            any_ = true;
            id_ = id;
            if (std::optional<RecordedMessage> found = message_of_row()) return found;
        }
        while (leaves_) {
            const std::optional<Db3Leaves::Row> row = leaves_->next();
            if (!row) {
                leaves_.reset();
                break;
            }
            if ((any_ && row->id <= id_) || !ids_.contains(row->topic)) continue;
            any_ = true;
            id_ = row->id;
            if (std::optional<RecordedMessage> found = message_of_leaf(*row)) return found;
        }
        for (; told_ < pages_.problems().size(); ++told_) {
            note(use_.topics.count_damage(), pages_.problems()[told_]);
        }
        return std::nullopt;
    }

    double progress() const override {
        if (!rows_ || last_id_ <= 0) return 1.0;
        return std::clamp(static_cast<double>(id_) / static_cast<double>(last_id_), 0.0, 1.0);
    }

  private:
    void open() {
        sqlite3* raw = pages_.open();
        database_.reset(raw);
        if (sqlite3_errcode(raw) != SQLITE_OK) fail();
        sqlite3_db_config(raw, SQLITE_DBCONFIG_DEFENSIVE, 1, nullptr);
        sqlite3_db_config(raw, SQLITE_DBCONFIG_TRUSTED_SCHEMA, 0, nullptr);
        sqlite3_db_config(raw, SQLITE_DBCONFIG_ENABLE_VIEW, 0, nullptr);
        sqlite3_db_config(raw, SQLITE_DBCONFIG_ENABLE_TRIGGER, 0, nullptr);
        sqlite3_limit(raw, SQLITE_LIMIT_LENGTH, static_cast<int>(kLargestMessage));
        // A row's cell is damaged where it says that it is larger than all the file.
        sqlite3_exec(raw, "PRAGMA cell_size_check=ON", nullptr, nullptr, nullptr);
        // More steps than a row for each byte have gone round in circles.
        steps_left_ = pages_.last_page() * pages_.page_size() / kStepsAtOnce + kStepsAtOnce;
        sqlite3_progress_handler(raw, kStepsAtOnce, &count_steps, this);
    }

    static int count_steps(void* self) {
        auto& left = static_cast<Db3*>(self)->steps_left_;
        if (left == 0) return 1;
        --left;
        return 0;
    }

    [[noreturn]] void fail() const {
        if (sqlite3_errcode(database_.get()) == SQLITE_NOMEM) throw std::bad_alloc();
        throw FormatError(
            path_.string(), 0, HITOS_TEXT("Errors", "cannot be read as a recording: %1"),
            pages_.cut() ? pages_.problems().front() : verbatim(sqlite3_errmsg(database_.get())));
    }

    Statement prepare(const char* sql) const {
        sqlite3_stmt* raw = nullptr;
        if (sqlite3_prepare_v2(database_.get(), sql, -1, &raw, nullptr) != SQLITE_OK) fail();
        return Statement(raw);
    }

    void require_table(const char* name) const {
        const Statement found = prepare(
            "SELECT 1 FROM sqlite_master WHERE type = 'table' AND name = ?1 "
            "AND sql NOT LIKE '%virtual%'");
        sqlite3_bind_text(found.get(), 1, name, -1, SQLITE_STATIC);
        const int result = sqlite3_step(found.get());
        if (result == SQLITE_ROW) return;
        if (result != SQLITE_DONE) fail();
        throw FormatError(
            path_.string(), 0,
            HITOS_TEXT("Errors",
                       "is an SQLite file without the table \"%1\", expected a recording of ROS 2"),
            name);
    }

    static std::string column(const Statement& row, int place) {
        const auto* text = reinterpret_cast<const char*>(sqlite3_column_text(row.get(), place));
        const auto size = static_cast<std::size_t>(sqlite3_column_bytes(row.get(), place));
        return text == nullptr ? std::string()
                               : std::string(text, std::min(size, std::size_t{kLongestWord}));
    }

    void read_topics() {
        const Statement rows = prepare("SELECT id, name, type, serialization_format FROM topics");
        int result = SQLITE_OK;
        while ((result = sqlite3_step(rows.get())) == SQLITE_ROW) {
            ids_.insert_or_assign(
                sqlite3_column_int64(rows.get(), 0),
                &use_.topics.of(column(rows, 1), column(rows, 2), column(rows, 3)));
        }
        if (result != SQLITE_DONE) fail();
    }

    /// What nobody wants, and what is too large, is not read: only told how long it is.
    std::string messages_query() const {
        std::vector<sqlite3_int64> wanted;
        for (const auto& [id, topic] : ids_) {
            if (topic->wanted) wanted.push_back(id);
        }
        return fmt::format(
            "SELECT id, topic_id, timestamp, CASE WHEN topic_id IN ({}) AND length(data) <= {} "
            "THEN data END, length(data) FROM messages ORDER BY id",
            fmt::join(wanted, ","), kLargestMessage);
    }

    sqlite3_int64 largest_id() const {
        const Statement row = prepare("SELECT max(id) FROM messages");
        return sqlite3_step(row.get()) == SQLITE_ROW ? sqlite3_column_int64(row.get(), 0) : 0;
    }

    std::optional<RecordedMessage> message_of_row() {
        const auto topic = ids_.find(sqlite3_column_int64(rows_.get(), 1));
        if (topic == ids_.end()) {
            note(use_.topics.count_damage(),
                 message(
                     HITOS_TEXT(
                         "Errors",
                         "found a message of the topic %1 in the row %2, which nothing describes"),
                     sqlite3_column_int64(rows_.get(), 1), id_));
            return std::nullopt;
        }
        const auto length = sqlite3_column_int64(rows_.get(), 4);
        const auto content = [&]() -> std::optional<std::string_view> {
            const void* data = sqlite3_column_blob(rows_.get(), 3);
            const auto size = static_cast<std::size_t>(sqlite3_column_bytes(rows_.get(), 3));
            return std::string_view(static_cast<const char*>(data), data == nullptr ? 0 : size);
        };
        return message_of(*topic->second, sqlite3_column_int64(rows_.get(), 2),
                          static_cast<std::uint64_t>(std::max<sqlite3_int64>(length, 0)), content);
    }

    std::optional<RecordedMessage> message_of_leaf(const Db3Leaves::Row& row) {
        return message_of(*ids_.at(row.topic), row.time_ns, row.length,
                          [this] { return leaves_->data(); });
    }

    template <class Content>
    std::optional<RecordedMessage> message_of(Topic& topic, std::int64_t log_time_ns,
                                              std::uint64_t length, Content content) {
        const std::uint64_t number = use_.topics.count(topic);
        if (!topic.wanted) return std::nullopt;
        if (length > kLargestMessage) {
            note(number,
                 message(HITOS_TEXT("Errors", "found a message of %1 bytes, expected at most %2"),
                         length, kLargestMessage));
            return std::nullopt;
        }
        const std::optional<std::string_view> bytes = content();
        if (!bytes) return std::nullopt;
        return RecordedMessage{&topic, number, log_time_ns, *bytes};
    }

    static constexpr int kStepsAtOnce = 1000;

    std::filesystem::path path_;
    RecordingUse use_;
    Db3Pages pages_;
    std::uint64_t steps_left_ = 0;
    std::unique_ptr<sqlite3, CloseDatabase> database_;
    std::map<sqlite3_int64, Topic*> ids_;
    Statement rows_;
    std::optional<Db3Leaves> leaves_;  ///< where the rows lead no further
    std::size_t told_ = 0;             ///< of the pages' problems
    sqlite3_int64 id_ = 0;
    sqlite3_int64 last_id_ = 0;
    bool any_ = false;
};

}  // namespace

bool begins_db3(std::string_view beginning) {
    return beginning.starts_with(kDb3Magic);
}

std::unique_ptr<Recording> open_db3(const std::filesystem::path& path, RecordingUse use) {
    return std::make_unique<Db3>(path, std::move(use));
}

}  // namespace hitos
