/// The program in a folder of its own, without starting a process: for tests of its commands.
#pragma once

#include <gtest/gtest.h>

#include <filesystem>
#include <sstream>
#include <string>
#include <utility>
#include <vector>

#include "apps/command/program.hpp"
#include "tests/specimen/temporary_folder.hpp"

namespace test {

class ProgramInFolder : public testing::Test {
 protected:
  /// @param command  that run() is about; empty = its arguments begin with one.   @param more  as
  /// run_program.
  explicit ProgramInFolder(std::string command = {}, app::MoreCommands more = {})
      : command_(std::move(command)), more_(std::move(more)) {
    std::filesystem::current_path(folder_ / "");
  }
  ~ProgramInFolder() override { std::filesystem::current_path(before_); }

  app::Exit run(std::vector<std::string> arguments) {
    if (!command_.empty()) arguments.insert(arguments.begin(), command_);
    return call(arguments);
  }
  /// Any command.
  app::Exit call(const std::vector<std::string>& arguments) {
    out_.str("");
    err_.str("");
    app::Console console{out_, err_, false, false, {}};
    return app::run_program(arguments, console, more_);
  }

  /// With this message alone, and nothing written.
  void expect_refusal(const std::vector<std::string>& arguments, app::Exit code, const std::string& message) {
    const std::ptrdiff_t before = folder_.size();
    EXPECT_EQ(run(arguments), code) << err_.str();
    EXPECT_EQ(err_.str(), "mesopix: " + message + "\n");
    EXPECT_EQ(out_.str(), "");
    EXPECT_EQ(folder_.size(), before) << "something was written";
  }
  void expect_refusal(const std::vector<std::string>& arguments, const std::string& message) {
    expect_refusal(arguments, app::Exit::usage, message);
  }

  std::ostringstream out_;
  std::ostringstream err_;

 private:
  std::filesystem::path before_ = std::filesystem::current_path();
  test::TemporaryFolder folder_;
  std::string command_;
  app::MoreCommands more_;
};

}  // namespace test
