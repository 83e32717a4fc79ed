// SPDX-License-Identifier: GPL-3.0-or-later
#include "server.hpp"

#include <fcntl.h>
#include <sys/wait.h>

#include <array>
#include <csignal>
#include <cstdint>
#include <sstream>
#include <utility>

namespace hitos::test {

namespace fs = std::filesystem;

namespace {

// As tests/shim/report.hpp has them.
constexpr int kRequests = 198;
constexpr int kReplies = 199;

[[noreturn]] void become(const fs::path& program, const fs::path& below, int requests,
                         int replies) {
    ::dup2(requests, kRequests);
    ::dup2(replies, kReplies);
    const std::string name = program.string();
    const std::string preloaded = HITOS_FAULTS_LIBRARY;
    ::setenv("LD_PRELOAD", preloaded.c_str(), 1);              // NOLINT(concurrency-mt-unsafe)
    ::setenv("HITOS_FAULT_SERVE", "1", 1);                     // NOLINT(concurrency-mt-unsafe)
    ::setenv("HITOS_FAULT_BELOW", below.string().c_str(), 1);  // NOLINT(concurrency-mt-unsafe)
    ::setenv("LC_ALL", "C.UTF-8", 1);                          // NOLINT(concurrency-mt-unsafe)
    ::setenv("LD_BIND_NOW", "1", 1);                           // NOLINT(concurrency-mt-unsafe)
    ::execl(name.c_str(), name.c_str(), nullptr);
    ::_exit(127);
}

int answer_of(int replies) {
    int value = 0;
    if (::read(replies, &value, sizeof value) != sizeof value) {
        throw std::runtime_error("the server of programs has ended");
    }
    return value;
}

}  // namespace

Server::Server(const fs::path& program, fs::path folder) : folder_(std::move(folder)) {
    std::array<int, 2> to{};
    std::array<int, 2> from{};
    if (::pipe2(to.data(), O_CLOEXEC) != 0 || ::pipe2(from.data(), O_CLOEXEC) != 0) {
        throw std::runtime_error("no pipes");
    }
    process_ = ::fork();
    if (process_ == 0) become(program, folder_, to[0], from[1]);
    ::close(to[0]);
    ::close(from[1]);
    requests_ = to[1];
    replies_ = from[0];
}

Server::~Server() {
    ::close(requests_);
    ::close(replies_);
    ::waitpid(process_, nullptr, 0);
}

void Server::begin(const Words& arguments, const Words& variables) {
    fs::remove(own_ / "report");
    std::string request;
    const auto put = [&request](std::string_view word) { (request += word) += '\0'; };
    put((own_ / "said").string());
    put(folder_.string());
    put("HITOS_FAULT_REPORT=" + (own_ / "report").string());
    for (const std::string& variable : variables) put(variable);
    put("");
    put("hitos-cli");
    for (const std::string& word : arguments) put(word);
    const auto size = static_cast<std::uint32_t>(request.size());
    std::string bytes(reinterpret_cast<const char*>(&size), sizeof size);
    bytes += request;
    if (::write(requests_, bytes.data(), bytes.size()) != static_cast<ssize_t>(bytes.size())) {
        throw std::runtime_error("the server of programs does not listen");
    }
    answer_of(replies_);
}

Outcome Server::end() {
    const int status = answer_of(replies_);
    return {WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status),
            content(own_ / "said")};
}

Outcome Server::run(const Words& arguments, const Words& variables) {
    begin(arguments, variables);
    return end();
}

std::vector<std::string> Server::report() const {
    std::istringstream text(content(own_ / "report"));
    std::vector<std::string> lines;
    for (std::string line; std::getline(text, line);) lines.push_back(line);
    return lines;
}

}  // namespace hitos::test
