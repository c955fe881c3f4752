#include "apps/study/study_folder.hpp"

#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <chrono>
#include <nlohmann/json.hpp>
#include <set>
#include <system_error>
#include <type_traits>

#include "apps/run/run_location.hpp"
#include "apps/scene/scene_text.hpp"
#include "apps/study/study_file.hpp"
#include "apps/study/study_values.hpp"
#include "apps/system/files.hpp"
#include "apps/text/figures.hpp"
#include "apps/text/markup.hpp"
#include "apps/text/text_parts.hpp"
#include "libmpm/files/replace_file.hpp"

namespace app {
namespace {

namespace fs = std::filesystem;

constexpr std::size_t most_differences = 5;

bool is_there(const fs::path& path) {
  std::error_code error;
  return fs::exists(path, error);
}

/// A study and its scene, word for word.
struct FileTexts {
  std::string study, scene;
  friend bool operator==(const FileTexts&, const FileTexts&) = default;
};

/// Whether it stands where the same study has begun, or was about to when it was cut off: study.toml comes
/// last.
bool is_of_beginning(const fs::path& path, const FileTexts& given) {
  const std::string name = path.filename().string();
  std::error_code error;
  return name == "specimen.h5" || name.ends_with(".tmp") ||
         (name == "scene.toml" && read_text_file(path.string()) == given.scene) ||
         ((name == "members" || name == "failures") && fs::is_empty(path, error));
}

/// Whether a study may begin here: nothing is in the folder, or the specimen that is to be broken.
bool is_free(const fs::path& folder, const FileTexts& given) {
  std::error_code error;
  if (!is_there(folder)) return true;
  if (!fs::is_directory(folder, error)) return false;
  const fs::directory_iterator entries(folder, error);
  return std::all_of(begin(entries), end(entries),
                     [&](const fs::directory_entry& entry) { return is_of_beginning(entry.path(), given); });
}

/// Empty where a study may begin.
FileTexts kept_texts(const fs::path& folder, const FileTexts& given) {
  if (!is_there(folder / "study.toml") && is_free(folder, given)) return {};
  if (!is_there(folder / "study.toml"))
    throw Rejected(Exit::usage, "-o", folder.string(), "holds something else than a study",
                   "choose another folder");
  return {read_text_file((folder / "study.toml").string()), read_text_file((folder / "scene.toml").string())};
}

std::string differences_text(const FileTexts& kept, const FileTexts& given) {
  std::vector<std::string> texts;
  const auto add = [&](const std::string& of, const std::string& there, const std::string& here) {
    for (const SceneDifference& one : scene_differences({there, here}))
      texts.push_back(fmt::format("{}{} was {} and is {}", of, one.key,
                                  one.values[0].empty() ? "not given" : one.values[0],
                                  one.values[1].empty() ? "not given" : one.values[1]));
  };
  add("", kept.study, given.study);
  add("scene ", kept.scene, given.scene);
  if (texts.size() > most_differences) texts.resize(most_differences);
  return listed(texts, "and");
}

/// Whether every member of the study that a folder holds is among those.
bool only_grew(const Study& kept, const std::vector<Member>& members) {
  std::set<std::string> ids;
  for (const Member& member : members) ids.insert(member.id);
  const std::vector<Member> before = list_members(kept);
  return std::all_of(before.begin(), before.end(),
                     [&](const Member& member) { return ids.count(member.id) > 0; });
}

std::string cure_of(const Study& kept, const Study& given) {
  const bool cube = kept.plan.sampling == Sampling::latin_hypercube &&
                    given.plan.sampling == Sampling::latin_hypercube &&
                    kept.plan.samples != given.plan.samples;
  return cube ? "a Latin hypercube cannot grow; sampling = \"sobol\" can, in another folder with -o"
              : "choose another folder with -o; a study may only grow: more seeds, levels or samples";
}

/// What one of our files says by a key: a whole number or a text.   @throws Rejected for a file that does
/// not.
template <class T>
T said_in(const fs::path& file, const char* key, const std::string& cure = {}) {
  const auto json = nlohmann::json::parse(read_text_file(file.string()), nullptr, false);
  const auto value = json.is_object() ? json.value(key, nlohmann::json()) : nlohmann::json();
  if (std::is_same_v<T, int> ? value.is_number_integer() : value.is_string()) return value.get<T>();
  throw Rejected(Exit::data, file.string(), std::string("says no ") + key, "must be as mesopix wrote it",
                 cure);
}

/// As the folder says it; before it did, it was 1.
int kept_format(const fs::path& file) { return is_there(file) ? said_in<int>(file, "format") : 1; }

/// Nothing is there, or an empty folder.
bool is_empty_place(const fs::path& folder) {
  std::error_code error;
  return !fs::exists(folder, error) || (fs::is_directory(folder, error) && fs::is_empty(folder, error));
}

/// Makes the folder of a study beside its place and then moves it there, so that others see all of it or
/// nothing.
/// @return false when another folder had taken the place.
bool make_at_once(const fs::path& folder, const FileTexts& texts) {
  const fs::path place = fs::absolute(folder).lexically_normal();
  const fs::path target = place.has_filename() ? place : place.parent_path();
  const fs::path made = target.string() + "." + std::to_string(::getpid()) + "-" +
                        std::to_string(std::chrono::steady_clock::now().time_since_epoch().count()) + ".tmp";
  std::error_code error;
  try {
    make_folders(made / "members");
    make_folders(made / "failures");
    mpm::replace_file((made / "scene.toml").string(), texts.scene);
    mpm::replace_file((made / "study.toml").string(), texts.study);
    mpm::replace_file((made / "format.json").string(), json_text({{"format", identity_format}}));
    fs::rename(made, target, error);
  } catch (...) {
    std::error_code ignored;
    fs::remove_all(made, ignored);
    throw;
  }
  if (!error) return true;
  std::error_code ignored;
  fs::remove_all(made, ignored);
  if (error == std::errc::directory_not_empty || error == std::errc::not_a_directory ||
      error == std::errc::file_exists)
    return false;
  throw Rejected(Exit::io, folder.string(), error.message(), "must be a folder that can be made");
}

bool holds_anything(const fs::path& folder) {
  std::error_code error;
  return fs::directory_iterator(folder, error) != fs::directory_iterator();
}

}  // namespace

/// Members that were named otherwise would count as open, and lie beside their successors for good.
void StudyFolder::check_format(const Study& study) const {
  if (!holds_anything(path_ / "members") && !holds_anything(path_ / "failures")) return;
  const int kept = kept_format(file("format.json"));
  if (kept == identity_format) return;
  throw Rejected(
      Exit::data, "-o", path_.string(),
      fmt::format("holds members kept by {} version of mesopix, which have another identity",
                  kept < identity_format ? "an older" : "a newer"),
      fmt::format("run the study anew in a folder of its own, mesopix study {} -o {}; what is in this "
                  "one, its table too, stays as it is",
                  shell_word(study.file.path), shell_word(path_.string() + "-new")));
}

void StudyFolder::open(const Study& study, const std::vector<Member>& members) const {
  const FileTexts given{study.file.text, study.scene.text};
  // Another program that begins the same study may be faster; then its folder is looked at as any other.
  if (is_empty_place(path_) && make_at_once(path_, given)) return;
  const FileTexts kept = kept_texts(path_, given);
  if (!kept.study.empty()) check_format(study);
  if (!kept.study.empty() && kept != given) {
    const Study before = study_of({kept.study, study.file.path}, {kept.scene, study.scene.path});
    if (!only_grew(before, members))
      throw Rejected(Exit::usage, "-o", path_.string() + " holds another study",
                     differences_text(kept, given), cure_of(before, study));
  }
  make_folders(path_ / "members");
  make_folders(path_ / "failures");
  for (const char* part : {"", "members", "failures"}) remove_old_remainders(path_ / part);
  if (kept.scene != given.scene) mpm::replace_file(file("scene.toml").string(), given.scene);
  if (kept.study != given.study) mpm::replace_file(file("study.toml").string(), given.study);
  if (kept_format(file("format.json")) != identity_format)
    mpm::replace_file(file("format.json").string(), json_text({{"format", identity_format}}));
}

fs::path StudyFolder::result_file(const Member& member) const {
  return path_ / "members" / (member.id + ".h5");
}

fs::path StudyFolder::run_folder(const Member& member) const { return path_ / "members" / member.id; }

fs::path StudyFolder::failure_file(const Member& member) const {
  return path_ / "failures" / (member.id + ".json");
}

bool StudyFolder::has_result(const Member& member) const { return is_there(result_file(member)); }

bool StudyFolder::has_failed(const Member& member) const { return is_there(failure_file(member)); }

bool StudyFolder::has_begun(const Member& member) const { return is_there(run_folder(member)); }

void StudyFolder::write_failure(const Study& study, const Member& member, const std::string& reason) const {
  nlohmann::ordered_json json{{"member", member.number}, {"id", member.id}, {"reason", reason}};
  if (member.seed) json["seed"] = *member.seed;
  json["values"] = nlohmann::ordered_json::object();
  for (std::size_t i = 0; i < member.values.size(); ++i)
    json["values"][study.plan.parameters[i].name] = text_of(study.plan.parameters[i], member.values[i]);
  mpm::replace_file(failure_file(member).string(), json_text(json));
}

std::string StudyFolder::failure(const Member& member) const {
  return has_failed(member) ? said_in<std::string>(failure_file(member), "reason", "remove it") : "";
}

void StudyFolder::forget_failure(const Member& member) const {
  std::error_code ignored;
  fs::remove(failure_file(member), ignored);
}

}  // namespace app
