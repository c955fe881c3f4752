#include "libmpm/files/hdf5_read.hpp"

#include <algorithm>
#include <array>
#include <cstdint>
#include <filesystem>
#include <fstream>
#include <set>
#include <string_view>

#include "libmpm/files/hdf5_handle.hpp"
#include "libmpm/files/hdf5_version.hpp"
#include "libmpm/solver/checkpoint.hpp"

namespace mpm::hdf5 {
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

namespace {

/// A file and the seal at its end.
class Sealed {
 public:
  explicit Sealed(const std::string& path) : file_(path, std::ios::binary | std::ios::ate) {
    if (!file_.is_open()) return;
    size_ = static_cast<std::uint64_t>(file_.tellg());
    constexpr std::size_t length = seal_mark.size() + sha256_bytes;
    if (size_ < length) return;
    const std::string end = read(size_ - length, length);
    if (end.starts_with(seal_mark)) seal_ = end.substr(seal_mark.size());
  }

  bool fits() {
    if (seal_.empty()) return !has_more_than_hdf5();
    Sha256 digest;
    const std::uint64_t end = size_ - seal_mark.size() - seal_.size();
    constexpr std::uint64_t step = std::uint64_t{1} << 20U;
    for (std::uint64_t at = 0; at < end; at += step) digest.add(read(at, std::min(step, end - at)));
    return digest.digest() == seal_;
  }

 private:
  std::string read(std::uint64_t place, std::uint64_t count) {
    std::string bytes(static_cast<std::size_t>(count), '\0');
    file_.seekg(static_cast<std::streamoff>(place));
    if (!file_.read(bytes.data(), static_cast<std::streamsize>(count))) bytes.clear();
    return bytes;
  }

  /// A seal whose mark is damaged: HDF5 itself leaves nothing behind the end that a file of the kind that we
  /// write names (superblock version 0: at byte 40).
  bool has_more_than_hdf5() {
    if (size_ < 48) return false;
    const std::string superblock = read(0, 48);
    return superblock.starts_with(std::string_view("\x89HDF\r\n\x1a\n\0", 9)) &&
           number(&superblock[24], 8) == 0 && number(&superblock[40], 8) < size_;
  }

  std::ifstream file_;
  std::uint64_t size_ = 0;
  std::string seal_;
};

}  // namespace

bool seal_fits(const std::string& path) { return Sealed(path).fits(); }

bool heaps_are_sound(const std::string& path) { return Heaps(path).are_sound(); }

namespace {

Handle open_attribute(hid_t object, const char* name) {
  return {H5Aopen(object, name, H5P_DEFAULT), H5Aclose, std::string("attribute ") + name + " is missing"};
}

void require_type(hid_t type, H5T_class_t kind, std::size_t size, const std::string& words) {
  require(H5Tget_class(type) == kind && H5Tget_size(type) == size, words + " has a wrong type");
}

void require_count(hid_t attribute, int count, const std::string& words) {
  const Handle space(H5Aget_space(attribute), H5Sclose, words + " is damaged");
  require(H5Sget_simple_extent_npoints(space) == count,
          words + " must hold " + (count == 1 ? "one value" : std::to_string(count) + " values"));
}

/// Soft and external links lead to other places, and other files.
void require_part(hid_t parent, const std::string& name, const std::string& words) {
  require(H5Lexists(parent, name.c_str(), H5P_DEFAULT) > 0, words + " is missing");
  H5L_info_t link{};
  require(H5Lget_info(parent, name.c_str(), &link, H5P_DEFAULT) >= 0, words + " is damaged");
  require(link.type == H5L_TYPE_HARD, words + " is a link, not part of the file itself");
}

std::vector<hsize_t> extent_of(hid_t dataset, std::size_t rank, const std::string& words) {
  const Handle space(H5Dget_space(dataset), H5Sclose, words + " is damaged");
  require(H5Sget_simple_extent_ndims(space) == static_cast<int>(rank), words + " has a wrong number of axes");
  std::vector<hsize_t> extent(rank);
  H5Sget_simple_extent_dims(space, extent.data(), nullptr);
  return extent;
}

double bytes_of(const std::vector<hsize_t>& extent, std::size_t value_size) {
  double bytes = static_cast<double>(value_size);
  for (const hsize_t side : extent) bytes *= static_cast<double>(side);
  return bytes;
}

/// HDF5 would load any filter that it does not bring itself from a folder of plug-ins, and run it. A filter
/// over its own output would unpack a few bytes to any number of them.
void require_known_filters(hid_t settings, const std::string& words) {
  std::set<H5Z_filter_t> met;
  for (int i = 0; i < H5Pget_nfilters(settings); ++i) {
    unsigned flags = 0;
    std::size_t values = 0;
    const H5Z_filter_t filter =
        H5Pget_filter2(settings, static_cast<unsigned>(i), &flags, &values, nullptr, 0, nullptr, nullptr);
    require(filter == H5Z_FILTER_DEFLATE || filter == H5Z_FILTER_SHUFFLE || filter == H5Z_FILTER_FLETCHER32,
            words + " is packed by filter " + std::to_string(filter) +
                ", which is not gzip, shuffle or fletcher32");
    require(met.insert(filter).second, words + " is packed twice by filter " + std::to_string(filter));
  }
}

/// Chunks that were never written would read as zeros.
void require_chunks(const Dataset& dataset, hid_t settings, std::size_t value_size) {
  std::vector<hsize_t> chunk(dataset.extent.size());
  require(H5Pget_chunk(settings, static_cast<int>(chunk.size()), chunk.data()) >= 0,
          dataset.words + " is damaged");
  require(bytes_of(chunk, value_size) <= 0x1p26, dataset.words + " has chunks of more than 64 MiB");
  hsize_t expected = 1;
  for (std::size_t i = 0; i < chunk.size(); ++i) expected *= (dataset.extent[i] + chunk[i] - 1) / chunk[i];
  hsize_t met = 0;
  const Handle space(H5Dget_space(dataset.id), H5Sclose, dataset.words + " is damaged");
  require(H5Dget_num_chunks(dataset.id, space, &met) >= 0 && met == expected,
          dataset.words + " lacks some of its data");
}

Handle settings_of(const Dataset& dataset) {
  return {H5Dget_create_plist(dataset.id), H5Pclose, dataset.words + " is damaged"};
}

/// Before the extent is asked for: HDF5 opens the other files to know how far they reach.
void require_inside(const Dataset& dataset) {
  const Handle settings = settings_of(dataset);
  require(H5Pget_layout(settings) != H5D_VIRTUAL && H5Pget_external_count(settings) == 0,
          dataset.words + " keeps its data in another file");
  require_known_filters(settings, dataset.words);
}

/// Chunks may lie over each other, so that all of them together claim more than the file holds.
double stored_bytes(const Dataset& dataset) {
  const Handle file(H5Iget_file_id(dataset.id), H5Fclose, dataset.words + " is damaged");
  hsize_t file_size = 0;
  require(H5Fget_filesize(file, &file_size) >= 0, dataset.words + " is damaged");
  return static_cast<double>(std::min(file_size, H5Dget_storage_size(dataset.id)));
}

/// An extent that a damaged file only claims would ask for any amount of memory; deflate packs at most
/// 1032:1.
void require_stored(const Dataset& dataset, std::size_t value_size) {
  const Handle settings = settings_of(dataset);
  const H5D_layout_t layout = H5Pget_layout(settings);
  require(bytes_of(dataset.extent, value_size) <= 1100.0 * stored_bytes(dataset),
          dataset.words + " has an extent that its data do not fill");
  const bool is_empty = std::find(dataset.extent.begin(), dataset.extent.end(), 0U) != dataset.extent.end();
  if (layout == H5D_CHUNKED && !is_empty) require_chunks(dataset, settings, value_size);
}

}  // namespace

Handle open_file(const std::string& path) {
  require(std::filesystem::is_regular_file(path), "there is no such file");
  require(seal_fits(path), "is damaged: its digest does not match its bytes");
  require(heaps_are_sound(path), "is damaged: lengths in a heap of its texts are wrong");
  Handle file(H5Fopen(path.c_str(), H5F_ACC_RDONLY, H5P_DEFAULT), H5Fclose,
              "is not an HDF5 file, or is cut short or damaged");
  const Handle settings(H5Fget_create_plist(file), H5Pclose, "is damaged");
  std::size_t address = 0, length = 0;
  require(H5Pget_sizes(settings, &address, &length) >= 0 && address == 8 && length == 8,
          "has addresses and lengths that are not of 64 bits");
  return file;
}

Handle open_group(hid_t parent, const std::string& name) {
  const std::string words = "group " + name;
  require_part(parent, name, words);
  return {H5Gopen2(parent, name.c_str(), H5P_DEFAULT), H5Gclose, words + " is not a group"};
}

void read_attribute(hid_t object, const char* name, H5T_class_t kind, std::size_t size, hid_t memory_type,
                    void* values, int count) {
  const std::string words = std::string("attribute ") + name;
  const Handle attribute = open_attribute(object, name);
  const Handle type(H5Aget_type(attribute), H5Tclose, words + " is damaged");
  require_type(type, kind, size, words);
  require_count(attribute, count, words);
  require(H5Aread(attribute, memory_type, values) >= 0, words + " cannot be read");
}

std::string read_text(hid_t object, const char* name) {
  const std::string words = std::string("attribute ") + name;
  const Handle attribute = open_attribute(object, name);
  const Handle type(H5Aget_type(attribute), H5Tclose, words + " is damaged");
  require(H5Tget_class(type) == H5T_STRING && H5Tis_variable_str(type) > 0, words + " has a wrong type");
  require_count(attribute, 1, words);
  char* value = nullptr;
  const Handle memory_type = text_type();
  require(H5Aread(attribute, memory_type, &value) >= 0, words + " cannot be read");
  std::string text = value == nullptr ? "" : value;
  H5free_memory(value);
  return text;
}

Dataset open_dataset(hid_t parent, const std::string& name, std::size_t rank, H5T_class_t kind,
                     std::size_t size) {
  const std::string words = "dataset " + name;
  require_part(parent, name, words);
  Dataset dataset{
      words, Handle(H5Dopen2(parent, name.c_str(), H5P_DEFAULT), H5Dclose, words + " is not a dataset"), {}};
  const Handle type(H5Dget_type(dataset.id), H5Tclose, words + " is damaged");
  require_type(type, kind, size, words);
  require_inside(dataset);
  dataset.extent = extent_of(dataset.id, rank, words);
  require_stored(dataset, size);
  return dataset;
}

void require_unit(const Dataset& dataset, const std::string& unit) {
  if (H5Aexists(dataset.id, "unit") <= 0) return;
  const std::string named = read_text(dataset.id, "unit");
  require(named == unit, dataset.words + " is in " + named + ", and must be in " + unit);
}

void read_all(const Dataset& dataset, hid_t memory_type, void* values) {
  require(H5Dread(dataset.id, memory_type, H5S_ALL, H5S_ALL, H5P_DEFAULT, values) >= 0,
          dataset.words + " is damaged");
}

}  // namespace mpm::hdf5

std::string mpm::hdf5_version() {
  unsigned major = 0, minor = 0, release = 0;
  (void)H5get_libversion(&major, &minor, &release);
  return std::to_string(major) + "." + std::to_string(minor) + "." + std::to_string(release);
}
