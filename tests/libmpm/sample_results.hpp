/// Result files to write, to damage and to read.
#pragma once

#include <gtest/gtest.h>
#include <hdf5.h>
#include <unistd.h>

#include <cmath>
#include <filesystem>
#include <fstream>
#include <limits>
#include <sstream>
#include <string>
#include <vector>

#include "libmpm/files/result_file.hpp"
#include "libmpm/scene/error.hpp"

namespace samples {

namespace fs = std::filesystem;

/// Values that text or 32 bits would not keep, on maps that are not square.
inline mpm::Result odd_result() {
  mpm::Result result;
  for (int i = 0; i < 5; ++i)
    result.history.push_back({i / 3.0, i * 1e-7 / 3, 1e6 / (i + 3), -1e-300, 5e-324, 1e300, 0.1, 0.2, 0.3,
                              std::nan(""), 0.4, (std::int64_t{1} << 60) + i, -i, 2 * i, 3 * i});
  result.peak_stress = 1e6 / 3;
  result.peak_strain = 1e-4 / 3;
  result.failure_strain.setConstant(3, 2, std::numeric_limits<float>::quiet_NaN());
  result.failure_strain(0, 1) = 1e-4F / 3;
  result.failure_mode.setZero(3, 2);
  result.failure_mode(0, 1) = 2;
  result.end_x.setConstant(3, 2, std::numeric_limits<float>::quiet_NaN());
  result.end_x(2, 1) = 1e-3F / 3;
  result.end_y.setConstant(3, 2, 1e-2F / 7);
  for (std::size_t i = 0; i < 4; ++i) result.deformation[i].setConstant(3, 2, static_cast<float>(i) / 3);
  result.tension_failures = 7;
  result.shear_failures = 8;
  result.points = 92628;
  result.steps = 10327;
  result.dt = 3e-8 / 7;
  result.wall_time = 12.5;
  result.energy_error = 1e-3 / 7;
  result.instruction_set = "avx512";
  result.threads = 3;
  result.stop = mpm::StopReason::drop;
  result.nothing_carries = true;
  return result;
}

/// A folder of its own for each test, and a file in it.
class ResultFileTest : public testing::Test {
 protected:
  void SetUp() override {
    fs::create_directories(folder_);
    H5Eset_auto2(H5E_DEFAULT, nullptr, nullptr);
  }
  void TearDown() override { fs::remove_all(folder_); }

  static std::string bytes_of(const fs::path& path) {
    std::ifstream in(path, std::ios::binary);
    std::ostringstream bytes;
    bytes << in.rdbuf();
    return bytes.str();
  }

  /// What read_result says about the file.
  std::string complaint() const {
    try {
      (void)mpm::read_result(path_);
    } catch (const mpm::FileError& error) {
      EXPECT_EQ(error.field, path_);
      return error.what();
    }
    return "nothing";
  }

  /// Change the file through HDF5 itself.
  template <class Change>
  void damage(Change change) const {
    const hid_t file = H5Fopen(path_.c_str(), H5F_ACC_RDWR, H5P_DEFAULT);
    ASSERT_GE(file, 0);
    change(file);
    ASSERT_GE(H5Fclose(file), 0);
  }

  /// Put a dataset of zeros in the place of another.
  void replace_dataset(const char* name, hid_t type, std::vector<hsize_t> extent) const {
    damage([&](hid_t file) {
      ASSERT_GE(H5Ldelete(file, name, H5P_DEFAULT), 0);
      const hid_t space = H5Screate_simple(static_cast<int>(extent.size()), extent.data(), nullptr);
      const hid_t settings = H5Pcreate(H5P_DATASET_CREATE);
      H5Pset_alloc_time(settings, H5D_ALLOC_TIME_EARLY);
      const hid_t dataset = H5Dcreate2(file, name, type, space, H5P_DEFAULT, settings, H5P_DEFAULT);
      ASSERT_GE(dataset, 0);
      H5Dclose(dataset);
      H5Pclose(settings);
      H5Sclose(space);
    });
  }

  fs::path folder_ = fs::path(testing::TempDir()) / ("result_file_" + std::to_string(::getpid()));
  std::string path_ = folder_ / "result.h5";
};

}  // namespace samples
