#include "libmpm/files/result_file.hpp"

#include <algorithm>

#include "libmpm/files/hdf5_write.hpp"
#include "libmpm/files/replace_file.hpp"
#include "libmpm/files/result_file_hdf5.hpp"
#include "libmpm/scene/error.hpp"
#include "libmpm/scene/result.hpp"

namespace mpm {
namespace {

using namespace hdf5;
using namespace result_file;

template <class T>
void write_map(hid_t parent, const std::string& name, const PixelField<T>& map, const std::string& meaning,
               const std::string& unit = "1") {
  write_values(parent, name, {static_cast<hsize_t>(map.rows()), static_cast<hsize_t>(map.cols())}, map.data(),
               {unit, meaning});
}

template <class T>
void write_column(hid_t group, const HistoryColumn& column, T HistoryRow::*member,
                  const std::vector<HistoryRow>& history) {
  std::vector<T> values(history.size());
  std::transform(history.begin(), history.end(), values.begin(),
                 [&](const HistoryRow& row) { return row.*member; });
  write_values(group, std::string(column.name), {values.size()}, values.data(),
               {std::string(column.unit), std::string(column.meaning)});
}

void write_history(hid_t file, const std::vector<HistoryRow>& history) {
  const Handle group = create_group(file, "history");
  for (const HistoryColumn& column : history_columns())
    std::visit([&](auto member) { write_column(group, column, member, history); }, column.member);
}

void write_gauges(hid_t file, const std::vector<GaugeReadings>& gauges) {
  if (gauges.empty()) return;
  const Handle group = create_group(file, "gauges");
  std::string names;
  for (const GaugeReadings& gauge : gauges) names += (names.empty() ? "" : ",") + gauge.name;
  write_text(group, "names", names);
  for (const GaugeReadings& gauge : gauges)
    write_values(group, gauge.name, {gauge.values.size()}, gauge.values.data(),
                 {"m", "how far its two points have moved apart, by row of the history"});
}

std::string stop_name(StopReason reason) {
  for (const auto& [value, name] : stop_reasons)
    if (value == reason) return name;
  throw Fault("stop_reason has no name");
}

void write_figures(hid_t file, const Result& result, const std::string& scene_text) {
  write_text(file, "format", format_name);
  write_number(file, "format_version", format_version);
  write_number(file, "peak_stress_Pa", peak_of(result, &Result::peak_stress));
  write_number(file, "peak_strain", peak_of(result, &Result::peak_strain));
  write_number(file, "largest_stress_Pa", result.peak_stress);
  write_number(file, "strain_at_largest_stress", result.peak_strain);
  write_number(file, "tension_failures", result.tension_failures);
  write_number(file, "shear_failures", result.shear_failures);
  write_number(file, "points", result.points);
  write_number(file, "steps", result.steps);
  write_number(file, "dt_s", result.dt);
  write_number(file, "wall_time_s", result.wall_time);
  write_number(file, "energy_error", result.energy_error);
  write_text(file, "instruction_set", result.instruction_set);
  write_number(file, "threads", result.threads);
  write_text(file, "stop_reason", stop_name(result.stop));
  write_number(file, "nothing_carries", std::int64_t{result.nothing_carries});
  write_text(file, "scene", scene_text);
}

void write_maps(hid_t file, const Result& result) {
  write_map(file, "failure_strain", result.failure_strain,
            "platen strain at which the point of a pixel failed, NaN = it did not fail; row 0 is the top");
  write_map(file, "failure_mode", result.failure_mode, "0 = none, 1 = tension, 2 = shear; row 0 is the top");
  if (result.crush_strain.size() > 0)
    write_map(file, "crush_strain", result.crush_strain,
              "platen strain at which a cracked point was crushed in shear, NaN = it was not crushed; row 0 "
              "is the top");
  if (result.end_x.size() > 0) {
    write_map(file, "end_x", result.end_x,
              "final position of the point of a pixel, NaN = none; row 0 is the top", "m");
    write_map(file, "end_y", result.end_y, "the same, upwards from the lower edge of the picture", "m");
  }
  for (std::size_t i = 0; i < result.deformation.size(); ++i)
    if (result.deformation[i].size() > 0)
      write_map(file, deformation_names[i], result.deformation[i],
                "final deformation gradient of the point of a pixel; row 0 is the top");
}

}  // namespace

void write_result(const std::string& path, const Result& result, const std::string& scene_text,
                  const RunTexts& texts) try {
  const Quiet quiet;
  const Handle file = memory_file();
  write_figures(file, result, scene_text);
  if (!texts.run.empty()) write_text(file, "run", texts.run);
  if (!texts.remarks.empty()) write_text(file, "remarks", texts.remarks);
  write_history(file, result.history);
  write_gauges(file, result.gauges);
  write_maps(file, result);
  replace_file(path, image_of(file));
} catch (const Fault& fault) {
  throw FileError(path, fault.what(), "");
}

}  // namespace mpm
