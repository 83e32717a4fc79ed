// SPDX-License-Identifier: GPL-3.0-or-later
// What is in a folder.
#pragma once

#include <filesystem>
#include <system_error>
#include <vector>

namespace hitos {

/// Everything in the folder, as far as it can be read. Unlike the iterators of std::filesystem,
/// which end the program then (libstdc++ 12), it may throw std::bad_alloc.
std::vector<std::filesystem::directory_entry> folder_entries(const std::filesystem::path& folder,
                                                             std::error_code& error);
/// All of it. Throws FileError.
std::vector<std::filesystem::directory_entry> folder_entries(const std::filesystem::path& folder);

/// Removes a file, or a folder with all that is in it, as far as it can: what is refused once, as
/// memory may be, is tried again, and what a gnuplot puts there whose caller was killed is removed
/// too.
void remove_whole(const std::filesystem::path& path) noexcept;

/// Removes from the folder what killed processes have not finished, of AtomicFile and of gnuplot.
/// Only where nobody can be at work.
void remove_leftovers(const std::filesystem::path& folder);

}  // namespace hitos
