// SPDX-License-Identifier: GPL-3.0-or-later
#include "progress_line.hpp"

#include <fmt/core.h>
#include <unistd.h>

#include <cmath>
#include <cstdio>

#include "hitos/base/message.hpp"
#include "hitos/base/plural.hpp"

namespace hitos::cli {
namespace {

std::string clock_text(double seconds) {
    const auto whole = std::llround(seconds);
    if (whole >= 3600) {
        return fmt::format("{}:{:02}:{:02}", whole / 3600, whole / 60 % 60, whole % 60);
    }
    return fmt::format("{}:{:02}", whole / 60, whole % 60);
}

}  // namespace

std::string percent_text(double fraction) {
    return fmt::format("{:3.0f} %", std::floor(100.0 * fraction));
}

ProgressLine::ProgressLine(std::string_view unit)
    : unit_(unit),
      terminal_(isatty(STDERR_FILENO) != 0),
      start_(std::chrono::steady_clock::now()),
      shown_(start_) {}

ProgressLine::~ProgressLine() {
    if (open_) std::fputc('\n', stderr);
}

double ProgressLine::seconds() const {
    return std::chrono::duration<double>(std::chrono::steady_clock::now() - start_).count();
}

void ProgressLine::show(std::uint64_t count, std::optional<double> fraction,
                        const std::string& detail) {
    const auto now = std::chrono::steady_clock::now();
    const auto every = terminal_ ? std::chrono::milliseconds(100) : std::chrono::seconds(10);
    if (now - shown_ < every) return;
    shown_ = now;
    print(count, fraction, detail);
}

void ProgressLine::finish(std::uint64_t count, const std::string& detail) {
    print(count, 1.0, detail);
    if (terminal_) std::fputc('\n', stderr);
    open_ = false;
}

void ProgressLine::say(const std::string& message) {
    fmt::print(stderr, "{}{}\n", open_ ? "\r\033[K" : "", without_control(message));
    open_ = false;
}

void ProgressLine::print(std::uint64_t count, std::optional<double> fraction,
                         const std::string& detail) {
    const double elapsed = seconds();
    std::string line;
    if (fraction) {
        if (terminal_) {
            constexpr int kWidth = 24;
            const int full = static_cast<int>(*fraction * kWidth);
            line += fmt::format("[{:#<{}}{:.<{}}] ", "", full, "", kWidth - full);
        }
        line += percent_text(*fraction) + "  ";
    }
    line += plural(count, unit_);
    if (elapsed > 0.05) {
        constexpr double kFast = 10.0;  // below it whole numbers say too little
        const double rate = static_cast<double>(count) / elapsed;
        line += fmt::format("  {:.{}f}/s", rate, rate < kFast ? 2 : 0);
    }
    if (fraction && *fraction > 0.01 && *fraction < 1.0) {
        line += fmt::format("  {} left", clock_text(elapsed * (1.0 - *fraction) / *fraction));
    } else if (fraction && *fraction >= 1.0) {
        line += fmt::format("  in {:.1f} s", elapsed);
    }
    if (!detail.empty()) line += "  " + detail;
    if (terminal_) {
        fmt::print(stderr, "\r\033[K{}", line);
        open_ = true;
    } else {
        fmt::print(stderr, "{}\n", line);
    }
    std::fflush(stderr);
}

}  // namespace hitos::cli
