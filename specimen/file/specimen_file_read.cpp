#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <climits>
#include <filesystem>
#include <system_error>

#include "specimen/body/specimen.hpp"
#include "specimen/file/specimen_file.hpp"
#include "specimen/file/specimen_file_source.hpp"

namespace specimen {
namespace {

using hdf5::Dataset;
using hdf5::file_type;
using hdf5::Handle;
using hdf5::memory_type;
using std::to_string;

LabelledMask read_mask(hid_t file) {
  const Dataset labels = hdf5::open_dataset(file, "/labels", file_type<std::uint8_t>(), 2, max_pixels);
  if (labels.extent[0] > INT_MAX || labels.extent[1] > INT_MAX)
    throw Error("/labels", hdf5::text_of(labels.extent) + " pixels", "must be at least 1 x 1");
  LabelledMask mask;
  mask.labels.rows = static_cast<int>(labels.extent[0]);
  mask.labels.cols = static_cast<int>(labels.extent[1]);
  mask.labels.data = hdf5::read_values<std::uint8_t>(labels, memory_type<std::uint8_t>());
  mask.pixel_size = hdf5::read_attribute<double>(file, "/", "pixel_size");
  hdf5::require_unit(file, "/", "pixel_size_unit", "m");
  mask.phases = hdf5::read_texts(file, "/phases", 256);
  return mask;
}

/// Points of `count` polygons.
std::vector<std::vector<Point>> read_polygons(hid_t file, const std::string& group, std::size_t count) {
  const std::string name = group + "/offsets";
  const auto offsets = hdf5::read_list<std::int64_t>(file, name, max_inclusions + 1);
  if (offsets.size() != count + 1)
    throw Error(name, to_string(offsets.size()) + " values", "must be " + to_string(count + 1));
  const Dataset dataset = hdf5::open_dataset(file, group + "/points", file_type<double>(), 2, 2 * max_points);
  if (dataset.extent[1] != 2)
    throw Error(dataset.name, hdf5::text_of(dataset.extent) + " values", "must be rows of x and y");
  hdf5::require_unit(dataset.id, dataset.name, "unit", "m");
  if (offsets.front() != 0 || !std::is_sorted(offsets.begin(), offsets.end()) ||
      offsets.back() != static_cast<std::int64_t>(dataset.extent[0]))
    throw Error(name, "out of order", "must rise from 0 to the number of points");
  const auto values = hdf5::read_values<double>(dataset, memory_type<double>());
  std::vector<std::vector<Point>> polygons(count);
  for (std::size_t k = 0; k < count; ++k) {
    const auto begin = static_cast<std::size_t>(offsets[k]);
    const auto end = static_cast<std::size_t>(offsets[k + 1]);
    polygons[k].reserve(end - begin);
    for (std::size_t i = begin; i < end; ++i) polygons[k].push_back({values[2 * i], values[2 * i + 1]});
  }
  return polygons;
}

std::vector<Inclusion> read_inclusions(hid_t file) {
  const Dataset table =
      hdf5::open_dataset(file, "/inclusions", hdf5::inclusion_type(true), 1, max_inclusions);
  hdf5::require_units(table, "units", hdf5::inclusion_units());
  const auto rows = hdf5::read_values<hdf5::InclusionRow>(table, hdf5::inclusion_type(false));
  auto contours = read_polygons(file, "/contours", rows.size());
  std::vector<Inclusion> inclusions;
  inclusions.reserve(rows.size());
  for (std::size_t k = 0; k < rows.size(); ++k) {
    const hdf5::InclusionRow& r = rows[k];
    inclusions.push_back({r.id, Ellipse{r.x, r.y, r.a, r.b, r.angle}, std::move(contours[k]), r.area,
                          r.perimeter, r.equivalent_diameter, r.orientation});
  }
  return inclusions;
}

std::vector<Ring> read_rings(hid_t file) {
  const auto owners = hdf5::read_list<std::int32_t>(file, "/rings/inclusion", max_inclusions);
  auto polygons = read_polygons(file, "/rings", owners.size());
  std::vector<Ring> rings;
  rings.reserve(owners.size());
  for (std::size_t k = 0; k < owners.size(); ++k) rings.push_back({owners[k], std::move(polygons[k])});
  return rings;
}

ItzOptions read_itz(hid_t file) {
  const Handle group = hdf5::open_object(file, "/rings", H5I_GROUP);
  const std::string mode = hdf5::read_text_attribute(group, "/rings", "mode");
  hdf5::require_unit(group, "/rings", "thickness_unit", "m");
  const auto known = std::find(hdf5::itz_modes.begin(), hdf5::itz_modes.end(), mode);
  if (known == hdf5::itz_modes.end())
    throw Error("/rings@mode", "'" + mode + "'", "must be ring, points or none");
  return {static_cast<ItzMode>(known - hdf5::itz_modes.begin()),
          hdf5::read_attribute<double>(group, "/rings", "thickness"),
          hdf5::read_attribute<std::int32_t>(group, "/rings", "segments")};
}

constexpr std::int64_t most_warnings = 100;

Provenance read_provenance(hid_t file) {
  const Handle group = hdf5::open_object(file, "/provenance", H5I_GROUP);
  const auto options = hdf5::read_texts(file, "/provenance/options", 1);
  if (options.empty()) throw Error("/provenance/options", "is empty", "must be one text");
  std::vector<std::string> warnings;
  if (hdf5::require(H5Lexists(group, "warnings", H5P_DEFAULT), "/provenance") > 0)
    warnings = hdf5::read_texts(file, "/provenance/warnings", most_warnings);
  return {hdf5::read_text_attribute(group, "/provenance", "source"),
          hdf5::read_text_attribute(group, "/provenance", "sha256"),
          options.front(),
          hdf5::read_attribute<std::uint64_t>(group, "/provenance", "seed"),
          hdf5::read_text_attribute(group, "/provenance", "version"),
          std::move(warnings)};
}

void check_format(hid_t file) {
  if (hdf5::require(H5Aexists(file, "format"), "/") == 0 ||
      hdf5::read_text_attribute(file, "/", "format") != hdf5::format_name)
    throw Error("/@format", "is not a mesopix specimen", "must be a file that mesopix wrote",
                "make one with: mesopix generate, or mesopix convert");
  const int version = hdf5::read_attribute<std::int32_t>(file, "/", "format_version");
  if (version != hdf5::format_version)
    throw Error("/@format_version", to_string(version), "must be " + to_string(hdf5::format_version),
                "use the version of mesopix that wrote it");
}

/// A regular file with HDF5's signature, or an Error that says what it is instead.
void check_signature(const std::string& path) {
  std::error_code error;
  const std::filesystem::file_status status = std::filesystem::status(path, error);
  if (!std::filesystem::exists(status))
    throw Error(path, "there is no such file", "must be a specimen", {}, Fault::write);
  if (!std::filesystem::is_regular_file(status))
    throw Error(path, "is not a regular file", "must be a specimen", {}, Fault::write);
  if (::access(path.c_str(), R_OK) != 0)
    throw Error(path, std::generic_category().message(errno), "must be a file that can be read", {},
                Fault::write);
  if (H5Fis_hdf5(path.c_str()) <= 0)
    throw Error(path, "is not an HDF5 file", "must be a specimen",
                "make one from a picture with: mesopix convert");
  if (!hdf5::heaps_are_sound(path))
    throw Error(path, "lengths in a heap of its texts are wrong", {},
                "the file is damaged: use a copy, or make the specimen again");
}

Specimen read_checked(const std::string& path) {
  const Handle access(H5Pcreate(H5P_FILE_ACCESS), "file");
  H5Pset_file_locking(access, false,
                      true);  // shared disks often cannot lock, and a written file never changes
  const Handle file(H5Fopen(path.c_str(), H5F_ACC_RDONLY, access), "/");
  check_format(file);
  Specimen specimen{read_mask(file), read_inclusions(file), read_itz(file), read_rings(file),
                    read_provenance(file)};
  validate(specimen);
  return specimen;
}

}  // namespace

Specimen read_specimen(const std::string& path) {
  hdf5::Quiet quiet;
  check_signature(path);
  try {
    return read_checked(path);
  } catch (const Error& error) {
    quiet.stay();
    throw Error(path + ": " + error.field, error.value, error.allowed, error.cure, error.fault);
  }
}

}  // namespace specimen
