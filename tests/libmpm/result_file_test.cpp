#include "libmpm/result_file.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <hdf5.h>
#include <unistd.h>

#include <cmath>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <limits>
#include <sstream>

#include "libmpm/error.hpp"
#include "libmpm/history_columns.hpp"

namespace {

namespace fs = std::filesystem;
using testing::HasSubstr;

constexpr float nan_f = std::numeric_limits<float>::quiet_NaN();

/// Values that text or 32 bits would not keep, on maps that are not square.
mpm::Result odd_result() {
  mpm::Result result;
  for (int i = 0; i < 5; ++i)
    result.history.push_back({i / 3.0, i * 1e-7 / 3, 1e6 / (i + 3), -1e-300, 5e-324, 1e300, 0.1, 0.2, 0.3,
                              std::nan(""), 0.4, (std::int64_t{1} << 60) + i, -i, 2 * i, 3 * i});
  result.peak_stress = 1e6 / 3;
  result.peak_strain = 1e-4 / 3;
  result.failure_strain.setConstant(3, 2, nan_f);
  result.failure_strain(0, 1) = 1e-4F / 3;
  result.failure_mode.setZero(3, 2);
  result.failure_mode(0, 1) = 2;
  result.end_x.setConstant(3, 2, nan_f);
  result.end_x(2, 1) = 1e-3F / 3;
  result.end_y.setConstant(3, 2, 1e-2F / 7);
  result.tension_failures = 7;
  result.shear_failures = 8;
  result.points = 92628;
  result.steps = 10327;
  result.dt = 3e-8 / 7;
  result.wall_time = 12.5;
  result.energy_error = 1e-3 / 7;
  result.instruction_set = "avx512";
  result.stop = mpm::StopReason::drop;
  return result;
}

/// NaN equals NaN here.
void expect_same(double read, double written) {
  if (std::isnan(written))
    EXPECT_TRUE(std::isnan(read));
  else
    EXPECT_EQ(read, written);
}

void expect_same(std::int64_t read, std::int64_t written) { EXPECT_EQ(read, written); }

template <class T>
void expect_same(const mpm::Lattice<T>& read, const mpm::Lattice<T>& written) {
  ASSERT_EQ(read.rows(), written.rows());
  ASSERT_EQ(read.cols(), written.cols());
  for (Eigen::Index i = 0; i < written.size(); ++i)
    expect_same(static_cast<double>(read.data()[i]), static_cast<double>(written.data()[i]));
}

void expect_same(const std::vector<mpm::HistoryRow>& read, const std::vector<mpm::HistoryRow>& written) {
  ASSERT_EQ(read.size(), written.size());
  for (std::size_t i = 0; i < written.size(); ++i)
    for (const mpm::HistoryColumn& column : mpm::history_columns())
      std::visit([&](auto member) { expect_same(read[i].*member, written[i].*member); }, column.member);
}

void expect_same(const mpm::Result& read, const mpm::Result& written) {
  expect_same(read.history, written.history);
  expect_same(read.peak_stress, written.peak_stress);
  expect_same(read.peak_strain, written.peak_strain);
  expect_same(read.failure_strain, written.failure_strain);
  expect_same(read.failure_mode, written.failure_mode);
  expect_same(read.crush_strain, written.crush_strain);
  expect_same(read.end_x, written.end_x);
  expect_same(read.end_y, written.end_y);
  EXPECT_EQ(read.tension_failures, written.tension_failures);
  EXPECT_EQ(read.shear_failures, written.shear_failures);
  EXPECT_EQ(read.points, written.points);
  EXPECT_EQ(read.steps, written.steps);
  expect_same(read.dt, written.dt);
  expect_same(read.wall_time, written.wall_time);
  expect_same(read.energy_error, written.energy_error);
  EXPECT_EQ(read.instruction_set, written.instruction_set);
  EXPECT_EQ(read.stop, written.stop);
}

class ResultFile : public testing::Test {
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

TEST_F(ResultFile, GivesBackEveryBit) {
  mpm::write_result(path_, odd_result(), "");
  expect_same(mpm::read_result(path_), odd_result());
}

TEST_F(ResultFile, KeepsCrushedPointsOfCrackClosure) {
  mpm::Result result = odd_result();
  result.crush_strain.setConstant(3, 2, nan_f);
  result.crush_strain(2, 0) = 2e-4F;
  mpm::write_result(path_, result, "");
  expect_same(mpm::read_result(path_), result);
}

TEST_F(ResultFile, KeepsEveryStopReason) {
  mpm::Result result = odd_result();
  for (const auto reason : {mpm::StopReason::strain, mpm::StopReason::drop, mpm::StopReason::interrupted}) {
    result.stop = reason;
    mpm::write_result(path_, result, "");
    EXPECT_EQ(mpm::read_result(path_).stop, reason);
  }
}

TEST_F(ResultFile, KeepsAResultWithoutRowsOrPixels) {
  mpm::write_result(path_, mpm::Result{}, "");
  expect_same(mpm::read_result(path_), mpm::Result{});
}

TEST_F(ResultFile, KeepsMapsLargerThanAChunk) {
  mpm::Result result = odd_result();
  result.failure_strain.setZero(700, 513);
  result.failure_mode.setZero(700, 513);
  for (Eigen::Index i = 0; i < result.failure_strain.size(); ++i) {
    result.failure_strain.data()[i] = static_cast<float>(i);
    result.failure_mode.data()[i] = static_cast<std::uint8_t>(i % 3);
  }
  mpm::write_result(path_, result, "");
  expect_same(mpm::read_result(path_), result);
}

TEST_F(ResultFile, KeepsALongScene) {
  const std::string scene = "title = \"µ\"\n" + std::string(200'000, '#');
  mpm::write_result(path_, odd_result(), scene);
  EXPECT_EQ(mpm::read_scene_text(path_), scene);
}

TEST_F(ResultFile, IsTheSameBytesForTheSameResult) {
  mpm::write_result(path_, odd_result(), "scene");
  const std::string first = bytes_of(path_);
  mpm::write_result(path_, odd_result(), "scene");
  EXPECT_EQ(bytes_of(path_), first);
  EXPECT_EQ(std::distance(fs::directory_iterator(folder_), fs::directory_iterator()), 1);
}

TEST_F(ResultFile, CarriesAUnitOnEveryColumn) {
  mpm::write_result(path_, odd_result(), "");
  const hid_t file = H5Fopen(path_.c_str(), H5F_ACC_RDONLY, H5P_DEFAULT);
  for (const mpm::HistoryColumn& column : mpm::history_columns()) {
    const std::string name = "history/" + std::string(column.name);
    const hid_t unit = H5Aopen_by_name(file, name.c_str(), "unit", H5P_DEFAULT, H5P_DEFAULT);
    ASSERT_GE(unit, 0) << name;
    const hid_t type = H5Aget_type(unit);
    char* text = nullptr;
    EXPECT_GE(H5Aread(unit, type, &text), 0);
    EXPECT_EQ(text, column.unit);
    H5free_memory(text);
    H5Tclose(type);
    H5Aclose(unit);
  }
  H5Fclose(file);
}

TEST_F(ResultFile, RefusesAFileThatIsNotThere) {
  EXPECT_EQ(complaint(), path_ +
                             ": there is no such file; must be a result.h5 that mesopix wrote; "
                             "run the simulation again");
}

TEST_F(ResultFile, RefusesOtherBytes) {
  std::ofstream(path_) << "strain,stress\n";
  EXPECT_THAT(complaint(), HasSubstr("is no HDF5 file, or is cut short or damaged"));
}

TEST_F(ResultFile, RefusesAFileThatIsCutShort) {
  mpm::write_result(path_, odd_result(), "scene");
  const auto whole = fs::file_size(path_);
  for (const double share : {0.01, 0.3, 0.7, 0.99}) {
    mpm::write_result(path_, odd_result(), "scene");
    fs::resize_file(path_, static_cast<std::uintmax_t>(share * static_cast<double>(whole)));
    EXPECT_THAT(complaint(), HasSubstr("cut short")) << share;
  }
}

TEST_F(ResultFile, RefusesAnHdf5FileOfAnotherKind) {
  const hid_t file = H5Fcreate(path_.c_str(), H5F_ACC_TRUNC, H5P_DEFAULT, H5P_DEFAULT);
  H5Fclose(file);
  EXPECT_THAT(complaint(), HasSubstr("is no result of mesopix"));
}

TEST_F(ResultFile, RefusesALaterFormat) {
  mpm::write_result(path_, odd_result(), "");
  damage([](hid_t file) {
    const hid_t version = H5Aopen(file, "format_version", H5P_DEFAULT);
    const std::int64_t later = 2;
    H5Awrite(version, H5T_NATIVE_INT64, &later);
    H5Aclose(version);
  });
  EXPECT_THAT(complaint(), HasSubstr("has format version 2, this program reads 1"));
}

TEST_F(ResultFile, NamesADatasetThatIsMissing) {
  mpm::write_result(path_, odd_result(), "");
  damage([](hid_t file) { H5Ldelete(file, "failure_mode", H5P_DEFAULT); });
  EXPECT_THAT(complaint(), HasSubstr("dataset failure_mode is missing"));
}

TEST_F(ResultFile, NamesAColumnThatIsMissing) {
  mpm::write_result(path_, odd_result(), "");
  damage([](hid_t file) { H5Ldelete(file, "history/damped", H5P_DEFAULT); });
  EXPECT_THAT(complaint(), HasSubstr("dataset damped is missing"));
}

TEST_F(ResultFile, NamesAnAttributeThatIsMissing) {
  mpm::write_result(path_, odd_result(), "");
  damage([](hid_t file) { H5Adelete(file, "dt_s"); });
  EXPECT_THAT(complaint(), HasSubstr("attribute dt_s is missing"));
}

TEST_F(ResultFile, RefusesAWrongType) {
  mpm::write_result(path_, odd_result(), "");
  replace_dataset("failure_strain", H5T_STD_I32LE, {3, 2});
  EXPECT_THAT(complaint(), HasSubstr("dataset failure_strain has a wrong type"));
}

TEST_F(ResultFile, RefusesAWrongNumberOfAxes) {
  mpm::write_result(path_, odd_result(), "");
  replace_dataset("failure_strain", H5T_IEEE_F32LE, {6});
  EXPECT_THAT(complaint(), HasSubstr("dataset failure_strain has a wrong number of axes"));
}

TEST_F(ResultFile, RefusesPlacesOfDifferentShapes) {
  mpm::write_result(path_, odd_result(), "");
  replace_dataset("end_y", H5T_IEEE_F32LE, {2, 3});
  EXPECT_THAT(complaint(), HasSubstr("dataset end_y has another shape than end_x"));
}

TEST_F(ResultFile, RefusesMapsOfDifferentShapes) {
  mpm::write_result(path_, odd_result(), "");
  replace_dataset("failure_mode", H5T_STD_U8LE, {2, 3});
  EXPECT_THAT(complaint(), HasSubstr("dataset failure_mode has another shape than failure_strain"));
}

TEST_F(ResultFile, RefusesColumnsOfDifferentLengths) {
  mpm::write_result(path_, odd_result(), "");
  replace_dataset("history/stress", H5T_IEEE_F64LE, {4});
  EXPECT_THAT(complaint(), HasSubstr("dataset history/stress has another length than history/time"));
}

TEST_F(ResultFile, RefusesAModeThatMeansNothing) {
  mpm::Result result = odd_result();
  result.failure_mode(1, 1) = 3;
  mpm::write_result(path_, result, "");
  EXPECT_THAT(complaint(), HasSubstr("dataset failure_mode holds a value above 2"));
}

TEST_F(ResultFile, RefusesAnExtentWithoutData) {
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

TEST_F(ResultFile, NoticesAFlippedBitInAMap) {
  mpm::Result result = odd_result();
  result.failure_strain = mpm::Lattice<float>::Random(400, 400);  // fills the greater part of the file
  result.failure_mode.setZero(400, 400);
  mpm::write_result(path_, result, "");
  std::string bytes = bytes_of(path_);
  bytes[bytes.size() / 2] = static_cast<char>(bytes[bytes.size() / 2] ^ 1);
  std::ofstream(path_, std::ios::binary) << bytes;
  EXPECT_THAT(complaint(), HasSubstr("dataset failure_strain is damaged"));
}

TEST_F(ResultFile, SaysWhyItCannotBeWritten) {
  std::ofstream(folder_ / "file") << "";
  try {
    mpm::write_result(folder_ / "file" / "result.h5", odd_result(), "");
    FAIL() << "a file was taken for a folder";
  } catch (const mpm::FileError& error) {
    EXPECT_THAT(error.what(), HasSubstr("cannot be written: Not a directory"));
  }
}

}  // namespace
