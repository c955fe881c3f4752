/// mesopix inspect: what is in a file.
#pragma once

#include "apps/command/command.hpp"

namespace app {

class InspectCommand : public Command {
 public:
  explicit InspectCommand(CLI::App& program);
  Exit run(Console& console) override;

 private:
  std::string file_;
  bool json_ = false;
};

}  // namespace app
