/// mesopix help: how a command is used.
#pragma once

#include <string>
#include <vector>

#include "apps/command/command.hpp"

namespace app {

class HelpCommand : public Command {
 public:
  explicit HelpCommand(CLI::App& program);
  Exit run(Console& console) override;

 private:
  std::vector<std::string> words_;
};

}  // namespace app
