#include "apps/run/run_location.hpp"

#include <string>
#include <system_error>

#include "apps/run/solving.hpp"
#include "apps/scene/input.hpp"
#include "apps/scene/scene_file.hpp"
#include "apps/system/hdf5_files.hpp"
#include "apps/text/complaint.hpp"
#include "specimen/body/files.hpp"

namespace app {
namespace {

namespace fs = std::filesystem;

fs::path first_free(const fs::path& base) {
  make_folders(base.parent_path());
  fs::path folder = base;
  std::error_code error;
  // Only the run that makes a folder owns it, so that two runs at once do not share one.
  for (int number = 2; !fs::create_directory(folder, error); ++number) {
    if (error)
      throw Rejected(Exit::io, folder.string(), error.message(), "must be a folder that can be made");
    folder = base.string() + "-" + std::to_string(number);
  }
  return folder;
}

}  // namespace

void make_folders(const fs::path& folder) {
  std::error_code error;
  fs::create_directories(folder, error);
  if (error) throw Rejected(Exit::io, folder.string(), error.message(), "must be a folder that can be made");
}

fs::path make_run_folder(const fs::path& wanted, const fs::path& stem, bool overwrite) {
  const fs::path folder = wanted.empty() ? fs::path("runs") / stem : wanted;
  if (wanted.empty() && !overwrite) return first_free(folder);
  std::error_code error;
  const bool taken = fs::exists(folder, error) && !(fs::is_directory(folder) && fs::is_empty(folder));
  if (taken && !fs::is_directory(folder))
    throw Rejected(Exit::usage, "-o", folder.string(), "is a file; must be a folder", "choose another name");
  if (taken && !overwrite)
    throw Rejected(Exit::usage, "-o", folder.string(), "is not empty",
                   "choose another folder, or add " + option_name("overwrite"));
  make_folders(folder);
  return folder;
}

RunRecord ReadRun::record() const {
  return {{specimen, scene, scene_toml, specimen::sha256_of_text(scene_toml), settings.title, notes}, result};
}

ReadRun read_run(const std::string& folder) {
  if (kind_of_input(folder) != InputKind::folder)
    throw Rejected(Exit::usage, "RUN", folder, "must be the folder of a run");
  const auto file = [&](const char* name) { return (std::filesystem::path(folder) / name).string(); };
  ReadRun run;
  run.result = read_result(file("result.h5"));
  run.scene_toml = read_scene_text(file("result.h5"));
  specimen::Specimen specimen = read_specimen(file("specimen.h5"));
  static_cast<Job&>(run) = make_job(resolve(parse_scene(run.scene_toml, file("scene.toml")), {}).settings,
                                    {std::move(specimen), {}, {}});
  const bool fits =
      run.result.failure_strain.size() == 0 || (run.result.failure_strain.rows() == run.scene.labels.rows() &&
                                                run.result.failure_strain.cols() == run.scene.labels.cols());
  if (!fits)
    throw Rejected(Exit::data, folder, "specimen.h5 and result.h5 have other shapes", "",
                   "take the folder as one run has written it");
  for (const Remark& remark : remarks_on({run.result, {}}, run.scene)) run.notes.push_back(remark.text);
  return run;
}

}  // namespace app
