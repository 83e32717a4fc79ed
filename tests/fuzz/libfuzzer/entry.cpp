// SPDX-License-Identifier: GPL-3.0-or-later
// What libFuzzer calls: the check HITOS_FUZZ_CHECK, and the count of what it was fed.
//
// HITOS_FUZZ_COUNT names a file that holds, at every moment, three 64-bit numbers of this run:
// inputs, bytes of them all, and the nanoseconds of the slowest. After HITOS_FUZZ_BYTES bytes the
// run is asked to end.
#include <fcntl.h>
#include <sys/mman.h>
#include <unistd.h>

#include <algorithm>
#include <charconv>
#include <chrono>
#include <csignal>
#include <cstdint>
#include <cstdlib>
#include <limits>
#include <string_view>

#include "targets.hpp"

namespace hitos::fuzz {
namespace {

struct Count {
    std::uint64_t inputs = 0;
    std::uint64_t bytes = 0;
    std::uint64_t slowest_ns = 0;
};

/// In the file, so that it outlives a crash.
Count* shared_count() {
    const char* const file = std::getenv("HITOS_FUZZ_COUNT");
    if (file == nullptr) return nullptr;
    const int descriptor = ::open(file, O_RDWR | O_CREAT | O_CLOEXEC, 0666);
    if (descriptor < 0 || ::ftruncate(descriptor, sizeof(Count)) != 0) std::abort();
    void* const place =
        ::mmap(nullptr, sizeof(Count), PROT_READ | PROT_WRITE, MAP_SHARED, descriptor, 0);
    ::close(descriptor);
    if (place == MAP_FAILED) std::abort();
    return static_cast<Count*>(place);
}

std::uint64_t most_bytes() {
    const char* const text = std::getenv("HITOS_FUZZ_BYTES");
    if (text == nullptr) return std::numeric_limits<std::uint64_t>::max();
    const std::string_view digits = text;
    std::uint64_t bytes = 0;
    const auto [stop, error] = std::from_chars(digits.data(), digits.data() + digits.size(), bytes);
    if (error != std::errc{} || stop != digits.data() + digits.size()) std::abort();
    return bytes;
}

class Counting {
  public:
    Counting() : count_(shared_count()), most_bytes_(most_bytes()) {
        if (count_ == nullptr) count_ = &own_;
    }

    void note(std::size_t bytes, std::chrono::nanoseconds took) {
        ++count_->inputs;
        count_->bytes += bytes;
        count_->slowest_ns = std::max(count_->slowest_ns, static_cast<std::uint64_t>(took.count()));
        // libFuzzer ends after this input, with what it has found.
        if (count_->bytes >= most_bytes_) static_cast<void>(std::raise(SIGUSR1));
    }

  private:
    Count own_;
    Count* count_;
    std::uint64_t most_bytes_;
};

}  // namespace
}  // namespace hitos::fuzz

// NOLINTNEXTLINE(readability-identifier-naming): the name that libFuzzer calls
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    using Clock = std::chrono::steady_clock;
    static hitos::fuzz::Counting counting;
    const auto begin = Clock::now();
    hitos::fuzz::HITOS_FUZZ_CHECK({reinterpret_cast<const char*>(data), size});
    counting.note(size, Clock::now() - begin);
    return 0;
}
