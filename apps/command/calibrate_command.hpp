/// mesopix calibrate: fit parameters of a scene to a measured peak or curve.
#pragma once

#include "apps/calibrate/calibration_wish.hpp"
#include "apps/command/command.hpp"

namespace app {

class CalibrateCommand : public Command {
 public:
  explicit CalibrateCommand(CLI::App& program);
  std::vector<std::string> prepare(const std::vector<std::string>& arguments) override;
  Exit run(Console& console) override;

 private:
  SettingOptions settings_;
  std::string input_;
  CalibrationWish wish_;
  std::string output_;
  bool overwrite_ = false;
  bool json_ = false;
  bool quiet_ = false;
};

}  // namespace app
