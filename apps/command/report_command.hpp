/// mesopix report: several runs on one page.
#pragma once

#include "apps/command/command.hpp"

namespace app {

class ReportCommand : public Command {
 public:
  explicit ReportCommand(CLI::App& program);
  Exit run(Console& console) override;

 private:
  std::vector<std::string> runs_;
  std::string output_ = "comparison.html";
  bool json_ = false;
  bool quiet_ = false;
};

}  // namespace app
