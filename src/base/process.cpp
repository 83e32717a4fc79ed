// SPDX-License-Identifier: GPL-3.0-or-later
#include "hitos/base/process.hpp"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <chrono>
#include <cmath>
#include <csignal>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <ctime>
#include <exception>
#include <filesystem>
#include <limits>
#include <new>
#include <span>
#include <string>
#include <system_error>
#include <vector>

#include "hitos/base/atomic_file.hpp"
#include "hitos/base/early_end.hpp"
#include "hitos/base/error.hpp"
#include "hitos/base/nameless_file.hpp"

namespace hitos {
namespace {

// Shared with a signal handler.
volatile std::sig_atomic_t patient = 0;
volatile std::sig_atomic_t asked = 0;

volatile std::sig_atomic_t watched = 0;  // there is a thread that ends the process,
volatile std::sig_atomic_t hurry = 0;    // and has to at once
volatile std::sig_atomic_t asked_at_ms = 0;

std::sig_atomic_t now_ms() {
    timespec now{};
    ::clock_gettime(CLOCK_MONOTONIC, &now);
    constexpr std::int64_t kMilli = 1000;
    return static_cast<std::sig_atomic_t>((now.tv_sec % 1'000'000) * kMilli +
                                          now.tv_nsec / 1'000'000);
}

const char* program_name = "";  // for who has no other way to know
std::terminate_handler end_otherwise = nullptr;

/// In words that take no memory themselves.
void tell_of_memory(const char* program) {
    std::fprintf(stderr,
                 "%s: out of memory; fewer particles, coarser cells of the grid or fewer runs at a "
                 "time take less\n",
                 program);
}

/// Some libraries (nlohmann's JSON) need memory to give memory back, and cannot pass on that there
/// is none.
[[noreturn]] void end_for_want_of_memory() {
    if (std::current_exception() != nullptr) {
        try {
            throw;
        } catch (const std::bad_alloc&) {
            tell_of_memory(program_name);
            std::fprintf(stderr,
                         "%s: it ended at once; what was being written is cleared by the same "
                         "command again\n",
                         program_name);
            remove_temporary_files();
            std::_Exit(1);
        } catch (...) {  // that is for the other one to tell
        }
    }
    if (end_otherwise != nullptr) end_otherwise();
    std::abort();
}

/// What the system says of a thread that it does not start names nothing.
const char* words_of(const std::exception& error) {
    const auto* of_system = dynamic_cast<const std::system_error*>(&error);
    if (of_system == nullptr || of_system->code() != std::errc::resource_unavailable_try_again)
        return error.what();
    return "the system starts no further thread; raise its limit (ulimit -u, or the container's), "
           "or "
           "use fewer threads (--threads)";
}

void end_or_ask(int signal) {
    // timeout(1) and some schedulers send one request twice: to the process and to its group.
    constexpr std::sig_atomic_t kOneRequestMs = 200;
    if (patient != 0 && asked == 0) {
        asked = signal;
        asked_at_ms = now_ms();
        return;
    }
    if (patient != 0 && now_ms() - asked_at_ms < kOneRequestMs) return;
    if (watched != 0) {
        hurry = 1;
        return;
    }
    remove_temporary_files();
    std::signal(signal, SIG_DFL);
    std::raise(signal);
}

/// Where a standard stream is closed, the first file that is opened would take its place and what
/// is told there would land in it. Errors and progress then go nowhere; reading standard input and
/// writing standard output fail as they should.
void occupy_standard_streams() {
    for (const int stream : std::array{STDIN_FILENO, STDOUT_FILENO, STDERR_FILENO}) {
        if (::fcntl(stream, F_GETFD) >= 0) continue;
        ::open("/dev/null", stream == STDOUT_FILENO ? O_RDONLY : O_WRONLY);
    }
}

}  // namespace

void prepare_process() {
    occupy_standard_streams();
    std::signal(SIGPIPE, SIG_IGN);
    std::signal(SIGXFSZ, SIG_IGN);
    for (const int signal : std::array{SIGINT, SIGTERM, SIGHUP, SIGQUIT}) {
        // What was to be ignored (nohup) stays ignored.
        struct sigaction action {};
        ::sigaction(signal, nullptr, &action);
        if (action.sa_handler == SIG_IGN) continue;
        action = {};
        action.sa_handler = end_or_ask;
        action.sa_flags = SA_RESTART | SA_NODEFER;
        ::sigaction(signal, &action, nullptr);
    }
}

namespace {

using Clock = std::chrono::steady_clock;
constexpr std::chrono::milliseconds kLook(20);

/// How long a command may go on after it was asked to end [s]; HITOS_STOP_SECONDS says otherwise.
double patience_s() {
    constexpr double kPatience = 1.7;
    const char* said = std::getenv("HITOS_STOP_SECONDS");
    const double seconds = said != nullptr ? std::strtod(said, nullptr) : 0.0;
    return seconds > 0.0 ? seconds : kPatience;
}

/// Ends the process where it goes on for too long after it was asked to end, or was asked again.
void watch_patience(std::binary_semaphore& over, double patience) {
    while (!StopByRequest::wanted()) {
        if (over.try_acquire_for(kLook)) return;
    }
    const Clock::time_point begin = Clock::now();
    do {
        const double seconds = std::chrono::duration<double>(Clock::now() - begin).count();
        if (seconds > patience || hurry != 0) {
            std::fprintf(stderr,
                         std::isinf(patience)
                             ? "\n%s: stopped at once, as it was asked to a second time; what was "
                               "not finished is cleared\n"
                             : "%s: ended before all was written, as it was asked to; what is "
                               "written is whole\n",
                         program_name);
            end_early(StopByRequest::status());
        }
    } while (!over.try_acquire_for(kLook));
}

}  // namespace

StopByRequest::StopByRequest(Patience patience) {
    asked = 0;
    hurry = 0;
    const double seconds =
        patience == Patience::two_seconds ? patience_s() : std::numeric_limits<double>::infinity();
    watch_ = std::jthread([this, seconds] { watch_patience(over_, seconds); });
    watched = 1;
    patient = 1;
}

StopByRequest::~StopByRequest() {
    patient = 0;
    watched = 0;
    over_.release();
}

bool StopByRequest::wanted() {
    return asked != 0;
}

int StopByRequest::status() {
    return 128 + asked;
}

StopSource::StopSource()
    : watch_([this] {
          while (!stop_.stop_requested() && !over_.try_acquire_for(kLook)) {
              if (StopByRequest::wanted()) stop_.request_stop();
          }
      }) {}

StopSource::~StopSource() {
    over_.release();
}

namespace {

/// All bytes that come from standard input go into the file. Throws FileError.
void keep_standard_input(NamelessFile& file) {
    std::vector<char> block(std::size_t{1} << 16);
    for (;;) {
        const ssize_t got = ::read(STDIN_FILENO, block.data(), block.size());
        if (got == 0) return;
        if (got < 0) {
            if (errno == EINTR) continue;
            throw FileError("/dev/stdin", HITOS_TEXT("Errors", "cannot be read: %1"),
                            system_message(errno));
        }
        file.write(std::span(block).first(static_cast<std::size_t>(got)));
    }
}

}  // namespace

std::string input_named(const std::string& name, const std::string& what) {
    constexpr const char* kStandardInput = "/dev/stdin";
    if (name != "-" && name != kStandardInput) return name;
    static std::string taken_by;
    if (!taken_by.empty()) {
        throw ConfigError(what, verbatim("found \"" + name + "\", but standard input is " +
                                         taken_by + " already; give one of the two as a file"));
    }
    taken_by = what;
    struct stat state {};
    if (::fstat(STDIN_FILENO, &state) != 0 || S_ISREG(state.st_mode)) return kStandardInput;
    if (isatty(STDIN_FILENO) != 0) {
        throw FileError(kStandardInput, HITOS_TEXT("Errors",
                                                   "is a terminal; expected a file or what another "
                                                   "program writes: hitos-cli … - < FILE"));
    }
    NamelessFile file(kStandardInput,
                      HITOS_TEXT("Errors",
                                 "cannot be kept in %1 to be read more than once: %2; make room "
                                 "there, or name another folder in TMPDIR"));
    keep_standard_input(file);
    // From here on standard input is that file, also for who asks again.
    if (::dup2(file.descriptor(), STDIN_FILENO) < 0) {
        throw FileError(kStandardInput, HITOS_TEXT("Errors", "cannot be read: %1"),
                        system_message(errno));
    }
    return kStandardInput;
}

int run_program(const char* program, const std::function<int()>& run) {
    int status = 1;
    bool cut_short = false;
    program_name = program;
    const std::terminate_handler before = std::set_terminate(end_for_want_of_memory);
    if (before != end_for_want_of_memory) end_otherwise = before;
    try {
        status = run();
    } catch (const std::bad_alloc&) {
        tell_of_memory(program);
    } catch (const std::exception& error) {
        wait_for_early_end();
        cut_short = std::ferror(stdout) != 0;  // and that is the error
        if (!cut_short) std::fprintf(stderr, "%s: %s\n", program, words_of(error));
    }
    wait_for_early_end();
    const int earlier = errno;
    errno = 0;
    if (std::fflush(stdout) == 0 && std::ferror(stdout) == 0) return status;
    const int reason = errno != 0 ? errno : earlier;
    constexpr int kSignalled = 128;
    if (reason == EPIPE) return status == 0 || cut_short ? kSignalled + SIGPIPE : status;
    std::fprintf(stderr, "%s: standard output: %s; not all that it says has arrived\n", program,
                 std::strerror(reason));  // NOLINT(concurrency-mt-unsafe)
    return status == 0 ? 1 : status;
}

}  // namespace hitos
