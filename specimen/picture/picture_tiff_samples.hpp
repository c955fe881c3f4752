/// What a TIFF says about its pixels, and how the values of one sample come out of a row of them.
#pragma once

#include <tiffio.h>

#include <cstddef>
#include <cstdint>
#include <vector>

#include "specimen/picture/picture_file.hpp"

namespace specimen {

struct TiffTags {
  int rows = 0, cols = 0, samples = 1;  ///< samples a pixel, extra ones (opacity) included
  int bits = 1;                         ///< per sample
  int format = SAMPLEFORMAT_UINT, photometric = PHOTOMETRIC_MINISBLACK;
  int orientation = ORIENTATION_TOPLEFT, planes = PLANARCONFIG_CONTIG;
  std::vector<int> extra{};  ///< meaning of each sample after the colours, as EXTRASAMPLE_...
  [[nodiscard]] bool one_channel() const {
    return photometric == PHOTOMETRIC_MINISBLACK || photometric == PHOTOMETRIC_MINISWHITE ||
           photometric == PHOTOMETRIC_MASK || photometric == PHOTOMETRIC_PALETTE;
  }
  /// Samples from one pixel to the next in the rows that are read.
  [[nodiscard]] std::size_t step() const {
    return planes == PLANARCONFIG_CONTIG ? static_cast<std::size_t>(samples) : 1;
  }
};

/// @throws Error for a picture that is too large, or whose pixels cannot be in the file.
[[nodiscard]] TiffTags read_tags(TIFF* tiff, const PictureSource& source);

/// Values of one sample out of a row of interleaved ones.
/// @param row  from the first value.   @param step  samples from one pixel to the next.
using Unpack = void (*)(const std::uint8_t* row, std::size_t step, int count, double* values);

/// @throws Error for samples of a depth or format that is not read.
[[nodiscard]] Unpack choose_unpack(const TiffTags& tags, const PictureSource& source);

}  // namespace specimen
