// SPDX-License-Identifier: GPL-3.0-or-later
#include "report.hpp"

#include <dlfcn.h>
#include <fcntl.h>
#include <sys/syscall.h>
#include <unistd.h>

#include <array>
#include <atomic>
#include <cerrno>
#include <cstdio>
#include <cstdlib>
#include <cstring>

namespace hitos::faults {
namespace {

std::atomic<bool> main_has_begun = false;
int (*real_main)(int, char**, char**) = nullptr;

int begin_main(int count, char** arguments, char** environment) {
    // Programs that this one starts are left alone.
    ::unsetenv("LD_PRELOAD");
    static std::vector<char*> served = served_arguments();
    main_has_begun = true;
    if (served.empty()) return real_main(count, arguments, environment);
    const int status = real_main(static_cast<int>(served.size()) - 1, served.data(), environ);
    // Without the ends of the libraries, which take a good part of a short command's time.
    std::fflush(nullptr);
    ::_exit(status);
}

std::array<char, 4096> report_file{};

}  // namespace

Order order_from(const char* variable) {
    const char* text = std::getenv(variable);  // NOLINT(concurrency-mt-unsafe)
    if (text == nullptr) return {};
    Order order;
    order.given = true;
    std::array<char, 16> word{};
    if (std::sscanf(text, "%ld:%ld:%15s", &order.number, &order.detail, word.data()) < 2) {
        std::fprintf(stderr, "%s: expected NUMBER:NUMBER[:WORD]\n", variable);
        ::_exit(1);
    }
    order.lasting = std::strstr(word.data(), "lasting") != nullptr;
    order.cut = std::strstr(word.data(), "cut") != nullptr;
    order.kill = std::strstr(word.data(), "kill") != nullptr;
    return order;
}

bool in_main() {
    return main_has_begun;
}

void report(std::string_view word, long number, std::string_view what, std::string_view detail) {
    const int kept = errno;
    if (report_file[0] == '\0') {
        const char* path = std::getenv("HITOS_FAULT_REPORT");  // NOLINT(concurrency-mt-unsafe)
        if (path == nullptr) return;
        std::strncpy(report_file.data(), path, report_file.size() - 1);
    }
    std::array<char, 8192> line{};
    const int length = std::snprintf(line.data(), line.size(), "%.*s %ld %.*s %.*s\n",
                                     static_cast<int>(word.size()), word.data(), number,
                                     static_cast<int>(what.size()), what.data(),
                                     static_cast<int>(detail.size()), detail.data());
    const long file = ::syscall(SYS_openat, AT_FDCWD, report_file.data(),
                                O_WRONLY | O_CREAT | O_APPEND | O_CLOEXEC, 0666);
    ::syscall(SYS_write, file, line.data(), static_cast<std::size_t>(length));
    ::syscall(SYS_close, file);
    errno = kept;
}

std::string_view name_of(int descriptor, char* room, std::size_t size) {
    std::array<char, 64> link{};
    std::snprintf(link.data(), link.size(), "/proc/self/fd/%d", descriptor);
    const long got = ::syscall(SYS_readlinkat, AT_FDCWD, link.data(), room, size);
    return got > 0 ? std::string_view(room, static_cast<std::size_t>(got)) : std::string_view();
}

}  // namespace hitos::faults

extern "C" {

/// Stands before the C library's own, so that what counts begins with main.
// NOLINTNEXTLINE(readability-identifier-naming)
int __libc_start_main(int (*main)(int, char**, char**), int count, char** arguments, void (*init)(),
                      void (*fini)(), void (*rtld_fini)(), void* stack_end) {
    using Start = int (*)(int (*)(int, char**, char**), int, char**, void (*)(), void (*)(),
                          void (*)(), void*);
    hitos::faults::real_main = main;
    const auto start = reinterpret_cast<Start>(::dlsym(RTLD_NEXT, "__libc_start_main"));
    return start(hitos::faults::begin_main, count, arguments, init, fini, rtld_fini, stack_end);
}
}
