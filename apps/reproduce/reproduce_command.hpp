/// mesopix reproduce: the figures of the paper with our numbers beside its claims.
#pragma once

#include "apps/command/command.hpp"

namespace app {

class ReproduceCommand : public Command {
 public:
  explicit ReproduceCommand(CLI::App& program);
  Exit run(Console& console) override;

 private:
  std::vector<std::string> figures_;
  std::string output_;
  int jobs_ = 0;  ///< 0 = as many as there are cores
  bool all_ = false;
  bool overwrite_ = false;
  bool json_ = false;
  bool quiet_ = false;
};

}  // namespace app
