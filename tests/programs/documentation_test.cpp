// The commands that docs/studies.md shows must work as they stand there.
#include <gmock/gmock.h>

#include <sstream>

#include "program.hpp"

namespace hitos {
namespace {

using test::kBin;
using test::kSource;
using test::Outcome;
using test::shell;

class Documentation : public test::ProgramTest {};

TEST_F(Documentation, TheCommandsOfStudiesRun) {
    std::istringstream text(test::content(kSource + "/docs/studies.md"));
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
        test::fs::create_symlink(kSource + "/" + name, folder_ / name);
    const Outcome result = shell("cd " + folder_.path().string() + " && export PATH=" + kBin +
                                 ":$PATH && set -e\n" + commands);
    EXPECT_EQ(result.status, 0) << result.output;
    EXPECT_TRUE(test::fs::exists(folder_ / "out" / "dmax.csv"));
    EXPECT_TRUE(test::fs::exists(folder_ / "out" / "particles" / "summary.tex"));
}

}  // namespace
}  // namespace hitos
