/// Study files: TOML that says what of a scene varies, and how.
#pragma once

#include <filesystem>
#include <functional>
#include <map>
#include <set>
#include <string>
#include <vector>

#include "apps/settings/schema.hpp"
#include "apps/study/study.hpp"
#include "apps/study/study_values.hpp"

namespace app {

/// Keys of a study file beside its table [vary].
[[nodiscard]] const std::vector<FieldOf<StudyPlan>>& study_fields();

/// Makes a plan of what is given key by key, by a study file or a script, and collects what is wrong with it.
class PlanMaker {
 public:
  /// @param path  of the study file, for messages; empty = there is none.   @param folder  that paths are
  /// relative to.
  PlanMaker(std::string path, std::string folder) : path_(std::move(path)), folder_(std::move(folder)) {}

  /// @pre one of the study_fields() has the name.
  void set(const std::string& name, const Value& value, const Place& place);
  /// A parameter: one key of the scene, or several with + between.
  /// @param values  gives them; may throw Mistake.
  void vary(const std::string& name, const std::function<GivenValues()>& values, const Place& of_name,
            const Place& of_values);
  void complain(Complaint complaint) {
    if (!is_full()) complaints_.push_back(std::move(complaint));
  }
  [[nodiscard]] bool is_full() const { return complaints_.size() >= most_complaints; }

  /// With what was left out filled in but for the default of seed_of, which needs the scene.
  /// @throws Rejected (Exit::data) with every complaint.
  [[nodiscard]] StudyPlan plan();

 private:
  [[nodiscard]] Place place(const std::string& key) const;
  [[nodiscard]] bool is_given(const std::string& key) const { return places_.count(key) > 0; }
  void check();
  void check_sampling();
  void check_seeds();

  std::string path_;
  std::string folder_;
  StudyPlan plan_;
  std::map<std::string, Place> places_;  ///< of what was set
  std::set<std::string> varied_;         ///< keys of the scene
  std::vector<Complaint> complaints_;
};

/// Whether a text is a study, right or wrong: it names a scene, or says what varies. Other keys of studies
/// stand in scenes by mistake.
/// @throws Rejected (Exit::data) where it is no TOML.
[[nodiscard]] bool is_meant_as_study(const std::string& text, const std::string& path);

/// Path of the scene that the text of a study names; empty when it names none.   @throws as
/// is_meant_as_study.
[[nodiscard]] std::string scene_of_study(const std::string& text, const std::string& path);

/// The plan that a text says.   @param path  for the messages and the folder that paths are relative to.
/// @throws Rejected (Exit::data) with every complaint.
[[nodiscard]] StudyPlan parse_study(const std::string& text, const std::string& path);

/// The study of a file, its scene read and found valid.
/// @throws Rejected for a study or a scene that is wrong, or cannot be read.
[[nodiscard]] Study read_study(const std::string& path);

/// The same from the texts of a study and its scene; the paths are for messages and folders.
[[nodiscard]] Study study_of(TextFile file, TextFile scene);

/// The same of what was made of both already.   @param base  resolved.
[[nodiscard]] Study study_of(StudyPlan plan, Resolved base, TextFile file, TextFile scene);

/// A text that parse_study() turns into the same plan.   @param folder  that the text is to be kept in.
[[nodiscard]] std::string plan_text(const StudyPlan& plan, const std::filesystem::path& folder);

}  // namespace app
