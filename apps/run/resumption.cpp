#include "apps/run/resumption.hpp"

#include <fmt/format.h>

#include "apps/run/checkpoint_folder.hpp"
#include "apps/system/hdf5_files.hpp"
#include "apps/job/scene_builder.hpp"
#include "apps/scene/scene_differences.hpp"
#include "apps/scene/scene_file.hpp"
#include "apps/scene/scene_text.hpp"
#include "apps/system/text_file.hpp"

namespace app {
namespace {

namespace fs = std::filesystem;

/// A folder without a checkpoint that can be read.
void say_how_it_ended(const fs::path& folder, const std::vector<std::string>& faults, Console& console) {
  if (!faults.empty())
    throw Rejected(Exit::data, complaint("--resume", folder.string() + " has no checkpoint that can be read",
                                         "", "begin the run anew"));
  const fs::path result = folder / "result.h5";
  if (!fs::exists(result) || read_result(result.string()).stop == mpm::StopReason::interrupted)
    throw Rejected(Exit::data, complaint("--resume", folder.string() + " has no checkpoint", "",
                                         "begin the run anew, with --checkpoint-every to have some"));
  console.say("the run in " + folder.string() + " has come to its end, there is nothing to go on with");
}

/// Long ones, such as lists of ellipses, by their beginning.
std::string shown(const std::string& value) {
  constexpr std::size_t most = 60;
  if (value.empty()) return "nothing";
  return value.size() > most ? value.substr(0, most) + "..." : value;
}

/// The number of threads may be another one: it changes no bit.
void refuse_differences(const std::string& of_the_run, const std::string& now) {
  std::vector<Complaint> complaints;
  for (const SceneDifference& one : scene_differences({of_the_run, now}))
    if (one.key != "solver.threads")
      complaints.push_back(complaint(one.key, shown(one.values[1]),
                                     "the run began with " + shown(one.values[0]),
                                     "take that back, or begin another run"));
  if (!complaints.empty()) throw Rejected(Exit::data, complaints);
}

/// The settings of the run's folder with those given beside it.
Resolved settings_of(const fs::path& folder, const std::string& of_the_run,
                     const std::vector<Assignment>& given) {
  const std::string path = (folder / "scene.toml").string();
  return resolve(parse_scene(fs::exists(path) ? read_text_file(path) : of_the_run, path), given);
}

Job job_of(const fs::path& folder, Settings settings, const mpm::Checkpoint& checkpoint) {
  const std::string path = (folder / "specimen.h5").string();
  specimen::Specimen specimen = read_specimen(path);
  mpm::Scene scene = build_scene(specimen, settings);
  mpm::validate(scene);
  if (mpm::specimen_digest(scene) != checkpoint.specimen)
    throw Rejected(Exit::data, complaint(path, "is not the specimen that the run began with", "",
                                         "bring it back as it was"));
  return {std::move(settings), std::move(specimen), std::move(scene), {}};
}

}  // namespace

std::optional<RunTask> task_that_goes_on(const fs::path& folder, const std::vector<Assignment>& given,
                                         Console& console) {
  if (!fs::is_directory(folder))
    throw Rejected(Exit::usage, complaint("--resume", folder.string(), "must be the folder of a run"));
  CheckpointFolder::Found found = CheckpointFolder(folder).last();
  for (const std::string& fault : found.faults) console.say("warning: " + fault);
  if (!found.last) {
    say_how_it_ended(folder, found.faults, console);
    return std::nullopt;
  }
  mpm::CheckpointFile& file = found.last->file;
  Resolved resolved = settings_of(folder, file.scene_text, given);
  console.origins = resolved.origins;
  refuse_differences(file.scene_text, scene_text(resolved.settings, Extent::whole, folder));
  RunTask task;
  task.job = job_of(folder, std::move(resolved.settings), file.checkpoint);
  task.folder = folder;
  task.remarks = parse_remarks(file.remarks, found.last->path.string());
  task.job.notes = task.remarks.notes;
  task.scene_toml = std::move(file.scene_text);
  console.say(fmt::format("goes on at {:.0f} %, step {}, from {}", 100 * file.checkpoint.fraction,
                          file.checkpoint.step, found.last->path.string()));
  task.from = std::move(file.checkpoint);
  return task;
}

}  // namespace app
