/// mesopix bench: how exact the program is for its time, measured on the spot.
#pragma once

#include "apps/command/command.hpp"

namespace app {

class BenchCommand : public Command {
 public:
  explicit BenchCommand(CLI::App& program);
  Exit run(Console& console) override;

 private:
  Exit run_error(Console& console) const;
  Exit run_stability(Console& console) const;
  Exit run_features(Console& console) const;

  std::string what_;
  std::vector<std::string> problems_;
  std::vector<std::string> cases_;
  std::string output_;
  bool overwrite_ = false;
  bool json_ = false;
  bool quiet_ = false;
};

}  // namespace app
