#include "apps/twin/twin_folder.hpp"

#include <nlohmann/json.hpp>
#include <regex>
#include <set>

#include "apps/text/complaint.hpp"
#include "apps/text/json_text.hpp"
#include "apps/scene/scene_text.hpp"
#include "apps/job/specimen_output.hpp"
#include "apps/twin/twin_json.hpp"
#include "apps/twin/twin_report.hpp"
#include "apps/twin/twin_words.hpp"
#include "libmpm/files/replace_file.hpp"

namespace app {
namespace {

namespace fs = std::filesystem;

void remove_other_twins(const fs::path& folder, const std::vector<TwinRecord>& twins) {
  static const std::regex of_twin(R"((twin_\d{3,})(\.h5|_preview\.png))");
  std::set<std::string> kept;
  for (const TwinRecord& twin : twins) kept.insert(fs::path(twin.file).stem().string());
  std::vector<fs::path> outdated;
  for (const fs::directory_entry& entry : fs::directory_iterator(folder)) {
    std::smatch match;
    const std::string name = entry.path().filename().string();
    if (std::regex_match(name, match, of_twin) && kept.count(match[1]) == 0) outdated.push_back(entry.path());
  }
  for (const fs::path& path : outdated) fs::remove(path);
}

/// A scene of the first twin, which stands for all of them.
std::string scene_of(const TwinTask& task, const fs::path& folder, const TwinRecord& twin) {
  Settings settings = task.settings;
  settings.specimen = {};
  settings.specimen.file = (folder / twin.file).string();
  return scene_text(settings, Extent::whole, folder);
}

std::string study_of(const TwinTask& task, const std::vector<TwinRecord>& twins) {
  std::string files;
  for (const TwinRecord& twin : twins) files += "  " + quoted(twin.file) + ",\n";
  return "title = " + quoted("Twins of " + task.name) +
         "\nscene = \"scene.toml\"  # loading, phases and solver of all of them\n"
         "# seeds = 4           # runs of each twin with other random strengths\n\n"
         "[vary]\n\"specimen.file\" = [\n" +
         files + "]\n";
}

}  // namespace

TwinStatistics write_twin_statistics(const fs::path& folder, const TwinTask& task,
                                     const std::vector<TwinRecord>& twins, std::vector<std::string> notes) {
  TwinStatistics statistics{specimen::compare(task.descriptors, descriptors_of(twins)), std::move(notes), {}};
  for (std::string& note : twin_notes(task, twins)) statistics.notes.push_back(std::move(note));
  auto json = twins_json(task, twins, statistics.misfit);
  json["notes"] = statistics.notes;
  statistics.json = json_text(json);
  remove_other_twins(folder, twins);
  (void)write_specimen_output((folder / "original.h5").string(), task.original);
  const auto write = [&](const char* name, const std::string& text) {
    mpm::replace_file((folder / name).string(), text);
  };
  write("statistics.csv", twins_csv(task, twins));
  write("statistics.json", statistics.json);
  write("scene.toml", scene_of(task, folder, twins.front()));
  write("study.toml", study_of(task, twins));
  write("report.html", twin_html(task, twins, statistics.misfit, statistics.notes));
  return statistics;
}

}  // namespace app
