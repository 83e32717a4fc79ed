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

/// Removes from the folder what killed processes have not finished, of AtomicFile and of gnuplot.
/// Only where nobody can be at work.
void remove_leftovers(const std::filesystem::path& folder);

}  // namespace hitos
