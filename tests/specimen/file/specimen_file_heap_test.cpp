// Heaps with lengths that HDF5 itself would follow anywhere, in a specimen whose labels are a view.
#include "specimen/file/specimen_file_source.hpp"

#include <gtest/gtest.h>
#include <hdf5.h>

#include <cstring>

#include "tests/specimen/changed_file.hpp"

namespace specimen_file_heap_test {

using specimen::hdf5::heaps_are_sound;

class SpecimenFileHeap : public test::ChangedFile {
 protected:
  /// What the reader says when the first object of the heap has this number and this length.
  std::string with_object(std::uint16_t number, std::uint64_t length) const {
    (void)verdict([](hid_t f) {
      const hid_t view = H5Pcreate(H5P_DATASET_CREATE);
      const test::Extent extent = {6, 8};
      const hid_t space = H5Screate_simple(2, extent.data(), nullptr);
      H5Pset_virtual(view, space, "other.h5", "/labels", space);
      test::replace(f, "/labels", H5T_STD_U8LE, extent, nullptr, view);
      H5Sclose(space);
      H5Pclose(view);
    });
    std::string bytes = test::read_text(path);
    const std::size_t heap = bytes.find("GCOL");
    if (heap == std::string::npos) return "there is no heap";
    std::memcpy(&bytes[heap + 16], &number, sizeof number);
    std::memcpy(&bytes[heap + 24], &length, sizeof length);
    test::write_text(path, bytes);
    return verdict();
  }
};

TEST_F(SpecimenFileHeap, OfASpecimenIsSound) { EXPECT_TRUE(heaps_are_sound(path)); }

TEST_F(SpecimenFileHeap, ThatHasNoEndIsRefused) {
  const std::string refused =
      "lengths in a heap of its texts are wrong; the file is damaged: take a copy of it, or make the "
      "specimen again";
  EXPECT_EQ(with_object(0, 0), refused);
  EXPECT_EQ(with_object(1, ~std::uint64_t{0} - 15), refused);
  EXPECT_EQ(with_object(1, 1U << 20U), refused);
}

/// To go through each of them to its end would take hours.
TEST_F(SpecimenFileHeap, OverOthersIsRefused) {
  std::string bytes;
  constexpr std::uint64_t objects = 20'000, length = 48, first_part = 16;
  for (std::uint64_t i = 0; i < objects; ++i) {
    const std::uint64_t rest = (objects - i) * length - first_part, inside = length - first_part;
    std::string object("\1\0\0\0\0\0\0\0........GCOL\1\0\0\0........\1\0\0\0\0\0\0\0\0\0\0\0\0\0\0\0",
                       length);
    std::memcpy(&object[8], &inside, sizeof inside);
    std::memcpy(&object[24], &rest, sizeof rest);  // a heap that goes on with all objects that follow
    bytes += object;
  }
  test::write_text(path, bytes);
  EXPECT_FALSE(heaps_are_sound(path));
  test::write_text(path, bytes.substr(bytes.size() - length));
  EXPECT_TRUE(heaps_are_sound(path)) << "one of them is sound";
}

}  // namespace specimen_file_heap_test
