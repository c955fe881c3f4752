#include "libmpm/files/result_file.hpp"

#include <gmock/gmock.h>

#include "libmpm/scene/result.hpp"
#include "tests/libmpm/sample_results.hpp"

namespace result_file_test {

namespace fs = std::filesystem;
using samples::odd_result;
using testing::HasSubstr;

constexpr float nan_f = std::numeric_limits<float>::quiet_NaN();

using ResultFile = samples::ResultFileTest;

/// NaN equals NaN here.
void expect_same(double read, double written) {
  if (std::isnan(written))
    EXPECT_TRUE(std::isnan(read));
  else
    EXPECT_EQ(read, written);
}

void expect_same(std::int64_t read, std::int64_t written) { EXPECT_EQ(read, written); }

template <class T>
void expect_same(const mpm::PixelField<T>& read, const mpm::PixelField<T>& written) {
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
  ASSERT_EQ(read.gauges.size(), written.gauges.size());
  for (std::size_t i = 0; i < written.gauges.size(); ++i) {
    EXPECT_EQ(read.gauges[i].name, written.gauges[i].name);
    EXPECT_EQ(read.gauges[i].values, written.gauges[i].values);
  }
  expect_same(read.peak_stress, written.peak_stress);
  expect_same(read.peak_strain, written.peak_strain);
  expect_same(read.failure_strain, written.failure_strain);
  expect_same(read.failure_mode, written.failure_mode);
  expect_same(read.crush_strain, written.crush_strain);
  expect_same(read.end_x, written.end_x);
  expect_same(read.end_y, written.end_y);
  for (std::size_t i = 0; i < 4; ++i) expect_same(read.deformation[i], written.deformation[i]);
  EXPECT_EQ(read.tension_failures, written.tension_failures);
  EXPECT_EQ(read.shear_failures, written.shear_failures);
  EXPECT_EQ(read.points, written.points);
  EXPECT_EQ(read.steps, written.steps);
  expect_same(read.dt, written.dt);
  expect_same(read.wall_time, written.wall_time);
  expect_same(read.energy_error, written.energy_error);
  EXPECT_EQ(read.instruction_set, written.instruction_set);
  EXPECT_EQ(read.threads, written.threads);
  EXPECT_EQ(read.stop, written.stop);
  EXPECT_EQ(read.nothing_carries, written.nothing_carries);
}

TEST_F(ResultFile, GivesBackEveryBit) {
  mpm::write_result(path_, odd_result(), "");
  expect_same(mpm::read_result(path_), odd_result());
}

TEST_F(ResultFile, KeepsWhatGaugesRead) {
  mpm::Result result = odd_result();
  result.gauges = {{"CMOD", {0, 1e-7 / 3, 2e-7 / 3, 5e-324, -1e-6}}, {"an-other_1", {0, 1, 2, 3, 4}}};
  mpm::write_result(path_, result, "");
  expect_same(mpm::read_result(path_), result);
  result.gauges[0].values.pop_back();
  mpm::write_result(path_, result, "");
  EXPECT_THROW((void)mpm::read_result(path_), mpm::FileError);
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

double attribute(const std::string& path, const char* name) {
  const hid_t file = H5Fopen(path.c_str(), H5F_ACC_RDONLY, H5P_DEFAULT);
  const hid_t attribute = H5Aopen(file, name, H5P_DEFAULT);
  double value = -1;
  EXPECT_GE(H5Aread(attribute, H5T_NATIVE_DOUBLE, &value), 0) << name;
  H5Aclose(attribute);
  H5Fclose(file);
  return value;
}

TEST_F(ResultFile, NamesNoPeakThatIsNone) {
  mpm::Result result = odd_result();
  result.history = {{}, {.strain = result.peak_strain, .stress = result.peak_stress}};
  mpm::write_result(path_, result, "");
  EXPECT_TRUE(std::isnan(attribute(path_, "peak_stress_Pa")));
  EXPECT_TRUE(std::isnan(attribute(path_, "peak_strain")));
  EXPECT_EQ(attribute(path_, "largest_stress_Pa"), result.peak_stress);
  EXPECT_EQ(attribute(path_, "strain_at_largest_stress"), result.peak_strain);
  expect_same(mpm::read_result(path_), result);
  result.history.push_back({.strain = 2 * result.peak_strain, .stress = 0.5 * result.peak_stress});
  mpm::write_result(path_, result, "");
  EXPECT_EQ(attribute(path_, "peak_stress_Pa"), result.peak_stress);
  EXPECT_EQ(attribute(path_, "peak_strain"), result.peak_strain);
}

TEST_F(ResultFile, IsReadWhereAnOlderVersionCalledTheLargestStressAPeak) {
  mpm::Result result = odd_result();
  result.history = {{}, {.strain = result.peak_strain, .stress = result.peak_stress}, {.strain = 1e-3}};
  mpm::write_result(path_, result, "");
  damage([](hid_t file) {
    ASSERT_GE(H5Adelete(file, "largest_stress_Pa"), 0);
    ASSERT_GE(H5Adelete(file, "strain_at_largest_stress"), 0);
  });
  expect_same(mpm::read_result(path_), result);
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

}  // namespace result_file_test
