#include "libmpm/files/frame_file.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <hdf5.h>
#include <unistd.h>

#include <filesystem>
#include <fstream>
#include <sstream>

#include "libmpm/scene/error.hpp"
#include "tests/libmpm/sample_scenes.hpp"

namespace frame_file_test {

namespace fs = std::filesystem;

/// What VTK makes of such a file is tested with VTK itself, on the files of a run.
class FrameFile : public testing::Test {
 protected:
  void SetUp() override { fs::create_directories(folder_); }
  void TearDown() override { fs::remove_all(folder_); }

  static mpm::Frame two_points() {
    mpm::Frame frame{.step = 7, .time = 1.5e-5, .strain = 2e-4, .row = 3, .points = {}};
    frame.points.push_back({.id = 4,
                            .phase = 2,
                            .x = 0.1,
                            .y = 0.2,
                            .ux = 1e-6,
                            .uy = 2e-6,
                            .vx = 3,
                            .vy = 4,
                            .sxx = 5,
                            .syy = 6,
                            .szz = 7,
                            .sxy = 8,
                            .damage = 0.25});
    frame.points.push_back({.id = 9, .phase = 3, .x = 0.3, .y = 0.4});
    return frame;
  }
  std::string bytes() const {
    std::ifstream in(path_, std::ios::binary);
    std::ostringstream text;
    text << in.rdbuf();
    return text.str();
  }
  std::vector<double> values(const char* name) const {
    const hid_t file = H5Fopen(path_.c_str(), H5F_ACC_RDONLY, H5P_DEFAULT);
    const hid_t dataset = H5Dopen2(file, name, H5P_DEFAULT);
    const hid_t space = H5Dget_space(dataset);
    std::vector<double> found(static_cast<std::size_t>(H5Sget_simple_extent_npoints(space)));
    H5Dread(dataset, H5T_NATIVE_DOUBLE, H5S_ALL, H5S_ALL, H5P_DEFAULT, found.data());
    H5Sclose(space);
    H5Dclose(dataset);
    H5Fclose(file);
    return found;
  }

  fs::path folder_ = fs::path(testing::TempDir()) / ("frame_file_" + std::to_string(::getpid()));
  fs::path path_ = folder_ / "frame.hdf";
  mpm::Scene scene_ = samples::mortar_block(2, 2);
};

TEST_F(FrameFile, HoldsTheNumbersOfTheFrame) {
  mpm::write_frame(path_, two_points(), scene_);
  using testing::ElementsAre;
  using testing::FloatEq;
  EXPECT_THAT(values("/VTKHDF/NumberOfPoints"), ElementsAre(2));
  EXPECT_THAT(values("/VTKHDF/Connectivity"), ElementsAre(0, 1));
  EXPECT_THAT(values("/VTKHDF/Offsets"), ElementsAre(0, 1, 2));
  EXPECT_THAT(values("/VTKHDF/Types"), ElementsAre(1, 1));
  const std::vector<double> points = values("/VTKHDF/Points");
  EXPECT_FLOAT_EQ(static_cast<float>(points[3]), 0.3F);
  EXPECT_EQ(points[5], 0);
  EXPECT_FLOAT_EQ(static_cast<float>(values("/VTKHDF/PointData/displacement")[1]), 2e-6F);
  EXPECT_THAT(values("/VTKHDF/PointData/velocity"), ElementsAre(3, 4, 0, 0, 0, 0));
  EXPECT_THAT(values("/VTKHDF/PointData/stress"),
              ElementsAre(5, 8, 0, 8, 6, 0, 0, 0, 7, 0, 0, 0, 0, 0, 0, 0, 0, 0));
  EXPECT_THAT(values("/VTKHDF/PointData/damage"), ElementsAre(0.25, 0));
  EXPECT_THAT(values("/VTKHDF/PointData/phase"), ElementsAre(2, 3));
  EXPECT_THAT(values("/VTKHDF/PointData/id"), ElementsAre(4, 9));
  EXPECT_THAT(values("/VTKHDF/FieldData/TimeValue"), ElementsAre(1.5e-5));
  EXPECT_THAT(values("/VTKHDF/FieldData/strain"), ElementsAre(2e-4));
  EXPECT_THAT(values("/VTKHDF/FieldData/step"), ElementsAre(7));
  EXPECT_THAT(values("/VTKHDF/FieldData/history_row"), ElementsAre(3));
}

TEST_F(FrameFile, HasTheSameBytesForTheSameFrame) {
  mpm::write_frame(path_, two_points(), scene_);
  const std::string first = bytes();
  mpm::write_frame(path_, two_points(), scene_);
  EXPECT_EQ(bytes(), first);
  EXPECT_EQ(std::distance(fs::directory_iterator(folder_), fs::directory_iterator()), 1);
}

TEST_F(FrameFile, MayHoldNoPointAtAll) {
  mpm::write_frame(path_, {}, scene_);
  EXPECT_THAT(values("/VTKHDF/NumberOfPoints"), testing::ElementsAre(0));
  EXPECT_TRUE(values("/VTKHDF/PointData/stress").empty());
}

TEST_F(FrameFile, NamesTheFileThatCannotBeWritten) {
  fs::create_directory(path_);
  try {
    mpm::write_frame(path_, two_points(), scene_);
    FAIL() << "a folder was replaced by a file";
  } catch (const mpm::FileError& error) {
    EXPECT_EQ(error.field, path_.string());
    EXPECT_THAT(error.what(), testing::HasSubstr("cannot be written: Is a directory"));
  }
}

}  // namespace frame_file_test
