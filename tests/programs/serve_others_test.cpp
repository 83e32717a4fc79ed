// SPDX-License-Identifier: GPL-3.0-or-later
// hitos-cli run --serve as programs that others wrote see it.
#include <gmock/gmock.h>

#include <string>

#include "program.hpp"

namespace hitos::test {
namespace {

using ::testing::HasSubstr;

/// Whether a script lacks what it needs, and says so; 127: there is no node.
bool lacks_something(const Outcome& script) {
    constexpr int kMissing = 77;
    constexpr int kNoProgram = 127;
    return script.status == kMissing || script.status == kNoProgram;
}

/// With the folder of modules that npm installs for all, where no other one is named.
std::string node(const std::string& script) {
    return "NODE_PATH=${NODE_PATH:-$(npm root -g 2>/dev/null)} timeout 300 node " + kSource +
           "/tests/programs/" + script;
}

class ServeToOthers : public ProgramTest {};

/// Every message as its channel's schema says, of all ten topics.
TEST_F(ServeToOthers, FoxglovesOwnClientFindsWhatIsAdvertised) {
    const Outcome client =
        shell(node("foxglove_client.js") + " " + cli_ + " " + log_ + " " + path("out"));
    if (lacks_something(client)) GTEST_SKIP() << client.output;
    ASSERT_EQ(client.status, 0) << client.output;
    for (const char* topic : {"/tf ", "/pose ", "/path ", "/particles ", "/covariance ",
                              "/landmarks ", "/loops ", "/scan ", "/grid ", "/run "}) {
        EXPECT_THAT(client.output, HasSubstr(topic));
    }
    EXPECT_TRUE(fs::exists(path("out/summary.json")));
}

/// Wide and on phones, light and dark, in both languages: drawn as large as it may be, legible, and
/// asking nobody else for anything.
TEST_F(ServeToOthers, ABrowserShowsThePage) {
    ASSERT_EQ(
        shell(cli_ + " convert " + log_ + " --to normalized --out " + path("tour.log")).status, 0);
    const Outcome browser = shell(node("page_in_browser.js") + " " + cli_ + " " + path("tour.log") +
                                  " " + path("out") + " " + path("pictures"));
    if (lacks_something(browser)) GTEST_SKIP() << browser.output;
    ASSERT_EQ(browser.status, 0) << browser.output;
    EXPECT_THAT(browser.output, HasSubstr("phone-dark-es"));
}

}  // namespace
}  // namespace hitos::test
