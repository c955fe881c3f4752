/// mesopix convert: picture -> specimen.
/// mesopix generate: random or listed ellipses -> specimen.
/// mesopix twin: random specimens like a picture.
#pragma once

#include "apps/command/command.hpp"
#include "apps/scene/scene_file.hpp"
#include "apps/twin/twinning.hpp"

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
