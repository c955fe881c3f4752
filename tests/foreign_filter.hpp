/// Filters of HDF5 that no reader of ours may run.
#pragma once

#include <gtest/gtest.h>
#include <hdf5.h>

#include <vector>

namespace test {

/// A filter such as a plug-in brings, known to HDF5 for as long as this object lives. It leaves the data as
/// they are, and counts how often it is asked to unpack them.
class ForeignFilter {
 public:
  static constexpr H5Z_filter_t id = 32001;

  ForeignFilter() {
    const H5Z_class2_t filter{H5Z_CLASS_T_VERS, id, 1, 1, "foreign", nullptr, nullptr, &ForeignFilter::run};
    unpacked_ = 0;
    EXPECT_GE(H5Zregister(&filter), 0);
  }
  ForeignFilter(const ForeignFilter&) = delete;
  ForeignFilter& operator=(const ForeignFilter&) = delete;
  ~ForeignFilter() { EXPECT_GE(H5Zunregister(id), 0); }

  [[nodiscard]] static int unpacked() { return unpacked_; }

 private:
  static std::size_t run(unsigned flags, std::size_t, const unsigned*, std::size_t size, std::size_t*,
                         void**) {
    if ((flags & H5Z_FLAG_REVERSE) != 0) ++unpacked_;
    return size;
  }

  static inline int unpacked_ = 0;
};

/// szip with the parameters that H5Pset_szip() would give it, for chunks of an even number of values. HDF5
/// reads as many whether or not they are there; an HDF5 without szip takes them for those of a filter that it
/// need not know.
inline void pack_by_szip(hid_t options) {
  const std::vector<unsigned> parameters{H5_SZIP_NN_OPTION_MASK, 2};  // pixels a block
  EXPECT_GE(H5Pset_filter(options, H5Z_FILTER_SZIP, H5Z_FLAG_OPTIONAL, parameters.size(), parameters.data()),
            0);
}

}  // namespace test
