/// mesopix simulate: break a specimen.
/// mesopix calibrate: fit parameters of a scene to a measured peak or curve.
#pragma once

#include <optional>
#include <string>

#include "apps/calibrate/calibration_folder.hpp"
#include "apps/command/command.hpp"

namespace app {

class SimulateCommand : public Command {
 public:
  explicit SimulateCommand(CLI::App& program);
  std::vector<std::string> prepare(const std::vector<std::string>& arguments) override;
  Exit run(Console& console) override;

 private:
  void check_options() const;
  [[nodiscard]] double tolerance() const;
  [[nodiscard]] std::optional<double> checkpoint_every() const;
  [[nodiscard]] Exit begin(Console& console);
  [[nodiscard]] Exit go_on(Console& console);
  [[nodiscard]] std::optional<int> port() const;

  SettingOptions settings_;
  std::string input_;
  std::string output_;
  bool overwrite_ = false;
  bool print_scene_ = false;
  bool explain_ = false;
  bool estimate_error_ = false;
  std::string tolerance_;
  std::string checkpoint_every_;
  std::string resume_;
  bool serve_ = false;
  std::string port_;
  bool json_ = false;
  bool quiet_ = false;
};

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
