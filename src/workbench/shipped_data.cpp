#include "hitos/workbench/shipped_data.hpp"

#include <dlfcn.h>
#include <fmt/format.h>
#include <link.h>

#include <algorithm>

#include "hitos/base/error.hpp"
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

std::vector<std::string> shipped_worlds() {
    std::vector<std::string> names;
    std::error_code ignored;
    for (const auto& entry : std::filesystem::directory_iterator(worlds_folder(), ignored)) {
        if (is_world_file(entry.path())) names.push_back(entry.path().stem().string());
    }
    std::ranges::sort(names);
    return names;
}

std::filesystem::path find_world(const std::string& name) {
    std::error_code ignored;
    if (std::filesystem::exists(name, ignored)) return name;
    const std::vector<std::string> worlds = shipped_worlds();
    if (std::ranges::find(worlds, name) != worlds.end()) {
        return worlds_folder() / (name + ".toml");
    }
    throw FileError(
        name,
        message(HITOS_TEXT("Errors", "no such world file; the worlds that come with Hitos are %1"),
                fmt::format("{}", fmt::join(worlds, ", "))));
}

std::string source_named(const std::string& name) {
    std::error_code ignored;
    if (std::filesystem::exists(name, ignored)) return name;
    const bool bare = !name.empty() && name.find_first_of("./") == std::string::npos;
    if (!bare) return name;
    const std::vector<std::string> worlds = shipped_worlds();
    if (std::ranges::find(worlds, name) != worlds.end()) return find_world(name).string();
    throw FileError(
        name,
        message(
            HITOS_TEXT(
                "Errors",
                "no such log, nor a world of that name; the worlds that come with Hitos are %1"),
            fmt::format("{}", fmt::join(worlds, ", "))));
}

std::filesystem::path find_thesis_results() {
    std::filesystem::path path = shipped_file("data/results.csv");
    if (path.empty()) {
        throw FileError(
            "data/results.csv",
            message(HITOS_TEXT(
                "Errors", "is not there; it comes with Hitos: start the program from its folder")));
    }
    return path;
}

}  // namespace hitos
