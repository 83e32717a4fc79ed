// SPDX-License-Identifier: GPL-3.0-or-later
#include "workplace.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <spawn.h>

#include <algorithm>
#include <array>
#include <csignal>
#include <sstream>
#include <utility>

namespace hitos::test {

namespace fs = std::filesystem;

namespace {

std::vector<char*> pointers(Words& words) {
    std::vector<char*> list;
    list.reserve(words.size() + 1);
    for (std::string& word : words) list.push_back(word.data());
    list.push_back(nullptr);
    return list;
}

constexpr std::size_t kScans = 15;  // a run over them takes little longer than the program's start

/// The first scans of the shipped log.
std::string short_tour() {
    const Outcome log = run_command("zcat " HITOS_SOURCE_DIR "/data/logs/carmen-flaser.log.gz");
    std::istringstream lines(log.output);
    std::string tour;
    std::size_t scans = 0;
    for (std::string line; scans < kScans && std::getline(lines, line);) {
        tour += line + "\n";
        if (line.starts_with("FLASER")) ++scans;
    }
    return tour;
}

/// A world in which a tour is short.
constexpr const char* kRoom = R"(walls = [[[-1, -1], [3, -1], [3, 3], [-1, 3], [-1, -1]]]

[tour]
start = [0, 0, 0]
rest = 0
way_points = [[1, 0.5], [0.2, 0.2]]

[laser]
rays = 19
)";

/// A reference to measure the tour against, at ten times a second.
std::string straight_path() {
    constexpr int kPoses = 40;
    std::string text;
    for (int i = 0; i < kPoses; ++i) text += fmt::format("{} {} 0 0 0 0 0 1\n", i / 10.0, i / 50.0);
    return text;
}

}  // namespace

Process::Process(const Words& words, const Words& environment, fs::path said)
    : said_(std::move(said)) {
    Words own_words = words;
    Words own_environment = environment;
    for (char** variable = environ; *variable != nullptr; ++variable) {
        const std::string_view text = *variable;
        const std::string_view name = text.substr(0, text.find('=') + 1);
        if (std::ranges::none_of(
                environment, [name](const std::string& own) { return own.starts_with(name); })) {
            own_environment.emplace_back(text);
        }
    }
    posix_spawn_file_actions_t actions;
    ::posix_spawn_file_actions_init(&actions);
    ::posix_spawn_file_actions_addopen(&actions, STDIN_FILENO, "/dev/null", O_RDONLY, 0);
    ::posix_spawn_file_actions_addopen(&actions, STDOUT_FILENO, said_.c_str(),
                                       O_WRONLY | O_CREAT | O_TRUNC | O_APPEND, 0666);
    ::posix_spawn_file_actions_adddup2(&actions, STDOUT_FILENO, STDERR_FILENO);
    const int error = ::posix_spawn(&process_, own_words.front().c_str(), &actions, nullptr,
                                    pointers(own_words).data(), pointers(own_environment).data());
    ::posix_spawn_file_actions_destroy(&actions);
    if (error != 0) throw std::runtime_error("cannot start " + words.front());
}

Process::~Process() {
    if (process_ == 0) return;
    kill();
    ended();
}

void Process::kill() const {
    ::kill(process_, SIGKILL);
}

Outcome Process::ended() {
    int status = 0;
    ::waitpid(std::exchange(process_, 0), &status, 0);
    return {WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status), content(said_)};
}

Workplace::Workplace() {
    fs::create_directory(work());
    fs::create_directory(folder_ / "bin");
    folder_.put("work/tour.log", short_tour());
    folder_.put("work/truth.tum", straight_path());
    folder_.put("work/room.toml", kRoom);
    const fs::path gnuplot = folder_.put("bin/gnuplot",
                                         "#!/bin/sh\n"
                                         "text=$(cat \"$2\")\n"
                                         "while read -r set output file; do\n"
                                         "    [ \"$set $output\" != 'set output' ] && continue\n"
                                         "    file=${file#\\'}\n"
                                         "    echo \"$text\" > \"${file%\\'}\"\n"
                                         "done < \"$2\"\n");
    fs::permissions(gnuplot, fs::perms::owner_all);
}

std::unique_ptr<Process> Workplace::start(const Words& arguments, const Words& environment) const {
    Words words{HITOS_BIN_DIR "/hitos-cli"};
    words.insert(words.end(), arguments.begin(), arguments.end());
    Words variables = environment;
    const char* path = std::getenv("PATH");  // NOLINT(concurrency-mt-unsafe)
    variables.push_back("PATH=" + (folder_ / "bin").string() + ":" + (path ? path : ""));
    return std::make_unique<Process>(words, variables, folder_ / "said");
}

Outcome Workplace::run(const Words& arguments, const Words& environment) const {
    return start(arguments, environment)->ended();
}

Content Workplace::content() const {
    Content content;
    for (const auto& entry : fs::recursive_directory_iterator(work())) {
        const std::string name = fs::relative(entry.path(), work()).string();
        if (entry.is_directory()) {
            content[name + "/"];
        } else {
            content[name] = without_times(entry.path(), test::content(entry.path()));
        }
    }
    return content;
}

void Workplace::keep(const std::string& name) const {
    fs::remove_all(folder_ / name);
    fs::copy(work(), folder_ / name, fs::copy_options::recursive);
}

void Workplace::restore(const std::string& name) const {
    fs::remove_all(work());
    fs::copy(folder_ / name, work(), fs::copy_options::recursive);
}

std::vector<std::string> Workplace::take_report() const {
    std::istringstream text(test::content(report_file()));
    fs::remove(report_file());
    std::vector<std::string> lines;
    for (std::string line; std::getline(text, line);) lines.push_back(line);
    return lines;
}

std::string without_times(const fs::path& file, const std::string& text) {
    const std::string name = file.filename().string();
    if (name == "timing.csv") return {};
    // Records of a study have a digest of their times too. What is left of one that a loss of power
    // took the end of is none.
    if (name.ends_with(".json") && file.parent_path().string().ends_with("runs")) {
        const bool whole = text.starts_with("{\n") && text.ends_with("\n}\n");
        return whole ? std::string() : text;
    }
    if (name != "summary.json") return text;
    std::istringstream lines(text);
    std::string rest;
    for (std::string line; std::getline(lines, line);) {
        const bool time = line.find("\"run_seconds\"") != std::string::npos ||
                          line.find("\"scans_per_second\"") != std::string::npos ||
                          line.find("\"rest_xxh3_128\"") != std::string::npos;  // a digest of them
        if (!time) rest += line + "\n";
    }
    return rest;
}

bool tells_of_missing(const std::string& output) {
    constexpr std::array kWords{"not written: ", "not drawn: ", "no plots: ", "no contact sheet: "};
    return std::ranges::any_of(
        kWords, [&output](const char* words) { return output.find(words) != std::string::npos; });
}

bool is_temporary(const std::string& path) {
    return path.find(".hitos-") != std::string::npos;
}

Content finished_files(Content content) {
    std::erase_if(content, [](const auto& file) { return is_temporary(file.first); });
    return content;
}

Content without_waiting(Content content) {
    std::erase_if(content, [](const auto& file) {
        return file.first.find("/.study.json.hitos-next/") != std::string::npos;
    });
    return content;
}

std::string difference(const Content& a, const Content& b) {
    std::string names;
    for (const auto& [name, bytes] : a) {
        const auto other = b.find(name);
        if (other == b.end()) {
            names += "only before: " + name + "\n";
        } else if (other->second != bytes) {
            names += "differs: " + name + "\n";
        }
    }
    for (const auto& [name, bytes] : b) {
        if (!a.contains(name)) names += "only after: " + name + "\n";
    }
    return names;
}

}  // namespace hitos::test
