// Files that are no results, or damaged ones.
#include <gmock/gmock.h>

#include <iterator>

#include "tests/damaged.hpp"
#include "tests/libmpm/sample_results.hpp"

namespace result_file_read_test {

namespace fs = std::filesystem;
using samples::odd_result;
using testing::HasSubstr;

using ResultFileRead = samples::ResultFileTest;

TEST_F(ResultFileRead, RefusesAFileThatIsNotThere) {
  EXPECT_EQ(complaint(), path_ +
                             ": there is no such file; must be a result.h5 that mesopix wrote; "
                             "run the simulation again");
}

TEST_F(ResultFileRead, RefusesOtherBytes) {
  std::ofstream(path_) << "strain,stress\n";
  EXPECT_THAT(complaint(), HasSubstr("is not an HDF5 file, or is cut short or damaged"));
}

TEST_F(ResultFileRead, RefusesAFileThatIsCutShort) {
  mpm::write_result(path_, odd_result(), "scene");
  const auto whole = fs::file_size(path_);
  for (const double share : {0.01, 0.3, 0.7, 0.99}) {
    mpm::write_result(path_, odd_result(), "scene");
    fs::resize_file(path_, static_cast<std::uintmax_t>(share * static_cast<double>(whole)));
    EXPECT_THAT(complaint(), HasSubstr("cut short")) << share;
  }
}

TEST_F(ResultFileRead, RefusesAnHdf5FileOfAnotherKind) {
  const hid_t file = H5Fcreate(path_.c_str(), H5F_ACC_TRUNC, H5P_DEFAULT, H5P_DEFAULT);
  H5Fclose(file);
  EXPECT_THAT(complaint(), HasSubstr("is not a mesopix result"));
}

TEST_F(ResultFileRead, RefusesALaterFormat) {
  mpm::write_result(path_, odd_result(), "");
  damage([](hid_t file) {
    const hid_t version = H5Aopen(file, "format_version", H5P_DEFAULT);
    const std::int64_t later = 2;
    H5Awrite(version, H5T_NATIVE_INT64, &later);
    H5Aclose(version);
  });
  EXPECT_THAT(complaint(), HasSubstr("has format version 2, this program reads 1"));
}

TEST_F(ResultFileRead, NamesADatasetThatIsMissing) {
  mpm::write_result(path_, odd_result(), "");
  damage([](hid_t file) { H5Ldelete(file, "failure_mode", H5P_DEFAULT); });
  EXPECT_THAT(complaint(), HasSubstr("dataset failure_mode is missing"));
}

TEST_F(ResultFileRead, NamesAColumnThatIsMissing) {
  mpm::write_result(path_, odd_result(), "");
  damage([](hid_t file) { H5Ldelete(file, "history/damped", H5P_DEFAULT); });
  EXPECT_THAT(complaint(), HasSubstr("dataset damped is missing"));
}

TEST_F(ResultFileRead, KnowsOlderFilesThatDoNotSayWhetherAnythingCarries) {
  mpm::write_result(path_, odd_result(), "");
  damage([](hid_t file) { H5Adelete(file, "nothing_carries"); });
  EXPECT_FALSE(mpm::read_result(path_).nothing_carries);
}

TEST_F(ResultFileRead, NamesAnAttributeThatIsMissing) {
  mpm::write_result(path_, odd_result(), "");
  damage([](hid_t file) { H5Adelete(file, "dt_s"); });
  EXPECT_THAT(complaint(), HasSubstr("attribute dt_s is missing"));
}

TEST_F(ResultFileRead, RefusesAWrongType) {
  mpm::write_result(path_, odd_result(), "");
  replace_dataset("failure_strain", H5T_STD_I32LE, {3, 2});
  EXPECT_THAT(complaint(), HasSubstr("dataset failure_strain has a wrong type"));
}

TEST_F(ResultFileRead, RefusesAWrongNumberOfAxes) {
  mpm::write_result(path_, odd_result(), "");
  replace_dataset("failure_strain", H5T_IEEE_F32LE, {6});
  EXPECT_THAT(complaint(), HasSubstr("dataset failure_strain has a wrong number of axes"));
}

TEST_F(ResultFileRead, RefusesPlacesOfDifferentShapes) {
  mpm::write_result(path_, odd_result(), "");
  replace_dataset("end_y", H5T_IEEE_F32LE, {2, 3});
  EXPECT_THAT(complaint(), HasSubstr("dataset end_y has another shape than end_x"));
}

TEST_F(ResultFileRead, RefusesMapsOfDifferentShapes) {
  mpm::write_result(path_, odd_result(), "");
  replace_dataset("failure_mode", H5T_STD_U8LE, {2, 3});
  EXPECT_THAT(complaint(), HasSubstr("dataset failure_mode has another shape than failure_strain"));
}

TEST_F(ResultFileRead, RefusesColumnsOfDifferentLengths) {
  mpm::write_result(path_, odd_result(), "");
  replace_dataset("history/stress", H5T_IEEE_F64LE, {4});
  EXPECT_THAT(complaint(), HasSubstr("dataset history/stress has another length than history/time"));
}

TEST_F(ResultFileRead, RefusesAModeThatMeansNothing) {
  mpm::Result result = odd_result();
  result.failure_mode(1, 1) = 3;
  mpm::write_result(path_, result, "");
  EXPECT_THAT(complaint(), HasSubstr("dataset failure_mode holds a value above 2"));
}

TEST_F(ResultFileRead, RefusesAnExtentWithoutData) {
  mpm::write_result(path_, odd_result(), "");
  damage([](hid_t file) {
    H5Ldelete(file, "failure_strain", H5P_DEFAULT);
    const hsize_t extent[] = {hsize_t{1} << 30, hsize_t{1} << 30};
    const hid_t space = H5Screate_simple(2, extent, nullptr);
    const hid_t dataset =
        H5Dcreate2(file, "failure_strain", H5T_IEEE_F32LE, space, H5P_DEFAULT, H5P_DEFAULT, H5P_DEFAULT);
    H5Dclose(dataset);
    H5Sclose(space);
  });
  EXPECT_THAT(complaint(), HasSubstr("dataset failure_strain has an extent that its data do not fill"));
}

TEST_F(ResultFileRead, FollowsNoLinks) {
  for (const char* name : {"history", "failure_mode"}) {
    mpm::write_result(path_, odd_result(), "");
    damage([&](hid_t file) {
      H5Lmove(file, name, file, "elsewhere", H5P_DEFAULT, H5P_DEFAULT);
      H5Lcreate_soft("/elsewhere", file, name, H5P_DEFAULT, H5P_DEFAULT);
    });
    EXPECT_THAT(complaint(), HasSubstr(std::string(name) + " is a link, not part of the file itself"));
  }
}

TEST_F(ResultFileRead, NoticesAFlippedBitInAMap) {
  mpm::Result result = odd_result();
  result.failure_strain = mpm::PixelField<float>::Random(400, 400);  // fills the greater part of the file
  result.failure_mode.setZero(400, 400);
  mpm::write_result(path_, result, "");
  std::string bytes = test::unsealed(bytes_of(path_));
  bytes[bytes.size() / 2] = static_cast<char>(bytes[bytes.size() / 2] ^ 1);
  std::ofstream(path_, std::ios::binary) << bytes;
  EXPECT_THAT(complaint(), HasSubstr("dataset failure_strain is damaged"));
}

}  // namespace result_file_read_test
