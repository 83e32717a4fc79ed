// SPDX-License-Identifier: GPL-3.0-or-later
#include "laws.hpp"

#include <sys/mman.h>
#include <unistd.h>

#include <cerrno>
#include <cstdlib>
#include <fstream>
#include <system_error>

namespace hitos::fuzz {
namespace {

[[noreturn]] void fail(const char* what) {
    throw std::system_error(errno, std::generic_category(), what);
}

std::filesystem::path place_in_memory() {
    // A fuzzer ends without cleaning up; whoever has started it does.
    if (const char* given = std::getenv("HITOS_FUZZ_SCRATCH")) return given;
    const std::filesystem::path memory = "/dev/shm";
    return ::access(memory.c_str(), W_OK) == 0 ? memory : std::filesystem::temp_directory_path();
}

}  // namespace

void require(bool holds, const char* law) {
    if (!holds) throw BrokenLaw(law);
}

std::uint32_t turn_of(std::string_view input, std::uint32_t laws) {
    // FNV-1a: the least that tells inputs apart, and the same everywhere.
    std::uint32_t hash = 2166136261U;
    for (const char c : input) hash = (hash ^ static_cast<unsigned char>(c)) * 16777619U;
    return hash % laws;
}

InputFile::InputFile() : descriptor_(::memfd_create("hitos-input", MFD_CLOEXEC)) {
    if (descriptor_ < 0) fail("a file in memory");
    path_ = "/proc/self/fd/" + std::to_string(descriptor_);
}

InputFile::~InputFile() {
    ::close(descriptor_);
}

void InputFile::fill(std::string_view bytes) const {
    if (::ftruncate(descriptor_, 0) != 0) fail("emptying the input");
    for (std::size_t done = 0; done < bytes.size();) {
        const ssize_t put = ::pwrite(descriptor_, bytes.data() + done, bytes.size() - done,
                                     static_cast<off_t>(done));
        if (put <= 0) fail("filling the input");
        done += static_cast<std::size_t>(put);
    }
}

const std::filesystem::path& file_of(std::string_view bytes) {
    static const InputFile file;
    file.fill(bytes);
    return file.path();
}

ScratchFolder::ScratchFolder() {
    std::string pattern = (place_in_memory() / "hitos-fuzz-XXXXXX").string();
    if (::mkdtemp(pattern.data()) == nullptr) fail("a folder for the fuzz targets");
    path_ = pattern;
}

ScratchFolder::~ScratchFolder() {
    std::error_code ignored;
    std::filesystem::remove_all(path_, ignored);
}

std::filesystem::path ScratchFolder::put(std::string_view name, std::string_view bytes) const {
    std::filesystem::path file = path_ / name;
    std::ofstream(file, std::ios::binary | std::ios::trunc) << bytes;
    return file;
}

}  // namespace hitos::fuzz
