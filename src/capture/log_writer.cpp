#include "hitos/capture/log_writer.hpp"

#include "hitos/base/error.hpp"
#include "tour_writer.hpp"

namespace hitos {

std::unique_ptr<LogWriter> make_log_writer(LogFormat format, const std::filesystem::path& path) {
    switch (format) {
        case LogFormat::player:
            return make_log_writer_player(path);
        case LogFormat::radish:
            return make_log_writer_radish(path);
        case LogFormat::carmen:
            return make_log_writer_carmen(path);
        case LogFormat::normalized:
            return make_log_writer_normalized(path);
        case LogFormat::automatic:
            break;
    }
    throw FormatError(path.string(), 0,
                      "cannot be written in the format auto; choose player, radish, normalized or "
                      "carmen");
}

}  // namespace hitos
