// Files that are damaged, incomplete or hostile: each is refused by name, or gives the specimen that was
// written.

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <hdf5.h>

#include <array>
#include <cstring>
#include <limits>

#include "tests/damaged.hpp"
#include "tests/specimen/changed_file.hpp"

namespace specimen_file_read_test {

using specimen::read_specimen;
using test::remove;
using test::replace;
using test::set_attribute;
using ::testing::EndsWith;
using ::testing::StartsWith;

using SpecimenFileRead = test::ChangedFile;

TEST_F(SpecimenFileRead, NamesAFileThatIsNone) {
  const auto message = [](const std::string& name) -> std::string {
    try {
      std::ignore = read_specimen(name);
    } catch (const specimen::Error& error) {
      return error.what();
    }
    return "was read";
  };
  EXPECT_EQ(message(folder / "none.h5"),
            (folder / "none.h5") + ": there is no such file; must be a specimen");
  EXPECT_EQ(message(folder / ""), (folder / "") + ": is not a regular file; must be a specimen");
  test::write_text(folder / "picture.png", "\x89PNG\r\n");
  EXPECT_EQ(message(folder / "picture.png"),
            (folder / "picture.png") +
                ": is not an HDF5 file; must be a specimen; make one from a picture with: mesopix convert");
}

/// Its bookkeeping has checksums, and so have its values.
TEST_F(SpecimenFileRead, ShowsEveryFlippedBit) {
  int refused = 0;
  test::flip_random_bits(test::read_text(path), 2000, [&](const std::string& bytes) {
    test::write_text(path, bytes);
    try {
      test::expect_equal(read_specimen(path), test::sample_specimen());
    } catch (const specimen::Error&) {
      ++refused;
    }
  });
  EXPECT_GT(refused, 500);
}

TEST_F(SpecimenFileRead, RefusesAnotherHdf5File) {
  EXPECT_EQ(verdict([](hid_t f) { H5Adelete(f, "format"); }),
            "/@format: is not a mesopix specimen; must be a file that mesopix wrote; make one with: mesopix "
            "generate, or mesopix convert");
  EXPECT_EQ(verdict([](hid_t f) { set_attribute(f, "/", "format_version", H5T_STD_I32LE, 2); }),
            "/@format_version: 2; must be 1; use the version of mesopix that wrote it");
}

TEST_F(SpecimenFileRead, RefusesOtherUnits) {
  const auto set_text = [](hid_t file, const char* object, const char* name, const char* text, bool varies) {
    H5Adelete_by_name(file, object, name, H5P_DEFAULT);
    const hid_t type = H5Tcopy(H5T_C_S1), space = H5Screate(H5S_SCALAR);
    H5Tset_size(type, varies ? H5T_VARIABLE : std::strlen(text));
    const hid_t attribute =
        H5Acreate_by_name(file, object, name, type, space, H5P_DEFAULT, H5P_DEFAULT, H5P_DEFAULT);
    H5Awrite(attribute, type, varies ? static_cast<const void*>(&text) : text);
    H5Aclose(attribute);
    H5Sclose(space);
    H5Tclose(type);
  };
  for (const bool varies : {false, true}) {
    EXPECT_EQ(verdict([&](hid_t f) { set_text(f, "/", "pixel_size_unit", "mm", varies); }),
              "/@pixel_size_unit: 'mm'; must be m; convert the values, or write the specimen again");
    EXPECT_EQ(verdict([&](hid_t f) { set_text(f, "/", "pixel_size_unit", "m", varies); }), "was read");
    EXPECT_THAT(verdict([&](hid_t f) { set_text(f, "/contours/points", "unit", "px", varies); }),
                StartsWith("/contours/points@unit: 'px'; must be m"));
    EXPECT_THAT(verdict([&](hid_t f) { set_text(f, "/rings", "thickness_unit", "um", varies); }),
                StartsWith("/rings@thickness_unit: 'um'; must be m"));
  }
  EXPECT_EQ(verdict([](hid_t f) { H5Adelete(f, "pixel_size_unit"); }), "was read");
}

TEST_F(SpecimenFileRead, NamesWhatIsMissing) {
  for (const char* name :
       {"/labels", "/phases", "/inclusions", "/contours/offsets", "/contours/points", "/rings/offsets",
        "/rings/points", "/rings/inclusion", "/rings", "/provenance", "/provenance/options"})
    EXPECT_THAT(
        verdict([name](hid_t f) { remove(f, name); }),
        testing::AllOf(StartsWith(name), EndsWith(": is missing; must be there; write the specimen again")));
  EXPECT_EQ(verdict([](hid_t f) { H5Adelete(f, "pixel_size"); }),
            "/@pixel_size: is missing; must be there; write the specimen again");
  EXPECT_EQ(verdict([](hid_t f) { H5Adelete_by_name(f, "/rings", "mode", H5P_DEFAULT); }),
            "/rings@mode: is missing; must be there; write the specimen again");
}

TEST_F(SpecimenFileRead, ChecksTheMeaningOfWhatIsThere) {
  const std::vector<unsigned char> labels(48, 6);
  EXPECT_EQ(verdict([&](hid_t f) {
              replace(f, "/labels", H5T_STD_U8LE, {6, 8}, labels.data());
            }),
            "labels: 6 at row 0, column 0; must be below 6, the number of phases");
  EXPECT_EQ(verdict([&](hid_t f) {
              replace(f, "/labels", H5T_STD_U8LE, {0, 8}, nullptr);
            }),
            "labels: 0 x 8 pixels; must be at least 1 x 1");
  EXPECT_EQ(verdict([](hid_t f) { set_attribute(f, "/", "pixel_size", H5T_IEEE_F64LE, -1.0); }),
            "pixel_size: -1.000000 m; must be > 0");
  EXPECT_EQ(verdict([](hid_t f) { set_attribute(f, "/rings", "segments", H5T_STD_I32LE, 1); }),
            "itz.segments: 1; must be >= 3, or 0 = automatic");
  const std::vector<int> owners = {3, 4};
  EXPECT_EQ(verdict([&](hid_t f) { replace(f, "/rings/inclusion", H5T_STD_I32LE, {2}, owners.data()); }),
            "rings[1].inclusion: 4; must be the id of an inclusion");
}

TEST_F(SpecimenFileRead, RefusesAnUnknownItzMode) {
  EXPECT_EQ(verdict([](hid_t f) {
              const hid_t type = H5Tcopy(H5T_C_S1);
              H5Tset_size(type, 4);
              set_attribute(f, "/rings", "mode", type, std::array<char, 4>{'h', 'a', 'l', 'o'});
              H5Tclose(type);
            }),
            "/rings@mode: 'halo'; must be ring, points or none");
}

TEST_F(SpecimenFileRead, RefusesOffsetsThatDoNotFit) {
  const auto offsets = [this](std::vector<std::int64_t> values) {
    return verdict(
        [&](hid_t f) { replace(f, "/rings/offsets", H5T_STD_I64LE, {values.size()}, values.data()); });
  };
  EXPECT_EQ(offsets({0, 4, 7}), "was read");
  const char* const order = "/rings/offsets: out of order; must rise from 0 to the number of points";
  EXPECT_EQ(offsets({0, 8, 7}), order);
  EXPECT_EQ(offsets({-3, 4, 7}), order);
  EXPECT_EQ(offsets({0, 4, 8}), order);
  EXPECT_EQ(offsets({0, std::numeric_limits<std::int64_t>::min(), 7}), order);
  EXPECT_EQ(offsets({0, 7}), "/rings/offsets: 2 values; must be 3");
  const std::vector<double> points(21);
  EXPECT_EQ(verdict([&](hid_t f) {
              replace(f, "/rings/points", H5T_IEEE_F64LE, {7, 3}, points.data());
            }),
            "/rings/points: 7 x 3 values; must be rows of x and y");
}

/// Whatever bit of the file turns over (one in every third byte is tried), the specimen is the one that was
/// written or there is none.
TEST_F(SpecimenFileRead, NoDamagedByteGivesAnotherSpecimen) {
  const std::string good = test::read_text(path);
  std::size_t refused = 0;
  for (std::size_t i = 0; i < good.size(); i += 3) {
    std::string bytes = good;
    bytes[i] = static_cast<char>(bytes[i] ^ (1 << i % 8));
    test::write_text(path, bytes);
    try {
      test::expect_equal(read_specimen(path), test::sample_specimen());
      ASSERT_FALSE(HasFailure()) << "byte " << i;
    } catch (const specimen::Error&) {
      ++refused;
    }
  }
  EXPECT_GT(refused, good.size() / 12) << "most of the file is padding?";
}

TEST_F(SpecimenFileRead, RefusesAFileThatWasCutShort) {
  const std::string good = test::read_text(path);
  for (const std::size_t length : {good.size() - 1, good.size() / 2, std::size_t{100}, std::size_t{9}}) {
    test::write_text(path, good.substr(0, length));
    EXPECT_THAT(verdict(), testing::Not("was read")) << length << " bytes";
  }
}

TEST_F(SpecimenFileRead, NamesTheChecksumThatFails) {
  const std::string good = test::read_text(path);
  hid_t file = H5Fopen(path.c_str(), H5F_ACC_RDONLY, H5P_DEFAULT);
  const hid_t labels = H5Dopen2(file, "/labels", H5P_DEFAULT);
  const std::array<hsize_t, 2> origin = {0, 0};
  unsigned mask = 0;
  haddr_t address = 0;
  hsize_t size = 0;
  ASSERT_GE(H5Dget_chunk_info_by_coord(labels, origin.data(), &mask, &address, &size), 0);
  H5Dclose(labels);
  H5Fclose(file);
  std::string bytes = good;
  bytes[address + size / 2] = static_cast<char>(bytes[address + size / 2] ^ 4);
  test::write_text(path, bytes);
  EXPECT_THAT(verdict(), StartsWith("/labels: data error detected by Fletcher32 checksum"));
}

}  // namespace specimen_file_read_test
