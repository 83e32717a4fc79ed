#include "hitos/capture/fuente.hpp"

#include <array>

namespace hitos {
namespace {

struct FormatName {
    LogFormat format;
    std::string_view word;
};

constexpr std::array kFormatNames = {
    FormatName{LogFormat::automatic, "auto"}, FormatName{LogFormat::player, "player"},
    FormatName{LogFormat::radish, "radish"}, FormatName{LogFormat::normalized, "normalized"},
    FormatName{LogFormat::carmen, "carmen"}};

}  // namespace

std::string_view to_string(LogFormat format) {
    for (const FormatName& name : kFormatNames) {
        if (name.format == format) return name.word;
    }
    return "auto";
}

std::optional<LogFormat> log_format_from(std::string_view word) {
    for (const FormatName& name : kFormatNames) {
        if (name.word == word) return name.format;
    }
    return std::nullopt;
}

}  // namespace hitos
