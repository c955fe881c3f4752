#include "specimen/file/specimen_file_source.hpp"

#include <algorithm>
#include <array>
#include <cstdint>
#include <cstring>
#include <fstream>
#include <set>
#include <string_view>

namespace specimen::hdf5 {
namespace {

constexpr std::string_view signature("GCOL\1", 5);  ///< with the only version that there is
constexpr std::uint64_t header_size = 16;           ///< of the heap, and of each object in it [bytes]

std::uint64_t number(const char* bytes, int width) {
  std::uint64_t value = 0;
  for (int i = width - 1; i >= 0; --i) value = value << 8U | static_cast<unsigned char>(bytes[i]);
  return value;
}

class Heaps {
 public:
  explicit Heaps(const std::string& path) : file_(path, std::ios::binary | std::ios::ate) {
    if (!file_.is_open()) return;
    size_ = static_cast<std::uint64_t>(file_.tellg());
    objects_left_ = size_ / header_size;  // more than that only where heaps lie over each other
  }

  bool are_sound() {
    // Blocks overlap, so that no signature is cut in two.
    constexpr std::uint64_t step = std::uint64_t{1} << 20U;
    std::string block;
    for (std::uint64_t begin = 0; begin < size_; begin += step) {
      block.resize(std::min(step + signature.size() - 1, size_ - begin));
      if (!read(begin, block.data(), block.size())) return true;
      for (std::size_t at = block.find(signature); at != std::string::npos;
           at = block.find(signature, at + 1))
        if (!is_sound(begin + at)) return false;
    }
    return true;
  }

 private:
  bool read(std::uint64_t place, char* bytes, std::size_t count) {
    file_.clear();
    file_.seekg(static_cast<std::streamoff>(place));
    return static_cast<bool>(file_.read(bytes, static_cast<std::streamsize>(count)));
  }

  bool is_sound(std::uint64_t begin) {
    std::array<char, header_size> header{};
    if (!read(begin, header.data(), header.size())) return true;
    const std::uint64_t size = number(&header[8], 8);
    // HDF5 itself refuses these; the letters may as well stand in the data by chance.
    if (size == 0 || size > size_ - begin) return true;
    return size >= header_size && objects_fill(begin + header_size, begin + size);
  }

  /// Objects follow each other up to the end of the heap; number 0 is the free space, which counts its
  /// header.
  bool objects_fill(std::uint64_t at, std::uint64_t end) {
    while (end - at >= header_size) {
      std::array<char, header_size> header{};
      if (objects_left_-- == 0 || !read(at, header.data(), header.size())) return false;
      const bool is_free = number(header.data(), 2) == 0;
      const std::uint64_t length = number(&header[8], 8);
      if (length > end - at) return false;
      const std::uint64_t need = is_free ? length : header_size + (length + 7) / 8 * 8;
      if (need < header_size || need > end - at) return false;
      at += need;
    }
    return true;
  }

  std::ifstream file_;
  std::uint64_t size_ = 0;
  std::uint64_t objects_left_ = 0;
};

}  // namespace

bool heaps_are_sound(const std::string& path) { return Heaps(path).are_sound(); }

namespace {

using std::to_string;

constexpr std::size_t max_text = std::size_t{16} << 20U;  ///< [bytes]
constexpr hsize_t max_chunk = hsize_t{64} << 20U;         ///< [bytes]; a chunk is unpacked in one piece

Extent extent_of(hid_t dataset, int rank, const std::string& name) {
  const Handle space(H5Dget_space(dataset), name);
  const int met = require(H5Sget_simple_extent_ndims(space), name);
  if (met != rank || H5Sget_simple_extent_type(space) != H5S_SIMPLE)
    throw Error(name, to_string(met) + " dimensions", "must be " + to_string(rank));
  Extent extent(static_cast<std::size_t>(rank));
  require(H5Sget_simple_extent_dims(space, extent.data(), nullptr), name);
  return extent;
}

bool is_empty(const Extent& extent) { return std::find(extent.begin(), extent.end(), 0U) != extent.end(); }

/// Whether the product is at most `limit`, without its overflow.
bool fits(const Extent& extent, hsize_t limit) {
  if (is_empty(extent)) return true;
  for (const hsize_t n : extent) {
    if (n > limit) return false;
    limit /= n;
  }
  return true;
}

/// Filters that HDF5 itself brings, each of them once. It would load any other from a plug-in folder and run
/// it; one over its own output would unpack a few bytes to any number of them.
void check_filters(hid_t options, const std::string& name) {
  std::set<H5Z_filter_t> known{H5Z_FILTER_DEFLATE, H5Z_FILTER_SHUFFLE, H5Z_FILTER_FLETCHER32};
  for (int i = 0; i < H5Pget_nfilters(options); ++i) {
    unsigned flags = 0;
    std::size_t n_values = 0;
    const H5Z_filter_t filter =
        H5Pget_filter2(options, static_cast<unsigned>(i), &flags, &n_values, nullptr, 0, nullptr, nullptr);
    if (known.erase(filter) == 0)
      throw Error(name, "filter " + to_string(filter),
                  "must be gzip, shuffle or fletcher32, each of them once");
  }
}

/// A chunk that was never written would read as zeros, that is as void.
void check_chunks(const Dataset& dataset, hid_t options, std::size_t value_size) {
  Extent chunk(dataset.extent.size());
  require(H5Pget_chunk(options, static_cast<int>(chunk.size()), chunk.data()), dataset.name);
  if (!fits(chunk, max_chunk / value_size))
    throw Error(dataset.name, "chunks of " + text_of(chunk), "must be at most 64 MiB");
  hsize_t expected = 1;
  for (std::size_t i = 0; i < chunk.size(); ++i) expected *= (dataset.extent[i] + chunk[i] - 1) / chunk[i];
  hsize_t met = 0;
  require(H5Dget_num_chunks(dataset.id, Handle(H5Dget_space(dataset.id), dataset.name), &met), dataset.name);
  if (met != expected)
    throw Error(dataset.name, to_string(met) + " of " + to_string(expected) + " chunks are there",
                "must be complete", "write the specimen again");
}

/// Before the extent is asked for: HDF5 opens the other files to know how far they reach.
void check_inside(const Dataset& dataset) {
  const Handle options(H5Dget_create_plist(dataset.id), dataset.name);
  const H5D_layout_t layout = H5Pget_layout(options);
  if ((layout != H5D_CHUNKED && layout != H5D_CONTIGUOUS) || H5Pget_external_count(options) > 0)
    throw Error(dataset.name, "has its data outside the file", "must be part of the file itself");
  check_filters(options, dataset.name);
}

void check_storage(const Dataset& dataset, std::size_t value_size) {
  const Handle options(H5Dget_create_plist(dataset.id), dataset.name);
  const H5D_layout_t layout = H5Pget_layout(options);
  if (is_empty(dataset.extent)) return;
  if (layout == H5D_CHUNKED) check_chunks(dataset, options, value_size);
  if (layout == H5D_CONTIGUOUS && H5Dget_storage_size(dataset.id) == 0)
    throw Error(dataset.name, "was never written", "must be complete", "write the specimen again");
}

std::size_t text_length(hid_t type, const std::string& name) {
  if (H5Tget_class(type) != H5T_STRING || H5Tis_variable_str(type) != 0)
    throw Error(name, "holds values of another type", "must be text of fixed length");
  const std::size_t length = H5Tget_size(type);
  if (length > max_text)
    throw Error(name, to_string(length) + " bytes per text", "must be at most " + to_string(max_text));
  return length;
}

std::string up_to_zero(const char* bytes, std::size_t length) { return {bytes, ::strnlen(bytes, length)}; }

Handle open_attribute(hid_t object, const std::string& name, const char* attribute_name) {
  if (require(H5Aexists(object, attribute_name), name) == 0)
    throw Error(name, "is missing", "must be there", "write the specimen again");
  Handle attribute(H5Aopen(object, attribute_name, H5P_DEFAULT), name);
  const Handle space(H5Aget_space(attribute), name);
  if (H5Sget_simple_extent_type(space) != H5S_SCALAR) throw Error(name, "is a list", "must be one value");
  return attribute;
}

}  // namespace

Handle open_object(hid_t file, const std::string& name, H5I_type_t kind) {
  for (std::size_t end = name.find('/', 1);; end = name.find('/', end + 1)) {
    const std::string part = name.substr(0, end);
    if (require(H5Lexists(file, part.c_str(), H5P_DEFAULT), name) == 0)
      throw Error(name, "is missing", "must be there", "write the specimen again");
    H5L_info_t link;
    require(H5Lget_info(file, part.c_str(), &link, H5P_DEFAULT), name);
    if (link.type != H5L_TYPE_HARD)
      throw Error(name, "is reached by a soft or external link", "must be part of the file itself");
    if (end == std::string::npos) break;
  }
  Handle object(H5Oopen(file, name.c_str(), H5P_DEFAULT), name);
  if (H5Iget_type(object) != kind)
    throw Error(name, "is another kind of object",
                kind == H5I_GROUP ? "must be a group" : "must be a dataset");
  return object;
}

std::string text_of(const Extent& extent) {
  std::string text;
  for (const hsize_t n : extent) text += (text.empty() ? "" : " x ") + to_string(n);
  return text;
}

Dataset open_dataset(hid_t file, const std::string& name, hid_t type, int rank, std::int64_t limit) {
  Dataset dataset{name, open_object(file, name, H5I_DATASET), {}};
  check_inside(dataset);
  dataset.extent = extent_of(dataset.id, rank, name);
  if (!fits(dataset.extent, static_cast<hsize_t>(limit)))
    throw Error(name, text_of(dataset.extent) + " values", "must be at most " + to_string(limit));
  const Handle met(H5Dget_type(dataset.id), name);
  if (require(H5Tequal(met, type), name) == 0)
    throw Error(name, "holds values of another type", "must be as mesopix writes it");
  check_storage(dataset, H5Tget_size(met));
  return dataset;
}

void read_bytes(const Dataset& dataset, hid_t memory, void* values) {
  if (is_empty(dataset.extent)) return;
  require(H5Dread(dataset.id, memory, H5S_ALL, H5S_ALL, H5P_DEFAULT, values), dataset.name);
}

std::vector<std::string> read_texts(hid_t file, const std::string& name, std::int64_t limit) {
  const Handle type(H5Dget_type(open_object(file, name, H5I_DATASET)), name);
  const std::size_t length = text_length(type, name);
  const Dataset dataset = open_dataset(file, name, type, 1, limit);
  if (!fits(dataset.extent, max_text / length))
    throw Error(name, text_of(dataset.extent) + " texts of " + to_string(length) + " bytes",
                "must be at most " + to_string(max_text) + " bytes together");
  std::vector<char> bytes(static_cast<std::size_t>(dataset.extent[0]) * length);
  read_bytes(dataset, type, bytes.data());
  std::vector<std::string> texts;
  for (std::size_t i = 0; i < bytes.size(); i += length) texts.push_back(up_to_zero(&bytes[i], length));
  return texts;
}

void read_attribute(hid_t object, const std::string& owner, const char* name, hid_t type, hid_t memory,
                    void* value) {
  const std::string full = owner + "@" + name;
  const Handle attribute = open_attribute(object, full, name);
  const Handle met(H5Aget_type(attribute), full);
  if (require(H5Tequal(met, type), full) == 0)
    throw Error(full, "holds a value of another type", "must be as mesopix writes it");
  require(H5Aread(attribute, memory, value), full);
}

std::string read_text_attribute(hid_t object, const std::string& owner, const char* name) {
  const std::string full = owner + "@" + name;
  const Handle attribute = open_attribute(object, full, name);
  const Handle type(H5Aget_type(attribute), full);
  std::vector<char> bytes(text_length(type, full));
  require(H5Aread(attribute, type, bytes.data()), full);
  return up_to_zero(bytes.data(), bytes.size());
}

namespace {

/// As other programs write texts.
std::string read_variable_text(hid_t attribute, hid_t type, const std::string& name) {
  char* value = nullptr;
  require(H5Aread(attribute, type, &value), name);
  std::string text = value == nullptr ? "" : value;
  H5free_memory(value);
  return text;
}

}  // namespace

void require_unit(hid_t object, const std::string& owner, const char* name, const std::string& unit) {
  const std::string full = owner + "@" + name;
  if (require(H5Aexists(object, name), full) == 0) return;
  const Handle attribute = open_attribute(object, full, name);
  const Handle type(H5Aget_type(attribute), full);
  const bool varies = H5Tget_class(type) == H5T_STRING && H5Tis_variable_str(type) > 0;
  const std::string named =
      varies ? read_variable_text(attribute, type, full) : read_text_attribute(object, owner, name);
  if (named != unit)
    throw Error(full, "'" + named + "'", "must be " + unit,
                "convert the values, or write the specimen again");
}

void require_units(const Dataset& table, const char* name, const std::vector<std::string>& units) {
  const std::string full = table.name + "@" + name;
  if (require(H5Aexists(table.id, name), full) == 0) return;
  const Handle attribute(H5Aopen(table.id, name, H5P_DEFAULT), full);
  const Handle space(H5Aget_space(attribute), full);
  const Handle type(H5Aget_type(attribute), full);
  const std::size_t length = text_length(type, full);
  if (H5Sget_simple_extent_npoints(space) != static_cast<hssize_t>(units.size()))
    throw Error(full, "has another number of units", "must be " + to_string(units.size()));
  std::vector<char> bytes(length * units.size());
  require(H5Aread(attribute, type, bytes.data()), full);
  for (std::size_t i = 0; i < units.size(); ++i)
    if (const std::string named = up_to_zero(&bytes[i * length], length); named != units[i])
      throw Error(full, "'" + named + "' of column " + to_string(i), "must be " + units[i],
                  "convert the values, or write the specimen again");
}

}  // namespace specimen::hdf5
