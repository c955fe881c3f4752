/// mesopix convert: picture -> specimen.
#pragma once

#include "apps/command/command.hpp"

namespace app {

class ConvertCommand : public Command {
 public:
  explicit ConvertCommand(CLI::App& program);
  std::vector<std::string> prepare(const std::vector<std::string>& arguments) override;
  Exit run(Console& console) override;

 private:
  SettingOptions settings_;
  std::string input_;
  std::string output_;
  std::string reference_;
  bool json_ = false;
  bool quiet_ = false;
};

}  // namespace app
