// The commands that docs/studies.md shows must work as they stand there.
#include <gmock/gmock.h>

#include <sstream>

#include "program.hpp"

namespace hitos {
namespace {

using testing::kBin;
using testing::kSource;
using testing::Result;
using testing::shell;

class Documentation : public testing::ProgramTest {};

TEST_F(Documentation, TheCommandsOfStudiesRun) {
    std::istringstream text(testing::content(kSource + "/docs/studies.md"));
    std::string commands;
    bool inside = false;
    for (std::string line; std::getline(text, line);) {
        if (line.starts_with("```")) {
            inside = line == "```sh";
        } else if (inside) {
            commands += line + "\n";
        }
    }
    ASSERT_GT(commands.size(), 100U);
    // As from the project's folder, but for what is written.
    for (const char* name : {"data", "config", "docs"})
        testing::fs::create_symlink(kSource + "/" + name, folder_ / name);
    const Result result = shell("cd " + folder_.string() + " && export PATH=" + kBin +
                                ":$PATH && set -e\n" + commands);
    EXPECT_EQ(result.status, 0) << result.said;
    EXPECT_TRUE(testing::fs::exists(folder_ / "out" / "dmax.csv"));
    EXPECT_TRUE(testing::fs::exists(folder_ / "out" / "particles" / "summary.tex"));
}

}  // namespace
}  // namespace hitos
