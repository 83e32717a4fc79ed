// SPDX-License-Identifier: GPL-3.0-or-later
// What the fuzz targets share: laws that can be broken, files in memory, folders that are reused.
#pragma once

#include <cmath>
#include <cstdint>
#include <filesystem>
#include <optional>
#include <stdexcept>
#include <string>
#include <string_view>

#include "hitos/base/error.hpp"
#include "hitos/base/geometry.hpp"

namespace hitos::fuzz {

/// A law that Hitos does not keep.
class BrokenLaw : public std::logic_error {
  public:
    using std::logic_error::logic_error;
};

/// Throws BrokenLaw, which names the law, where it does not hold.
void require(bool holds, const char* law);

inline bool is_finite(const Point2& point) {
    return std::isfinite(point.x) && std::isfinite(point.y);
}
inline bool is_finite_if_any(const std::optional<double>& value) {
    return !value || std::isfinite(*value);
}

/// Whose turn of so many laws it is, where each costs more than it may for every input: always the
/// same one for the same input.
std::uint32_t turn_of(std::string_view input, std::uint32_t laws);

/// What `read` gives; nothing where it refuses with an error of Hitos, which must say something.
template <class Read>
auto unless_refused(const Read& read) -> std::optional<decltype(read())> {
    try {
        return read();
    } catch (const Error& error) {
        require(!std::string_view(error.what()).empty(), "an error says what is wrong");
        require(error.message().english() == error.what(), "an error says it in English");
        return std::nullopt;
    }
}

/// One file in memory, filled anew for every input: regular, as readers demand, and quick.
class InputFile {
  public:
    InputFile();
    ~InputFile();
    InputFile(const InputFile&) = delete;
    InputFile& operator=(const InputFile&) = delete;

    void fill(std::string_view bytes) const;
    const std::filesystem::path& path() const { return path_; }

  private:
    int descriptor_;
    std::filesystem::path path_;
};

/// The process's own InputFile, holding these bytes.
const std::filesystem::path& file_of(std::string_view bytes);

/// A folder of this process, in HITOS_FUZZ_SCRATCH or in memory where the system has such a place,
/// and removed at its end.
class ScratchFolder {
  public:
    ScratchFolder();
    ~ScratchFolder();
    ScratchFolder(const ScratchFolder&) = delete;
    ScratchFolder& operator=(const ScratchFolder&) = delete;

    const std::filesystem::path& path() const { return path_; }
    std::filesystem::path put(std::string_view name, std::string_view bytes) const;

  private:
    std::filesystem::path path_;
};

}  // namespace hitos::fuzz
