// SPDX-License-Identifier: GPL-3.0-or-later
#include "hitos/workbench/shipped_data.hpp"

#include <dlfcn.h>
#include <fmt/format.h>
#include <link.h>

#include <algorithm>
#include <charconv>

#include "hitos/base/error.hpp"
#include "hitos/base/text_input.hpp"
#include "hitos/capture/archivo.hpp"
#include "hitos/capture/live_source.hpp"
#include "hitos/capture/tour_reader.hpp"

namespace hitos {
namespace {

std::filesystem::path worlds_folder() {
    return shipped_file("data/worlds");
}

/// What this function is part of: a program, or a module that another program has loaded.
std::filesystem::path own_file() {
    std::error_code ignored;
    static const char here = 0;
    Dl_info info{};
    link_map* loaded = nullptr;
    void* place = nullptr;
    if (dladdr1(&here, &info, &place, RTLD_DL_LINKMAP) != 0) loaded = static_cast<link_map*>(place);
    if (loaded != nullptr && loaded->l_name != nullptr && *loaded->l_name != '\0') {
        return std::filesystem::canonical(loaded->l_name, ignored);
    }
    return std::filesystem::read_symlink("/proc/self/exe", ignored);
}

/// A page's first line, without the mark of a heading and the number before the title.
std::string title_of(const std::filesystem::path& page) {
    const std::string text = input::read_text(page);
    const std::string line = text.substr(0, text.find('\n'));
    const std::size_t begin = line.find_first_not_of("#0123456789. ");
    return begin == std::string::npos ? std::string() : line.substr(begin);
}

}  // namespace

std::filesystem::path shipped_file(const std::filesystem::path& relative) {
    std::error_code ignored;
    std::filesystem::path above = own_file();
    while (above.has_relative_path()) {
        above = above.parent_path();
        for (const std::filesystem::path& place :
             {relative, "share/hitos" / relative, "share/doc/hitos" / relative}) {
            if (std::filesystem::exists(above / place, ignored)) return above / place;
        }
    }
    if (std::filesystem::exists(relative, ignored)) return relative;
    return {};
}

std::filesystem::path needed_file(const std::filesystem::path& relative) {
    std::filesystem::path path = shipped_file(relative);
    if (path.empty()) {
        throw FileError(
            relative.string(),
            HITOS_TEXT("Errors",
                       "is not there; it comes with Hitos: start the program from its folder"));
    }
    return path;
}

std::vector<std::string> shipped_worlds() {
    std::vector<std::string> names;
    std::error_code ignored;
    for (const auto& entry : std::filesystem::directory_iterator(worlds_folder(), ignored)) {
        if (is_world_file(entry.path())) names.push_back(entry.path().stem().string());
    }
    std::ranges::sort(names);
    return names;
}

namespace {

bool is_shipped(const std::string& name) {
    return std::ranges::count(shipped_worlds(), name) > 0;
}

/// Whether a file of that name is what is asked for. A folder without a recording, as of the
/// results of a world, does not hide the world.
bool is_source(const std::string& name) {
    std::error_code ignored;
    if (!std::filesystem::exists(name, ignored)) return false;
    const bool other = std::filesystem::is_directory(name, ignored) && !is_recording_folder(name);
    return !other || !is_shipped(name);
}

}  // namespace

std::filesystem::path find_world(const std::string& name) {
    if (is_source(name)) return name;
    if (is_shipped(name)) return worlds_folder() / (name + ".toml");
    throw FileError(
        name, HITOS_TEXT("Errors", "no such world file; the worlds that come with Hitos are %1"),
        fmt::format("{}", fmt::join(shipped_worlds(), ", ")));
}

std::string source_named(const std::string& name) {
    if (is_source(name)) return name;
    if (is_websocket_address(name)) {
        throw FileError(name, HITOS_TEXT("Errors",
                                         "is the address of a running robot, expected a log: "
                                         "hitos-cli run --follow maps what the robot sends, and "
                                         "keeps a log of it"));
    }
    const bool bare = !name.empty() && name.find_first_of("./") == std::string::npos;
    if (!bare) return name;
    if (is_shipped(name)) return find_world(name).string();
    throw FileError(
        name,
        HITOS_TEXT("Errors",
                   "no such log, nor a world of that name; the worlds that come with Hitos are %1"),
        fmt::format("{}", fmt::join(shipped_worlds(), ", ")));
}

std::filesystem::path Lesson::page(std::string_view language) const {
    return folder / (language.starts_with("es") ? "lesson.es.md" : "lesson.en.md");
}

std::vector<Lesson> lessons() {
    std::vector<Lesson> found;
    std::error_code ignored;
    for (const auto& entry :
         std::filesystem::directory_iterator(shipped_file("data/lessons"), ignored)) {
        Lesson lesson;
        lesson.folder = entry.path();
        lesson.name = lesson.folder.filename().string();
        const char* end = lesson.name.data() + lesson.name.size();
        const auto number = std::from_chars(lesson.name.data(), end, lesson.number);
        if (number.ec != std::errc() || number.ptr == end || *number.ptr != '-') continue;
        lesson.world = lesson.folder / "world.toml";
        lesson.configuration = lesson.folder / "run.cfg";
        lesson.title_en = title_of(lesson.page("en"));
        lesson.title_es = title_of(lesson.page("es"));
        found.push_back(std::move(lesson));
    }
    std::ranges::sort(found, {}, &Lesson::number);
    return found;
}

}  // namespace hitos
