#include <fmt/format.h>
#include <pybind11/stl.h>

#include <memory>
#include <nlohmann/json.hpp>

#include "apps/python/body.hpp"
#include "apps/python/options.hpp"
#include "apps/python/spectator.hpp"
#include "apps/python/study.hpp"
#include "apps/run/run_location.hpp"
#include "apps/scene/input.hpp"
#include "apps/twin/twin_folder.hpp"
#include "apps/twin/twin_words.hpp"
#include "apps/twin/twinning.hpp"
#include "specimen/file/specimen_file.hpp"

namespace binding {
namespace {

namespace fs = std::filesystem;

/// mesopix.Twins: where they are, and how they compare.
struct Family {
  fs::path folder;
  std::vector<std::string> files;
  std::string text;  ///< "10 twins of photo, 150 mm x 150 mm, ..."
  app::TwinStatistics statistics;
};

using FamilyPointer = std::shared_ptr<Family>;

app::TwinWish twins_wish_of(const py::dict& wanted) {
  app::TwinWish wish;
  take(wanted, "count", wish.count);
  take(wanted, "seed", wish.seed);
  take(wanted, "twin_width", wish.width, "m");
  take(wanted, "twin_height", wish.height, "m");
  take(wanted, "twin_pixel_size", wish.pixel_size, "m");
  take(wanted, "gap", wish.gap, "m");
  take(wanted, "border", wish.border);
  return wish;
}

app::TwinTask task_of(const py::object& input, const Broken& broken, const app::TwinWish& wish,
                      std::vector<std::string>& notes) {
  app::Prepared original = broken.whole();
  const bool keeps_itz = source_of(broken.resolved.settings) == app::Source::file;
  const specimen::ItzOptions itz = keeps_itz ? original.specimen.itz : broken.resolved.settings.itz;
  notes = std::move(original.notes);
  return app::make_twin_task(wish, py::isinstance<Body>(input) ? broken.stem : path_text(input),
                             broken.resolved.settings, itz, std::move(original.specimen));
}

std::vector<app::TwinRecord> twins_make(const app::TwinTask& task, const fs::path& folder,
                                        Spectator& spectator) {
  return work_apart(spectator, [&](Overseer& overseer) {
    return app::make_twins(
        task, folder, [&] { return !overseer.goes_on(); },
        [&](std::size_t done) { overseer.look([&] { return glance_at_twins(done, task.count); }); });
  });
}

FamilyPointer twin(const py::object& input, const py::dict& settings, const py::dict& options,
                   const py::dict& wanted, const py::object& output, bool overwrite,
                   const py::object& progress) {
  const app::TwinWish wish = located({}, [&] {
    app::TwinWish read = twins_wish_of(wanted);
    (void)twin_options(read);
    return read;
  });
  const Broken broken = located(
      {}, [&] { return broken_of(input, assignments(app::offer_of_twin(), settings, options), "PICTURE"); });
  return located(with_output("output", broken.resolved.origins), [&] {
    std::vector<std::string> notes;
    const app::TwinTask task = task_of(input, broken, wish, notes);
    const app::FreshFolder folder(app::make_run_folder(path_text(output), "", overwrite));
    Spectator spectator(progress);
    const std::vector<app::TwinRecord> twins = twins_make(task, folder.path(), spectator);
    FamilyPointer family;
    if (!twins.empty()) {
      family = std::make_shared<Family>(Family{folder.path(),
                                               {},
                                               twins_text(task, twins.size()),
                                               write_twin_statistics(folder.path(), task, twins, notes)});
      for (const app::TwinRecord& one : twins) family->files.push_back(one.file);
    }
    const std::string text = family ? "interrupted; the twins that were made are in .result"
                                    : "interrupted before a twin was made";
    spectator.conclude(text, family ? py::cast(family) : py::none());
    if (!family) raise_with("Interrupted", text, py::none());
    return family;
  });
}

Body read(const fs::path& path) {
  return located({}, [&] {
    return Body{std::make_shared<const specimen::Specimen>(specimen::read_specimen(path.string())), {}};
  });
}

Body item(const Family& family, py::ssize_t i) {
  const auto count = static_cast<py::ssize_t>(family.files.size());
  if (i < 0) i += count;
  if (i < 0 || i >= count) throw py::index_error(fmt::format("there are {} twins", count));
  return read(family.folder / family.files[static_cast<std::size_t>(i)]);
}

}  // namespace

void bind_twins(py::module_& module) {
  py::class_<Family, FamilyPointer>(
      module, "Twins",
      "Random specimens that are like an original: twins[i] is a Specimen, read "
      "from its file.")
      .def_property_readonly(
          "original", [](const Family& family) { return read(family.folder / "original.h5"); },
          "the Specimen that they are like")
      .def_property_readonly(
          "summary",
          [](const Family& family) { return as_dict(nlohmann::ordered_json::parse(family.statistics.json)); },
          "figures, curves and misfits, a dict as statistics.json; SI units in the names of the keys")
      .def_property_readonly(
          "notes", [](const Family& family) { return py::tuple(py::cast(family.statistics.notes)); },
          "what was guessed and what to keep in mind, one sentence each")
      .def_property_readonly(
          "folder", [](const Family& family) { return family.folder.string(); },
          "that holds the twins, statistics.csv, report.html, and study.toml, which breaks them all")
      .def("__len__", [](const Family& family) { return family.files.size(); })
      .def("__getitem__", &item)
      .def("__repr__", [](const Family& family) { return "<mesopix.Twins: " + family.text + ">"; });
  module.def("twin", &twin);
}

}  // namespace binding
