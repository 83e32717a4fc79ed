// SPDX-License-Identifier: GPL-3.0-or-later
#include "hitos/capture/tour_reader.hpp"

#include <algorithm>
#include <cctype>

namespace hitos {

Message ReadReport::place(std::uint64_t line) const {
    return of_recording ? message(HITOS_TEXT("Errors", "message %1"), line)
                        : message(HITOS_TEXT("Errors", "line %1"), line);
}

Message ReadReport::placed(const Skip& skip) const {
    return message("%1: %2", place(skip.line), skip.reason);
}

bool is_world_file(const std::filesystem::path& path) {
    std::string extension = path.extension().string();
    std::ranges::transform(extension, extension.begin(),
                           [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
    return extension == ".toml";
}

}  // namespace hitos
