/// mesopix twin: random specimens like a picture.
#pragma once

#include "apps/command.hpp"
#include "apps/scene_file.hpp"
#include "apps/twinning.hpp"

namespace app {

class TwinCommand : public Command {
 public:
  explicit TwinCommand(CLI::App& program);
  std::vector<std::string> prepare(const std::vector<std::string>& arguments) override;
  Exit run(Console& console) override;

 private:
  [[nodiscard]] specimen::TwinOptions twin_options() const;
  [[nodiscard]] TwinTask make_task(const Settings& settings, specimen::Specimen original) const;

  SettingOptions settings_;
  std::string input_;
  std::string count_ = "10";
  std::string seed_ = "1";
  std::string width_;
  std::string height_;
  std::string pixel_size_;
  std::string gap_ = "auto";
  std::string border_ = "auto";
  std::string output_;
  bool overwrite_ = false;
  bool json_ = false;
  bool quiet_ = false;
};

}  // namespace app
