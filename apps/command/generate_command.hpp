/// mesopix generate: random or listed ellipses -> specimen.
#pragma once

#include "apps/command/command.hpp"

namespace app {

class GenerateCommand : public Command {
 public:
  explicit GenerateCommand(CLI::App& program);
  std::vector<std::string> prepare(const std::vector<std::string>& arguments) override;
  Exit run(Console& console) override;

 private:
  SettingOptions settings_;
  std::string scene_;
  std::string output_ = "specimen.h5";
  bool json_ = false;
  bool quiet_ = false;
};

}  // namespace app
