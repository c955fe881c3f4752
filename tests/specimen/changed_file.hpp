/// A sample specimen on disk that a test changes behind the reader's back.
#pragma once

#include <gtest/gtest.h>
#include <hdf5.h>

#include <functional>
#include <string>
#include <vector>

#include "specimen/body/error.hpp"
#include "specimen/file/specimen_file.hpp"
#include "tests/specimen/sample_specimen.hpp"
#include "tests/specimen/temporary_folder.hpp"

namespace test {

using Extent = std::vector<hsize_t>;

class ChangedFile : public testing::Test {
 protected:
  const TemporaryFolder folder;
  const std::string path = folder / "s.h5";

  void SetUp() override { write_specimen(path, sample_specimen()); }

  /// What the reader says of the file, without the path.
  [[nodiscard]] std::string verdict() const {
    try {
      std::ignore = specimen::read_specimen(path);
    } catch (const specimen::Error& error) {
      const std::string text = error.what();
      EXPECT_EQ(text.substr(0, path.size() + 2), path + ": ");
      return text.substr(path.size() + 2);
    }
    return "was read";
  }

  /// The same after a change of the sample.
  [[nodiscard]] std::string verdict(const std::function<void(hid_t)>& change) const {
    write_specimen(path, sample_specimen());
    const hid_t file = H5Fopen(path.c_str(), H5F_ACC_RDWR, H5P_DEFAULT);
    change(file);
    H5Fclose(file);
    return verdict();
  }
};

inline void remove(hid_t file, const char* name) { H5Ldelete(file, name, H5P_DEFAULT); }

/// Puts a dataset in the place of another; without values it is never written.
inline void replace(hid_t file, const char* name, hid_t type, const Extent& extent,
                    const void* values = nullptr, hid_t options = H5P_DEFAULT) {
  remove(file, name);
  const hid_t space = H5Screate_simple(static_cast<int>(extent.size()), extent.data(), nullptr);
  const hid_t dataset = H5Dcreate2(file, name, type, space, H5P_DEFAULT, options, H5P_DEFAULT);
  ASSERT_GE(dataset, 0) << name;
  if (values != nullptr) H5Dwrite(dataset, type, H5S_ALL, H5S_ALL, H5P_DEFAULT, values);
  H5Dclose(dataset);
  H5Sclose(space);
}

template <class T>
void set_attribute(hid_t file, const char* object, const char* name, hid_t type, T value) {
  H5Adelete_by_name(file, object, name, H5P_DEFAULT);
  const hid_t space = H5Screate(H5S_SCALAR);
  const hid_t attribute =
      H5Acreate_by_name(file, object, name, type, space, H5P_DEFAULT, H5P_DEFAULT, H5P_DEFAULT);
  H5Awrite(attribute, type, &value);
  H5Aclose(attribute);
  H5Sclose(space);
}

}  // namespace test
