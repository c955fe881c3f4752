#include "apps/python/study.hpp"

#include <algorithm>
#include <map>
#include <utility>

#include "apps/python/body.hpp"
#include "apps/python/options.hpp"
#include "apps/run/run_location.hpp"
#include "apps/scene/input.hpp"
#include "apps/scene/scene_text.hpp"
#include "apps/study/study_file.hpp"
#include "apps/study/study_values.hpp"
#include "apps/system/files.hpp"
#include "apps/system/hdf5_files.hpp"
#include "specimen/file/specimen_file.hpp"

namespace binding {
namespace {

namespace fs = std::filesystem;

app::Rejected refused(const std::string& field, const std::string& value, const std::string& allowed,
                      const std::string& cure = {}) {
  return {app::Exit::usage, field, value, allowed, cure};
}

/// Whether the same would be broken, wherever both came from.
bool are_same(const specimen::Specimen& a, const specimen::Specimen& b) {
  return a.mask == b.mask && a.itz == b.itz &&
         std::equal(a.rings.begin(), a.rings.end(), b.rings.begin(), b.rings.end(),
                    [](const auto& one, const auto& other) { return one.vertices == other.vertices; });
}

/// A specimen beside the study that was given it; removed again, with a folder that holds nothing else,
/// unless the study is kept.
class GivenSpecimen {
 public:
  /// @throws app::Rejected when the folder has another one.
  GivenSpecimen(fs::path folder, const specimen::Specimen& specimen) : folder_(std::move(folder)) {
    app::make_folders(folder_);
    const std::string file = (folder_ / specimen_name).string();
    was_there_ = fs::exists(file);
    if (!was_there_)
      specimen::write_specimen(file, specimen);
    else if (!are_same(app::read_specimen(file), specimen))
      throw refused("output", folder_.string(), "holds another specimen", "choose another folder");
  }
  ~GivenSpecimen() {
    std::error_code ignored;
    if (!kept_ && !was_there_) fs::remove(folder_ / specimen_name, ignored);
    if (!kept_) fs::remove(folder_, ignored);  // fails, as it should, where anything else is in it
  }
  GivenSpecimen(const GivenSpecimen&) = delete;
  GivenSpecimen& operator=(const GivenSpecimen&) = delete;
  void keep() { kept_ = true; }

 private:
  fs::path folder_;
  bool was_there_ = false;
  bool kept_ = false;
};

/// Paths in full, since the study stands elsewhere.
app::Value value_in_study(const app::Field& field, py::handle value) {
  app::Value setting = value_of(field, value);
  if (auto* text = std::get_if<std::string>(&setting.data);
      text != nullptr && field.form.kind == app::Kind::path)
    *text = fs::absolute(*text).lexically_normal().string();
  return setting;
}

/// {"low": 1, "high": 2}, {"from": 1, "to": 2, "steps": 3}, or a sequence.
app::GivenValues values_in(const app::Field& field, py::handle values) {
  if (py::isinstance<py::dict>(values)) {
    std::map<std::string, app::Value> ends;
    for (const auto& [name, value] : values.cast<py::dict>()) {
      const std::string word = py::str(name).cast<std::string>();
      ends[word] = word == "steps" ? plain_value(value) : value_in_study(field, value);
    }
    return ends;
  }
  if (py::isinstance<py::str>(values) || !py::hasattr(values, "__iter__"))
    throw app::Mistake(
        "must be a sequence of values, {\"from\": 1, \"to\": 3, \"steps\": 5} or {\"low\": 1, \"high\": 3}");
  app::Value::List list;
  for (const py::handle value : values) list.push_back(value_in_study(field, value));
  return list;
}

/// @param names  as simulate takes them, several with + between.
void vary(app::PlanMaker& maker, const std::string& names, py::handle values) {
  std::string keys, first;
  for (const std::string& name : app::keys_of(names)) {
    const std::string key = app::key_named(app::offer_of_simulate(), name);
    if (first.empty()) first = key;
    keys += (keys.empty() ? "" : " + ") + key;
  }
  if (first.empty())
    throw refused("vary", app::quoted(names), "must be a setting, or several with + between");
  try {
    const app::GivenValues given = values_in(*app::find_field(first), values);
    maker.vary(keys, [&] { return given; }, {}, {});
  } catch (const app::Mistake& mistake) {
    throw refused("vary." + names, py::repr(values).cast<std::string>(), mistake.allowed, mistake.cure);
  }
}

void set(app::PlanMaker& maker, const std::string& name, py::handle value) {
  try {
    maker.set(name, plain_value(value), {});
  } catch (const app::Mistake& mistake) {
    throw refused(name, py::repr(value).cast<std::string>(), mistake.allowed, mistake.cure);
  }
}

app::StudyPlan plan_of(const py::dict& wanted, const fs::path& folder) {
  app::PlanMaker maker("", folder.string());
  maker.set("scene", {"scene.toml"}, {});
  for (const auto& [name, value] : wanted)
    if (!value.is_none() && !py::str(name).equal(py::str("vary")))
      set(maker, py::str(name).cast<std::string>(), value);
  if (const py::object all = wanted["vary"]; !all.is_none())
    for (const auto& [names, values] : all.cast<py::dict>())
      vary(maker, py::str(names).cast<std::string>(), values);
  return maker.plan();
}

StudyWish of_scene(const StudyArguments& arguments, const fs::path& folder) {
  Broken broken = broken_of(
      arguments.input, assignments(app::offer_of_simulate(), arguments.settings, arguments.options), "INPUT");
  StudyWish wish;
  app::Settings& settings = broken.resolved.settings;
  if (broken.given) {
    wish.given = std::make_shared<GivenSpecimen>(folder, broken.given->specimen);
    settings.specimen.file = (folder / specimen_name).string();
  }
  app::StudyPlan plan = plan_of(arguments.wanted, folder);
  app::TextFile file{plan_text(plan, folder), (folder / "study.toml").string()};
  app::TextFile scene{app::scene_text(settings, app::Extent::whole, folder), plan.scene};
  wish.study =
      study_of(std::move(plan), app::as_written(std::move(settings)), std::move(file), std::move(scene));
  return wish;
}

bool names_a_study(const py::object& input) {
  if (py::isinstance<Body>(input)) return false;
  const std::string path = path_text(input);
  return app::kind_of_input(path) == app::InputKind::scene &&
         app::is_meant_as_study(app::read_text_file(path), path);
}

StudyWish of_file(const StudyArguments& arguments) {
  for (const py::dict& given : {arguments.settings, arguments.options, arguments.wanted})
    for (const auto& [name, value] : given)
      if (!value.is_none())
        throw refused(py::str(name).cast<std::string>(), py::repr(value).cast<std::string>(),
                      "given beside a study file", "write it there, or give its scene in place of the study");
  return {app::read_study(path_text(arguments.input)), {}};
}

}  // namespace

void StudyWish::keep() const {
  if (given) static_cast<GivenSpecimen*>(given.get())->keep();
}

StudyWish read_wish(const StudyArguments& arguments, const fs::path& folder) {
  return names_a_study(arguments.input) ? of_file(arguments) : of_scene(arguments, folder);
}

}  // namespace binding
