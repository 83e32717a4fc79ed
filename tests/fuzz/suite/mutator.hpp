// SPDX-License-Identifier: GPL-3.0-or-later
// Damages texts and bytes, in the same way on every machine.
#pragma once

#include <array>
#include <cstddef>
#include <random>
#include <string>
#include <string_view>
#include <vector>

namespace hitos::test {

/// Values that readers get wrong: too great, too small, none, of another kind.
inline constexpr std::array<std::string_view, 19> kHostileWords = {
    "-1",   "0",   "nan",    "-inf",       "1e308", "99999999999999999999", "+-1",
    "x",    "0x7", "1e-320", "4294967296", "-0",    "2147483647",           "#",
    "ODOM", ".",   "1.",     "\r",         "\t"};

class Mutator {
  public:
    explicit Mutator(std::vector<std::string> words = {kHostileWords.begin(), kHostileWords.end()})
        : words_(std::move(words)) {}

    /// With a few damages.
    std::string mutate(std::string text) {
        constexpr int kMost = 3;
        const int times = 1 + below(kMost);
        for (int i = 0; i < times && !text.empty(); ++i) once(text);
        return text;
    }
    /// The same of one line, which stays one.
    std::string mutate_line(std::string line) {
        std::string bad = mutate(std::move(line));
        for (char& c : bad) {
            if (c == '\n') c = ' ';
        }
        return bad;
    }
    int below(int limit) { return static_cast<int>(engine_() % static_cast<unsigned>(limit)); }
    std::size_t below(std::size_t limit) { return engine_() % limit; }
    /// One of a list.
    template <class List>
    const auto& one_of(const List& list) {
        return list[below(list.size())];
    }

  private:
    void once(std::string& text) {
        const std::size_t at = below(text.size());
        switch (below(7)) {
            case 0:
                text[at] = static_cast<char>(below(256));
                break;
            case 1:
                text.erase(at, 1);
                break;
            case 2:
                text.insert(at, 1, static_cast<char>(below(256)));
                break;
            case 3:
                text.resize(at);
                break;
            case 4:
                text += text.substr(at);
                break;
            case 5:
                replace_word(text, at, one_of(words_));
                break;
            default:
                replace_word(text, at, "");
                break;
        }
    }
    static void replace_word(std::string& text, std::size_t at, const std::string& word) {
        constexpr std::string_view kBetween = " \n";
        std::size_t begin = text.find_last_of(kBetween, at);
        begin = begin == std::string::npos ? 0 : begin + 1;
        std::size_t end = text.find_first_of(kBetween, begin);
        if (end == std::string::npos) end = text.size();
        text.replace(begin, end - begin, word);
    }

    std::vector<std::string> words_;
    std::mt19937 engine_{20240607};
};

}  // namespace hitos::test
