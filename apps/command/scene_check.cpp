#include "apps/command/scene_command.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <exception>
#include <nlohmann/json.hpp>
#include <optional>
#include <utility>

#include "apps/job/job.hpp"
#include "apps/report/fixture_drawing.hpp"
#include "apps/report/run_words.hpp"
#include "apps/scene/scene_doubt.hpp"
#include "apps/scene/scene_file.hpp"
#include "apps/scene/toml.hpp"
#include "apps/settings/assignment.hpp"
#include "apps/study/study_file.hpp"
#include "apps/study/study_members.hpp"
#include "apps/study/study_run.hpp"
#include "apps/system/files.hpp"
#include "libmpm/kernels/instruction_set.hpp"
#include "libmpm/scene/error.hpp"
#include "libmpm/solver/plan.hpp"
#include "specimen/pack/packing.hpp"

namespace app {
namespace {

/// Looks at one scene from all sides.
class SceneCheck {
 public:
  /// @param text  that can be parsed.   @param left_out  of it, since it could not.
  SceneCheck(const std::string& text, const std::string& path, const std::string& left_out)
      : resolved_(resolve_what_can_be(parse_scene(text, path), {}, complaints_)),
        settings_(resolved_.settings),
        doubt_(complaints_, left_out),
        is_whole_(left_out.empty()) {}

  CheckedFile run() {
    for (const Complaint& one : check_use(resolved_.origins, settings_))
      if (!doubt_.is_about(one.field)) complaints_.push_back(one);
    add_new(faults_of_solver());
    add_new(flight_complaints(settings_.scene.loading));
    add_new(faults_of_packing());
    look([&] { settle_source(settings_); });
    const bool is_made = is_specimen_clear() && make_specimen();
    if (!is_made) add_new(faults_of_phases());
    CheckedFile checked;
    checked.complaints = std::move(complaints_);
    checked.notes = std::move(notes_);
    if (checked.complaints.empty()) checked.what = words();
    if (checked.complaints.empty() && is_made) checked.set_up = output::fixture_drawing(mask_, scene_);
    if (const std::string note = note_of_left_out(resolved_.origins, settings_); !note.empty())
      checked.notes.push_back(note);
    return checked;
  }

 private:
  void add(const std::vector<Complaint>& more) {
    complaints_.insert(complaints_.end(), more.begin(), more.end());
  }

  /// Of the libraries: where a setting is refused already, what they say follows from that.
  template <class Error>
  void add_new(const std::vector<Error>& faults) {
    std::vector<Complaint> found;
    for (const Error& fault : faults) {
      if (!has_complaint(fault.field) && !doubt_.is_about(fault.field))
        found.push_back(place(complaint(fault.field, fault.value, fault.allowed, fault.cure)));
    }
    add(found);
  }

  /// @return whether nothing was thrown.
  template <class Step>
  bool look(const Step& step) {
    try {
      step();
      return true;
    } catch (const std::exception&) {
      const Rejected refused = refusal_of(std::current_exception(), located_by(resolved_.origins));
      if (refused.code == Exit::internal) throw;
      for (const Complaint& one : refused.complaints)
        if (!has_complaint(one.field)) complaints_.push_back(place(one));
    }
    return false;
  }

  /// Where the user set it; a file that is named there is at fault there.
  [[nodiscard]] Complaint place(Complaint complaint) const {
    for (const char* key : {"specimen.file", "specimen.picture", "specimen.ellipses"}) {
      const auto given = resolved_.origins.find(key);
      if (given == resolved_.origins.end() || !complaint.place.file.empty()) continue;
      const auto* path = std::get_if<std::string>(&given->second.value.data);
      if (path == nullptr || complaint.field != *path) continue;
      complaint.value = complaint.field + ": " + complaint.value;
      complaint.field = key;
    }
    return locate(resolved_.origins, std::move(complaint));
  }

  [[nodiscard]] bool has_complaint(const std::string& field) const {
    return std::any_of(complaints_.begin(), complaints_.end(),
                       [&](const Complaint& one) { return one.field == field; });
  }

  [[nodiscard]] std::vector<mpm::Error> faults_of_solver() const {
    std::vector<mpm::Error> faults = mpm::faults_beside_specimen(settings_.scene);
    try {
      (void)mpm::chosen_kernels(settings_.scene.instruction_set);
    } catch (const mpm::Error& fault) {
      faults.push_back(fault);
    }
    return faults;
  }

  /// What the sizes of pixels and aggregates say of each other is left out where one of them is refused.
  [[nodiscard]] std::vector<specimen::Error> faults_of_packing() const {
    const Source source = source_of(settings_);
    const specimen::PackingOptions& packing = settings_.packing;
    std::vector<specimen::Error> faults;
    const bool is_drawn = source == Source::generated || source == Source::ellipses;
    if (is_drawn && !has_complaint("generate.pixel_size"))
      faults = specimen::canvas_faults(packing.width, packing.height, settings_.pixel_size, "generate");
    if (source != Source::generated) return faults;
    specimen::PackingOptions options = packing;
    bool is_graded = false;
    if (is_specimen_clear()) try {
        options = packing_options(settings_);
        is_graded = true;
      } catch (const specimen::Error& fault) {  // the sieve curve
        faults.push_back(fault);
      }
    for (const specimen::Error& fault : specimen::faults(options))
      if (is_graded || (fault.field != "generate.d_min" && fault.field != "generate.d_max"))
        faults.push_back(fault);
    return faults;
  }

  /// Of those that the user gave; whether the specimen has them is not known.
  [[nodiscard]] std::vector<mpm::Error> faults_of_phases() const {
    std::vector<mpm::Error> faults;
    for (const mpm::Phase& phase : settings_.phases) {
      const std::string table = "phases." + phase.name + ".";
      const auto given = resolved_.origins.lower_bound(table);
      if (given == resolved_.origins.end() || !given->first.starts_with(table)) continue;
      for (const mpm::Error& fault : mpm::faults(phase, settings_.scene.plane)) faults.push_back(fault);
    }
    return faults;
  }

  [[nodiscard]] bool is_specimen_clear() const {
    return is_whole_ && !doubt_.is_about_specimen() &&
           std::none_of(complaints_.begin(), complaints_.end(), [](const Complaint& one) {
             return is_of_specimen(one.field) || one.field == "solver.cell";
           });
  }

  /// The specimen, and what only shows with it.   @return whether its phases were looked at.
  bool make_specimen() {
    Prepared prepared;
    if (!look([&] { prepared = prepare_cells(settings_); })) return false;
    notes_ = prepared.notes;
    mask_ = prepared.specimen.mask;
    mpm::Scene scene;
    if (!look([&] { scene = build_scene(prepared.specimen, settings_); })) return false;
    const std::vector<mpm::Error> faults = mpm::faults(scene);
    add_new(faults);
    if (faults.empty() && look([&] { plan_ = mpm::plan(scene); })) scene_ = std::move(scene);
    return true;
  }

  [[nodiscard]] std::string words() const {
    static constexpr std::array sources{"random aggregates", "listed ellipses", "a picture",
                                        "a specimen file"};
    return fmt::format("a scene: {}, {:.4g} mm x {:.4g} mm, {}; {} points, {}",
                       sources.at(static_cast<std::size_t>(source_of(settings_))), 1e3 * scene_.width(),
                       1e3 * scene_.height(), output::setting_of_loading(scene_), mpm::count_points(scene_),
                       scene_.method == mpm::SolverMethod::quasi_static
                           ? "a state for each failure"
                           : fmt::format("{} steps", plan_.steps));
  }

  std::vector<Complaint> complaints_;
  std::vector<std::string> notes_;
  Resolved resolved_;
  Settings settings_;
  SceneDoubt doubt_;
  bool is_whole_ = true;  ///< nothing was left out
  specimen::LabelledMask mask_;
  mpm::Scene scene_;
  mpm::Plan plan_;
};

CheckedFile refused(const std::string& path, const Rejected& rejected) {
  CheckedFile checked;
  checked.complaints = rejected.complaints;
  checked.readable = rejected.code != Exit::io;
  for (Complaint& one : checked.complaints)
    if (one.place.file.empty()) one.place.file = path;
  return checked;
}

/// A study whose scene is right: what its members are refused for, the first that is.
CheckedFile check_members(const std::string& path) {
  const Study study = read_study(path);
  const std::vector<Member> members = list_members(study);
  check_scenes(study, members);
  CheckedFile checked;
  checked.what = fmt::format("a study: {} members of {}", members.size(), study.plan.scene);
  return checked;
}

CheckedFile check_text(const std::string& text, const std::string& path, bool of_study);

/// A study names a scene, not another study: files that name each other would be read without end.
CheckedFile check_scene_of_study(const std::string& path) {
  try {
    return check_text(read_text_file(path), path, true);
  } catch (const Rejected& rejected) {
    return refused({}, rejected);
  }
}

/// @param text  that can be parsed.
CheckedFile check_study(const std::string& text, const std::string& path, bool is_whole) {
  CheckedFile checked;
  try {
    (void)parse_study(text, path);
  } catch (const Rejected& rejected) {
    checked = refused(path, rejected);
  }
  if (const std::string scene = scene_of_study(text, path); !scene.empty()) {
    const CheckedFile base = check_scene_of_study(scene);
    const std::size_t room = most_complaints - std::min(most_complaints, checked.complaints.size());
    const auto count = static_cast<std::ptrdiff_t>(std::min(room, base.complaints.size()));
    checked.complaints.insert(checked.complaints.end(), base.complaints.begin(),
                              base.complaints.begin() + count);
  }
  if (!is_whole || !checked.complaints.empty()) return checked;
  try {
    return check_members(path);
  } catch (const std::exception&) {
    return refused(path, refusal_of(std::current_exception()));
  }
}

bool comes_before(const Complaint& a, const Complaint& b) {
  return a.place.file == b.place.file &&
         std::pair(a.place.line, a.place.column) < std::pair(b.place.line, b.place.column);
}

/// The whole file, syntax first.   @param of_study  a study names it as its scene.
CheckedFile check_text(const std::string& text, const std::string& path, bool of_study) {
  bool study = false;
  const Parseable parts =
      parseable(text, [&](const std::string& part) { study = is_meant_as_study(part, path); });
  if (study && of_study)
    return refused(path, Rejected(Exit::data, "scene", path, "is a study itself", "must be a scene"));
  CheckedFile checked = study ? check_study(parts.text, path, parts.complaints.empty())
                              : SceneCheck(parts.text, path, parts.left_out).run();
  checked.complaints.insert(checked.complaints.begin(), parts.complaints.begin(), parts.complaints.end());
  std::stable_sort(checked.complaints.begin(), checked.complaints.end(), comes_before);
  return checked;
}

nlohmann::ordered_json place_json(int number) {
  return number > 0 ? nlohmann::ordered_json(number) : nlohmann::ordered_json(nullptr);
}

nlohmann::ordered_json text_json(const std::string& text) {
  return text.empty() ? nlohmann::ordered_json(nullptr) : nlohmann::ordered_json(text);
}

nlohmann::ordered_json complaint_json(Complaint one, const std::string& file) {
  const Place place = std::exchange(one.place, {});  // told apart from the message
  return {{"file", place.file.empty() ? file : place.file},
          {"line", place_json(place.line)},
          {"column", place_json(place.column)},
          {"key", text_json(one.field)},
          {"value", text_json(one.value)},
          {"problem", text(one)},
          {"allowed", text_json(one.allowed)},
          {"cure", text_json(one.cure)}};
}

}  // namespace

CheckedFile check_file(const std::string& path) {
  CheckedFile checked;
  try {
    checked = check_text(read_text_file(path), path, false);
  } catch (const Rejected& rejected) {
    checked = refused({}, rejected);
  }
  checked.file = path;
  return checked;
}

nlohmann::ordered_json complaints_json(const std::vector<CheckedFile>& files) {
  nlohmann::ordered_json list = nlohmann::ordered_json::array();
  for (const CheckedFile& file : files)
    for (const Complaint& one : file.complaints) list.push_back(complaint_json(one, file.file));
  return list;
}

}  // namespace app
