// SPDX-License-Identifier: GPL-3.0-or-later
#include "roff.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <cctype>

#include "hitos/base/text_input.hpp"
#include "hitos/services/results/results.hpp"

namespace hitos::manual {
namespace {

std::string capitals(std::string_view text) {
    std::string result(text);
    std::ranges::transform(result, result.begin(), [](unsigned char letter) {
        return static_cast<char>(std::toupper(letter));
    });
    return result;
}

/// The marks of a line, where they come in pairs.
std::string roff_of_line(std::string_view line) {
    std::string result;
    while (!line.empty()) {
        const bool twice = line.starts_with("**");
        const std::string_view mark = twice ? "**" : line.substr(0, 1);
        const bool marks = twice || mark == "*" || mark == "`";
        const std::size_t end = marks ? line.find(mark, mark.size()) : std::string_view::npos;
        if (end == std::string_view::npos) {
            const std::size_t next = std::min(line.find_first_of("*`", 1), line.size());
            result += roff(line.substr(0, next));
            line.remove_prefix(next);
            continue;
        }
        const std::string_view inside = line.substr(mark.size(), end - mark.size());
        result += mark == "*" ? italic(inside) : bold(inside);
        line.remove_prefix(end + mark.size());
    }
    return result;
}

/// What the lines of a page are, one after another.
class Prose {
  public:
    void take(std::string_view line) {
        if (line.empty()) {
            close();
        } else if (line.starts_with("## ")) {
            close();
            text_ += roff_section(line.substr(3));
        } else if (line.starts_with("    ") && !open_) {
            code_ += fmt::format("{}\n", line.substr(4));
        } else if (line.starts_with("- ")) {
            close();
            text_ += ".IP \\(bu 2\n";
            open_ = true;
            add(line.substr(2));
        } else {
            if (!open_) text_ += ".PP\n";
            open_ = true;
            add(input::trimmed(line));
        }
    }
    std::string finish() {
        close();
        return std::move(text_);
    }

  private:
    void add(std::string_view line) { text_ += roff_of_line(line) + "\n"; }
    void close() {
        if (!code_.empty()) text_ += roff_verbatim(code_);
        code_.clear();
        open_ = false;
    }

    std::string text_;
    std::string code_;   // lines that are not written yet
    bool open_ = false;  // a paragraph or an item of a list, which the next line goes on with
};

}  // namespace

std::string roff(std::string_view text) {
    std::string result;
    bool at_start = true;
    for (const char letter : text) {
        if (at_start && (letter == '.' || letter == '\'')) result += "\\&";
        at_start = letter == '\n';
        if (letter == '\\') {
            result += "\\e";
        } else if (letter == '-') {
            result += "\\-";
        } else {
            result += letter;
        }
    }
    return result;
}

std::string bold(std::string_view text) {
    return fmt::format("\\fB{}\\fR", roff(text));
}

std::string italic(std::string_view text) {
    return fmt::format("\\fI{}\\fR", roff(text));
}

std::string roff_title(std::string_view name, int section) {
    return fmt::format(".TH \"{}\" {} \"\" \"Hitos {}\" \"Hitos\"\n.nh\n.ad l\n",
                       roff(capitals(name)), section, version());
}

std::string roff_section(std::string_view heading) {
    return fmt::format(".SH {}\n", roff(capitals(heading)));
}

std::string roff_item(std::string_view tag, std::string_view text) {
    return fmt::format(".TP\n{}\n{}\n", tag, text);
}

std::string roff_verbatim(std::string_view lines) {
    const bool ended = lines.ends_with('\n');
    return fmt::format(".PP\n.RS 4\n.nf\n{}{}.fi\n.RE\n", roff(lines), ended ? "" : "\n");
}

std::string roff_of_prose(std::string_view markdown) {
    Prose prose;
    while (const auto line = input::next_line(markdown)) prose.take(*line);
    return prose.finish();
}

}  // namespace hitos::manual
