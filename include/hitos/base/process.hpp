// SPDX-License-Identifier: GPL-3.0-or-later
// What all programs share as processes: signals and streams.
#pragma once

#include <cstdint>
#include <functional>
#include <semaphore>
#include <stop_token>
#include <string>
#include <thread>

namespace hitos {

/// At a program's start: a pipe that nobody reads and a file that may not grow are errors to be
/// told, not deaths; SIGINT, SIGTERM and SIGHUP take the temporary files along; no file is opened
/// in the place of a standard stream that is closed.
void prepare_process();

/// While it lives, the first SIGINT, SIGTERM or SIGHUP only asks: the command ends itself. A second
/// one, a moment later, ends the process at once, and so does the first one where the command takes
/// near two seconds (or what the environment's HITOS_STOP_SECONDS says): what is written by then is
/// whole, and what is under way is cleared (AtEarlyEnd).
class StopByRequest {
  public:
    enum class Patience : std::uint8_t { two_seconds, endless };
    explicit StopByRequest(Patience patience = Patience::two_seconds);
    ~StopByRequest();
    StopByRequest(const StopByRequest&) = delete;
    StopByRequest& operator=(const StopByRequest&) = delete;

    static bool wanted();
    /// The status of a program that was stopped, as shells know it: 128 and the signal's number.
    static int status();

  private:
    std::binary_semaphore over_{0};  ///< so that the end of a command waits for no look
    std::jthread watch_;
};

/// Hands such a request on to what is under way.
class StopSource {
  public:
    StopSource();
    ~StopSource();
    StopSource(const StopSource&) = delete;
    StopSource& operator=(const StopSource&) = delete;

    std::stop_token token() const { return stop_.get_token(); }

  private:
    StopByRequest request_;
    std::stop_source stop_;
    std::binary_semaphore over_{0};
    std::jthread watch_;
};

/// The name of an input file; where it is "-" or "/dev/stdin", standard input is made one that can
/// be read as often as one likes, and its name is "/dev/stdin": what comes through a pipe is kept
/// in a file without a name in the folder for temporary files. Throws FileError. `what` is the
/// option or argument that says it: there is one standard input, and ConfigError of the second one
/// that wants it.
std::string input_named(const std::string& name, const std::string& what);

/// Runs the program and tells its errors on stderr. Gives its status once all that it said has
/// arrived: what standard output cannot take is an error. Where nobody reads on (`| head`), the
/// program ends without a word and with the status that SIGPIPE gives.
int run_program(const char* program, const std::function<int()>& run);

}  // namespace hitos
