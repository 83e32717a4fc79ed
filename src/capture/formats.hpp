// How the lines of the four formats are told apart, without parsing their numbers.
#pragma once

#include <array>
#include <cstdint>
#include <filesystem>
#include <memory>
#include <optional>
#include <string_view>

#include "hitos/capture/archivo.hpp"

namespace hitos {

inline constexpr std::array kFormats = {LogFormat::player, LogFormat::radish, LogFormat::normalized,
                                        LogFormat::carmen};

/// The part of a Player line before the payload. Files of Player 1.5 and 1.6 have no type and
/// subtype; their sixth field is the data's own time, with a point in it.
struct PlayerHeader {
    std::string_view time;
    std::string_view interface;
    std::string_view index;
    std::string_view type;     ///< empty in the old layout
    std::string_view subtype;  ///< empty in the old layout
    std::string_view payload;

    bool old_layout() const { return type.empty(); }
    /// Whether type and subtype are these numbers, however they are padded.
    bool is(std::int64_t wanted_type, std::int64_t wanted_subtype) const;
};

/// Nothing where the line does not begin as a Player line must.
std::optional<PlayerHeader> split_player_header(std::string_view text);

/// The format whose line or comment this is; nothing where no format, or more than one, claims it.
std::optional<LogFormat> format_of_line(std::string_view text);

/// The file as a source of the given format, which must not be `automatic`.
std::unique_ptr<Archivo> make_archivo(LogFormat format, const std::filesystem::path& path);

}  // namespace hitos
