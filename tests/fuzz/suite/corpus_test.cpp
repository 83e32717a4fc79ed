// SPDX-License-Identifier: GPL-3.0-or-later
// Every fuzz target over its corpus, and over thousands of damages to it with a fixed seed.
#include <gtest/gtest.h>

#include <algorithm>
#include <charconv>
#include <filesystem>
#include <fstream>
#include <ostream>
#include <string>
#include <vector>

#include "mutator.hpp"
#include "support.hpp"
#include "targets.hpp"

namespace hitos::fuzz {

std::ostream& operator<<(std::ostream& out, const Target& target) {
    return out << target.name;
}

namespace {

namespace fs = std::filesystem;

fs::path fuzz_folder() {
    return HITOS_FUZZ_DIR;
}

/// By name, so that the seed means the same everywhere.
std::vector<std::string> corpus_of(const Target& target) {
    std::vector<fs::path> files;
    for (const auto& entry : fs::directory_iterator(fuzz_folder() / "corpus" / target.name)) {
        files.push_back(entry.path());
    }
    std::ranges::sort(files);
    std::vector<std::string> inputs;
    inputs.reserve(files.size());
    for (const fs::path& file : files) inputs.push_back(test::content(file));
    return inputs;
}

/// The bytes of a dictionary's entry, "a\\b\"c\x0a" in libFuzzer's words.
std::string unescaped(std::string_view entry) {
    std::string bytes;
    for (std::size_t i = 0; i < entry.size(); ++i) {
        if (entry[i] != '\\' || i + 1 == entry.size()) {
            bytes += entry[i];
            continue;
        }
        ++i;
        if (entry[i] != 'x') {
            bytes += entry[i];
            continue;
        }
        unsigned byte = 0;
        constexpr std::size_t kDigits = 2;
        const std::string_view digits = entry.substr(i + 1, kDigits);
        std::from_chars(digits.data(), digits.data() + digits.size(), byte, 16);
        bytes += static_cast<char>(byte);
        i += digits.size();
    }
    return bytes;
}

/// What libFuzzer inserts too, and what readers get wrong anywhere.
std::vector<std::string> words_of(const Target& target) {
    std::vector<std::string> words(test::kHostileWords.begin(), test::kHostileWords.end());
    std::ifstream dictionary(fuzz_folder() / "dictionaries" / (std::string(target.name) + ".dict"));
    for (std::string line; std::getline(dictionary, line);) {
        const std::size_t begin = line.find('"');
        const std::size_t end = line.rfind('"');
        if (line.starts_with('#') || begin == end) continue;
        words.push_back(unescaped(std::string_view(line).substr(begin + 1, end - begin - 1)));
    }
    return words;
}

/// The two halves of two inputs.
std::string spliced(test::Mutator& mutator, const std::string& a, const std::string& b) {
    if (a.empty() || b.empty()) return a + b;
    return a.substr(0, mutator.below(a.size())) + b.substr(mutator.below(b.size()));
}

/// Counts who was taken; what is thrown is told with the input that it was thrown for.
class Feeder {
  public:
    explicit Feeder(const Target& target) : target_(target) {}

    void feed(const std::string& input) {
        try {
            ++(target_.check(input) ? taken : refused);
        } catch (const std::exception& error) {
            const fs::path file =
                fs::path(testing::TempDir()) / ("hitos-fuzz-" + std::string(target_.name));
            std::ofstream(file, std::ios::binary) << input;
            FAIL() << error.what() << "; the input is in " << file;
        }
    }

    int taken = 0;
    int refused = 0;

  private:
    const Target& target_;
};

class Corpus : public testing::TestWithParam<Target> {};

TEST_P(Corpus, IsReadOrRefusedWhateverIsDamagedInIt) {
    const Target& target = GetParam();
    const std::vector<std::string> corpus = corpus_of(target);
    ASSERT_FALSE(corpus.empty());
    Feeder whole(target);
    for (const std::string& input : corpus) {
        ASSERT_NO_FATAL_FAILURE(whole.feed(input));
    }
    // A corpus of which nothing is read, or all, would show nothing.
    EXPECT_GT(whole.taken, 0);
    EXPECT_GT(whole.refused, 0);

    test::Mutator mutator(words_of(target));
    Feeder damaged(target);
    const int rounds = test::repeated(2000);
    constexpr int kSplicedEvery = 8;
    for (int round = 0; round < rounds; ++round) {
        const std::string& input = mutator.one_of(corpus);
        const bool splice = mutator.below(kSplicedEvery) == 0;
        const std::string bad =
            splice ? spliced(mutator, input, mutator.one_of(corpus)) : mutator.mutate(input);
        ASSERT_NO_FATAL_FAILURE(damaged.feed(bad));
    }
    const int least_of_each = rounds / 200;
    EXPECT_GT(damaged.taken, least_of_each);
    EXPECT_GT(damaged.refused, least_of_each);
}

INSTANTIATE_TEST_SUITE_P(Targets, Corpus, testing::ValuesIn(targets().begin(), targets().end()),
                         [](const auto& value) { return std::string(value.param.name); });

}  // namespace
}  // namespace hitos::fuzz
