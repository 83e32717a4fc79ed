// SPDX-License-Identifier: GPL-3.0-or-later
// A command of hitos-cli with --json, as a user calls it.
#pragma once

#include <gmock/gmock.h>

#include <nlohmann/json.hpp>
#include <string>
#include <utility>

#include "program.hpp"

namespace hitos::test {

class CommandTest : public ProgramTest {
  protected:
    explicit CommandTest(std::string command) : command_(std::move(command)) {}

    Outcome call(const std::string& arguments) const {
        return shell(cli_ + " " + command_ + " " + arguments + " 2>&1");
    }
    nlohmann::json object(const std::string& arguments) const {
        const Outcome outcome = call(arguments + " --json");
        EXPECT_EQ(outcome.status, 0) << outcome.output;
        return nlohmann::json::parse(outcome.output);
    }
    void refused(const std::string& arguments, const std::string& words) const {
        const Outcome outcome = call(arguments);
        EXPECT_EQ(outcome.status, 1) << outcome.output;
        EXPECT_THAT(outcome.output, ::testing::HasSubstr(words));
    }

  private:
    std::string command_;
};

}  // namespace hitos::test
