/// Frame files to write, to change and to read.
#pragma once

#include <gtest/gtest.h>
#include <hdf5.h>
#include <unistd.h>

#include <filesystem>
#include <string>
#include <vector>

#include "libmpm/files/frame_file.hpp"
#include "libmpm/scene/error.hpp"
#include "tests/libmpm/sample_scenes.hpp"

namespace samples {

namespace fs = std::filesystem;

/// Numbers that 32 bits keep.
inline mpm::Frame odd_frame() {
  mpm::Frame frame{
      .step = (std::int64_t{1} << 60) + 1, .time = 1e-5 / 3, .strain = 1e-4 / 3, .row = 3, .points = {}};
  frame.points.push_back({.id = 4,
                          .phase = 2,
                          .x = 0.125,
                          .y = 0.25,
                          .ux = 0x1p-20,
                          .uy = -0x1p-21,
                          .vx = 3,
                          .vy = -4,
                          .sxx = 5e6,
                          .syy = -6e6,
                          .szz = 7,
                          .sxy = 8,
                          .damage = 0.25});
  frame.points.push_back({.id = 9, .phase = 3, .x = 0.375, .y = 0.5, .damage = 1});
  return frame;
}

struct Creation {
  hid_t id = H5Pcreate(H5P_DATASET_CREATE);
  Creation() = default;
  Creation(const Creation&) = delete;
  Creation& operator=(const Creation&) = delete;
  ~Creation() { H5Pclose(id); }
};

class FrameFileTest : public testing::Test {
 protected:
  void SetUp() override {
    fs::create_directories(folder_);
    H5Eset_auto2(H5E_DEFAULT, nullptr, nullptr);
    mpm::write_frame(path_, odd_frame(), scene_);
  }
  void TearDown() override { fs::remove_all(folder_); }

  std::string complaint() const {
    try {
      (void)mpm::read_frame(path_);
    } catch (const mpm::FileError& error) {
      EXPECT_EQ(error.field, path_);
      return error.what();
    }
    return "nothing";
  }

  /// What read_frame says of the file after it was changed through HDF5 itself.
  template <class Change>
  std::string verdict(Change change) const {
    mpm::write_frame(path_, odd_frame(), scene_);
    const hid_t file = H5Fopen(path_.c_str(), H5F_ACC_RDWR, H5P_DEFAULT);
    EXPECT_GE(file, 0);
    change(file);
    EXPECT_GE(H5Fclose(file), 0);
    return complaint();
  }

  static void create(hid_t file, const char* name, hid_t type, std::vector<hsize_t> extent, hid_t creation,
                     const void* values) {
    if (H5Lexists(file, name, H5P_DEFAULT) > 0) H5Ldelete(file, name, H5P_DEFAULT);
    const hid_t space = H5Screate_simple(static_cast<int>(extent.size()), extent.data(), nullptr);
    const hid_t dataset = H5Dcreate2(file, name, type, space, H5P_DEFAULT, creation, H5P_DEFAULT);
    ASSERT_GE(dataset, 0);
    if (values != nullptr) H5Dwrite(dataset, type, H5S_ALL, H5S_ALL, H5P_DEFAULT, values);
    H5Dclose(dataset);
    H5Sclose(space);
  }
  /// With zeros in the place of a dataset.
  std::string with_zeros(const char* name, hid_t type, std::vector<hsize_t> extent) const {
    const std::vector<double> zeros(100);
    return verdict([&](hid_t f) { create(f, name, type, extent, H5P_DEFAULT, zeros.data()); });
  }

  fs::path folder_ = fs::path(testing::TempDir()) / ("frame_file_" + std::to_string(::getpid()));
  std::string path_ = folder_ / "frame.hdf";
  mpm::Scene scene_ = samples::mortar_block(2, 2);
};

}  // namespace samples
