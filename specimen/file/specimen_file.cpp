#include "specimen/file/specimen_file.hpp"

#include <algorithm>
#include <cstdlib>
#include <cstring>
#include <span>
#include <vector>

#include "specimen/body/files.hpp"
#include "specimen/body/specimen.hpp"
#include "specimen/file/specimen_file_hdf5.hpp"

namespace specimen {
namespace {

using hdf5::file_type;
using hdf5::Handle;
using hdf5::memory_type;
using hdf5::require;

using Extent = std::vector<hsize_t>;

constexpr const char* orientation =
    "row 0 is the top of the picture; y points up; the centre of pixel (row, col) lies at "
    "x = (col + 1/2) pixel_size, y = (rows - row - 1/2) pixel_size";

/// Strings of one length, as HDF5 stores them.
struct TextTable {
  explicit TextTable(const std::vector<std::string>& texts) : count(texts.size()) {
    for (const std::string& text : texts) length = std::max(length, text.size());
    bytes.resize(length * count);
    for (std::size_t i = 0; i < count; ++i) texts[i].copy(bytes.data() + i * length, texts[i].size());
  }
  std::size_t count;
  std::size_t length = 1;
  std::vector<char> bytes;
};

void write_attribute(hid_t object, const char* name, hid_t type, hid_t memory, hid_t space,
                     const void* value) {
  const Handle attribute(H5Acreate2(object, name, type, space, H5P_DEFAULT, H5P_DEFAULT), name);
  require(H5Awrite(attribute, memory, value), name);
}

template <class T>
void write_attribute(hid_t object, const char* name, T value) {
  write_attribute(object, name, file_type<T>(), memory_type<T>(), Handle(H5Screate(H5S_SCALAR), name),
                  &value);
}

void write_attribute(hid_t object, const char* name, const std::string& text) {
  const Handle type = hdf5::text_type(text.size());
  write_attribute(object, name, type, type, Handle(H5Screate(H5S_SCALAR), name), text.c_str());
}

void write_attribute(hid_t object, const char* name, const std::vector<std::string>& texts) {
  const TextTable table(texts);
  const Handle type = hdf5::text_type(table.length);
  const hsize_t count = table.count;
  const Handle space(H5Screate_simple(1, &count, nullptr), name);
  write_attribute(object, name, type, type, space, table.bytes.data());
}

/// Chunks, compression, checksum; and no time of creation, so that the same data gives the same bytes.
Handle dataset_options(const Extent& extent, const Extent& largest_chunk) {
  Handle options(H5Pcreate(H5P_DATASET_CREATE), "dataset");
  H5Pset_obj_track_times(options, false);
  if (std::find(extent.begin(), extent.end(), 0U) != extent.end()) return options;  // nothing to cut
  Extent chunk(extent.size());
  for (std::size_t i = 0; i < chunk.size(); ++i) chunk[i] = std::min(extent[i], largest_chunk[i]);
  H5Pset_chunk(options, static_cast<int>(chunk.size()), chunk.data());
  H5Pset_shuffle(options);
  H5Pset_deflate(options, 4);
  H5Pset_fletcher32(options);
  return options;
}

Handle write_dataset(hid_t parent, const char* name, hid_t type, hid_t memory, const Extent& extent,
                     const Extent& largest_chunk, const void* values) {
  const Handle space(H5Screate_simple(static_cast<int>(extent.size()), extent.data(), nullptr), name);
  const Handle options = dataset_options(extent, largest_chunk);
  Handle dataset(H5Dcreate2(parent, name, type, space, H5P_DEFAULT, options, H5P_DEFAULT), name);
  require(H5Dwrite(dataset, memory, H5S_ALL, H5S_ALL, H5P_DEFAULT, values), name);
  return dataset;
}

template <class T>
Handle write_list(hid_t parent, const char* name, const std::vector<T>& values) {
  return write_dataset(parent, name, file_type<T>(), memory_type<T>(), {values.size()}, {65536},
                       values.data());
}

void write_list(hid_t parent, const char* name, const std::vector<std::string>& texts) {
  const TextTable table(texts);
  const Handle type = hdf5::text_type(table.length);
  write_dataset(parent, name, type, type, {table.count}, {1024}, table.bytes.data());
}

Handle create_group(hid_t parent, const char* name) {
  const Handle options(H5Pcreate(H5P_GROUP_CREATE), name);
  H5Pset_obj_track_times(options, false);
  return {H5Gcreate2(parent, name, H5P_DEFAULT, options, H5P_DEFAULT), name};
}

void write_labels(hid_t file, const LabelledMask& mask) {
  const Extent extent = {static_cast<hsize_t>(mask.labels.rows), static_cast<hsize_t>(mask.labels.cols)};
  const Handle labels = write_dataset(file, "labels", file_type<std::uint8_t>(), memory_type<std::uint8_t>(),
                                      extent, {512, 512}, mask.labels.data.data());
  write_attribute(labels, "orientation", std::string(orientation));
  write_attribute(file, "pixel_size", mask.pixel_size);
  write_attribute(file, "pixel_size_unit", std::string("m"));
  write_list(file, "phases", mask.phases);
}

void write_inclusions(hid_t file, const std::vector<Inclusion>& inclusions) {
  std::vector<hdf5::InclusionRow> rows;
  rows.reserve(inclusions.size());
  for (const Inclusion& i : inclusions)
    rows.push_back({i.id, i.ellipse.x, i.ellipse.y, i.ellipse.a, i.ellipse.b, i.ellipse.angle, i.area,
                    i.perimeter, i.equivalent_diameter, i.orientation});
  const Handle table = write_dataset(file, "inclusions", hdf5::inclusion_type(true),
                                     hdf5::inclusion_type(false), {rows.size()}, {4096}, rows.data());
  write_attribute(table, "units", hdf5::inclusion_units());
}

/// Polygons one after the other; `polygon` tells the points of an element of the list.
template <class Element>
void write_polygons(hid_t group, const std::vector<Element>& list, std::vector<Point> Element::*polygon) {
  std::vector<std::int64_t> offsets = {0};
  std::vector<Point> points;
  for (const Element& element : list) {
    const std::vector<Point>& corners = element.*polygon;
    points.insert(points.end(), corners.begin(), corners.end());
    offsets.push_back(static_cast<std::int64_t>(points.size()));
  }
  static_assert(sizeof(Point) == 2 * sizeof(double));
  write_list(group, "offsets", offsets);
  const Handle dataset = write_dataset(group, "points", file_type<double>(), memory_type<double>(),
                                       {points.size(), 2}, {16384, 2}, points.data());
  write_attribute(dataset, "unit", std::string("m"));
}

void write_rings(hid_t file, const std::vector<Ring>& rings, const ItzOptions& itz) {
  const Handle group = create_group(file, "rings");
  write_polygons(group, rings, &Ring::vertices);
  std::vector<std::int32_t> owners;
  owners.reserve(rings.size());
  for (const Ring& ring : rings) owners.push_back(ring.inclusion);
  write_list(group, "inclusion", owners);
  write_attribute(group, "mode", std::string(hdf5::itz_modes.at(static_cast<std::size_t>(itz.mode))));
  write_attribute(group, "thickness", itz.thickness);
  write_attribute(group, "thickness_unit", std::string("m"));
  write_attribute(group, "segments", static_cast<std::int32_t>(itz.segments));
}

void write_provenance(hid_t file, const Provenance& provenance) {
  const Handle group = create_group(file, "provenance");
  write_attribute(group, "source", provenance.source);
  write_attribute(group, "sha256", provenance.sha256);
  write_attribute(group, "seed", provenance.seed);
  write_attribute(group, "version", provenance.version);
  write_list(group, "options", std::vector<std::string>{provenance.options});  // an attribute ends at 64 KiB
  if (!provenance.warnings.empty()) write_list(group, "warnings", provenance.warnings);
}

/// An HDF5 file that lives in memory, so that HDF5 never meets a disk that fails half-way.
/// (H5Fget_file_image would also hand out the bytes, but HDF5 1.10 then forgets to renew a checksum.)
class MemoryFile {
 public:
  MemoryFile() {
    const Handle access(H5Pcreate(H5P_FILE_ACCESS), "file");
    constexpr std::size_t growth = std::size_t{1} << 20U;
    H5Pset_fapl_core(access, growth, false);
    H5Pset_libver_bounds(access, H5F_LIBVER_V110, H5F_LIBVER_V110);  // has checksums on its bookkeeping too
    H5FD_file_image_callbacks_t callbacks{};
    callbacks.image_realloc = [](void* memory, size_t size, H5FD_file_image_op_t, void*) {
      return std::realloc(memory, size);
    };
    callbacks.image_free = &MemoryFile::keep_and_free;
    callbacks.udata_copy = [](void* self) { return self; };
    callbacks.udata_free = [](void*) -> herr_t { return 0; };
    callbacks.udata = this;
    H5Pset_file_image_callbacks(access, &callbacks);
    const Handle creation(H5Pcreate(H5P_FILE_CREATE), "file");
    H5Pset_obj_track_times(creation, false);
    // HDF5 first opens what has the name, so that there must never be such a file.
    file_ = Handle(H5Fcreate("/dev/null/specimen", H5F_ACC_TRUNC, creation, access), "file");
  }
  MemoryFile(const MemoryFile&) = delete;
  MemoryFile& operator=(const MemoryFile&) = delete;
  ~MemoryFile() = default;

  [[nodiscard]] hid_t id() const { return file_; }

  /// Close the file and hand out its bytes.
  std::vector<std::byte> close() {
    require(H5Fflush(file_, H5F_SCOPE_GLOBAL), "file");
    bytes_.resize(static_cast<std::size_t>(require(H5Fget_file_image(file_, nullptr, 0), "file")));
    file_ = Handle();
    if (!closed_) throw Error("file", hdf5::reason(), "must close");
    return std::move(bytes_);
  }

 private:
  static herr_t keep_and_free(void* memory, H5FD_file_image_op_t operation, void* self) {
    auto& file = *static_cast<MemoryFile*>(self);
    // HDF5 looks first whether a file of this name lies in the folder; closing that one is not meant.
    if (operation == H5FD_FILE_IMAGE_OP_FILE_CLOSE && !file.bytes_.empty()) {
      std::memcpy(file.bytes_.data(), memory, file.bytes_.size());
      file.closed_ = true;
    }
    std::free(memory);
    return 0;
  }

  std::vector<std::byte> bytes_;
  bool closed_ = false;
  Handle file_;
};

std::vector<std::byte> lay_out(const Specimen& specimen) {
  const hdf5::Quiet quiet;
  MemoryFile memory;
  const hid_t file = memory.id();
  write_attribute(file, "format", std::string(hdf5::format_name));
  write_attribute(file, "format_version", static_cast<std::int32_t>(hdf5::format_version));
  write_labels(file, specimen.mask);
  write_inclusions(file, specimen.inclusions);
  write_polygons(create_group(file, "contours"), specimen.inclusions, &Inclusion::contour);
  write_rings(file, specimen.rings, specimen.itz);
  write_provenance(file, specimen.provenance);
  return memory.close();
}

std::vector<std::byte> checked_bytes(const std::string& path, const Specimen& specimen) {
  try {
    validate(specimen);
    return lay_out(specimen);
  } catch (const Error& error) {
    throw Error(path + ": " + error.field, error.value, error.allowed, error.cure, error.fault);
  }
}

}  // namespace

void write_specimen(const std::string& path, const Specimen& specimen) {
  replace_file(path, checked_bytes(path, specimen));
}

}  // namespace specimen
