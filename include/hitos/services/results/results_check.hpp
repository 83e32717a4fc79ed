// SPDX-License-Identifier: GPL-3.0-or-later
// Whether a folder of results is what a run wrote.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace hitos {

/// What is not as the summary states it; all empty where the folder is whole.
struct ResultsCheck {
    std::size_t files = 0;               ///< that the summary names
    bool finished = true;                ///< the tour; else the run was stopped before its end
    std::vector<std::string> missing;    ///< named, not there
    std::vector<std::string> changed;    ///< of another size or content
    std::vector<std::string> left_over;  ///< of a run, but not of this one
    /// Asked for and never there, with the reason: "grid.pgm: …". The folder is whole without them.
    std::vector<std::string> not_written;

    bool whole() const { return missing.empty() && changed.empty() && left_over.empty(); }
};

/// Compares the folder that write_results() wrote with its summary, by size and content. Throws
/// FileError where it has no summary, FormatError where the summary is none or names no files, as
/// those before the first release did.
ResultsCheck check_results(const std::filesystem::path& folder);

}  // namespace hitos
