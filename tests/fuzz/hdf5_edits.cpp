#include "tests/fuzz/hdf5_edits.hpp"

#include <fuzzer/FuzzedDataProvider.h>
#include <hdf5.h>

#include <algorithm>
#include <array>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <string_view>

#include "tests/fuzz/input_file.hpp"

namespace fuzz {
namespace {

using Input = FuzzedDataProvider;

/// Extents around the limits of the readers, and beyond what numbers of 64 bits hold.
constexpr std::array<hsize_t, 13> extents{
    0, 1, 2, 3, 5, 6, 8, 9, 257, 100'000, 200'000'001, hsize_t{1} << 32U, hsize_t{1} << 62U};

hid_t make_type(Input& input) {
  switch (input.ConsumeIntegralInRange(0, 10)) {
    case 0:
      return H5Tcopy(H5T_STD_U8LE);
    case 1:
      return H5Tcopy(H5T_STD_I32LE);
    case 2:
      return H5Tcopy(H5T_STD_I64LE);
    case 3:
      return H5Tcopy(H5T_STD_U64BE);
    case 4:
      return H5Tcopy(H5T_IEEE_F32LE);
    case 5:
      return H5Tcopy(H5T_IEEE_F64LE);
    case 6:
      return H5Tcopy(H5T_STD_REF_OBJ);
    case 7:
      return H5Tvlen_create(H5T_STD_I32LE);
    case 8: {
      const hid_t text = H5Tcopy(H5T_C_S1);
      H5Tset_size(text, H5T_VARIABLE);
      return text;
    }
    case 9: {
      const hid_t text = H5Tcopy(H5T_C_S1);
      H5Tset_size(text, input.ConsumeIntegralInRange<std::size_t>(1, 1U << 25U));
      return text;
    }
    default: {
      const hid_t row = H5Tcreate(H5T_COMPOUND, input.ConsumeIntegralInRange<std::size_t>(1, 100));
      H5Tinsert(row, "id", 0, H5T_STD_U8LE);
      return row;
    }
  }
}

/// Whether values of a type are bytes in a row. HDF5 follows the addresses of others wherever they lead.
bool is_plain(hid_t type) { return H5Tget_class(type) != H5T_VLEN && H5Tis_variable_str(type) <= 0; }

hid_t make_space(Input& input, std::vector<hsize_t>& extent) {
  const auto rank = input.ConsumeIntegralInRange<std::size_t>(0, 3);
  for (std::size_t i = 0; i < rank; ++i) extent.push_back(input.PickValueInArray(extents));
  if (rank == 0) return H5Screate(input.ConsumeBool() ? H5S_SCALAR : H5S_NULL);
  return H5Screate_simple(static_cast<int>(rank), extent.data(), nullptr);
}

/// Where and how a dataset is stored; chunks and filters for what has axes.
hid_t make_storage(Input& input, hid_t space, const std::vector<hsize_t>& extent) {
  const hid_t storage = H5Pcreate(H5P_DATASET_CREATE);
  const int kind = input.ConsumeIntegralInRange(0, 4);
  if (kind == 1) H5Pset_layout(storage, H5D_COMPACT);
  if (kind == 2) H5Pset_external(storage, "/proc/self/status", 0, H5F_UNLIMITED);
  if (kind == 3) H5Pset_virtual(storage, space, "/proc/self/exe", "/labels", space);
  if (kind != 4 || extent.empty()) return storage;
  std::vector<hsize_t> chunk;
  for (std::size_t i = 0; i < extent.size(); ++i)
    chunk.push_back(std::max(hsize_t{1}, input.PickValueInArray(extents)));
  H5Pset_chunk(storage, static_cast<int>(chunk.size()), chunk.data());
  if (input.ConsumeBool()) H5Pset_deflate(storage, 1);
  if (input.ConsumeBool()) H5Pset_fletcher32(storage);
  // Those that szip takes, because it reads them whether or not they are there.
  constexpr std::array<unsigned, 2> parameters{H5_SZIP_NN_OPTION_MASK, 2};
  if (input.ConsumeBool())
    H5Pset_filter(storage, input.ConsumeIntegralInRange(1, 400), H5Z_FLAG_OPTIONAL, parameters.size(),
                  parameters.data());
  return storage;
}

/// Whether a filter stands among those of a dataset.
bool is_packed_by(hid_t storage, H5Z_filter_t filter) {
  unsigned flags = 0;
  std::size_t values = 0;
  return H5Pget_filter_by_id2(storage, filter, &flags, &values, nullptr, 0, nullptr, nullptr) >= 0;
}

/// Whether HDF5 can write values into the file: not into another one, and not by szip, which divides by zero
/// where its parameters were not fitted to the dataset.
bool is_writable(hid_t dataset) {
  const hid_t storage = H5Dget_create_plist(dataset);
  const bool inside = H5Pget_layout(storage) != H5D_VIRTUAL && H5Pget_external_count(storage) == 0;
  const bool writable = inside && !is_packed_by(storage, H5Z_FILTER_SZIP);
  H5Pclose(storage);
  return writable;
}

/// Bytes for all values of a dataset, where these are few.
void fill(Input& input, hid_t dataset) {
  if (!is_writable(dataset)) return;
  const hid_t space = H5Dget_space(dataset), type = H5Dget_type(dataset);
  const hssize_t count = H5Sget_simple_extent_npoints(space);
  const std::size_t value_size = H5Tget_size(type);
  if (is_plain(type) && count > 0 && count <= 4096 && value_size <= 4096) {
    std::vector<std::uint8_t> values(static_cast<std::size_t>(count) * value_size);
    for (std::uint8_t& value : values) value = input.ConsumeIntegral<std::uint8_t>();
    H5Dwrite(dataset, type, H5S_ALL, H5S_ALL, H5P_DEFAULT, values.data());
  }
  H5Tclose(type);
  H5Sclose(space);
}

void put_dataset(Input& input, hid_t file, const std::string& name) {
  H5Ldelete(file, name.c_str(), H5P_DEFAULT);
  std::vector<hsize_t> extent;
  const hid_t type = make_type(input), space = make_space(input, extent);
  const hid_t storage = make_storage(input, space, extent);
  const hid_t dataset = H5Dcreate2(file, name.c_str(), type, space, H5P_DEFAULT, storage, H5P_DEFAULT);
  if (dataset >= 0) {
    if (input.ConsumeBool()) fill(input, dataset);
    H5Dclose(dataset);
  }
  H5Pclose(storage);
  H5Sclose(space);
  H5Tclose(type);
}

void put_values(Input& input, hid_t file, const std::string& name) {
  const hid_t object = H5Oopen(file, name.c_str(), H5P_DEFAULT);
  if (object < 0) return;
  if (H5Iget_type(object) == H5I_DATASET) fill(input, object);
  H5Oclose(object);
}

void put_link(Input& input, hid_t file, const std::string& name, const std::string& other) {
  H5Ldelete(file, name.c_str(), H5P_DEFAULT);
  switch (input.ConsumeIntegralInRange(0, 3)) {
    case 0:
      H5Lcreate_soft(other.c_str(), file, name.c_str(), H5P_DEFAULT, H5P_DEFAULT);
      break;
    case 1:
      H5Lcreate_external("/proc/self/exe", other.c_str(), file, name.c_str(), H5P_DEFAULT, H5P_DEFAULT);
      break;
    case 2:
      H5Lcreate_hard(file, other.c_str(), file, name.c_str(), H5P_DEFAULT, H5P_DEFAULT);
      break;
    default:
      H5Lcreate_hard(file, "/", file, name.c_str(), H5P_DEFAULT, H5P_DEFAULT);
  }
}

void put_attribute(Input& input, hid_t file, const std::string& full) {
  const std::size_t at = full.find('@');
  const std::string owner = full.substr(0, at), name = full.substr(at + 1);
  H5Adelete_by_name(file, owner.c_str(), name.c_str(), H5P_DEFAULT);
  std::vector<hsize_t> extent;
  const hid_t type = make_type(input), space = make_space(input, extent);
  const auto size = static_cast<std::size_t>(H5Sget_simple_extent_npoints(space));
  // HDF5 1.10 itself falls over attributes of references and of nothing when it changes the object again.
  if (is_plain(type) && H5Tget_class(type) != H5T_REFERENCE && size >= 1 && size <= 16 &&
      H5Tget_size(type) <= 4096) {
    const hid_t attribute = H5Acreate_by_name(file, owner.c_str(), name.c_str(), type, space, H5P_DEFAULT,
                                              H5P_DEFAULT, H5P_DEFAULT);
    std::vector<std::uint8_t> values(size * H5Tget_size(type));
    for (std::uint8_t& value : values) value = input.ConsumeIntegral<std::uint8_t>();
    H5Awrite(attribute, type, values.data());
    H5Aclose(attribute);
  }
  H5Sclose(space);
  H5Tclose(type);
}

/// @return whether another edit may follow: HDF5 1.10 itself falls over links that lead in a circle when it
/// changes the file again.
bool edit(Input& input, hid_t file, const Hdf5Sample& sample) {
  const std::string& name =
      sample.links[input.ConsumeIntegralInRange<std::size_t>(0, sample.links.size() - 1)];
  switch (input.ConsumeIntegralInRange(0, 4)) {
    case 0:
      H5Ldelete(file, name.c_str(), H5P_DEFAULT);
      break;
    case 1:
      put_dataset(input, file, name);
      break;
    case 2:
      put_values(input, file, name);
      break;
    case 3:
      put_link(input, file, name,
               sample.links[input.ConsumeIntegralInRange<std::size_t>(0, sample.links.size() - 1)]);
      return false;
    default:
      put_attribute(
          input, file,
          sample.attributes[input.ConsumeIntegralInRange<std::size_t>(0, sample.attributes.size() - 1)]);
  }
  return true;
}

/// HDF5 gives the names one by one.
herr_t note(hid_t object, const char* name, const H5O_info_t*, void* data) {
  auto& sample = *static_cast<Hdf5Sample*>(data);
  const std::string path = std::string("/") + (std::string_view(name) == "." ? "" : name);
  if (path != "/") sample.links.push_back(path);
  const hid_t owner = H5Oopen(object, name, H5P_DEFAULT);
  const auto add = [](hid_t, const char* attribute, const H5A_info_t*, void* all) -> herr_t {
    static_cast<std::vector<std::string>*>(all)->emplace_back(attribute);
    return 0;
  };
  std::vector<std::string> names;
  H5Aiterate2(owner, H5_INDEX_NAME, H5_ITER_INC, nullptr, add, &names);
  H5Oclose(owner);
  for (const std::string& attribute : names) sample.attributes.push_back(path + "@" + attribute);
  return 0;
}

}  // namespace

Hdf5Sample hdf5_sample(const std::function<void(const std::string&)>& write) {
  H5Eset_auto2(H5E_DEFAULT, nullptr, nullptr);
  const std::string path = temporary_path("sample");
  write(path);
  Hdf5Sample sample;
  std::ifstream stream(path, std::ios::binary);
  sample.bytes.assign(std::istreambuf_iterator<char>(stream), {});
  const hid_t file = H5Fopen(path.c_str(), H5F_ACC_RDONLY, H5P_DEFAULT);
  H5Ovisit2(file, H5_INDEX_NAME, H5_ITER_INC, note, &sample, H5O_INFO_BASIC);
  H5Fclose(file);
  std::filesystem::remove(path);
  if (sample.links.empty() || sample.attributes.empty()) std::abort();
  return sample;
}

void read_hdf5_input(const Hdf5Sample& sample, const std::uint8_t* data, std::size_t size,
                     const std::function<void(const std::string&)>& read) {
  static const InputFile file;
  const std::string& path = file.hold(sample.bytes.data(), sample.bytes.size());
  Input input(data, size);
  const hid_t changed = H5Fopen(path.c_str(), H5F_ACC_RDWR, H5P_DEFAULT);
  if (changed < 0) std::abort();
  for (int i = 0; i < 4 && input.remaining_bytes() > 0; ++i)
    if (!edit(input, changed, sample)) break;
  H5Fclose(changed);
  read(path);
}

}  // namespace fuzz
