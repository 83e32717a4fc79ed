// What the programs of the command line share as processes: signals and streams.
#pragma once

#include <functional>

namespace hitos::cli {

/// At a program's start: a pipe that nobody reads and a file that may not grow are errors to be
/// told, not deaths; SIGINT, SIGTERM and SIGHUP take the temporary files along.
void prepare_process();

/// While it lives, the first SIGINT, SIGTERM or SIGHUP only asks: the command ends itself. A second
/// one, a moment later, ends the process at once.
class StopByRequest {
  public:
    StopByRequest();
    ~StopByRequest();
    StopByRequest(const StopByRequest&) = delete;
    StopByRequest& operator=(const StopByRequest&) = delete;

    static bool wanted();
    /// The status of a program that was stopped, as shells know it: 128 and the signal's number.
    static int status();
};

/// Runs the program and tells its errors on stderr. Gives its status once all that it said has
/// arrived: what standard output cannot take is an error.
int finished(const char* program, const std::function<int()>& run);

}  // namespace hitos::cli
