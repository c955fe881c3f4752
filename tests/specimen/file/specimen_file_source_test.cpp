// The storage of a file that is out to harm its reader: extents, types, links, filters, missing pieces.
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <hdf5.h>
#include <sys/stat.h>

#include <array>
#include <cstring>
#include <functional>

#include "specimen/file/specimen_file_source.hpp"
#include "tests/foreign_filter.hpp"
#include "tests/specimen/changed_file.hpp"

namespace specimen_file_source_test {

using SpecimenFileSource = test::ChangedFile;
using specimen::hdf5::heaps_are_sound;
using test::Extent;
using test::replace;

/// Creation options of a dataset.
struct Options {
  hid_t id = H5Pcreate(H5P_DATASET_CREATE);
  Options() = default;
  Options(const Options&) = delete;
  Options& operator=(const Options&) = delete;
  ~Options() { H5Pclose(id); }
};

TEST_F(SpecimenFileSource, RefusesAbsurdExtentsBeforeItAsksForMemory) {
  const auto labels = [this](const Extent& extent) {
    const Options options;
    const Extent chunk(extent.size(), 16);
    H5Pset_chunk(options.id, static_cast<int>(chunk.size()), chunk.data());
    return verdict([&](hid_t f) { replace(f, "/labels", H5T_STD_U8LE, extent, nullptr, options.id); });
  };
  EXPECT_EQ(labels({1'000'000, 1'000'000}), "/labels: 1000000 x 1000000 values; must be at most 200000000");
  constexpr hsize_t huge = hsize_t{1} << 32U;  // huge * huge is 0 in 64 bits
  EXPECT_EQ(labels({huge, huge}), "/labels: 4294967296 x 4294967296 values; must be at most 200000000");
  EXPECT_EQ(labels({48}), "/labels: 1 dimensions; must be 2");
}

TEST_F(SpecimenFileSource, RefusesAWideAndEmptyPicture) {
  EXPECT_EQ(verdict([](hid_t f) {
              replace(f, "/labels", H5T_STD_U8LE, {0, hsize_t{1} << 40U});
            }),
            "/labels: 0 x 1099511627776 pixels; must be at least 1 x 1");
}

TEST_F(SpecimenFileSource, RefusesHugeTextsAndHugeChunks) {
  const hid_t text = H5Tcopy(H5T_C_S1);
  H5Tset_size(text, std::size_t{1} << 30U);
  EXPECT_EQ(verdict([&](hid_t f) { replace(f, "/phases", text, {4}); }),
            "/phases: 1073741824 bytes per text; must be at most 16777216");
  H5Tset_size(text, std::size_t{1} << 20U);
  EXPECT_EQ(verdict([&](hid_t f) {
              const Options options;
              const hsize_t one = 1;
              H5Pset_chunk(options.id, 1, &one);
              H5Pset_alloc_time(options.id, H5D_ALLOC_TIME_EARLY);
              H5Pset_deflate(options.id, 1);
              replace(f, "/phases", text, {17}, nullptr, options.id);
            }),
            "/phases: 17 texts of 1048576 bytes; must be at most 16777216 bytes together");
  H5Tclose(text);
  EXPECT_EQ(verdict([](hid_t f) {
              const Options options;
              const Extent chunk = {10'000, 10'000};
              H5Pset_chunk(options.id, 2, chunk.data());
              replace(f, "/labels", H5T_STD_U8LE, {10'000, 10'000}, nullptr, options.id);
            }),
            "/labels: chunks of 10000 x 10000; must be at most 64 MiB");
}

TEST_F(SpecimenFileSource, RefusesOtherTypes) {
  const char* const typed = ": holds values of another type; must be as mesopix writes it";
  EXPECT_EQ(verdict([](hid_t f) {
              replace(f, "/labels", H5T_STD_I32LE, {6, 8});
            }),
            std::string("/labels") + typed);
  EXPECT_EQ(verdict([](hid_t f) { replace(f, "/inclusions", H5T_IEEE_F64LE, {2}); }),
            std::string("/inclusions") + typed);
  EXPECT_EQ(verdict([](hid_t f) { replace(f, "/phases", H5T_STD_U8LE, {6}); }),
            "/phases: holds values of another type; must be text of fixed length");
  EXPECT_EQ(verdict([](hid_t f) {
              const hid_t text = H5Tcopy(H5T_C_S1);
              H5Tset_size(text, H5T_VARIABLE);
              replace(f, "/phases", text, {6});
              H5Tclose(text);
            }),
            "/phases: holds values of another type; must be text of fixed length");
  EXPECT_EQ(verdict([](hid_t f) {
              H5Ldelete(f, "/labels", H5P_DEFAULT);
              H5Gclose(H5Gcreate2(f, "/labels", H5P_DEFAULT, H5P_DEFAULT, H5P_DEFAULT));
            }),
            "/labels: is another kind of object; must be a dataset");
}

TEST_F(SpecimenFileSource, RefusesOtherAttributes) {
  const auto attribute = [this](hid_t type, hid_t space) {
    return verdict([&](hid_t f) {
      H5Adelete(f, "pixel_size");
      H5Aclose(H5Acreate2(f, "pixel_size", type, space, H5P_DEFAULT, H5P_DEFAULT));
    });
  };
  const hid_t scalar = H5Screate(H5S_SCALAR);
  const hsize_t two = 2;
  const hid_t list = H5Screate_simple(1, &two, nullptr);
  EXPECT_EQ(attribute(H5T_IEEE_F32LE, scalar),
            "/@pixel_size: holds a value of another type; must be as mesopix writes it");
  EXPECT_EQ(attribute(H5T_IEEE_F64LE, list), "/@pixel_size: is a list; must be one value");
  H5Sclose(list);
  H5Sclose(scalar);
}

TEST_F(SpecimenFileSource, FollowsNoLinks) {
  write_specimen(folder / "other.h5", test::sample_specimen());
  EXPECT_EQ(verdict([](hid_t f) {
              H5Ldelete(f, "/labels", H5P_DEFAULT);
              H5Lcreate_external("other.h5", "/labels", f, "/labels", H5P_DEFAULT, H5P_DEFAULT);
            }),
            "/labels: is reached by a soft or external link; must be part of the file itself");
  EXPECT_EQ(verdict([](hid_t f) {
              H5Lmove(f, "/rings", f, "/hoops", H5P_DEFAULT, H5P_DEFAULT);
              H5Lcreate_soft("/hoops", f, "/rings", H5P_DEFAULT, H5P_DEFAULT);
            }),
            "/rings: is reached by a soft or external link; must be part of the file itself");
  EXPECT_EQ(verdict([](hid_t f) {
              H5Ldelete(f, "/contours", H5P_DEFAULT);
              H5Lcreate_external("other.h5", "/contours", f, "/contours", H5P_DEFAULT, H5P_DEFAULT);
            }),
            "/contours/offsets: is reached by a soft or external link; must be part of the file itself");
}

TEST_F(SpecimenFileSource, ReadsNoOtherFile) {
  const char* const elsewhere = "/labels: has its data outside the file; must be part of the file itself";
  test::write_text(folder / "secret", std::string(48, '\1'));
  EXPECT_EQ(verdict([this](hid_t f) {
              const Options options;
              H5Pset_external(options.id, (folder / "secret").c_str(), 0, 48);
              replace(f, "/labels", H5T_STD_U8LE, {6, 8}, nullptr, options.id);
            }),
            elsewhere);
  write_specimen(folder / "other.h5", test::sample_specimen());
  EXPECT_EQ(verdict([this](hid_t f) {
              const Options options;
              const Extent extent = {6, 8};
              const hid_t space = H5Screate_simple(2, extent.data(), nullptr);
              H5Pset_virtual(options.id, space, (folder / "other.h5").c_str(), "/labels", space);
              replace(f, "/labels", H5T_STD_U8LE, extent, nullptr, options.id);
              H5Sclose(space);
            }),
            elsewhere);
}

/// One of a plug-in, and szip, which divides by zero where a file gives it no parameters.
TEST_F(SpecimenFileSource, RunsNoFilterButThoseOfSpecimens) {
  const test::ForeignFilter foreign;
  const auto packed = [this](const std::function<void(hid_t)>& pack) {
    return verdict([&](hid_t f) {
      const Options options;
      const Extent chunk = {6, 8};
      const std::array<unsigned char, 48> zeros{};
      H5Pset_chunk(options.id, 2, chunk.data());
      pack(options.id);
      replace(f, "/labels", H5T_STD_U8LE, {6, 8}, zeros.data(), options.id);
    });
  };
  EXPECT_EQ(packed([](hid_t options) {
              H5Pset_filter(options, test::ForeignFilter::id, H5Z_FLAG_MANDATORY, 0, nullptr);
            }),
            "/labels: filter 32001; must be gzip, shuffle or fletcher32, each of them once");
  EXPECT_EQ(foreign.unpacked(), 0);
  EXPECT_EQ(packed(test::pack_by_szip),
            "/labels: filter 4; must be gzip, shuffle or fletcher32, each of them once");
}

/// HDF5 opens the sources of a view to know how far it reaches, and would wait for ever for one that is a
/// pipe.
TEST_F(SpecimenFileSource, DoesNotLookHowFarAViewReaches) {
  const std::string pipe = folder / "pipe";
  ASSERT_EQ(::mkfifo(pipe.c_str(), 0600), 0);
  EXPECT_EQ(verdict([&](hid_t f) {
              const Options view;
              const Extent extent = {6, 8}, endless = {H5S_UNLIMITED, 8}, first = {0, 0}, one = {1, 1};
              const hid_t space = H5Screate_simple(2, extent.data(), endless.data());
              H5Sselect_hyperslab(space, H5S_SELECT_SET, first.data(), nullptr, one.data(), endless.data());
              H5Pset_virtual(view.id, space, pipe.c_str(), "/labels", space);
              test::remove(f, "/labels");
              const hid_t labels =
                  H5Dcreate2(f, "/labels", H5T_STD_U8LE, space, H5P_DEFAULT, view.id, H5P_DEFAULT);
              ASSERT_GE(labels, 0);
              H5Dclose(labels);
              H5Sclose(space);
            }),
            "/labels: has its data outside the file; must be part of the file itself");
}

TEST_F(SpecimenFileSource, UnpacksNothingTwice) {
  EXPECT_EQ(verdict([](hid_t f) {
              const Options options;
              const Extent chunk = {6, 8};
              const std::array<unsigned char, 48> ones{};
              H5Pset_chunk(options.id, 2, chunk.data());
              for (const unsigned level : {9U, 9U})
                H5Pset_filter(options.id, H5Z_FILTER_DEFLATE, H5Z_FLAG_MANDATORY, 1, &level);
              replace(f, "/labels", H5T_STD_U8LE, {6, 8}, ones.data(), options.id);
            }),
            "/labels: filter 1; must be gzip, shuffle or fletcher32, each of them once");
}

/// HDF5 reads what was never written as zeros, and zero is the label of void.
TEST_F(SpecimenFileSource, TakesNoZerosForWhatWasNeverWritten) {
  EXPECT_EQ(verdict([](hid_t f) {
              replace(f, "/labels", H5T_STD_U8LE, {6, 8});
            }),
            "/labels: was never written; must be complete; write the specimen again");
  EXPECT_EQ(verdict([](hid_t f) {
              const Options options;
              const Extent chunk = {3, 3};
              H5Pset_chunk(options.id, 2, chunk.data());
              replace(f, "/labels", H5T_STD_U8LE, {6, 8}, nullptr, options.id);
              const hid_t labels = H5Dopen2(f, "/labels", H5P_DEFAULT);
              const Extent origin = {0, 0};
              const std::array<unsigned char, 9> ones{};
              H5Dwrite_chunk(labels, H5P_DEFAULT, 0, origin.data(), ones.size(), ones.data());
              H5Dclose(labels);
            }),
            "/labels: 1 of 6 chunks are there; must be complete; write the specimen again");
}

// Heaps with lengths that HDF5 itself would follow anywhere, in a specimen whose labels are a view.

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
      "lengths in a heap of its texts are wrong; the file is damaged: use a copy, or make the "
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

}  // namespace specimen_file_source_test
