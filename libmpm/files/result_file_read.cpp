#include "libmpm/files/hdf5_read.hpp"
#include "libmpm/files/result_file.hpp"

#include <sstream>
#include "libmpm/files/result_file_hdf5.hpp"
#include "libmpm/scene/error.hpp"
#include "libmpm/scene/result.hpp"

namespace mpm {
namespace {

using namespace hdf5;
using namespace result_file;

template <class T>
PixelField<T> read_map(hid_t file, const std::string& name, const char* unit = "1") {
  PixelField<T> map;
  read_values<T>(file, name, 2, unit, [&](const std::vector<hsize_t>& extent) {
    map.resize(static_cast<Eigen::Index>(extent[0]), static_cast<Eigen::Index>(extent[1]));
    return map.data();
  });
  return map;
}

template <class T>
void read_column(hid_t group, const HistoryColumn& column, T HistoryRow::*member,
                 std::vector<HistoryRow>& history) {
  std::vector<T> values;
  read_values<T>(group, std::string(column.name), 1, std::string(column.unit),
                 [&](const std::vector<hsize_t>& extent) {
                   values.resize(extent[0]);
                   return values.data();
                 });
  if (&column == &history_columns().front()) history.resize(values.size());
  require(values.size() == history.size(),
          "dataset history/" + std::string(column.name) + " has another length than history/time");
  for (std::size_t i = 0; i < values.size(); ++i) history[i].*member = values[i];
}

std::vector<HistoryRow> read_history(hid_t file) {
  const Handle group = open_group(file, "history");
  std::vector<HistoryRow> history;
  for (const HistoryColumn& column : history_columns())
    std::visit([&](auto member) { read_column(group, column, member, history); }, column.member);
  return history;
}

std::vector<GaugeReadings> read_gauges(hid_t file, std::size_t rows) {
  std::vector<GaugeReadings> gauges;
  if (H5Lexists(file, "gauges", H5P_DEFAULT) <= 0) return gauges;
  const Handle group = open_group(file, "gauges");
  std::istringstream names(read_text(group, "names"));
  for (std::string name; std::getline(names, name, ',');) {
    GaugeReadings& gauge = gauges.emplace_back();
    gauge.name = name;
    read_values<double>(group, name, 1, "m", [&](const std::vector<hsize_t>& extent) {
      gauge.values.resize(extent[0]);
      return gauge.values.data();
    });
    require(gauge.values.size() == rows, "dataset gauges/" + name + " has another length than history/time");
  }
  return gauges;
}

StopReason stop_of(const std::string& name) {
  for (const auto& [value, known] : stop_reasons)
    if (name == known) return value;
  throw Fault("attribute stop_reason is \"" + name + "\", which is unknown");
}

void read_figures(hid_t file, Result& result) {
  // Older files call the largest stress a peak, whether it is one or not.
  const bool older = H5Aexists(file, "largest_stress_Pa") <= 0;
  result.peak_stress = read_number<double>(file, older ? "peak_stress_Pa" : "largest_stress_Pa");
  result.peak_strain = read_number<double>(file, older ? "peak_strain" : "strain_at_largest_stress");
  result.tension_failures = read_number<std::int64_t>(file, "tension_failures");
  result.shear_failures = read_number<std::int64_t>(file, "shear_failures");
  result.points = read_number<std::int64_t>(file, "points");
  result.steps = read_number<std::int64_t>(file, "steps");
  result.dt = read_number<double>(file, "dt_s");
  result.wall_time = read_number<double>(file, "wall_time_s");
  result.energy_error = read_number<double>(file, "energy_error");
  result.instruction_set = read_text(file, "instruction_set");
  result.threads = read_number<std::int64_t>(file, "threads");
  result.stop = stop_of(read_text(file, "stop_reason"));
  // Older files do not say.
  result.nothing_carries =
      H5Aexists(file, "nothing_carries") > 0 && read_number<std::int64_t>(file, "nothing_carries") != 0;
}

template <class A, class B>
bool same_shape(const PixelField<A>& a, const PixelField<B>& b) {
  return a.rows() == b.rows() && a.cols() == b.cols();
}

void read_maps(hid_t file, Result& result) {
  result.failure_strain = read_map<float>(file, "failure_strain");
  result.failure_mode = read_map<std::uint8_t>(file, "failure_mode");
  require(same_shape(result.failure_mode, result.failure_strain),
          "dataset failure_mode has another shape than failure_strain");
  require(result.failure_mode.size() == 0 || result.failure_mode.maxCoeff() <= 2,
          "dataset failure_mode holds a value above 2");
  if (H5Lexists(file, "crush_strain", H5P_DEFAULT) > 0) {
    result.crush_strain = read_map<float>(file, "crush_strain");
    require(same_shape(result.crush_strain, result.failure_strain),
            "dataset crush_strain has another shape than failure_strain");
  }
  if (H5Lexists(file, "end_x", H5P_DEFAULT) > 0) {
    result.end_x = read_map<float>(file, "end_x", "m");
    result.end_y = read_map<float>(file, "end_y", "m");
    require(same_shape(result.end_y, result.end_x), "dataset end_y has another shape than end_x");
  }
  if (H5Lexists(file, deformation_names[0], H5P_DEFAULT) <= 0) return;
  for (std::size_t i = 0; i < deformation_names.size(); ++i) {
    result.deformation[i] = read_map<float>(file, deformation_names[i]);
    require(same_shape(result.deformation[i], result.end_x),
            std::string("dataset ") + deformation_names[i] + " has another shape than end_x");
  }
}

Handle open_and_check(const std::string& path) {
  Handle file = open_file(path);
  require(H5Aexists(file, "format") > 0 && read_text(file, "format") == format_name,
          "is not a mesopix result");
  const auto version = read_number<std::int64_t>(file, "format_version");
  require(version == format_version, "has format version " + std::to_string(version) +
                                         ", this program reads " + std::to_string(format_version));
  return file;
}

}  // namespace

Result read_result(const std::string& path) try {
  const Quiet quiet;
  const Handle file = open_and_check(path);
  Result result;
  read_figures(file, result);
  result.history = read_history(file);
  result.gauges = read_gauges(file, result.history.size());
  read_maps(file, result);
  return result;
} catch (const Fault& fault) {
  throw FileError(path, fault.what(), "must be a result.h5 that mesopix wrote", "run the simulation again");
}

std::string read_scene_text(const std::string& path) try {
  const Quiet quiet;
  return read_text(open_and_check(path), "scene");
} catch (const Fault& fault) {
  throw FileError(path, fault.what(), "must be a result.h5 that mesopix wrote", "run the simulation again");
}

RunTexts read_run_texts(const std::string& path) try {
  const Quiet quiet;
  const Handle file = open_and_check(path);
  const auto text = [&](const char* name) { return H5Aexists(file, name) > 0 ? read_text(file, name) : ""; };
  return {text("run"), text("remarks")};
} catch (const Fault& fault) {
  throw FileError(path, fault.what(), "must be a result.h5 that mesopix wrote", "run the simulation again");
}

}  // namespace mpm
