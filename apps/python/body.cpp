#include "apps/python/body.hpp"

#include <pybind11/stl.h>

#include <filesystem>
#include <nlohmann/json.hpp>

#include "apps/job/job.hpp"
#include "apps/job/specimen_report.hpp"
#include "apps/job/specimen_source.hpp"
#include "apps/python/options.hpp"
#include "apps/python/views.hpp"
#include "apps/scene/input.hpp"
#include "apps/system/hdf5_files.hpp"
#include "specimen/describe/doubts.hpp"
#include "specimen/describe/statistics.hpp"
#include "specimen/file/specimen_file.hpp"
#include "specimen/picture/picture.hpp"
#include "specimen/picture/picture_codecs.hpp"

namespace binding {
namespace {

/// Made without the lock, unless HDF5 is read, which is not safe everywhere.
template <class Make>
app::Prepared unlocked(const app::Settings& settings, const Make& make) {
  if (source_of(settings) == app::Source::file) return make();
  const py::gil_scoped_release unlock;
  return make();
}

/// Says what speaks against it, in a picture.
app::Prepared doubted(app::Prepared prepared) {
  warn_of_doubts(specimen::doubts_of(prepared.specimen));
  return prepared;
}

Body body_of(app::Prepared made) {
  app::Prepared prepared = doubted(std::move(made));
  return {std::make_shared<const specimen::Specimen>(std::move(prepared.specimen)),
          std::move(prepared.notes)};
}

Body body_make(app::Resolved resolved) {
  return located(resolved.origins, [&] {
    settle_source(resolved.settings);
    return body_of(unlocked(resolved.settings, [&] { return prepare_specimen(resolved.settings); }));
  });
}

Body generate(const py::object& scene, const py::dict& settings, const py::dict& options) {
  return located({}, [&] {
    return body_make(app::resolve_ellipses(scene.is_none() ? "" : path_text(scene),
                                           assignments(app::offer_of_generate(), settings, options)));
  });
}

Body convert_array(const py::object& image, std::vector<app::Assignment> given) {
  given.insert(given.begin(), {"specimen.picture", {"array"}, {}, "image", ""});
  app::Resolved resolved = app::resolve({}, given);
  return located(resolved.origins, [&] {
    specimen::Picture picture = picture_of(image);
    resolved.settings.specimen.sha256 = digest_of(picture);
    return body_of(
        unlocked(resolved.settings, [&] { return prepare_specimen(std::move(picture), resolved.settings); }));
  });
}

Body convert(const py::object& image, const py::dict& settings, const py::dict& options) {
  return located({}, [&] {
    auto given = assignments(app::offer_of_convert(), settings, options);
    return is_path(image) ? body_make(app::resolve_picture(path_text(image), std::move(given)))
                          : convert_array(image, std::move(given));
  });
}

Body read_specimen(const py::object& path) {
  return located({}, [&] { return body_of({app::read_specimen(path_text(path)), {}, {}}); });
}

std::vector<std::string> body_write(const Body& body, const py::object& path) {
  return located(with_output("path"), [&] {
    app::check_output(path_text(path), "");
    return app::write_specimen_output(path_text(path), *body.specimen);
  });
}

nlohmann::ordered_json body_figures(const Body& body) { return app::specimen_json(*body.specimen, {}); }

std::string body_representation(const Body& body) {
  std::string text = app::specimen_heading(body_figures(body));
  const std::vector<std::int64_t> counts = specimen::count_labels(body.specimen->mask);
  const std::vector<double> shares = specimen::fractions(body.specimen->mask);
  for (std::size_t label = 0; label < counts.size(); ++label)
    if (counts[label] > 0)
      text += "; " + body.specimen->mask.phases[label] + " " +
              py::str("{:.1f} %").format(100 * shares[label]).cast<std::string>();
  return "<mesopix.Specimen: " + text + ">";
}

py::bytes png(const Body& body) {
  const specimen::LabelledMask& mask = body.specimen->mask;
  const specimen::Bytes bytes =
      specimen::encode_png("", specimen::preview(mask), mask.pixel_size,
                           specimen::own_words(specimen::Origin::preview, mask.phases));
  return {reinterpret_cast<const char*>(bytes.data()), bytes.size()};
}

void refuse_sources(const std::vector<app::Assignment>& given) {
  for (const app::Assignment& one : given)
    if (app::group_of(one.key) == "specimen")
      throw app::Rejected(app::Exit::usage, one.field, one.written, "given beside a specimen", "remove it");
}

}  // namespace

app::Prepared Broken::cells() const {
  const app::Settings& settings = resolved.settings;
  if (given) return doubted(app::fit_to_cells(*given, settings));
  return doubted(unlocked(settings, [&] { return app::prepare_cells(settings); }));
}

app::Prepared Broken::whole() const {
  if (given) return doubted(*given);
  return doubted(unlocked(resolved.settings, [&] { return app::prepare_specimen(resolved.settings); }));
}

Broken broken_of(const py::object& input, std::vector<app::Assignment> given, const std::string& argument) {
  if (!py::isinstance<Body>(input)) {
    const std::string path = path_text(input);
    Broken broken{argument == "SCENE" ? app::resolve_scene(path, given)
                                      : app::resolve_input(argument.c_str(), path, std::move(given)),
                  {},
                  std::filesystem::path(path).stem().string()};
    located(broken.resolved.origins, [&] { settle_source(broken.resolved.settings); });
    if (broken.resolved.settings.title.empty()) broken.resolved.settings.title = broken.stem;
    return broken;
  }
  refuse_sources(given);
  given.push_back({"specimen.file", {specimen_name}, {}, "specimen", ""});
  return {app::resolve({}, given), app::Prepared{*input.cast<const Body&>().specimen, {}, {}}, "specimen"};
}

void bind_specimen(py::module_& module) {
  py::class_<Body>(module, "Specimen",
                   "Which phase each pixel is made of: what simulate breaks. Made by generate, convert and "
                   "read_specimen.")
      .def_property_readonly(
          "labels",
          [](const py::object& self) { return view(self.cast<const Body&>().specimen->mask.labels, self); },
          "label per pixel, uint8 of shape (rows, columns), row 0 on top; read-only, shares the memory of "
          "the "
          "specimen")
      .def_property_readonly(
          "phases", [](const Body& body) { return py::tuple(py::cast(body.specimen->mask.phases)); },
          "names of the labels: phases[label]")
      .def_property_readonly(
          "pixel_size", [](const Body& body) { return body.specimen->mask.pixel_size; },
          "edge of a pixel [m]")
      .def_property_readonly(
          "width", [](const Body& body) { return body.specimen->mask.width(); }, "[m]")
      .def_property_readonly(
          "height", [](const Body& body) { return body.specimen->mask.height(); }, "[m]")
      .def_property_readonly(
          "notes", [](const Body& body) { return py::tuple(py::cast(body.notes)); },
          "what was guessed when it was made, one sentence each")
      .def_property_readonly(
          "summary", [](const Body& body) { return as_dict(body_figures(body)); },
          "figures as mesopix inspect --json gives them; SI units in the names of the keys")
      .def("write", &body_write, py::arg("path"),
           "write(path) -> list of the files\n\nWrite a specimen file (.h5) with a preview picture beside "
           "it, or "
           "the labels as a picture (.png, .tif,\n.bmp, .pgm). Raises Error for another ending, FileError "
           "when "
           "the disk fails.")
      .def("_repr_png_", &png)
      .def("__repr__", &body_representation);
  module.def("generate", &generate);
  module.def("convert", &convert);
  module.def("read_specimen", &read_specimen);
}

}  // namespace binding
