#include "libmpm/result_file.hpp"

#include <hdf5.h>

#include <algorithm>
#include <array>
#include <filesystem>
#include <stdexcept>
#include <utility>

#include "libmpm/error.hpp"
#include "libmpm/history_columns.hpp"
#include "libmpm/replace_file.hpp"

namespace mpm {
namespace {

constexpr const char* format_name = "mesopix result";
constexpr std::int64_t format_version = 1;
constexpr std::array<std::pair<StopReason, const char*>, 3> stop_reasons{{
    {StopReason::strain, "strain"},
    {StopReason::drop, "drop"},
    {StopReason::interrupted, "interrupted"},
}};

/// What is wrong, without the path; the two public functions add it.
struct Fault : std::runtime_error {
  using std::runtime_error::runtime_error;
};

/// HDF5 prints its error stack unless told otherwise; a library never prints.
class Quiet {
 public:
  Quiet() {
    H5Eget_auto2(H5E_DEFAULT, &print_, &data_);
    H5Eset_auto2(H5E_DEFAULT, nullptr, nullptr);
  }
  Quiet(const Quiet&) = delete;
  Quiet& operator=(const Quiet&) = delete;
  ~Quiet() { H5Eset_auto2(H5E_DEFAULT, print_, data_); }

 private:
  H5E_auto2_t print_ = nullptr;
  void* data_ = nullptr;
};

/// An HDF5 identifier that is closed with its scope.
class Handle {
 public:
  Handle(hid_t id, herr_t (*close)(hid_t), const std::string& what) : id_(id), close_(close) {
    if (id_ < 0) throw Fault(what);
  }
  Handle(Handle&& other) noexcept : id_(std::exchange(other.id_, -1)), close_(other.close_) {}
  Handle(const Handle&) = delete;
  Handle& operator=(const Handle&) = delete;
  Handle& operator=(Handle&&) = delete;
  ~Handle() {
    if (id_ >= 0) close_(id_);
  }
  operator hid_t() const { return id_; }

 private:
  hid_t id_;
  herr_t (*close_)(hid_t);
};

void require(bool condition, const std::string& what) {
  if (!condition) throw Fault(what);
}

// ---- types -----------------------------------------------------------------------------------------------

/// How a C++ number lies in memory and in the file.
template <class T>
struct Number;
template <>
struct Number<double> {
  static hid_t memory() { return H5T_NATIVE_DOUBLE; }
  static hid_t file() { return H5T_IEEE_F64LE; }
  static constexpr H5T_class_t kind = H5T_FLOAT;
};
template <>
struct Number<float> {
  static hid_t memory() { return H5T_NATIVE_FLOAT; }
  static hid_t file() { return H5T_IEEE_F32LE; }
  static constexpr H5T_class_t kind = H5T_FLOAT;
};
template <>
struct Number<std::int64_t> {
  static hid_t memory() { return H5T_NATIVE_INT64; }
  static hid_t file() { return H5T_STD_I64LE; }
  static constexpr H5T_class_t kind = H5T_INTEGER;
};
template <>
struct Number<std::uint8_t> {
  static hid_t memory() { return H5T_NATIVE_UINT8; }
  static hid_t file() { return H5T_STD_U8LE; }
  static constexpr H5T_class_t kind = H5T_INTEGER;
};

/// Text of any length, UTF-8, which h5py reads as str.
Handle text_type() {
  Handle type(H5Tcopy(H5T_C_S1), H5Tclose, "out of memory");
  H5Tset_size(type, H5T_VARIABLE);
  H5Tset_cset(type, H5T_CSET_UTF8);
  return type;
}

// ---- writing ---------------------------------------------------------------------------------------------

void write_attribute(hid_t object, const char* name, hid_t file_type, hid_t memory_type, const void* value) {
  const Handle space(H5Screate(H5S_SCALAR), H5Sclose, "out of memory");
  const Handle attribute(H5Acreate2(object, name, file_type, space, H5P_DEFAULT, H5P_DEFAULT), H5Aclose,
                         std::string(name) + " cannot be created");
  require(H5Awrite(attribute, memory_type, value) >= 0, std::string(name) + " cannot be written");
}

template <class T>
void write_number(hid_t object, const char* name, T value) {
  write_attribute(object, name, Number<T>::file(), Number<T>::memory(), &value);
}

void write_text(hid_t object, const char* name, const std::string& text) {
  const Handle type = text_type();
  const char* value = text.c_str();
  write_attribute(object, name, type, type, &value);
}

/// Chunks of at most 512 values a side, compressed and with a checksum. No time is kept, so that the same
/// result gives the same bytes.
Handle dataset_settings(const std::vector<hsize_t>& extent) {
  Handle settings(H5Pcreate(H5P_DATASET_CREATE), H5Pclose, "out of memory");
  H5Pset_obj_track_times(settings, false);
  if (std::find(extent.begin(), extent.end(), 0U) != extent.end()) return settings;  // no chunk can be empty
  std::vector<hsize_t> chunk = extent;
  for (hsize_t& side : chunk) side = std::min<hsize_t>(side, extent.size() == 1 ? 16384 : 512);
  H5Pset_chunk(settings, static_cast<int>(chunk.size()), chunk.data());
  H5Pset_shuffle(settings);
  H5Pset_deflate(settings, 6);
  H5Pset_fletcher32(settings);
  return settings;
}

template <class T>
void write_values(hid_t parent, const std::string& name, const std::vector<hsize_t>& extent, const T* values,
                  const std::string& unit, const std::string& meaning) {
  const Handle space(H5Screate_simple(static_cast<int>(extent.size()), extent.data(), nullptr), H5Sclose,
                     "out of memory");
  const Handle settings = dataset_settings(extent);
  const Handle dataset(
      H5Dcreate2(parent, name.c_str(), Number<T>::file(), space, H5P_DEFAULT, settings, H5P_DEFAULT),
      H5Dclose, name + " cannot be created");
  require(H5Dwrite(dataset, Number<T>::memory(), H5S_ALL, H5S_ALL, H5P_DEFAULT, values) >= 0,
          name + " cannot be written");
  write_text(dataset, "unit", unit);
  write_text(dataset, "meaning", meaning);
}

template <class T>
void write_map(hid_t parent, const std::string& name, const Lattice<T>& map, const std::string& meaning) {
  write_values(parent, name, {static_cast<hsize_t>(map.rows()), static_cast<hsize_t>(map.cols())}, map.data(),
               "1", meaning);
}

template <class T>
void write_column(hid_t group, const HistoryColumn& column, T HistoryRow::*member,
                  const std::vector<HistoryRow>& history) {
  std::vector<T> values(history.size());
  std::transform(history.begin(), history.end(), values.begin(),
                 [&](const HistoryRow& row) { return row.*member; });
  write_values(group, std::string(column.name), {values.size()}, values.data(), std::string(column.unit),
               std::string(column.meaning));
}

void write_history(hid_t file, const std::vector<HistoryRow>& history) {
  const Handle settings(H5Pcreate(H5P_GROUP_CREATE), H5Pclose, "out of memory");
  H5Pset_obj_track_times(settings, false);
  const Handle group(H5Gcreate2(file, "history", H5P_DEFAULT, settings, H5P_DEFAULT), H5Gclose,
                     "history cannot be created");
  for (const HistoryColumn& column : history_columns())
    std::visit([&](auto member) { write_column(group, column, member, history); }, column.member);
}

std::string stop_name(StopReason reason) {
  for (const auto& [value, name] : stop_reasons)
    if (value == reason) return name;
  throw Fault("stop_reason has no name");
}

void write_figures(hid_t file, const Result& result, const std::string& scene_text) {
  write_text(file, "format", format_name);
  write_number(file, "format_version", format_version);
  write_number(file, "peak_stress_Pa", result.peak_stress);
  write_number(file, "peak_strain", result.peak_strain);
  write_number(file, "tension_failures", result.tension_failures);
  write_number(file, "shear_failures", result.shear_failures);
  write_number(file, "points", result.points);
  write_number(file, "steps", result.steps);
  write_number(file, "dt_s", result.dt);
  write_number(file, "wall_time_s", result.wall_time);
  write_number(file, "energy_error", result.energy_error);
  write_text(file, "instruction_set", result.instruction_set);
  write_text(file, "stop_reason", stop_name(result.stop));
  write_text(file, "scene", scene_text);
}

void write_maps(hid_t file, const Result& result) {
  write_map(file, "failure_strain", result.failure_strain,
            "platen strain at which the point of a pixel failed, NaN = it did not; row 0 is the top");
  write_map(file, "failure_mode", result.failure_mode, "0 = none, 1 = tension, 2 = shear; row 0 is the top");
  if (result.crush_strain.size() > 0)
    write_map(
        file, "crush_strain", result.crush_strain,
        "platen strain at which a cracked point was crushed in shear, NaN = it was not; row 0 is the top");
}

/// A file that lives in memory: a full disk can then hit one plain write only, not HDF5 on its way out.
Handle memory_file() {
  const Handle access(H5Pcreate(H5P_FILE_ACCESS), H5Pclose, "out of memory");
  H5Pset_fapl_core(access, std::size_t{1} << 20, false);
  const Handle creation(H5Pcreate(H5P_FILE_CREATE), H5Pclose, "out of memory");
  H5Pset_obj_track_times(creation, false);
  return {H5Fcreate("result", H5F_ACC_TRUNC, creation, access), H5Fclose, "out of memory"};
}

std::string image_of(hid_t file) {
  require(H5Fflush(file, H5F_SCOPE_GLOBAL) >= 0, "cannot be flushed");
  const ssize_t size = H5Fget_file_image(file, nullptr, 0);
  require(size > 0, "cannot be laid out");
  std::string image(static_cast<std::size_t>(size), '\0');
  require(H5Fget_file_image(file, image.data(), image.size()) == size, "cannot be laid out");
  return image;
}

// ---- reading ---------------------------------------------------------------------------------------------

Handle open_result(const std::string& path) {
  require(std::filesystem::is_regular_file(path), "there is no such file");
  return {H5Fopen(path.c_str(), H5F_ACC_RDONLY, H5P_DEFAULT), H5Fclose,
          "is no HDF5 file, or is cut short or damaged"};
}

Handle open_attribute(hid_t object, const char* name) {
  return {H5Aopen(object, name, H5P_DEFAULT), H5Aclose, std::string("attribute ") + name + " is missing"};
}

void require_type(hid_t type, H5T_class_t kind, std::size_t size, const std::string& name) {
  require(H5Tget_class(type) == kind && H5Tget_size(type) == size, name + " has a wrong type");
}

void require_scalar(hid_t attribute, const std::string& name) {
  const Handle space(H5Aget_space(attribute), H5Sclose, name + " is damaged");
  require(H5Sget_simple_extent_npoints(space) == 1, name + " must hold one value");
}

template <class T>
T read_number(hid_t object, const char* name) {
  const Handle attribute = open_attribute(object, name);
  const Handle type(H5Aget_type(attribute), H5Tclose, std::string(name) + " is damaged");
  require_type(type, Number<T>::kind, sizeof(T), std::string("attribute ") + name);
  require_scalar(attribute, std::string("attribute ") + name);
  T value{};
  require(H5Aread(attribute, Number<T>::memory(), &value) >= 0, std::string(name) + " cannot be read");
  return value;
}

std::string read_text(hid_t object, const char* name) {
  const Handle attribute = open_attribute(object, name);
  const Handle type(H5Aget_type(attribute), H5Tclose, std::string(name) + " is damaged");
  require(H5Tget_class(type) == H5T_STRING && H5Tis_variable_str(type) > 0,
          std::string("attribute ") + name + " has a wrong type");
  require_scalar(attribute, std::string("attribute ") + name);
  char* value = nullptr;
  const Handle memory_type = text_type();
  require(H5Aread(attribute, memory_type, &value) >= 0, std::string(name) + " cannot be read");
  std::string text = value == nullptr ? "" : value;
  H5free_memory(value);
  return text;
}

std::vector<hsize_t> extent_of(hid_t dataset, std::size_t rank, const std::string& name) {
  const Handle space(H5Dget_space(dataset), H5Sclose, name + " is damaged");
  require(H5Sget_simple_extent_ndims(space) == static_cast<int>(rank), name + " has a wrong number of axes");
  std::vector<hsize_t> extent(rank);
  H5Sget_simple_extent_dims(space, extent.data(), nullptr);
  return extent;
}

/// An extent that a damaged file only claims would ask for any amount of memory; deflate packs at most
/// 1032:1.
void require_stored(hid_t dataset, const std::vector<hsize_t>& extent, std::size_t value_size,
                    const std::string& name) {
  double bytes = static_cast<double>(value_size);
  for (const hsize_t side : extent) bytes *= static_cast<double>(side);
  require(bytes <= 1100.0 * static_cast<double>(H5Dget_storage_size(dataset)),
          name + " has an extent that its data do not fill");
}

/// @param allocate  given the extent, returns where to put the values.
template <class T, class Allocate>
void read_values(hid_t parent, const std::string& name, std::size_t rank, Allocate allocate) {
  const Handle dataset(H5Dopen2(parent, name.c_str(), H5P_DEFAULT), H5Dclose,
                       "dataset " + name + " is missing");
  const Handle type(H5Dget_type(dataset), H5Tclose, name + " is damaged");
  require_type(type, Number<T>::kind, sizeof(T), "dataset " + name);
  const std::vector<hsize_t> extent = extent_of(dataset, rank, "dataset " + name);
  require_stored(dataset, extent, sizeof(T), "dataset " + name);
  T* values = allocate(extent);
  require(H5Dread(dataset, Number<T>::memory(), H5S_ALL, H5S_ALL, H5P_DEFAULT, values) >= 0,
          "dataset " + name + " is damaged");
}

template <class T>
Lattice<T> read_map(hid_t file, const std::string& name) {
  Lattice<T> map;
  read_values<T>(file, name, 2, [&](const std::vector<hsize_t>& extent) {
    map.resize(static_cast<Eigen::Index>(extent[0]), static_cast<Eigen::Index>(extent[1]));
    return map.data();
  });
  return map;
}

template <class T>
void read_column(hid_t group, const HistoryColumn& column, T HistoryRow::*member,
                 std::vector<HistoryRow>& history) {
  std::vector<T> values;
  read_values<T>(group, std::string(column.name), 1, [&](const std::vector<hsize_t>& extent) {
    values.resize(extent[0]);
    return values.data();
  });
  if (&column == &history_columns().front()) history.resize(values.size());
  require(values.size() == history.size(),
          "dataset history/" + std::string(column.name) + " has another length than history/time");
  for (std::size_t i = 0; i < values.size(); ++i) history[i].*member = values[i];
}

std::vector<HistoryRow> read_history(hid_t file) {
  const Handle group(H5Gopen2(file, "history", H5P_DEFAULT), H5Gclose, "group history is missing");
  std::vector<HistoryRow> history;
  for (const HistoryColumn& column : history_columns())
    std::visit([&](auto member) { read_column(group, column, member, history); }, column.member);
  return history;
}

StopReason stop_of(const std::string& name) {
  for (const auto& [value, known] : stop_reasons)
    if (name == known) return value;
  throw Fault("attribute stop_reason is \"" + name + "\", which means nothing");
}

void read_figures(hid_t file, Result& result) {
  result.peak_stress = read_number<double>(file, "peak_stress_Pa");
  result.peak_strain = read_number<double>(file, "peak_strain");
  result.tension_failures = read_number<std::int64_t>(file, "tension_failures");
  result.shear_failures = read_number<std::int64_t>(file, "shear_failures");
  result.points = read_number<std::int64_t>(file, "points");
  result.steps = read_number<std::int64_t>(file, "steps");
  result.dt = read_number<double>(file, "dt_s");
  result.wall_time = read_number<double>(file, "wall_time_s");
  result.energy_error = read_number<double>(file, "energy_error");
  result.instruction_set = read_text(file, "instruction_set");
  result.stop = stop_of(read_text(file, "stop_reason"));
}

template <class A, class B>
bool same_shape(const Lattice<A>& a, const Lattice<B>& b) {
  return a.rows() == b.rows() && a.cols() == b.cols();
}

void read_maps(hid_t file, Result& result) {
  result.failure_strain = read_map<float>(file, "failure_strain");
  result.failure_mode = read_map<std::uint8_t>(file, "failure_mode");
  require(same_shape(result.failure_mode, result.failure_strain),
          "dataset failure_mode has another shape than failure_strain");
  require(result.failure_mode.size() == 0 || result.failure_mode.maxCoeff() <= 2,
          "dataset failure_mode holds a value above 2");
  if (H5Lexists(file, "crush_strain", H5P_DEFAULT) <= 0) return;
  result.crush_strain = read_map<float>(file, "crush_strain");
  require(same_shape(result.crush_strain, result.failure_strain),
          "dataset crush_strain has another shape than failure_strain");
}

Handle open_and_check(const std::string& path) {
  Handle file = open_result(path);
  require(H5Aexists(file, "format") > 0 && read_text(file, "format") == format_name,
          "is no result of mesopix");
  const auto version = read_number<std::int64_t>(file, "format_version");
  require(version == format_version, "has format version " + std::to_string(version) +
                                         ", this program reads " + std::to_string(format_version));
  return file;
}

}  // namespace

void write_result(const std::string& path, const Result& result, const std::string& scene_text) try {
  const Quiet quiet;
  const Handle file = memory_file();
  write_figures(file, result, scene_text);
  write_history(file, result.history);
  write_maps(file, result);
  replace_file(path, image_of(file));
} catch (const Fault& fault) {
  throw FileError(path, fault.what(), "");
}

Result read_result(const std::string& path) try {
  const Quiet quiet;
  const Handle file = open_and_check(path);
  Result result;
  read_figures(file, result);
  result.history = read_history(file);
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

}  // namespace mpm
