// Use of the program as it goes on for a year. HITOS_USE=FIRST_SEED:SEQUENCES[:STEPS] chooses
// another part of it than the gate's; what fails says the line that repeats it.
#include <fmt/format.h>

#include <cstdio>
#include <iostream>

#include "model.hpp"

namespace hitos::test {
namespace {

constexpr unsigned kSteps = 25;  // of a sequence

struct Extent {
    unsigned first = 1, sequences = 24, steps = kSteps;
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

TEST(Use, LeavesWhatAModelSaysWhateverHappens) {
    const Extent extent = wished();
    std::size_t steps = 0;
    for (unsigned seed = extent.first; seed < extent.first + extent.sequences; ++seed) {
        UseModel model(seed);
        for (unsigned step = 1; step <= extent.steps; ++step, ++steps) {
            const std::string wrong = model.go_on();
            if (wrong.empty()) continue;
            std::string history;
            for (const std::string& line : model.history()) history += "  " + line + "\n";
            FAIL() << wrong << "\nafter\n"
                   << history
                   << fmt::format("Again: HITOS_USE={}:1:{} test_faults --gtest_filter='Use.*'",
                                  seed, step);
        }
    }
    std::cout << fmt::format("{} operations, 0 differences\n", steps);
}

}  // namespace
}  // namespace hitos::test
