// What the tests of the simulation share.
#pragma once

#include <gtest/gtest.h>
#include <unistd.h>

#include <filesystem>
#include <fstream>
#include <iterator>
#include <string>
#include <string_view>
#include <vector>

#include "hitos/simulation/world.hpp"

namespace hitos::testing {

/// A new empty folder, removed with what is in it.
class Folder {
  public:
    Folder() {
        std::string pattern =
            (std::filesystem::temp_directory_path() / "hitos-simulation-XXXXXX").string();
        if (::mkdtemp(pattern.data()) == nullptr) throw std::runtime_error("no temporary folder");
        path_ = pattern;
    }
    ~Folder() {
        std::error_code ignored;
        std::filesystem::remove_all(path_, ignored);
    }
    Folder(const Folder&) = delete;
    Folder& operator=(const Folder&) = delete;

    std::filesystem::path operator/(std::string_view name) const { return path_ / name; }
    std::filesystem::path file(std::string_view name, std::string_view content) const {
        std::ofstream(path_ / name, std::ios::binary) << content;
        return path_ / name;
    }
    std::size_t files() const {
        return static_cast<std::size_t>(std::distance(std::filesystem::directory_iterator(path_),
                                                      std::filesystem::directory_iterator()));
    }

  private:
    std::filesystem::path path_;
};

inline std::string content(const std::filesystem::path& path) {
    std::ifstream in(path, std::ios::binary);
    return {std::istreambuf_iterator<char>(in), std::istreambuf_iterator<char>()};
}

/// The message of the exception of exactly type E that the action throws; a failure where it
/// throws none or another one.
template <class E>
std::string message_of(const auto& action) {
    try {
        action();
    } catch (const E& error) {
        EXPECT_EQ(typeid(error), typeid(E)) << error.what();
        return error.what();
    } catch (const std::exception& error) {
        ADD_FAILURE() << "another type of exception: " << error.what();
        return {};
    }
    ADD_FAILURE() << "nothing was thrown";
    return {};
}

inline const std::vector<std::string>& shipped_names() {
    static const std::vector<std::string> names = {"recinto", "lineamedia", "bigloop", "bigloop2",
                                                   "complex", "iusiani",    "usc-sal"};
    return names;
}

inline World shipped(const std::string& name) {
    return read_world(std::filesystem::path(HITOS_SOURCE_DIR) / "data/worlds" / (name + ".toml"));
}

/// A room of 10 x 6 m round the origin, and a short tour.
inline World small_world() {
    return parse_world(
        "walls = [[[-2, -2], [8, -2], [8, 4], [-2, 4], [-2, -2]]]\n"
        "[tour]\nstart = [0, 0, 0]\nrest = 1\nway_points = [[0, 2], [5, 2], [5, 0]]\n",
        "small.toml");
}

}  // namespace hitos::testing
