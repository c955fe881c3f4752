// The heap of the texts in a result file, with lengths that HDF5 itself would follow anywhere.
#include "libmpm/hdf5_heap.hpp"

#include <gmock/gmock.h>

#include <cstring>

#include "tests/libmpm/sample_results.hpp"

namespace {

using testing::HasSubstr;

class Hdf5Heap : public samples::ResultFileTest {
 protected:
  void SetUp() override {
    ResultFileTest::SetUp();
    mpm::write_result(path_, samples::odd_result(), "[loading]\n");
    good_ = bytes_of(path_);
    heap_ = good_.find("GCOL");
    ASSERT_NE(heap_, std::string::npos);
  }

  /// What the reader says with a number of 16 or 64 bits in the place of another, counted from the heap.
  template <class Number>
  std::string verdict(std::size_t place, Number number) const {
    std::string bytes = good_;
    std::memcpy(&bytes[heap_ + place], &number, sizeof number);
    std::filesystem::remove(path_);
    std::ofstream(path_, std::ios::binary) << bytes;
    return complaint();
  }

  std::string good_;
  std::size_t heap_ = 0;
};

constexpr std::size_t size_of_heap = 8, first_number = 16, first_length = 24;

TEST_F(Hdf5Heap, ThatIsSoundIsRead) { EXPECT_EQ(complaint(), "nothing"); }

TEST_F(Hdf5Heap, WithObjectsThatEndNowhereIsRefused) {
  for (const std::uint64_t length :
       {std::uint64_t{1} << 20U, ~std::uint64_t{0}, ~std::uint64_t{0} - 15, std::uint64_t{1} << 63U})
    EXPECT_THAT(verdict(first_length, length), HasSubstr("its texts are damaged")) << length;
}

/// HDF5 would stand still at free space of no length.
TEST_F(Hdf5Heap, WithFreeSpaceOfNoLengthIsRefused) {
  std::uint64_t free_space = 0;
  std::memcpy(&good_[heap_ + first_number], &free_space, 2);
  EXPECT_THAT(verdict(first_length, free_space), HasSubstr("its texts are damaged"));
}

TEST_F(Hdf5Heap, LargerThanItsFileIsRefused) {
  EXPECT_THAT(verdict(size_of_heap, std::uint64_t{good_.size()}), HasSubstr("its texts are damaged"));
  EXPECT_THAT(verdict(size_of_heap, std::uint64_t{0}), HasSubstr("its texts are damaged"));
}

TEST_F(Hdf5Heap, OfAFileThatIsNotThereIsNoMatterOfTheHeap) {
  EXPECT_NO_THROW(mpm::hdf5::require_sound_heaps(folder_ / "none.h5"));
}

}  // namespace
