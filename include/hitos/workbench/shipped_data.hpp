// SPDX-License-Identifier: GPL-3.0-or-later
// The files that come with Hitos: where they lie, and which of them are worlds and lessons.
#pragma once

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

namespace hitos {

/// A file or folder that comes with Hitos, by its place in the source tree ("data/worlds"): looked
/// for from the place of the program, or of the module that another program has loaded, upwards,
/// there, in share/hitos and share/doc/hitos, then in the current folder. Empty where there is
/// none.
std::filesystem::path shipped_file(const std::filesystem::path& relative);

/// The same, but throws FileError where there is none.
std::filesystem::path needed_file(const std::filesystem::path& relative);

/// The path itself where it exists or is more than a bare name; else the world of that name among
/// those that come with Hitos, which no folder hides but one with a recording. Throws FileError
/// that lists their names where there is none.
std::filesystem::path find_world(const std::string& name);

/// The worlds that come with Hitos, by name.
std::vector<std::string> shipped_worlds();

/// What is asked for as a log or a world: a path as it stands, or the world of that bare name that
/// comes with Hitos. Throws FileError for a bare name that is neither; a path that is missing is
/// given back for the reader to complain of.
std::string source_named(const std::string& name);

/// A lesson that comes with Hitos (docs/lessons.md): a small world, how it is run, and a page about
/// it in each language.
struct Lesson {
    int number = 0;    ///< from 1
    std::string name;  ///< of its folder: "04-loop"
    std::string title_en;
    std::string title_es;
    std::filesystem::path folder;
    std::filesystem::path world;
    std::filesystem::path configuration;  ///< names the world as its source

    /// Its page; in English for a language that has none.
    std::filesystem::path page(std::string_view language) const;
};

/// By number, titles from the first lines of the pages. Throws FileError for a page that cannot be
/// read; no lessons where none are installed.
std::vector<Lesson> lessons();

}  // namespace hitos
