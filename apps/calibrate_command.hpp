/// mesopix calibrate: fit parameters of a scene to a measured peak or curve.
#pragma once

#include "apps/calibration.hpp"
#include "apps/command.hpp"

namespace app {

class CalibrateCommand : public Command {
 public:
  explicit CalibrateCommand(CLI::App& program);
  std::vector<std::string> prepare(const std::vector<std::string>& arguments) override;
  Exit run(Console& console) override;

 private:
  [[nodiscard]] Target read_target() const;
  void read_numbers(CalibrationTask& task) const;
  [[nodiscard]] std::string wanted_free(const Target& target) const;

  SettingOptions settings_;
  std::string input_;
  std::string curve_;
  std::string peak_stress_;
  std::string peak_strain_;
  std::string free_;
  std::string seeds_ = "4";
  std::string tolerance_ = "0.5 %";
  std::string evaluations_ = "100";
  std::string output_;
  bool overwrite_ = false;
  bool json_ = false;
  bool quiet_ = false;
};

}  // namespace app
