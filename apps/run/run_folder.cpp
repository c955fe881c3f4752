#include "apps/run/run_folder.hpp"

#include <fstream>
#include <iterator>
#include <nlohmann/json.hpp>
#include <string>
#include <string_view>
#include <vector>

#include "apps/drawing/chart.hpp"
#include "apps/drawing/damage_picture.hpp"
#include "apps/drawing/deformed_picture.hpp"
#include "apps/drawing/drawing_files.hpp"
#include "apps/drawing/picture_parts.hpp"
#include "apps/report/key_figures.hpp"
#include "apps/report/report.hpp"
#include "apps/report/run_charts.hpp"
#include "apps/run/run_remarks.hpp"
#include "apps/system/files.hpp"
#include "libmpm/files/replace_file.hpp"
#include "libmpm/files/result_file.hpp"
#include "libmpm/scene/error.hpp"
#include "specimen/file/specimen_file.hpp"
#include "specimen/picture/picture.hpp"

namespace {

namespace fs = std::filesystem;

void create_folder(const fs::path& folder) {
  std::error_code error;
  fs::create_directories(folder, error);
  if (error)
    throw mpm::FileError(folder.string(), "cannot be created: " + error.message(), "",
                         "choose a folder that may be written to");
}

void write_text(const fs::path& path, std::string_view text) { mpm::replace_file(path.string(), text); }

/// Magnified by a whole factor, so that small masks can be looked at.
void write_picture(const fs::path& path, const specimen::Raster<specimen::Rgb>& picture, double pixel_size) {
  const int factor = output::file_magnification(picture.rows, picture.cols);
  specimen::write_png(path.string(), output::magnified(picture, factor), pixel_size / factor,
                      specimen::Origin::drawing);
}

/// Of an earlier run in the same folder, which may have gone farther.
void remove_pictures(const fs::path& folder, const std::vector<int>& percents) {
  for (const int percent : percents)
    for (const bool colour : {false, true}) {
      std::error_code ignored;  // there is nothing to remove in a new folder
      fs::remove(folder / output::picture_name(percent, colour), ignored);
    }
}

void write_damage(const fs::path& folder, const RunRecord& record, Attempts& attempt) {
  const specimen::LabelledMask& mask = record.specimen.mask;
  const output::DamageStages stages = output::damage_stages(record.result);
  remove_pictures(folder, stages.missing);
  for (const bool colour : {false, true}) {
    const output::Palette palette = colour ? output::colour_palette() : output::grey_palette();
    for (const output::DamageStage& stage : stages.drawn)
      attempt([&] {
        write_picture(folder / output::picture_name(stage.percent, colour),
                      output::damage_picture(mask, record.result, stage.strain, palette), mask.pixel_size);
      });
  }
}

/// As fine as the other pictures are magnified.
void write_end(const fs::path& folder, const RunRecord& record, Attempts& attempt) {
  const specimen::LabelledMask& mask = record.specimen.mask;
  const int fineness = output::file_magnification(mask.labels.rows, mask.labels.cols);
  for (const bool colour : {false, true}) {
    const fs::path path = folder / output::deformed_name(colour);
    const output::Palette palette = colour ? output::colour_palette() : output::grey_palette();
    std::error_code ignored;  // there is nothing to remove in a new folder
    if (!output::has_end(record.result)) {
      fs::remove(path, ignored);
      continue;
    }
    attempt([&] {
      specimen::write_png(path.string(), output::deformed_picture(mask, record.result, palette, fineness),
                          mask.pixel_size / fineness, specimen::Origin::drawing);
    });
  }
}

/// What mesopix export has made of an earlier run in the same folder.
constexpr const char* maps[] = {"damage.tif", "failure_strain.tif"};

void remove_maps(const fs::path& folder) {
  for (const char* name : maps) {
    std::error_code ignored;
    fs::remove(folder / name, ignored);
  }
}

/// What comes of a run; result.h5 first, without which the others say nothing.
std::vector<std::string> names_of_results() {
  std::vector<std::string> names{"result.h5", "summary.json", "report.html",
                                 "curve.csv", "curve.png",    "specimen.png"};
  for (const bool colour : {false, true}) {
    for (const int percent : output::stage_percents) names.push_back(output::picture_name(percent, colour));
    names.push_back(output::deformed_name(colour));
  }
  names.insert(names.end(), std::begin(maps), std::end(maps));
  return names;
}

void remove_result(const fs::path& path) {
  std::error_code error;
  fs::remove(path, error);
  if (error)
    throw mpm::FileError(path.string(), "of an earlier run cannot be removed: " + error.message(), "",
                         "choose another folder");
}

std::vector<fs::path> results_in(const fs::path& folder) {
  std::vector<fs::path> paths;
  std::error_code error;
  for (const std::string& name : names_of_results())
    if (fs::is_regular_file(folder / name, error)) paths.push_back(folder / name);
  return paths;
}

bool holds_another_scene(const fs::path& folder, const std::string& scene_toml) {
  std::error_code error;
  if (!fs::is_regular_file(folder / "scene.toml", error)) return false;
  std::ifstream in(folder / "scene.toml", std::ios::binary);
  return std::string(std::istreambuf_iterator<char>(in), {}) != scene_toml;
}

mpm::RunTexts texts_of(const RunRecord& record) {
  app::RunRemarks remarks;
  remarks.notes = record.notes;
  remarks.tolerated = record.error_estimate;
  return {run_digest(record.scene_toml, record.scene), app::remarks_text(remarks)};
}

/// All but result.h5.
void write_rest(const fs::path& folder, const RunRecord& record, Attempts& attempt) {
  const auto text = [&](const char* name, const auto& made) {
    attempt([&] { write_text(folder / name, made()); });
  };
  text("curve.csv", [&] { return output::curve_csv(record); });
  text("summary.json",
       [&] { return summary(record).dump(2, ' ', false, nlohmann::json::error_handler_t::replace) + "\n"; });
  text("scene.toml", [&] { return record.scene_toml; });
  attempt([&] { specimen::write_specimen((folder / "specimen.h5").string(), record.specimen); });
  text("report.html", [&] { return output::report_html(record); });
  text("curve.png",
       [&] { return output::png_of(output::lay_out(output::stress_chart(record), 608, 368), 2.5, 16); });
  attempt([&] {
    write_picture(folder / "specimen.png", specimen::preview(record.specimen.mask),
                  record.specimen.mask.pixel_size);
  });
  write_damage(folder, record, attempt);
  write_end(folder, record, attempt);
  attempt.conclude();
}

}  // namespace

void retire_results(const fs::path& folder, const std::string& scene_toml,
                    const specimen::Specimen& specimen) {
  const std::vector<fs::path> old = results_in(folder);
  if (old.empty()) return;
  write_text(folder / "scene.toml", scene_toml);
  for (const fs::path& path : old) remove_result(path);
  specimen::write_specimen((folder / "specimen.h5").string(), specimen);
}

void write_run(const fs::path& folder, const RunRecord& record) {
  Attempts attempt;
  attempt([&] {
    create_folder(folder);
    if (holds_another_scene(folder, record.scene_toml))
      retire_results(folder, record.scene_toml, record.specimen);
  });
  attempt.conclude();
  remove_maps(folder);
  attempt([&] {
    mpm::write_result((folder / "result.h5").string(), record.result, record.scene_toml, texts_of(record));
  });
  write_rest(folder, record, attempt);
}

void write_run_again(const fs::path& folder, const RunRecord& record) {
  Attempts attempt;
  write_rest(folder, record, attempt);
}
