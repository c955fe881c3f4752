/// mesopix doctor: whether this machine and this program are ready.
#pragma once

#include "apps/command/command.hpp"

namespace app {

class DoctorCommand : public Command {
 public:
  explicit DoctorCommand(CLI::App& program);
  Exit run(Console& console) override;

 private:
  bool json_ = false;
  bool quiet_ = false;
};

}  // namespace app
