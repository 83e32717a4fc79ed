// SPDX-License-Identifier: GPL-3.0-or-later
#include <fcntl.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <cstdint>
#include <cstdlib>
#include <cstring>
#include <string>

#include "report.hpp"

namespace hitos::faults {
namespace {

bool read_all(void* bytes, std::size_t count) {
    auto* place = static_cast<char*>(bytes);
    while (count > 0) {
        const ssize_t got = ::read(kRequests, place, count);
        if (got <= 0) return false;
        place += got;
        count -= static_cast<std::size_t>(got);
    }
    return true;
}

void put(int value) {
    if (::write(kReplies, &value, sizeof value) != sizeof value) ::_exit(0);
}

/// In the child: output, variables and working directory as the request says.
std::vector<char*> begun(std::string& request) {
    std::vector<char*> words;
    for (char* word = request.data(); word < request.data() + request.size();
         word += std::strlen(word) + 1) {
        words.push_back(word);
    }
    const int said = ::open(words[0], O_WRONLY | O_CREAT | O_TRUNC | O_APPEND, 0666);
    const int nothing = ::open("/dev/null", O_RDONLY);
    ::dup2(nothing, STDIN_FILENO);
    ::dup2(said, STDOUT_FILENO);
    ::dup2(said, STDERR_FILENO);
    for (const int descriptor : {said, nothing, kRequests, kReplies}) ::close(descriptor);
    if (::chdir(words[1]) != 0) ::_exit(1);
    std::size_t next = 2;
    for (; *words[next] != '\0'; ++next) ::putenv(words[next]);  // NOLINT(concurrency-mt-unsafe)
    renew_file_order();
    words.erase(words.begin(), words.begin() + static_cast<std::ptrdiff_t>(next) + 1);
    words.push_back(nullptr);
    return words;
}

}  // namespace

std::vector<char*> served_arguments() {
    if (std::getenv("HITOS_FAULT_SERVE") == nullptr) return {};  // NOLINT(concurrency-mt-unsafe)
    static std::string request;  // the child's arguments point into it
    for (std::uint32_t size = 0; read_all(&size, sizeof size);) {
        request.resize(size);
        if (!read_all(request.data(), size)) break;
        const pid_t child = ::fork();
        if (child == 0) return begun(request);
        put(child);
        int status = 0;
        ::waitpid(child, &status, 0);
        put(status);
    }
    ::_exit(0);
}

}  // namespace hitos::faults
