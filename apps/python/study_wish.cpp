#include "apps/python/study.hpp"

#include <fmt/format.h>

#include <utility>

#include "apps/python/body.hpp"
#include "apps/python/options.hpp"
#include "apps/run/run_location.hpp"
#include "apps/scene/input.hpp"
#include "apps/scene/scene_text.hpp"
#include "apps/study/study_file.hpp"
#include "apps/study/study_values.hpp"
#include "apps/system/files.hpp"
#include "specimen/body/files.hpp"
#include "specimen/file/specimen_file.hpp"

namespace binding {
namespace {

namespace fs = std::filesystem;

app::Rejected refused(const std::string& field, const std::string& value, const std::string& allowed,
                      const std::string& cure = {}) {
  return {app::Exit::usage, app::complaint(field, value, allowed, cure)};
}

/// A specimen beside the study that was given it; removed again, with a folder that holds nothing else,
/// unless the study is kept.
class GivenSpecimen {
 public:
  /// @throws app::Rejected when the folder has another one.
  GivenSpecimen(fs::path folder, const specimen::Specimen& specimen) : folder_(std::move(folder)) {
    app::make_folders(folder_);
    const fs::path file = folder_ / specimen_name, written = folder_ / "specimen.h5.new";
    specimen::write_specimen(written.string(), specimen);
    was_there_ = fs::exists(file);
    const bool same =
        was_there_ && specimen::sha256_of_file(file.string()) == specimen::sha256_of_file(written.string());
    if (was_there_)
      fs::remove(written);
    else
      fs::rename(written, file);
    if (was_there_ && !same)
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

/// As the study file has it: paths in full, since the file stands elsewhere.
std::string toml_of(const app::Field& field, py::handle value) {
  app::Value setting = value_of(field, value);
  if (auto* text = std::get_if<std::string>(&setting.data);
      text != nullptr && field.form.kind == app::Kind::path)
    *text = fs::absolute(*text).lexically_normal().string();
  return app::toml_text(setting);
}

/// {"low": 1, "high": 2}, {"from": 1, "to": 2, "steps": 3}, or a sequence.
std::string toml_of_values(const app::Field& field, py::handle values) {
  std::string text;
  const auto add = [&](const std::string& part) { text += (text.empty() ? "" : ", ") + part; };
  if (py::isinstance<py::dict>(values)) {
    for (const auto& [name, value] : values.cast<py::dict>()) {
      const std::string word = py::str(name).cast<std::string>();
      add(app::quoted(word) + " = " +
          (word == "steps" ? py::str(value).cast<std::string>() : toml_of(field, value)));
    }
    return "{" + text + "}";
  }
  if (py::isinstance<py::str>(values) || !py::hasattr(values, "__iter__"))
    throw app::Mistake(
        "must be a sequence of values, {\"from\": 1, \"to\": 3, \"steps\": 5} or {\"low\": 1, \"high\": 3}");
  for (const py::handle value : values) add(toml_of(field, value));
  return "[" + text + "]";
}

/// A line of [vary]: names as simulate takes them, several with + between.
std::string vary_line(const std::string& names, py::handle values) {
  std::string keys, first;
  for (const std::string& name : app::keys_of(names)) {
    const std::string key = app::key_named(app::offer_of_simulate(), name);
    if (first.empty()) first = key;
    keys += (keys.empty() ? "" : " + ") + key;
  }
  if (first.empty())
    throw refused("vary", app::quoted(names), "must be a setting, or several with + between");
  try {
    return app::quoted(keys) + " = " + toml_of_values(*app::find_field(first), values) + "\n";
  } catch (const app::Mistake& mistake) {
    throw refused("vary." + names, py::repr(values).cast<std::string>(), mistake.allowed, mistake.cure);
  }
}

std::string plain_toml(py::handle value) {
  if (py::isinstance<py::str>(value)) return app::quoted(value.cast<std::string>());
  if (!py::hasattr(value, "__iter__")) return py::str(value).cast<std::string>();
  std::string text;
  for (const py::handle item : value) text += (text.empty() ? "" : ", ") + plain_toml(item);
  return "[" + text + "]";
}

std::string study_text(const py::dict& wanted) {
  std::string text = "scene = \"scene.toml\"\n";
  for (const auto& [name, value] : wanted)
    if (!value.is_none() && !py::str(name).equal(py::str("vary")))
      text += py::str(name).cast<std::string>() + " = " + plain_toml(value) + "\n";
  const py::object vary = wanted["vary"];
  if (vary.is_none()) return text;
  text += "\n[vary]\n";
  for (const auto& [names, values] : vary.cast<py::dict>())
    text += vary_line(py::str(names).cast<std::string>(), values);
  return text;
}

/// Of complaints about a text that stands in no file yet.
template <class Read>
app::Study without_places(const std::string& path, const Read& read) {
  try {
    return read();
  } catch (app::Rejected& rejected) {
    for (app::Complaint& one : rejected.complaints)
      if (one.place.file == path) one.place = {};
    throw app::Rejected(app::Exit::usage, rejected.complaints);
  }
}

StudyWish of_scene(const StudyArguments& arguments, const fs::path& folder) {
  Broken broken =
      broken_of(arguments.input, assignments(app::offer_of_simulate(), arguments.settings, arguments.options),
                [](const std::string& path, std::vector<app::Assignment> given) {
                  return app::resolve_input("INPUT", path, std::move(given));
                });
  StudyWish wish;
  app::Settings& settings = broken.resolved.settings;
  if (broken.given) {
    wish.given = std::make_shared<GivenSpecimen>(folder, broken.given->specimen);
    settings.specimen.file = (folder / specimen_name).string();
  }
  const std::string path = (folder / "study.toml").string();
  wish.study = without_places(path, [&] {
    return app::study_of(
        {study_text(arguments.wanted), path},
        {app::scene_text(settings, app::Extent::whole, folder), (folder / "scene.toml").string()});
  });
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
