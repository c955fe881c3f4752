#include "apps/job/specimen_source.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <filesystem>
#include <nlohmann/json.hpp>
#include <utility>

#include "apps/job/specimen_report.hpp"
#include "apps/scene/ellipse_list.hpp"
#include "apps/scene/scene_text.hpp"
#include "apps/scene/stroke_list.hpp"
#include "apps/system/files.hpp"
#include "apps/system/hdf5_files.hpp"
#include "apps/text/complaint.hpp"
#include "apps/text/markup.hpp"
#include "apps/text/version.hpp"
#include "specimen/body/files.hpp"
#include "specimen/convert/convert.hpp"
#include "specimen/describe/doubts.hpp"
#include "specimen/file/specimen_file.hpp"
#include "specimen/pack/packing.hpp"
#include "specimen/picture/picture.hpp"

namespace app {
namespace {

namespace fs = std::filesystem;

specimen::Provenance provenance(const Settings& settings, std::string source, const fs::path& folder) {
  return {std::move(source), settings.specimen.sha256, scene_text(settings, Extent::specimen, folder), 0,
          version()};
}

Prepared draw(const Settings& settings, const std::vector<specimen::Ellipse>& ellipses,
              specimen::Provenance provenance) {
  auto segmented =
      specimen::draw_ellipses(ellipses, settings.packing.width, settings.packing.height, settings.pixel_size);
  return {specimen::make_specimen(std::move(segmented), settings.itz, std::move(provenance)), {}, {}};
}

Prepared generate(const Settings& settings) {
  const specimen::Packing packing = specimen::pack(packing_options(settings));
  specimen::Provenance origin = provenance(settings, "generated", fs::path());
  origin.seed = settings.packing.seed;
  Prepared prepared = draw(settings, packing.ellipses, std::move(origin));
  if (packing.relaxed)
    prepared.notes.push_back(
        "plain placement did not reach the fraction; overlaps were pushed apart instead");
  return prepared;
}

/// A label picture that has its ITZ needs no second one round it.
specimen::ItzOptions itz_for(const specimen::LabelledMask& mask, specimen::ItzOptions options,
                             std::vector<std::string>& notes) {
  const bool has_itz = specimen::count_labels(mask)[specimen::phase::itz] > 0;
  if (!has_itz || options.mode != specimen::ItzMode::ring) return options;
  notes.emplace_back("the picture has its ITZ already, so no rings were drawn");
  options.mode = specimen::ItzMode::none;
  return options;
}

Prepared with_rings(specimen::Converted converted, const Settings& settings) {
  const fs::path picture = settings.specimen.picture;
  Prepared prepared;
  prepared.notes = std::move(converted.report.notes);
  prepared.segmentation.mask = converted.segmented.mask;
  prepared.segmentation.instances = converted.segmented.instances;
  prepared.photograph = std::move(converted.photograph);
  prepared.uncertain = std::move(converted.uncertain);
  prepared.uncertain_share = converted.report.uncertain;
  prepared.model = std::move(converted.model);
  const auto itz = itz_for(prepared.segmentation.mask, settings.itz, prepared.notes);
  auto origin = provenance(settings, picture.filename().string(), picture.parent_path());
  origin.warnings = std::move(converted.report.warnings);
  prepared.specimen = specimen::make_specimen(std::move(converted.segmented), itz, std::move(origin));
  return prepared;
}

/// The options of a conversion, with the strokes that are lines in a file.
specimen::ConvertOptions conversion_of(const Settings& settings) {
  specimen::ConvertOptions options = settings.convert;
  if (!holds_lines(options.strokes)) return options;
  options.stroke_lines = read_stroke_list(options.strokes);
  options.strokes.clear();
  return options;
}

void pin(const std::string& file, std::string& expected) {
  const std::string found = specimen::sha256_of_file(file);
  if (!expected.empty() && expected != found)
    throw Rejected(Exit::data, "specimen.sha256", file + " has " + found, "must be " + expected,
                   "bring the file back as it was, or remove specimen.sha256");
  expected = found;
}

}  // namespace

void settle_source(Settings& settings) {
  SpecimenChoice& choice = settings.specimen;
  if (!choice.ellipses.empty()) {
    pin(choice.ellipses, choice.sha256);
    choice.ellipse_list = read_ellipse_list(choice.ellipses);
    choice.ellipses.clear();
    choice.sha256.clear();
  }
  if (!choice.file.empty()) pin(choice.file, choice.sha256);
  if (!choice.picture.empty()) pin(choice.picture, choice.sha256);
}

bool is_cut_out(double x, double y, const std::vector<Cut>& cuts) {
  return std::any_of(cuts.begin(), cuts.end(), [&](const Cut& cut) {
    const auto& r = cut.rectangle;
    const auto& c = cut.circle;
    const bool inside = (!r.empty() && x >= r[0] && x < r[0] + r[2] && y >= r[1] && y < r[1] + r[3]) ||
                        (!c.empty() && std::hypot(x - c[0], y - c[1]) < c[2]);
    return inside != cut.keeps_inside;
  });
}

namespace {

void check_cuts(const std::vector<Cut>& cuts) {
  for (std::size_t i = 0; i < cuts.size(); ++i)
    if (cuts[i].rectangle.empty() == cuts[i].circle.empty())
      throw Rejected(Exit::data, "cuts[" + std::to_string(i + 1) + "]",
                     cuts[i].circle.empty() ? "neither rectangle nor circle" : "rectangle and circle",
                     "a cut is one of them", "give one of the two");
}

/// Pixels whose centre lies in a cut become void.
Prepared with_cuts(Prepared prepared, const std::vector<Cut>& cuts) {
  check_cuts(cuts);
  if (cuts.empty()) return prepared;
  specimen::LabelledMask& mask = prepared.specimen.mask;
  const auto nothing = std::find(mask.phases.begin(), mask.phases.end(), "void");
  if (nothing == mask.phases.end())
    throw Rejected(Exit::data, "cuts", "in a specimen without void", "a cut leaves void, phase 0");
  const auto label = static_cast<std::uint8_t>(nothing - mask.phases.begin());
  for (int row = 0; row < mask.labels.rows; ++row)
    for (int col = 0; col < mask.labels.cols; ++col)
      if (is_cut_out((col + 0.5) * mask.pixel_size, (mask.labels.rows - row - 0.5) * mask.pixel_size, cuts))
        mask.labels(row, col) = label;
  return prepared;
}

Prepared uncut(const Settings& settings, specimen::SizeListener before_pixels) {
  switch (source_of(settings)) {
    case Source::generated:
      return generate(settings);
    case Source::ellipses:
      return draw(settings, settings.specimen.ellipse_list, provenance(settings, "ellipse list", fs::path()));
    case Source::picture:
      return with_rings(specimen::convert_picture(settings.specimen.picture, conversion_of(settings),
                                                  std::move(before_pixels)),
                        settings);
    case Source::file:
      return {read_specimen(settings.specimen.file), {}, {}};
  }
  return {};
}

}  // namespace

Prepared prepare_specimen(specimen::Picture picture, const Settings& settings) {
  return with_cuts(
      with_rings(specimen::convert_picture(std::move(picture), conversion_of(settings)), settings),
      settings.cuts);
}

Prepared prepare_specimen(const Settings& settings, specimen::SizeListener before_pixels) {
  return with_cuts(uncut(settings, std::move(before_pixels)), settings.cuts);
}

namespace {

namespace fs = std::filesystem;

std::string path_beside(const std::string& path, const char* ending) {
  const fs::path file(path);
  return (file.parent_path() / (file.stem().string() + ending)).string();
}

constexpr const char* preview_ending = "_preview.png";
constexpr const char* overlay_ending = "_overlay.png";

bool same_file(const std::string& first, const std::string& second) {
  std::error_code error;
  return fs::equivalent(first, second, error) && !error;
}

}  // namespace

void check_output(const std::string& path, const std::string& input) {
  constexpr std::array<const char*, 6> endings{".h5", ".png", ".tif", ".tiff", ".bmp", ".pgm"};
  if (std::find(endings.begin(), endings.end(), ending_of(path)) == endings.end())
    throw Rejected(Exit::usage, "-o", path, "must end in .h5, .png, .tif, .tiff, .bmp or .pgm");
  for (const std::string& file : {path, path_beside(path, preview_ending), path_beside(path, overlay_ending)})
    if (!input.empty() && same_file(file, input))
      throw Rejected(Exit::usage, "-o", path, "would overwrite " + input, "choose another name");
}

std::vector<std::string> write_specimen_output(const std::string& path, const specimen::Specimen& specimen,
                                               const specimen::Raster<specimen::Rgb>& photograph,
                                               const specimen::Raster<std::uint8_t>& uncertain) {
  if (ending_of(path) != ".h5") {
    specimen::write_labels(path, specimen.mask);
    return {path};
  }
  specimen::write_specimen(path, specimen);
  std::vector<std::string> files{path, path_beside(path, preview_ending)};
  specimen::write_preview(files.back(), specimen.mask);
  if (photograph.empty()) return files;
  files.push_back(path_beside(path, overlay_ending));
  specimen::write_overlay(files.back(), photograph, specimen.mask, uncertain);
  return files;
}

void report_specimen(Console& console, bool as_json, const Prepared& prepared, nlohmann::ordered_json figures,
                     const std::vector<std::string>& files) {
  for (const std::string& note : prepared.notes) console.say("note: " + note);
  for (const std::string& doubt : specimen::doubts_of(prepared.specimen)) console.warn(doubt);
  if (as_json) {
    figures["notes"] = prepared.notes;
    figures["files"] = files;
    console.out << json_text(figures);
    return;
  }
  std::string text = specimen_text(figures);
  text.pop_back();  // its last line break: say() adds one
  console.say(text);
  for (const std::string& file : files) console.say("wrote " + file);
}

}  // namespace app
