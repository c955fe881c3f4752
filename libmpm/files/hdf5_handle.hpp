/// Common parts of the readers and writers of HDF5 files. Not installed: private to hdf5_*, result_file*,
/// frame_file* and table_file*.
#pragma once

#include <hdf5.h>
#include <cstdint>
#include <exception>
#include <new>
#include <stdexcept>
#include <string>
#include <string_view>
#include <utility>

namespace mpm::hdf5 {

/// A fault, without the path; the public functions add the path.
struct Fault : std::runtime_error {
  using std::runtime_error::runtime_error;
};

/// HDF5 prints its error stack unless told otherwise; a library never prints. The caller's setting comes back
/// afterwards, but not after an exception: HDF5 1.10 loses track of memory in a damaged file, and complains
/// of it on the terminal when the program ends.
class Quiet {
 public:
  Quiet() {
    H5Eget_auto2(H5E_DEFAULT, &print_, &data_);
    H5Eset_auto2(H5E_DEFAULT, nullptr, nullptr);
  }
  Quiet(const Quiet&) = delete;
  Quiet& operator=(const Quiet&) = delete;
  ~Quiet() {
    if (std::uncaught_exceptions() == exceptions_) H5Eset_auto2(H5E_DEFAULT, print_, data_);
  }

 private:
  int exceptions_ = std::uncaught_exceptions();
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

/// Behind the bytes of a file, before their SHA-256. HDF5 cuts it off from a file that it changes, which then
/// counts as one without a seal.
inline constexpr std::string_view seal_mark = "\nMPXSEAL";

/// Whether the last call of HDF5 failed for want of memory.
inline bool lacks_memory() {
  const auto look = [](unsigned, const H5E_error2_t* entry, void* found) -> herr_t {
    if (entry->min_num == H5E_NOSPACE || entry->min_num == H5E_CANTALLOC) *static_cast<bool*>(found) = true;
    return 0;
  };
  bool found = false;
  H5Ewalk2(H5E_DEFAULT, H5E_WALK_UPWARD, look, &found);
  return found;
}

/// @throws Fault unless it is met; std::bad_alloc where HDF5 had no memory for it.
inline void require(bool condition, const std::string& what) {
  if (condition) return;
  if (lacks_memory()) throw std::bad_alloc();
  throw Fault(what);
}

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
struct Number<std::int32_t> {
  static hid_t memory() { return H5T_NATIVE_INT32; }
  static hid_t file() { return H5T_STD_I32LE; }
  static constexpr H5T_class_t kind = H5T_INTEGER;
};
template <>
struct Number<std::uint8_t> {
  static hid_t memory() { return H5T_NATIVE_UINT8; }
  static hid_t file() { return H5T_STD_U8LE; }
  static constexpr H5T_class_t kind = H5T_INTEGER;
};

/// Text of any length, UTF-8, which h5py reads as str.
inline Handle text_type() {
  Handle type(H5Tcopy(H5T_C_S1), H5Tclose, "out of memory");
  H5Tset_size(type, H5T_VARIABLE);
  H5Tset_cset(type, H5T_CSET_UTF8);
  return type;
}

}  // namespace mpm::hdf5
