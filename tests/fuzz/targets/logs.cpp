// Logs of the four formats.

#include "hitos/capture/archivo.hpp"
#include "laws.hpp"
#include "targets.hpp"
#include "tour_laws.hpp"

namespace hitos::fuzz {
namespace {

bool check_log_of(std::string_view format, std::string_view input) {
    // Whatever the file is, it is found out or refused.
    unless_refused([&] { return open_log(file_of(input)) != nullptr; });
    return check_log(input, format);
}

}  // namespace

bool check_player(std::string_view input) {
    return check_log_of("player", input);
}

bool check_radish(std::string_view input) {
    return check_log_of("radish", input);
}

bool check_normalized(std::string_view input) {
    return check_log_of("normalized", input);
}

bool check_carmen(std::string_view input) {
    return check_log_of("carmen", input);
}

}  // namespace hitos::fuzz
