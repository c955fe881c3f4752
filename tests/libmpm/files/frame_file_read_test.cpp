// Frames read back, and files that are none.
#include <gmock/gmock.h>

#include <cmath>
#include <fstream>

#include "tests/libmpm/sample_frames.hpp"

namespace frame_file_read_test {

namespace fs = std::filesystem;
using samples::odd_frame;
using testing::HasSubstr;

using FrameFileRead = samples::FrameFileTest;

TEST_F(FrameFileRead, GivesBackWhatWasWritten) {
  EXPECT_EQ(mpm::read_frame(path_), odd_frame());
  mpm::write_frame(path_, {}, scene_);
  EXPECT_EQ(mpm::read_frame(path_), mpm::Frame{});
}

TEST_F(FrameFileRead, TheHeadingIsTheFrameWithoutItsPoints) {
  mpm::Frame heading = odd_frame();
  heading.points.clear();
  EXPECT_EQ(mpm::read_frame_heading(path_), heading);
}

TEST_F(FrameFileRead, RefusesWhatIsNoFrame) {
  fs::remove(path_);
  EXPECT_EQ(complaint(), path_ +
                             ": there is no such file; must be a frame that mesopix wrote; "
                             "run the simulation again");
  std::ofstream(path_) << "strain,stress\n";
  EXPECT_THAT(complaint(), HasSubstr("is not an HDF5 file, or is cut short or damaged"));
  H5Fclose(H5Fcreate(path_.c_str(), H5F_ACC_TRUNC, H5P_DEFAULT, H5P_DEFAULT));
  EXPECT_THAT(complaint(), HasSubstr("is not a mesopix frame"));
  mpm::write_frame(path_, odd_frame(), scene_);
  fs::resize_file(path_, fs::file_size(path_) / 2);
  EXPECT_THAT(complaint(), HasSubstr("cut short"));
}

TEST_F(FrameFileRead, RefusesALaterVersion) {
  EXPECT_THAT(verdict([](hid_t f) {
                const hid_t root = H5Gopen2(f, "VTKHDF", H5P_DEFAULT);
                const hid_t version = H5Aopen(root, "Version", H5P_DEFAULT);
                const std::int64_t later[] = {2, 0};
                H5Awrite(version, H5T_NATIVE_INT64, later);
                H5Aclose(version);
                H5Gclose(root);
              }),
              HasSubstr("has VTKHDF version 2, this program reads 1"));
  EXPECT_THAT(verdict([](hid_t f) {
                H5Adelete_by_name(f, "VTKHDF", "Version", H5P_DEFAULT);
                const hid_t space = H5Screate(H5S_SCALAR);
                const hid_t root = H5Gopen2(f, "VTKHDF", H5P_DEFAULT);
                H5Aclose(H5Acreate2(root, "Version", H5T_STD_I64LE, space, H5P_DEFAULT, H5P_DEFAULT));
                H5Gclose(root);
                H5Sclose(space);
              }),
              HasSubstr("attribute Version must hold 2 values"));
}

TEST_F(FrameFileRead, NamesWhatIsMissing) {
  for (const std::string name :
       {"Points", "NumberOfPoints", "PointData/displacement", "PointData/velocity", "PointData/stress",
        "PointData/damage", "PointData/phase", "PointData/id", "FieldData/TimeValue", "FieldData/strain",
        "FieldData/step", "FieldData/history_row"})
    EXPECT_THAT(verdict([&](hid_t f) { H5Ldelete(f, ("VTKHDF/" + name).c_str(), H5P_DEFAULT); }),
                HasSubstr("dataset " + name.substr(name.find('/') + 1) + " is missing"));
  for (const std::string name : {"PointData", "FieldData"})
    EXPECT_THAT(verdict([&](hid_t f) { H5Ldelete(f, ("VTKHDF/" + name).c_str(), H5P_DEFAULT); }),
                HasSubstr("group " + name + " is missing"));
}

TEST_F(FrameFileRead, RefusesWrongTypesAndShapes) {
  const char* const stress = "VTKHDF/PointData/stress";
  EXPECT_THAT(with_zeros(stress, H5T_IEEE_F64LE, {2, 9}), HasSubstr("dataset stress has a wrong type"));
  EXPECT_THAT(with_zeros(stress, H5T_STD_I32LE, {2, 9}), HasSubstr("dataset stress has a wrong type"));
  EXPECT_THAT(with_zeros(stress, H5T_IEEE_F32LE, {18}),
              HasSubstr("dataset stress has a wrong number of axes"));
  EXPECT_THAT(with_zeros(stress, H5T_IEEE_F32LE, {2, 6}), HasSubstr("dataset stress has a wrong shape"));
  EXPECT_THAT(with_zeros(stress, H5T_IEEE_F32LE, {3, 9}), HasSubstr("dataset stress has a wrong shape"));
  EXPECT_THAT(with_zeros("VTKHDF/PointData/damage", H5T_IEEE_F32LE, {1}),
              HasSubstr("dataset damage has a wrong shape"));
  EXPECT_THAT(with_zeros("VTKHDF/FieldData/strain", H5T_IEEE_F64LE, {2}),
              HasSubstr("dataset strain must hold one value"));
  EXPECT_THAT(verdict([](hid_t f) {
                H5Ldelete(f, "VTKHDF/PointData/id", H5P_DEFAULT);
                H5Gclose(H5Gcreate2(f, "VTKHDF/PointData/id", H5P_DEFAULT, H5P_DEFAULT, H5P_DEFAULT));
              }),
              HasSubstr("dataset id is not a dataset"));
}

TEST_F(FrameFileRead, RefusesNumbersThatMeanNothing) {
  EXPECT_THAT(with_zeros("VTKHDF/PointData/id", H5T_STD_I32LE, {2}),
              HasSubstr("dataset id holds numbers that do not increase from 0"));
  EXPECT_THAT(with_zeros("VTKHDF/NumberOfPoints", H5T_STD_I64LE, {1}),
              HasSubstr("dataset NumberOfPoints differs from the number of values in id"));
  const auto holds = [&](const char* name, hid_t type, std::vector<hsize_t> extent, const void* values) {
    return verdict([&](hid_t f) { create(f, name, type, extent, H5P_DEFAULT, values); });
  };
  const std::int32_t negative[] = {-1, 4};
  EXPECT_THAT(holds("VTKHDF/PointData/id", H5T_STD_I32LE, {2}, negative),
              HasSubstr("do not increase from 0"));
  for (const float wrong : {-0.5F, 1.5F, std::nanf("")}) {
    const float damage[] = {0, wrong};
    EXPECT_THAT(holds("VTKHDF/PointData/damage", H5T_IEEE_F32LE, {2}, damage),
                HasSubstr("dataset damage holds a value that does not lie in [0, 1]"));
  }
  const double none = std::nan("");
  EXPECT_THAT(holds("VTKHDF/FieldData/strain", H5T_IEEE_F64LE, {1}, &none),
              HasSubstr("dataset strain is not a number"));
}

}  // namespace frame_file_read_test
