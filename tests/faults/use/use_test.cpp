// SPDX-License-Identifier: GPL-3.0-or-later
// Use of the program as it goes on for a year. HITOS_USE=FIRST_SEED:SEQUENCES[:STEPS] chooses
// another part of it than the gate's; what fails says the line that repeats it (two processes at
// once excepted, which meet as the system has it).
#include <fmt/format.h>

#include <algorithm>
#include <cstdio>
#include <iostream>

#include "model.hpp"

namespace hitos::test {
namespace {

constexpr unsigned kTests = 8;  // tests that may run side by side

struct Extent {
    unsigned first = 1, sequences = 24, steps = 25;
};

Extent wished() {
    Extent extent;
    extent.sequences = static_cast<unsigned>(repeated(static_cast<int>(extent.sequences)));
    const char* const wish = std::getenv("HITOS_USE");  // NOLINT(concurrency-mt-unsafe)
    if (wish != nullptr &&
        std::sscanf(wish, "%u:%u:%u", &extent.first, &extent.sequences, &extent.steps) < 2) {
        ADD_FAILURE() << "HITOS_USE: expected FIRST_SEED:SEQUENCES[:STEPS], found " << wish;
    }
    return extent;
}

class Use : public ::testing::TestWithParam<unsigned> {};

TEST_P(Use, LeavesWhatAModelSaysWhateverHappens) {
    const Extent extent = wished();
    std::size_t operations = 0;
    const Workplace place;
    place.keep("fresh");
    Programs programs(place);
    for (unsigned i = GetParam(); i < extent.sequences; i += kTests) {
        place.restore("fresh");
        UseModel model(place, programs, extent.first + i);
        for (unsigned step = 1; step <= extent.steps; ++step, ++operations) {
            const std::string wrong = model.go_on();
            if (wrong.empty()) continue;
            std::string history;
            for (const std::string& line : model.history()) history += "  " + line + "\n";
            FAIL() << wrong << "\nafter\n"
                   << history
                   << fmt::format("Again: HITOS_USE={}:1:{} test_faults --gtest_filter='*Use.*'",
                                  extent.first + i, step);
        }
    }
    std::cout << fmt::format("{} operations, 0 differences\n", operations);
}

INSTANTIATE_TEST_SUITE_P(, Use, ::testing::Range(0U, kTests));

}  // namespace
}  // namespace hitos::test
