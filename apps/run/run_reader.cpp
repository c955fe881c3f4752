#include "apps/run/run_reader.hpp"

#include "apps/command/command.hpp"
#include "apps/system/hdf5_files.hpp"
#include "apps/job/scene_builder.hpp"
#include "apps/scene/scene_file.hpp"
#include "specimen/body/digest.hpp"

namespace app {

RunRecord ReadRun::record() const {
  return {specimen, scene, result, scene_toml, specimen::sha256_of_text(scene_toml), settings.title, {}};
}

ReadRun read_run(const std::string& folder) {
  if (kind_of_input(folder) != InputKind::folder)
    throw Rejected(Exit::usage, complaint("RUN", folder, "must be the folder of a run"));
  const auto file = [&](const char* name) { return (std::filesystem::path(folder) / name).string(); };
  ReadRun run;
  run.result = read_result(file("result.h5"));
  run.specimen = read_specimen(file("specimen.h5"));
  run.scene_toml = read_scene_text(file("result.h5"));
  run.settings = resolve(parse_scene(run.scene_toml, file("scene.toml")), {}).settings;
  run.scene = build_scene(run.specimen, run.settings);
  const bool fits =
      run.result.failure_strain.size() == 0 || (run.result.failure_strain.rows() == run.scene.labels.rows() &&
                                                run.result.failure_strain.cols() == run.scene.labels.cols());
  if (!fits)
    throw Rejected(Exit::data, complaint(folder, "specimen.h5 and result.h5 have other shapes", "",
                                         "take the folder as one run has written it"));
  return run;
}

}  // namespace app
