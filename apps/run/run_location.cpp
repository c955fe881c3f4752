#include "apps/run/run_location.hpp"

#include <nlohmann/json.hpp>
#include <string>
#include <system_error>
#include <utility>

#include "apps/run/run_remarks.hpp"
#include "apps/run/solving.hpp"
#include "apps/scene/input.hpp"
#include "apps/scene/scene_file.hpp"
#include "apps/system/files.hpp"
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
  return {{specimen, scene, scene_toml, specimen::sha256_of_text(scene_toml), settings.title, notes},
          result,
          error_estimate};
}

namespace {

[[noreturn]] void refuse_mixture(const std::string& file, const std::string& other) {
  throw Rejected(Exit::data, file, "is of another run than " + other, "",
                 "begin the run anew with " + option_name("overwrite") +
                     ", or take the folder as one run has written it");
}

/// What summary.json names as its run; empty where it names none.
std::string run_of_summary(const std::string& path) {
  if (!fs::exists(path)) return {};
  const nlohmann::json summary = nlohmann::json::parse(read_text_file(path), nullptr, false);
  return summary.is_object() && summary.contains("run") && summary["run"].is_string()
             ? summary["run"].get<std::string>()
             : std::string();
}

}  // namespace

void check_one_run(const std::string& folder) {
  const auto file = [&](const char* name) { return (fs::path(folder) / name).string(); };
  const std::string result = file("result.h5"), scene = file("scene.toml"), summary = file("summary.json");
  if (fs::exists(scene) && read_text_file(scene) != read_scene_text(result)) refuse_mixture(result, scene);
  const std::string of_result = read_run_texts(result).run, of_summary = run_of_summary(summary);
  if (!of_result.empty() && !of_summary.empty() && of_result != of_summary) refuse_mixture(summary, result);
}

ReadRun read_run(const std::string& folder) {
  if (kind_of_input(folder) != InputKind::folder)
    throw Rejected(Exit::usage, "RUN", folder, "must be the folder of a run");
  const auto file = [&](const char* name) { return (std::filesystem::path(folder) / name).string(); };
  ReadRun run;
  run.result = read_result(file("result.h5"));
  run.scene_toml = read_scene_text(file("result.h5"));
  const mpm::RunTexts texts = read_run_texts(file("result.h5"));
  check_one_run(folder);
  Settings settings = resolve(parse_scene(run.scene_toml, file("scene.toml")), {}).settings;
  static_cast<Job&>(run) = fs::exists(file("specimen.h5"))
                               ? make_job(std::move(settings), {read_specimen(file("specimen.h5")), {}, {}})
                               : make_job(std::move(settings));
  const bool fits =
      run.result.failure_strain.size() == 0 || (run.result.failure_strain.rows() == run.scene.labels.rows() &&
                                                run.result.failure_strain.cols() == run.scene.labels.cols());
  if (!fits)
    throw Rejected(Exit::data, folder, "specimen.h5 and result.h5 have other shapes", "",
                   "take the folder as one run has written it");
  run.run = texts.run;
  if (!texts.run.empty() && texts.run != run_digest(run.scene_toml, run.scene))
    refuse_mixture(file("specimen.h5"), file("result.h5"));
  if (texts.remarks.empty()) {
    for (const Remark& remark : remarks_on({run.result, {}}, run.scene)) run.notes.push_back(remark.text);
    return run;
  }
  RunRemarks remarks = parse_remarks(texts.remarks, file("result.h5"));
  run.notes = std::move(remarks.notes);
  run.error_estimate = std::move(remarks.tolerated);
  return run;
}

}  // namespace app
