#include "libmpm/files/table_file.hpp"

#include <gtest/gtest.h>
#include <hdf5.h>

#include "libmpm/scene/error.hpp"
#include "tests/specimen/temporary_folder.hpp"

namespace table_file_test {

const std::vector<mpm::TableColumn> columns{
    {"generate.width + generate.height", "m", "of the specimen", std::vector<double>{0.5, -1e-300}},
    {"seed", "1", "of the random numbers", std::vector<std::int64_t>{7, 1LL << 60}},
    {"state", "1", "done or failed", std::vector<std::string>{"done", "fehlgeschlagen, ü"}}};

/// A dataset read by the HDF5 library itself.
template <class T>
std::vector<T> read(const std::string& path, const char* name, hid_t type, std::size_t count) {
  const hid_t file = H5Fopen(path.c_str(), H5F_ACC_RDONLY, H5P_DEFAULT);
  const hid_t dataset = H5Dopen2(file, name, H5P_DEFAULT);
  std::vector<T> values(count);
  EXPECT_GE(H5Dread(dataset, type, H5S_ALL, H5S_ALL, H5P_DEFAULT, values.data()), 0);
  H5Dclose(dataset);
  H5Fclose(file);
  return values;
}

TEST(TableFile, HoldsItsColumns) {
  const test::TemporaryFolder folder;
  const std::string path = folder / "table.h5";
  mpm::write_table(path, columns);
  EXPECT_EQ(read<double>(path, "generate.width + generate.height", H5T_NATIVE_DOUBLE, 2),
            std::get<0>(columns[0].values));
  EXPECT_EQ(read<std::int64_t>(path, "seed", H5T_NATIVE_INT64, 2), std::get<1>(columns[1].values));
  const std::string longest = "fehlgeschlagen, ü";
  const hid_t text = H5Tcopy(H5T_C_S1);
  H5Tset_size(text, longest.size());
  H5Tset_strpad(text, H5T_STR_NULLPAD);
  H5Tset_cset(text, H5T_CSET_UTF8);
  const std::vector<char> letters = read<char>(path, "state", text, 2 * longest.size());
  H5Tclose(text);
  EXPECT_EQ(std::string(letters.data()), "done");
  EXPECT_EQ(std::string(letters.begin() + static_cast<std::ptrdiff_t>(longest.size()), letters.end()),
            longest);
}

TEST(TableFile, IsReadAsItWasWritten) {
  const test::TemporaryFolder folder;
  mpm::write_table(folder / "t.h5", columns);
  const std::vector<mpm::TableColumn> read = mpm::read_table(folder / "t.h5");
  ASSERT_EQ(read.size(), columns.size());
  for (std::size_t i = 0; i < columns.size(); ++i) {  // which are in the order of their names
    EXPECT_EQ(read[i].name, columns[i].name);
    EXPECT_EQ(read[i].unit, columns[i].unit);
    EXPECT_EQ(read[i].meaning, columns[i].meaning);
    EXPECT_EQ(read[i].values, columns[i].values);
  }
  test::write_text(folder / "no.h5", "no table");
  EXPECT_THROW((void)mpm::read_table(folder / "no.h5"), mpm::FileError);
  EXPECT_THROW((void)mpm::read_table(folder / "none.h5"), mpm::FileError);
}

TEST(TableFile, TheSameTableGivesTheSameBytes) {
  const test::TemporaryFolder folder;
  mpm::write_table(folder / "a.h5", columns);
  mpm::write_table(folder / "b.h5", columns);
  EXPECT_EQ(test::read_text(folder / "a.h5"), test::read_text(folder / "b.h5"));
}

TEST(TableFile, SaysWhereItCannotWrite) {
  const test::TemporaryFolder folder;
  EXPECT_THROW(mpm::write_table(folder / "none/table.h5", columns), mpm::FileError);
}

}  // namespace table_file_test
