// SPDX-License-Identifier: GPL-3.0-or-later
// Compressed chunks and SQLite files for tests, by the formats' own libraries.
#pragma once

#include <bzlib.h>
#include <lz4frame.h>
#include <sqlite3.h>
#include <zstd.h>

#include <algorithm>
#include <filesystem>
#include <functional>
#include <stdexcept>
#include <string>
#include <vector>

#include "unit/capture/ros_writers.hpp"

namespace hitos::test {

inline std::string packed_bz2(const std::string& content) {
    std::string packed(content.size() + content.size() / 50 + 1000, '\0');
    auto size = static_cast<unsigned>(packed.size());
    std::string source = content;
    if (BZ2_bzBuffToBuffCompress(packed.data(), &size, source.data(),
                                 static_cast<unsigned>(source.size()), 9, 0, 0) != BZ_OK) {
        throw std::runtime_error("bz2");
    }
    packed.resize(size);
    return packed;
}

inline std::string packed_lz4(const std::string& content) {
    std::string packed(LZ4F_compressFrameBound(content.size(), nullptr), '\0');
    packed.resize(
        LZ4F_compressFrame(packed.data(), packed.size(), content.data(), content.size(), nullptr));
    return packed;
}

inline std::string packed_zstd(const std::string& content) {
    std::string packed(ZSTD_compressBound(content.size()), '\0');
    packed.resize(ZSTD_compress(packed.data(), packed.size(), content.data(), content.size(), 3));
    return packed;
}

/// How an SQLite file is written.
struct Db3Layout {
    std::string encoding = "cdr";
    std::string pragmas;
    std::size_t in_transaction = 1'000'000;
    std::function<void()> before_close = [] {};
};

/// As rosbag2 creates it, without what nobody reads.
inline void write_db3(const std::filesystem::path& path, const std::vector<Said>& all,
                      const Db3Layout& layout = {}) {
    sqlite3* database = nullptr;
    sqlite3_open(path.c_str(), &database);
    const auto run = [&](const std::string& sql) {
        if (sqlite3_exec(database, sql.c_str(), nullptr, nullptr, nullptr) != SQLITE_OK) {
            throw std::runtime_error(sqlite3_errmsg(database));
        }
    };
    run(layout.pragmas);
    run("CREATE TABLE topics(id INTEGER PRIMARY KEY,name TEXT NOT NULL,type TEXT NOT NULL,"
        "serialization_format TEXT NOT NULL,offered_qos_profiles TEXT NOT NULL);"
        "CREATE TABLE messages(id INTEGER PRIMARY KEY,topic_id INTEGER NOT NULL,"
        "timestamp INTEGER NOT NULL, data BLOB NOT NULL); BEGIN");
    std::vector<std::string> topics;
    sqlite3_stmt* insert = nullptr;
    sqlite3_prepare_v2(database, "INSERT INTO messages(topic_id,timestamp,data) VALUES(?1,?2,?3)",
                       -1, &insert, nullptr);
    for (std::size_t i = 0; i < all.size(); ++i) {
        const Said& said = all[i];
        if (i > 0 && i % layout.in_transaction == 0) run("COMMIT; BEGIN");
        const auto known = std::find(topics.begin(), topics.end(), said.topic);
        const auto id = static_cast<int>(known - topics.begin()) + 1;
        if (known == topics.end()) {
            topics.push_back(said.topic);
            run("INSERT INTO topics VALUES(" + std::to_string(id) + ",'" + said.topic + "','" +
                said.type + "','" + layout.encoding + "','')");
        }
        sqlite3_bind_int(insert, 1, id);
        sqlite3_bind_int64(insert, 2, static_cast<sqlite3_int64>(said.log_time_ns));
        sqlite3_bind_blob(insert, 3, said.bytes.data(), static_cast<int>(said.bytes.size()),
                          SQLITE_TRANSIENT);
        sqlite3_step(insert);
        sqlite3_reset(insert);
    }
    sqlite3_finalize(insert);
    run("COMMIT");
    layout.before_close();
    sqlite3_close(database);
}

}  // namespace hitos::test
