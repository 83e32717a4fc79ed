// SPDX-License-Identifier: GPL-3.0-or-later
#include "hitos/base/process.hpp"

#include <gtest/gtest.h>

#include <new>
#include <stdexcept>
#include <system_error>
#include <thread>

namespace hitos {
namespace {

/// In a place that no exception may leave, as destructors of libraries.
int fail_where_nothing_may(void (*fail)()) {
    std::thread([fail]() noexcept { fail(); }).join();
    return 0;
}

void find_no_memory() {
    throw std::bad_alloc();
}
void find_another_problem() {
    throw std::runtime_error("another problem");
}

TEST(ProcessDeathTest, MemoryThatEndsWhereNobodyCanPassItOnIsTold) {
    testing::FLAGS_gtest_death_test_style = "threadsafe";
    EXPECT_EXIT(std::_Exit(run_program("some-program",
                                       [] { return fail_where_nothing_may(find_no_memory); })),
                testing::ExitedWithCode(1), "some-program: out of memory; .*it ended at once");
}

TEST(ProcessDeathTest, OtherProblemsThereEndAsEver) {
    testing::FLAGS_gtest_death_test_style = "threadsafe";
    EXPECT_DEATH(std::_Exit(run_program(
                     "some-program", [] { return fail_where_nothing_may(find_another_problem); })),
                 "another problem");
}

TEST(Process, MemoryThatEndsIsTold) {
    testing::internal::CaptureStderr();
    EXPECT_EQ(run_program("some-program", []() -> int { throw std::bad_alloc(); }), 1);
    EXPECT_NE(testing::internal::GetCapturedStderr().find("some-program: out of memory"),
              std::string::npos);
}

TEST(Process, AThreadThatTheSystemDoesNotStartIsTold) {
    ::testing::internal::CaptureStderr();
    EXPECT_EQ(run_program("hitos-cli",
                          []() -> int {
                              throw std::system_error(
                                  std::make_error_code(std::errc::resource_unavailable_try_again));
                          }),
              1);
    EXPECT_EQ(::testing::internal::GetCapturedStderr().substr(0, 47),
              "hitos-cli: the system starts no further thread;");
}

}  // namespace
}  // namespace hitos
