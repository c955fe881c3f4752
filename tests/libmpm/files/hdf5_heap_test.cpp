// The heap of the texts in a result file, with lengths that HDF5 itself would follow anywhere.
#include "libmpm/files/hdf5_read.hpp"

#include <gmock/gmock.h>

#include <cstring>

#include "tests/libmpm/sample_results.hpp"

namespace hdf5_heap_test {

using mpm::hdf5::heaps_are_sound;
using testing::HasSubstr;

/// Writes a number over bytes.
template <class Number>
void put(std::string& bytes, std::size_t place, Number number) {
  std::memcpy(&bytes[place], &number, sizeof number);
}

class Hdf5Heap : public samples::ResultFileTest {
 protected:
  void SetUp() override {
    ResultFileTest::SetUp();
    mpm::write_result(path_, samples::odd_result(), "[loading]\n");
    good_ = bytes_of(path_);
    heap_ = good_.find("GCOL");
    ASSERT_NE(heap_, std::string::npos);
  }

  void hold(const std::string& bytes) const {
    std::filesystem::remove(path_);
    std::ofstream(path_, std::ios::binary) << bytes;
  }

  /// What the reader says with a number of 16 or 64 bits in the place of another, counted from the heap.
  template <class Number>
  std::string verdict(std::size_t place, Number number) const {
    std::string bytes = good_;
    put(bytes, heap_ + place, number);
    hold(bytes);
    return complaint();
  }

  std::string good_;
  std::size_t heap_ = 0;
};

constexpr std::size_t size_of_heap = 8, first_number = 16, first_length = 24;
constexpr const char* wrong = "lengths in a heap of its texts are wrong";

TEST_F(Hdf5Heap, ThatIsSoundIsRead) { EXPECT_EQ(complaint(), "nothing"); }

TEST_F(Hdf5Heap, WithObjectsThatEndNowhereIsRefused) {
  for (const std::uint64_t length :
       {std::uint64_t{1} << 20U, ~std::uint64_t{0}, ~std::uint64_t{0} - 15, std::uint64_t{1} << 63U})
    EXPECT_THAT(verdict(first_length, length), HasSubstr(wrong)) << length;
}

/// HDF5 would stand still at free space of no length.
TEST_F(Hdf5Heap, WithFreeSpaceOfNoLengthIsRefused) {
  put(good_, heap_ + first_number, std::uint16_t{0});
  EXPECT_THAT(verdict(first_length, std::uint64_t{0}), HasSubstr(wrong));
}

TEST_F(Hdf5Heap, TooSmallForItsObjectsIsRefused) {
  for (const std::uint64_t size : {8, 40}) EXPECT_THAT(verdict(size_of_heap, size), HasSubstr(wrong)) << size;
}

/// Its letters may as well stand in the data by chance, so that the heap itself is no fault.
TEST_F(Hdf5Heap, LargerThanItsFileIsLeftToHdf5WhichRefusesIt) {
  for (const std::uint64_t size :
       {std::uint64_t{0}, std::uint64_t{good_.size()}, std::uint64_t{2 * good_.size()}})
    EXPECT_THAT(verdict(size_of_heap, size), HasSubstr("attribute format cannot be read")) << size;
}

TEST_F(Hdf5Heap, ThatIsNoneIsNoFault) {
  hold(good_ + std::string("GCOL\1 such letters in the data", 30) + "GCOL\1");
  EXPECT_TRUE(heaps_are_sound(path_));
  EXPECT_EQ(complaint(), "nothing");
}

/// To go through each of them to its end would take hours.
TEST_F(Hdf5Heap, OverOthersIsRefused) {
  constexpr std::size_t objects = 20'000, length = 48;
  std::string bytes(objects * length, '\0');
  for (std::size_t at = 0; at < bytes.size(); at += length) {
    put(bytes, at, std::uint16_t{1});
    put(bytes, at + 8, std::uint64_t{32});
    bytes.replace(at + 16, 5, "GCOL\1");  // the object holds a heap that goes on with all that follow
    put(bytes, at + 24, std::uint64_t{bytes.size() - at - 16});
    put(bytes, at + 32, std::uint16_t{1});
  }
  hold(bytes);
  EXPECT_FALSE(heaps_are_sound(path_));
  bytes = bytes.substr(bytes.size() - length);
  hold(bytes);
  EXPECT_TRUE(heaps_are_sound(path_)) << "one of them is sound";
}

TEST_F(Hdf5Heap, OfAFileThatIsNotThereIsNoMatterOfTheHeap) {
  EXPECT_TRUE(heaps_are_sound(folder_ / "none.h5"));
}

}  // namespace hdf5_heap_test
