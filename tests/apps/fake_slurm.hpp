/// Stand-ins for the programs of Slurm, in front of the PATH: for tests of who asks them what.
#pragma once

#include <cstdlib>
#include <filesystem>
#include <string>

#include "apps/text/text_parts.hpp"
#include "tests/specimen/temporary_folder.hpp"

namespace test {

class FakeSlurm {
 public:
  FakeSlurm() { setenv("PATH", ((folder_ / "") + ":" + before_).c_str(), 1); }
  ~FakeSlurm() { setenv("PATH", before_.c_str(), 1); }
  FakeSlurm(const FakeSlurm&) = delete;
  FakeSlurm& operator=(const FakeSlurm&) = delete;

  /// A program that notes its arguments, and then runs `script`.
  void answer(const std::string& program, const std::string& script) {
    write_text(folder_ / program, "#!/bin/sh\necho \"$@\" >>" +
                                      app::shell_word(folder_ / (program + ".asked")) + "\n" + script + "\n");
    std::filesystem::permissions(folder_ / program, std::filesystem::perms::owner_all);
  }
  /// Arguments of each call, a line each; empty when it was not called.
  [[nodiscard]] std::string asked(const std::string& program) const {
    const std::string path = folder_ / (program + ".asked");
    return std::filesystem::exists(path) ? read_text(path) : "";
  }

 private:
  TemporaryFolder folder_;
  std::string before_ = std::getenv("PATH");
};

}  // namespace test
