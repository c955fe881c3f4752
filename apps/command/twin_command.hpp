/// mesopix twin: random specimens like a picture.
#pragma once

#include "apps/command/command.hpp"
#include "apps/scene/scene_file.hpp"
#include "apps/twin/twin_wish.hpp"

namespace app {

class TwinCommand : public Command {
 public:
  explicit TwinCommand(CLI::App& program);
  std::vector<std::string> prepare(const std::vector<std::string>& arguments) override;
  Exit run(Console& console) override;

 private:
  SettingOptions settings_;
  std::string input_;
  TwinWish wish_;
  std::string output_;
  bool overwrite_ = false;
  bool json_ = false;
  bool quiet_ = false;
};

}  // namespace app
