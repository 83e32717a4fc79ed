// SPDX-License-Identifier: GPL-3.0-or-later
#include "hitos/services/drawing/gnuplot.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <atomic>
#include <cctype>
#include <cerrno>
#include <exception>
#include <fstream>
#include <iterator>
#include <sstream>
#include <system_error>

#include "hitos/base/atomic_file.hpp"
#include "hitos/base/error.hpp"
#include "hitos/base/folder_entries.hpp"
#include "hitos/base/text_input.hpp"

namespace hitos {
namespace {

namespace fs = std::filesystem;

/// A folder for gnuplot to write in; what is whole in the end is moved out.
class Workshop {
  public:
    explicit Workshop(const fs::path& beside)
        : path_(beside / fmt::format(".hitos-{}-{}-plots", ::getpid(), ++made())) {
        std::error_code error;
        fs::remove_all(path_, error);
        fs::create_directory(path_, error);
        if (error) {
            throw FileError(path_.string(), HITOS_TEXT("Errors", "cannot be made: %1"),
                            system_message(error.value()));
        }
    }
    ~Workshop() { remove_whole(path_); }
    Workshop(const Workshop&) = delete;
    Workshop& operator=(const Workshop&) = delete;
    const fs::path& path() const { return path_; }

  private:
    /// Several may be at work in one folder.
    static std::atomic<int>& made() {
        static std::atomic<int> count = 0;
        return count;
    }

    fs::path path_;
};

/// What can be read of it.
std::string read_all(const fs::path& path) {
    std::ostringstream text;
    text << std::ifstream(path, std::ios::binary).rdbuf();
    return text.str();
}

/// In double quotes, in which numbers stand for bytes.
std::string in_numbers(const std::string& text) {
    std::string result = "\"";
    for (const char c : text) {
        const auto byte = static_cast<unsigned char>(c);
        const bool means_something = byte < 0x20 || c == '"' || c == '\\' || c == '`';
        result += means_something ? fmt::format("\\{:03o}", byte) : std::string(1, c);
    }
    return result + "\"";
}

/// The name of a file that is nothing but that.
std::string plain(const std::string& name) {
    const auto first = static_cast<unsigned char>(name.empty() ? 'x' : name[0]);
    return std::isalnum(first) != 0 || first == '_' ? name : (fs::path(".") / name).string();
}

/// Empty where gnuplot has run the script; else why not.
Message run_gnuplot(const fs::path& folder, const std::string& script) {
    const fs::path said = folder / "gnuplot.out";
    const fs::path nothing = folder / "gnuplot.in";
    posix_spawn_file_actions_t actions;
    ::posix_spawn_file_actions_init(&actions);
    // Nothing outside the folder, so that what is missing can be gnuplot alone.
    ::posix_spawn_file_actions_addopen(&actions, STDIN_FILENO, nothing.c_str(), O_RDONLY | O_CREAT,
                                       0600);
    ::posix_spawn_file_actions_addopen(&actions, STDOUT_FILENO, said.c_str(),
                                       O_WRONLY | O_CREAT | O_TRUNC, 0600);
    ::posix_spawn_file_actions_adddup2(&actions, STDOUT_FILENO, STDERR_FILENO);
    ::posix_spawn_file_actions_addchdir_np(&actions, folder.c_str());
    std::string program = "gnuplot";
    std::string argument = plain(script);
    std::string no_settings = "-d";  // whatever ~/.gnuplot asks for
    std::array<char*, 4> arguments{program.data(), no_settings.data(), argument.data(), nullptr};
    pid_t process = 0;
    const int error =
        ::posix_spawnp(&process, program.c_str(), &actions, nullptr, arguments.data(), environ);
    ::posix_spawn_file_actions_destroy(&actions);
    if (error == ENOENT) {
        return message(HITOS_TEXT("Errors", "gnuplot is not installed (Debian: gnuplot-nox)"));
    }
    if (error != 0) return message("gnuplot: %1", system_message(error));
    int status = 0;
    while (::waitpid(process, &status, 0) < 0 && errno == EINTR) {
    }
    if (WIFEXITED(status) && WEXITSTATUS(status) == 0) return {};
    const std::string output = read_all(said);
    return message(HITOS_TEXT("Errors", "gnuplot fails: %1"),
                   input::trimmed(output).substr(0, 400));
}

}  // namespace

Message draw_pictures(const fs::path& folder, std::span<const PlotFile> files,
                      const std::string& script, std::span<const std::string> pictures,
                      const Message& refusal) {
    const Workshop workshop(folder);
    for (const PlotFile& file : files) {
        write_file(folder / file.name, file.text);
        write_file(workshop.path() / file.name, file.text);
    }
    Message failure = refusal.empty() ? run_gnuplot(workshop.path(), script) : refusal;
    for (const std::string& picture : pictures) {
        if (failure.empty()) {
            try {
                write_file(folder / picture, input::read_text(workshop.path() / picture));
                continue;
            } catch (const FileError& error) {
                failure = error.replaced(workshop.path().string(), folder.string()).message();
            }
        }
        // One from an earlier time would not show these figures.
        std::error_code ignored;
        fs::remove(folder / picture, ignored);
    }
    return failure;
}

std::string place_script(const std::string& picture, std::span<const PlotLayer> layers) {
    Bounds frame;
    std::string data;
    std::string plot;
    for (const PlotLayer& layer : layers) {
        if (layer.lines.empty()) continue;
        auto out = std::back_inserter(data);
        fmt::format_to(out, "${} << EOD\n", layer.name);
        for (const auto& line : layer.lines) {
            for (const Point2& p : line) {
                frame.hold(p);
                fmt::format_to(out, "{:.4f} {:.4f}\n", p.x, p.y);
            }
            data += '\n';
        }
        data += "EOD\n";
        plot += fmt::format("{}${} with {}", plot.empty() ? "plot " : ", ", layer.name, layer.look);
    }
    const Point2 size{frame.high.x - frame.low.x, frame.high.y - frame.low.y};
    const double margin = 0.03 * std::max(size.x, size.y) + 0.2;
    constexpr double kLongest = 1300.0;  // pixels
    constexpr double kLeast = 360.0;
    constexpr double kAround = 130.0;  // for axes and legend
    const double scale = kLongest / (std::max(size.x, size.y) + 2.0 * margin);
    const auto pixels = [&](double metres) {
        return std::max((metres + 2.0 * margin) * scale, kLeast) + kAround;
    };
    return data + fmt::format(
                      "set terminal pngcairo size {:.0f},{:.0f}\nset output '{}'\n"
                      "set size ratio -1\nset xrange [{:.3f}:{:.3f}]\n"
                      "set yrange [{:.3f}:{:.3f}]\nset xlabel 'x (m)'\nset ylabel 'y (m)'\n"
                      "set grid lc rgb '#e0e0e0'\nset key below horizontal\n{}\n",
                      pixels(size.x), pixels(size.y), picture, frame.low.x - margin,
                      frame.high.x + margin, frame.low.y - margin, frame.high.y + margin, plot);
}

std::string gnuplot_quoted(const std::string& text) {
    std::string line = text;
    std::ranges::replace_if(
        line, [](unsigned char c) { return c < 0x20; }, ' ');
    if (line.starts_with('\'')) return in_numbers(line);  // no beginning of gnuplot's own quotes
    std::string result = "'";
    for (const char c : line) {
        if (c == '\'') result += '\'';
        result += c;
    }
    return result + "'";
}

std::string gnuplot_file(const std::string& name) {
    const std::string path = plain(name);
    const bool in_one_line = std::ranges::none_of(path, [](unsigned char c) { return c < 0x20; });
    return in_one_line ? gnuplot_quoted(path) : in_numbers(path);
}

std::string gnuplot_head(const std::string& script) {
    std::string name = script;
    std::ranges::replace_if(
        name, [](unsigned char c) { return c < 0x20; }, '?');
    if (name.ends_with('\\')) name += '?';  // would go on in the next line
    return fmt::format("# Draw again with: gnuplot {}\n", name);
}

}  // namespace hitos
