#include "apps/twin/twin_folder.hpp"

#include <cmath>
#include <nlohmann/json.hpp>
#include <regex>
#include <set>

#include "apps/job/specimen_source.hpp"
#include "apps/scene/scene_text.hpp"
#include "apps/text/complaint.hpp"
#include "apps/text/markup.hpp"
#include "apps/text/quantity.hpp"
#include "apps/text/version.hpp"
#include "apps/twin/twin_report.hpp"
#include "apps/twin/twin_words.hpp"
#include "libmpm/files/replace_file.hpp"
#include "specimen/describe/doubts.hpp"

namespace app {
namespace {

using Json = nlohmann::ordered_json;

Json number(double value) { return std::isfinite(value) ? Json(value) : Json(nullptr); }

/// A figure that every specimen has, and how it is called.
struct Column {
  const char* name;
  double (*of)(const specimen::Descriptors&);
};

constexpr Column columns[] = {
    {"aggregate_fraction", [](const specimen::Descriptors& d) { return d.fraction; }},
    {"median_diameter_m", [](const specimen::Descriptors& d) { return d.median_diameter; }},
    {"mean_aspect", [](const specimen::Descriptors& d) { return d.mean_aspect; }},
    {"direction_rad", [](const specimen::Descriptors& d) { return d.orientation.direction; }},
    {"direction_strength", [](const specimen::Descriptors& d) { return d.orientation.strength; }},
    {"direction_probability", [](const specimen::Descriptors& d) { return d.orientation.probability; }},
    {"mean_gap_m", [](const specimen::Descriptors& d) { return d.mean_gap; }},
    {"specific_perimeter_per_m", [](const specimen::Descriptors& d) { return d.specific_perimeter; }},
    {"whole_aggregates",
     [](const specimen::Descriptors& d) { return static_cast<double>(d.sample.whole()); }},
    {"cut_aggregates", [](const specimen::Descriptors& d) { return static_cast<double>(d.sample.cut); }},
    {"void_fraction", [](const specimen::Descriptors& d) { return d.void_fraction; }},
};

Json figures_json(const specimen::Descriptors& descriptors) {
  Json figures = Json::object();
  for (const Column& column : columns) figures[column.name] = number(column.of(descriptors));
  return figures;
}

Json figure_json(const specimen::FigureMisfit& misfit) {
  return {{"original", number(misfit.original)},         {"twins_mean", number(misfit.mean)},
          {"twins_deviation", number(misfit.deviation)}, {"twins_least", number(misfit.least)},
          {"twins_largest", number(misfit.largest)},     {"difference", number(misfit.difference())}};
}

Json curve_json(const specimen::CurveMisfit& misfit) {
  return {{"original_from_twins", number(misfit.original)},
          {"twin_from_others_mean", number(misfit.mean)},
          {"twin_from_others_largest", number(misfit.largest)},
          {"within", std::isfinite(misfit.largest) ? Json(misfit.within()) : Json(nullptr)}};
}

Json misfit_json(const specimen::Misfit& misfit) {
  return {{"aggregate_fraction", figure_json(misfit.fraction)},
          {"median_diameter_m", figure_json(misfit.median_diameter)},
          {"mean_aspect", figure_json(misfit.mean_aspect)},
          {"direction_strength", figure_json(misfit.strength)},
          {"direction_of_twins_rad", misfit.direction},
          {"mean_gap_m", figure_json(misfit.mean_gap)},
          {"specific_perimeter_per_m", figure_json(misfit.specific_perimeter)},
          {"size_curve_largest", curve_json(misfit.sizes)},
          {"size_curve_mean_m", curve_json(misfit.sizes_mean)},
          {"nearest_neighbours_largest", curve_json(misfit.gaps)},
          {"s2_rms", curve_json(misfit.s2_rms)},
          {"s2_largest", curve_json(misfit.s2_largest)},
          {"s2_along_x_rms", curve_json(misfit.s2_along_x_rms)},
          {"s2_along_y_rms", curve_json(misfit.s2_along_y_rms)}};
}

Json s2_json(const specimen::TwoPoint& s2) {
  return {
      {"distance_m", s2.distance}, {"radial", s2.radial}, {"along_x", s2.along_x}, {"along_y", s2.along_y}};
}

Json plan_json(const TwinTask& task, std::size_t count) {
  const specimen::TwinPlan& plan = task.plan;
  return {{"count", count},
          {"first_seed", task.seed},
          {"width_m", plan.width},
          {"height_m", plan.height},
          {"pixel_size_m", plan.pixel_size},
          {"gap_m", plan.gap},
          {"border", plan.cut ? "cut" : "whole"},
          {"keep_directions", plan.oriented}};
}

}  // namespace

Json twins_json(const TwinTask& task, const std::vector<TwinRecord>& twins, const specimen::Misfit& misfit) {
  Json original{{"name", task.name}, {"sha256", task.original.provenance.sha256}};
  original.update(figures_json(task.descriptors));
  original["s2"] = s2_json(task.descriptors.s2);
  Json list = Json::array();
  for (const TwinRecord& twin : twins) {
    Json one{{"file", twin.file}, {"seed", twin.seed}, {"relaxed", twin.relaxed}};
    one.update(figures_json(twin.descriptors));
    one["s2"] = s2_json(twin.descriptors.s2);
    list.push_back(std::move(one));
  }
  return {{"kind", "twins"},
          {"version", version()},
          {"original", std::move(original)},
          {"plan", plan_json(task, twins.size())},
          {"misfit", misfit_json(misfit)},
          {"twins", std::move(list)}};
}

std::string twins_csv(const TwinTask& task, const std::vector<TwinRecord>& twins) {
  std::string csv = "file,seed";
  for (const Column& column : columns) csv += std::string(",") + column.name;
  csv += '\n';
  const auto line = [&csv](const std::string& file, const std::string& seed, const specimen::Descriptors& d) {
    csv += file + ',' + seed;
    for (const Column& column : columns) csv += ',' + format_number(column.of(d));
    csv += '\n';
  };
  line("original.h5", "", task.descriptors);
  for (const TwinRecord& twin : twins) line(twin.file, std::to_string(twin.seed), twin.descriptors);
  return csv;
}

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
  json["warnings"] = specimen::doubts_of(task.original);
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
