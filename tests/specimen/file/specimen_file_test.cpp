#include "specimen/file/specimen_file.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <hdf5.h>

#include <cmath>
#include <limits>

#include "specimen/body/error.hpp"
#include "specimen/body/files.hpp"
#include "tests/specimen/sample_specimen.hpp"
#include "tests/specimen/temporary_folder.hpp"

namespace specimen_file_test {

using specimen::Inclusion;
using specimen::read_specimen;
using specimen::Specimen;
using specimen::write_specimen;
using test::expect_equal;
using ::testing::HasSubstr;

TEST(SpecimenFile, GivesBackAllThatWasWritten) {
  const test::TemporaryFolder folder;
  write_specimen(folder / "s.h5", test::sample_specimen());
  expect_equal(read_specimen(folder / "s.h5"), test::sample_specimen());
  EXPECT_EQ(folder.size(), 1) << "a temporary file was left behind";
}

TEST(SpecimenFile, KeepsTheSignOfZero) {
  const test::TemporaryFolder folder;
  write_specimen(folder / "s.h5", test::sample_specimen());
  EXPECT_TRUE(std::signbit(read_specimen(folder / "s.h5").rings[1].vertices[2].x));
}

TEST(SpecimenFile, TakesASpecimenOfMortarAlone) {
  const test::TemporaryFolder folder;
  Specimen s;
  s.mask.pixel_size = 1;
  s.mask.labels = specimen::Raster<std::uint8_t>(1, 1, specimen::phase::mortar);
  write_specimen(folder / "s.h5", s);
  expect_equal(read_specimen(folder / "s.h5"), s);
}

TEST(SpecimenFile, TakesMoreThanOneChunkAndMoreThan64KiBOfOptions) {
  const test::TemporaryFolder folder;
  Specimen s = test::sample_specimen();
  s.mask.labels = specimen::Raster<std::uint8_t>(700, 1100);
  for (std::size_t i = 0; i < s.mask.labels.size(); ++i)
    s.mask.labels.data[i] = static_cast<std::uint8_t>(i * i / 7 % 6);
  s.inclusions.clear();
  s.rings.clear();
  for (int id = 1; id <= 5000; ++id) {
    Inclusion inclusion = test::sample_specimen().inclusions[1];
    inclusion.id = id;
    inclusion.contour.resize(static_cast<std::size_t>(id % 9), {1.0 * id, 2.0 * id});
    s.inclusions.push_back(inclusion);
    s.rings.push_back({id, {{1.0 * id, 0}, {0, 1.0 * id}, {1, 1}}});
  }
  s.provenance.options = std::string(100'000, '#') + "\n";
  write_specimen(folder / "s.h5", s);
  expect_equal(read_specimen(folder / "s.h5"), s);
}

TEST(SpecimenFile, GivesTheSameBytesForTheSameSpecimen) {
  const test::TemporaryFolder folder;
  write_specimen(folder / "first.h5", test::sample_specimen());
  const std::string first = specimen::sha256_of_file(folder / "first.h5");
  write_specimen(folder / "second name.h5", test::sample_specimen());
  EXPECT_EQ(specimen::sha256_of_file(folder / "second name.h5"), first);
  Specimen other = test::sample_specimen();
  other.provenance.seed = 1;
  write_specimen(folder / "first.h5", other);
  EXPECT_NE(specimen::sha256_of_file(folder / "first.h5"), first);
}

TEST(SpecimenFile, KeepsNoTimeOfDay) {
  const test::TemporaryFolder folder;
  write_specimen(folder / "s.h5", test::sample_specimen());
  const hid_t file = H5Fopen((folder / "s.h5").c_str(), H5F_ACC_RDONLY, H5P_DEFAULT);
  const auto visit = [](hid_t, const char* name, const H5O_info_t* info, void* visited) -> herr_t {
    EXPECT_EQ(info->ctime, 0) << name;
    EXPECT_EQ(info->mtime, 0) << name;
    ++*static_cast<int*>(visited);
    return 0;
  };
  int visited = 0;
  H5Ovisit2(file, H5_INDEX_NAME, H5_ITER_NATIVE, visit, &visited, H5O_INFO_TIME);
  EXPECT_EQ(visited, 14) << "of 4 groups and 10 datasets";
  H5Fclose(file);
}

TEST(SpecimenFile, CompressesAndChecksTheLabels) {
  const test::TemporaryFolder folder;
  write_specimen(folder / "s.h5", test::sample_specimen());
  const hid_t file = H5Fopen((folder / "s.h5").c_str(), H5F_ACC_RDONLY, H5P_DEFAULT);
  const hid_t labels = H5Dopen2(file, "labels", H5P_DEFAULT);
  const hid_t options = H5Dget_create_plist(labels);
  std::vector<H5Z_filter_t> filters;
  const int n_filters = H5Pget_nfilters(options);
  for (int i = 0; i < n_filters; ++i) {
    unsigned flags = 0;
    size_t n = 0;
    filters.push_back(
        H5Pget_filter2(options, static_cast<unsigned>(i), &flags, &n, nullptr, 0, nullptr, nullptr));
  }
  EXPECT_EQ(filters,
            (std::vector<H5Z_filter_t>{H5Z_FILTER_SHUFFLE, H5Z_FILTER_DEFLATE, H5Z_FILTER_FLETCHER32}));
  EXPECT_GT(H5Aexists(labels, "orientation"), 0);
  H5Pclose(options);
  H5Dclose(labels);
  H5Fclose(file);
}

TEST(SpecimenFile, RefusesToWriteWhatItWouldNotRead) {
  const test::TemporaryFolder folder;
  Specimen s = test::sample_specimen();
  s.mask.pixel_size = std::numeric_limits<double>::infinity();
  try {
    write_specimen(folder / "s.h5", s);
    FAIL() << "an infinite pixel was written";
  } catch (const specimen::Error& error) {
    EXPECT_EQ(error.what(), (folder / "s.h5") + ": pixel_size: inf m; must be > 0");
  }
  EXPECT_EQ(folder.size(), 0);
}

TEST(SpecimenFile, SaysWhereItCouldNotWrite) {
  const test::TemporaryFolder folder;
  try {
    write_specimen(folder / "none/s.h5", test::sample_specimen());
    FAIL() << "a folder was made up";
  } catch (const specimen::Error& error) {
    EXPECT_THAT(error.what(), HasSubstr("none/s.h5: could not be written: No such file or directory"));
    EXPECT_EQ(error.fault, specimen::Fault::write);
  }
}

/// HDF5's printing, which is the caller's to set, is as it was before.
TEST(SpecimenFile, LeavesTheErrorPrintingOfTheCallerAlone) {
  const test::TemporaryFolder folder;
  test::write_text(folder / "s.h5", "no HDF5");
  const H5E_auto2_t of_the_caller = [](hid_t, void*) { return herr_t{0}; };
  H5E_auto2_t before = nullptr;
  H5E_auto2_t after = nullptr;
  void* data = nullptr;
  H5Eget_auto2(H5E_DEFAULT, &before, &data);
  H5Eset_auto2(H5E_DEFAULT, of_the_caller, nullptr);
  testing::internal::CaptureStderr();
  EXPECT_THROW(std::ignore = read_specimen(folder / "s.h5"), specimen::Error);
  EXPECT_EQ(testing::internal::GetCapturedStderr(), "");
  H5Eget_auto2(H5E_DEFAULT, &after, &data);
  EXPECT_EQ(after, of_the_caller);
  H5Eset_auto2(H5E_DEFAULT, before, nullptr);
}

}  // namespace specimen_file_test
