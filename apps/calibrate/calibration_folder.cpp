#include "apps/calibrate/calibration_folder.hpp"

#include <nlohmann/json.hpp>

#include "apps/calibrate/calibration_json.hpp"
#include "apps/calibrate/calibration_report.hpp"
#include "apps/text/json_text.hpp"
#include "apps/scene/scene_text.hpp"
#include "libmpm/files/replace_file.hpp"

namespace app {

Attempts write_calibration(const std::filesystem::path& folder, const CalibrationTask& task,
                           const Calibration& calibration) {
  const std::string toml = scene_text(calibration.settings, Extent::whole, folder);
  Attempts attempt;
  const auto write = [&](const char* name, const std::string& text) {
    attempt([&] { mpm::replace_file((folder / name).string(), text); });
  };
  write("scene.toml", toml);
  write("calibration.json", json_text(calibration_json(task, calibration)));
  write("report.html", calibration_html(task, calibration, "Calibration: " + task.settings.title, toml));
  return attempt;
}

}  // namespace app
