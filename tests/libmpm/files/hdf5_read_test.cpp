// The storage of a file that is damaged or out to harm its reader, tried with frames.
#include "libmpm/files/hdf5_read.hpp"

#include <gmock/gmock.h>
#include <sys/stat.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstring>
#include <fstream>
#include <functional>

#include "libmpm/files/hdf5_write.hpp"
#include "libmpm/files/table_file.hpp"
#include "tests/damaged.hpp"
#include "tests/foreign_filter.hpp"
#include "tests/libmpm/sample_frames.hpp"
#include "tests/libmpm/sample_results.hpp"
#include "tests/specimen/temporary_folder.hpp"

namespace hdf5_read_test {

namespace fs = std::filesystem;
using samples::Creation;
using samples::odd_frame;
using testing::HasSubstr;
using Hdf5Read = samples::FrameFileTest;
using mpm::hdf5::heaps_are_sound;

TEST_F(Hdf5Read, AsksForNoMemoryThatAnExtentOnlyClaims) {
  constexpr hsize_t huge = hsize_t{1} << 40U;
  EXPECT_THAT(
      verdict([](hid_t f) { create(f, "VTKHDF/PointData/id", H5T_STD_I32LE, {huge}, H5P_DEFAULT, nullptr); }),
      HasSubstr("dataset id has an extent that its data do not fill"));
  EXPECT_THAT(verdict([](hid_t f) {
                create(f, "VTKHDF/PointData/stress", H5T_IEEE_F32LE, {huge, huge}, H5P_DEFAULT, nullptr);
              }),
              HasSubstr("dataset stress has an extent that its data do not fill"));
  EXPECT_THAT(verdict([](hid_t f) {
                const Creation chunked;
                const hsize_t chunk = 1 << 25;
                H5Pset_chunk(chunked.id, 1, &chunk);
                H5Pset_deflate(chunked.id, 9);
                H5Pset_alloc_time(chunked.id, H5D_ALLOC_TIME_EARLY);
                create(f, "VTKHDF/PointData/id", H5T_STD_I32LE, {chunk}, chunked.id, nullptr);
              }),
              HasSubstr("dataset id has chunks of more than 64 MiB"));
}

/// The same chunk of zeros over and over: a small file of very many ids.
void fill_with_zeros(hid_t file, const char* name, hsize_t chunk, hsize_t chunks) {
  const Creation packed;
  H5Pset_chunk(packed.id, 1, &chunk);
  H5Pset_deflate(packed.id, 1);
  const hsize_t extent = chunk * chunks;
  const hid_t space = H5Screate_simple(1, &extent, nullptr);
  const hid_t dataset = H5Dcreate2(file, name, H5T_STD_I32LE, space, H5P_DEFAULT, packed.id, H5P_DEFAULT);
  const hsize_t origin = 0;
  H5Sselect_hyperslab(space, H5S_SELECT_SET, &origin, nullptr, &chunk, nullptr);
  const hid_t memory = H5Screate_simple(1, &chunk, nullptr);
  const std::vector<std::int32_t> zeros(chunk);
  H5Dwrite(dataset, H5T_NATIVE_INT32, memory, space, H5P_DEFAULT, zeros.data());
  H5Dflush(dataset);
  hsize_t size = 0;
  H5Dget_chunk_storage_size(dataset, &origin, &size);
  std::vector<char> bytes(size);
  std::uint32_t filters = 0;
  H5Dread_chunk(dataset, H5P_DEFAULT, &origin, &filters, bytes.data());
  for (hsize_t at = chunk; at < extent; at += chunk)
    H5Dwrite_chunk(dataset, H5P_DEFAULT, 0, &at, size, bytes.data());
  H5Sclose(memory);
  H5Dclose(dataset);
  H5Sclose(space);
}

TEST_F(Hdf5Read, RefusesMorePointsThanAnyRunHas) {
  EXPECT_THAT(verdict([](hid_t f) {
                H5Ldelete(f, "VTKHDF/PointData/id", H5P_DEFAULT);
                fill_with_zeros(f, "VTKHDF/PointData/id", hsize_t{1} << 24U, 12);
              }),
              HasSubstr("dataset id has more than 200000000 values"));
}

TEST_F(Hdf5Read, FollowsNoLinks) {
  mpm::write_frame(folder_ / "other.hdf", odd_frame(), scene_);
  for (const std::string name : {"VTKHDF", "VTKHDF/PointData", "VTKHDF/PointData/stress", "VTKHDF/FieldData"})
    EXPECT_THAT(verdict([&](hid_t f) {
                  H5Ldelete(f, name.c_str(), H5P_DEFAULT);
                  H5Lcreate_external("other.hdf", name.c_str(), f, name.c_str(), H5P_DEFAULT, H5P_DEFAULT);
                }),
                HasSubstr(" is a link, not part of the file itself"))
        << name;
}

TEST_F(Hdf5Read, ReadsNoOtherFile) {
  const char* const damage = "VTKHDF/PointData/damage";
  const char* const elsewhere = "dataset damage keeps its data in another file";
  std::ofstream(folder_ / "secret") << std::string(8, '\0');
  EXPECT_THAT(verdict([&](hid_t f) {
                const Creation outside;
                H5Pset_external(outside.id, (folder_ / "secret").c_str(), 0, 8);
                create(f, damage, H5T_IEEE_F32LE, {2}, outside.id, nullptr);
              }),
              HasSubstr(elsewhere));
  EXPECT_THAT(verdict([&](hid_t f) {
                const Creation views;
                const hsize_t two = 2;
                const hid_t space = H5Screate_simple(1, &two, nullptr);
                H5Pset_virtual(views.id, space, (folder_ / "other.hdf").c_str(), damage, space);
                create(f, damage, H5T_IEEE_F32LE, {2}, views.id, nullptr);
                H5Sclose(space);
              }),
              HasSubstr(elsewhere));
}

/// One of a plug-in, and szip, which divides by zero where a file gives it no parameters.
TEST_F(Hdf5Read, RunsNoFilterButThoseOfResults) {
  const test::ForeignFilter foreign;
  const auto packed = [this](const std::function<void(hid_t)>& pack) {
    return verdict([&](hid_t f) {
      const Creation options;
      const hsize_t two = 2;
      const std::array<float, 2> zeros{};
      H5Pset_chunk(options.id, 1, &two);
      pack(options.id);
      create(f, "VTKHDF/PointData/damage", H5T_IEEE_F32LE, {2}, options.id, zeros.data());
    });
  };
  const char* const none_of_ours = ", which is not gzip, shuffle or fletcher32";
  EXPECT_THAT(packed([](hid_t options) {
                H5Pset_filter(options, test::ForeignFilter::id, H5Z_FLAG_MANDATORY, 0, nullptr);
              }),
              HasSubstr(std::string("dataset damage is packed by filter 32001") + none_of_ours));
  EXPECT_EQ(foreign.unpacked(), 0);
  EXPECT_THAT(packed(test::pack_by_szip),
              HasSubstr(std::string("dataset damage is packed by filter 4") + none_of_ours));
}

/// HDF5 opens the sources of a view to know how far it reaches, and would wait for ever for one that is a
/// pipe.
TEST_F(Hdf5Read, DoesNotLookHowFarAViewReaches) {
  const std::string pipe = folder_ / "pipe";
  ASSERT_EQ(::mkfifo(pipe.c_str(), 0600), 0);
  EXPECT_THAT(verdict([&](hid_t f) {
                const Creation view;
                const hsize_t two = 2, endless = H5S_UNLIMITED, first = 0, one = 1;
                const hid_t space = H5Screate_simple(1, &two, &endless);
                H5Sselect_hyperslab(space, H5S_SELECT_SET, &first, nullptr, &one, &endless);
                H5Pset_virtual(view.id, space, pipe.c_str(), "damage", space);
                H5Ldelete(f, "VTKHDF/PointData/damage", H5P_DEFAULT);
                const hid_t dataset = H5Dcreate2(f, "VTKHDF/PointData/damage", H5T_IEEE_F32LE, space,
                                                 H5P_DEFAULT, view.id, H5P_DEFAULT);
                ASSERT_GE(dataset, 0);
                H5Dclose(dataset);
                H5Sclose(space);
              }),
              HasSubstr("dataset damage keeps its data in another file"));
}

TEST_F(Hdf5Read, UnpacksNothingTwice) {
  EXPECT_THAT(verdict([&](hid_t f) {
                const Creation packed;
                const hsize_t two = 2;
                const std::array<float, 2> values{};
                H5Pset_chunk(packed.id, 1, &two);
                for (const unsigned level : {9U, 9U})
                  H5Pset_filter(packed.id, H5Z_FILTER_DEFLATE, H5Z_FLAG_MANDATORY, 1, &level);
                create(f, "VTKHDF/PointData/damage", H5T_IEEE_F32LE, {2}, packed.id, values.data());
              }),
              HasSubstr("dataset damage is packed twice by filter 1"));
}

TEST_F(Hdf5Read, TakesNoZerosForChunksThatAreNotThere) {
  EXPECT_THAT(verdict([](hid_t f) {
                const Creation chunked;
                const hsize_t one = 1;
                H5Pset_chunk(chunked.id, 1, &one);
                create(f, "VTKHDF/PointData/damage", H5T_IEEE_F32LE, {2}, chunked.id, nullptr);
                const hid_t dataset = H5Dopen2(f, "VTKHDF/PointData/damage", H5P_DEFAULT);
                const hsize_t origin = 0;
                const float value = 0;
                H5Dwrite_chunk(dataset, H5P_DEFAULT, 0, &origin, sizeof value, &value);
                H5Dclose(dataset);
              }),
              HasSubstr("dataset damage lacks some of its data"));
}

TEST_F(Hdf5Read, NoticesAFlippedBitOfADataset) {
  mpm::Frame frame = odd_frame();
  for (std::uint32_t i = 10; i < 3000; ++i)  // fills the greater part of the file
    frame.points.push_back(
        {.id = i, .sxx = 1e6 * std::sin(i), .syy = 1e6 * std::sin(7 * i), .sxy = 1e6 * std::sin(3 * i)});
  mpm::write_frame(path_, frame, scene_);
  test::write_text(path_, test::unsealed(test::read_text(path_)));
  const hid_t file = H5Fopen(path_.c_str(), H5F_ACC_RDONLY, H5P_DEFAULT);
  const hid_t stress = H5Dopen2(file, "VTKHDF/PointData/stress", H5P_DEFAULT);
  const hid_t space = H5Dget_space(stress);
  haddr_t address = 0;
  hsize_t size = 0;
  H5Dget_chunk_info(stress, space, 0, nullptr, nullptr, &address, &size);
  H5Sclose(space);
  H5Dclose(stress);
  H5Fclose(file);
  std::fstream bytes(path_, std::ios::binary | std::ios::in | std::ios::out);
  const auto place = static_cast<std::streamoff>(address + size / 2);
  bytes.seekg(place);
  const char flipped = static_cast<char>(bytes.get() ^ 1);
  bytes.seekp(place);
  bytes.put(flipped);
  bytes.close();
  EXPECT_THAT(complaint(), HasSubstr("dataset stress is damaged"));
}

TEST_F(Hdf5Read, RefusesOtherUnits) {
  const auto with_unit = [](const char* text) {
    return [text](hid_t f) {
      const hid_t dataset = H5Dopen2(f, "VTKHDF/PointData/stress", H5P_DEFAULT);
      H5Adelete(dataset, "unit");
      if (*text != '\0') mpm::hdf5::write_text(dataset, "unit", text);
      H5Dclose(dataset);
    };
  };
  EXPECT_THAT(verdict(with_unit("MPa")), HasSubstr("dataset stress is in MPa, and must be in Pa"));
  EXPECT_EQ(verdict(with_unit("Pa")), "nothing");
  EXPECT_EQ(verdict(with_unit("")), "nothing") << "as it need not name any";
}

// The heap of the texts in a result file, with lengths that HDF5 itself would follow anywhere.

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
    good_ = test::unsealed(bytes_of(path_));
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

// Files with one bit turned over, anywhere.

class Seal : public samples::ResultFileTest {
 protected:
  /// How many of so many damaged copies of the file are read all the same.
  template <class Read>
  int taken(Read read, int count = 2000) const {
    int all = 0;
    test::flip_random_bits(bytes_of(path_), count, [&](const std::string& bytes) {
      test::write_text(path_, bytes);
      try {
        read(path_);
        ++all;
      } catch (const mpm::FileError& error) {
        EXPECT_EQ(error.field, path_) << "the file is named";
      }
    });
    return all;
  }
};

TEST_F(Seal, ShowsEveryFlippedBitOfAResult) {
  mpm::write_result(path_, samples::odd_result(), "[loading]\n", {"digest", "{}"});
  EXPECT_NO_THROW((void)mpm::read_result(path_));
  EXPECT_EQ(taken([](const std::string& path) { (void)mpm::read_result(path); }), 0);
}

TEST_F(Seal, ShowsEveryFlippedBitOfAFrame) {
  mpm::write_frame(path_, samples::odd_frame(), samples::mortar_block(2, 2), "digest");
  EXPECT_EQ(mpm::read_frame(path_).run, "digest");
  EXPECT_EQ(taken([](const std::string& path) { (void)mpm::read_frame(path); }), 0);
  EXPECT_EQ(taken([](const std::string& path) { (void)mpm::read_frame_heading(path); }, 100), 0);
}

TEST_F(Seal, ShowsEveryFlippedBitOfATable) {
  mpm::write_table(path_, {{"seed", "1", "of the random numbers", std::vector<std::int64_t>{7, 8}},
                           {"peak", "Pa", "of the stress", std::vector<double>{1e6 / 3, 2e6}},
                           {"state", "1", "done or failed", std::vector<std::string>{"done", "failed"}}});
  EXPECT_NO_THROW((void)mpm::read_table(path_));
  EXPECT_EQ(taken([](const std::string& path) { (void)mpm::read_table(path); }), 0);
}

/// The sectors of a disk go by 512 bytes or more.
TEST_F(Seal, ShowsALostEnd) {
  mpm::write_result(path_, samples::odd_result(), "[loading]\n");
  std::string bytes = bytes_of(path_);
  std::fill(bytes.end() - 512, bytes.end(), '\0');
  test::write_text(path_, bytes);
  EXPECT_THAT(complaint(), HasSubstr("is damaged: its digest does not match its bytes"));
}

TEST_F(Seal, IsMissingWhereAnotherProgramHasChangedTheFile) {
  mpm::write_result(path_, samples::odd_result(), "[loading]\n");
  damage([](hid_t file) {
    const hid_t space = H5Screate(H5S_SCALAR);
    H5Aclose(H5Acreate2(file, "note", H5T_STD_I32LE, space, H5P_DEFAULT, H5P_DEFAULT));
    H5Sclose(space);
  });
  EXPECT_EQ(complaint(), "nothing");
}

}  // namespace hdf5_read_test
