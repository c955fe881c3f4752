#include "specimen/picture/picture_tiff_samples.hpp"

#include <cstring>
#include <string>

#include "specimen/body/error.hpp"
#include "specimen/picture/picture_header.hpp"
#include "specimen/picture/picture_tiff_tags.hpp"

namespace specimen {
namespace {

/// Bytes that one byte of a file can become at most; a claim beyond it is refused before memory is asked for.
std::int64_t tightest_packing(int compression) {
  switch (compression) {
    case COMPRESSION_NONE:
      return 1;
    case COMPRESSION_PACKBITS:
      return 64;
    case COMPRESSION_DEFLATE:
    case COMPRESSION_ADOBE_DEFLATE:
      return 1032;
    case COMPRESSION_LZW:
      return 2560;  // a code of 12 bits for the longest string of its table
    default:
      return std::int64_t{1} << 20;
  }
}

template <class T>
void unpack(const std::uint8_t* row, std::size_t step, int count, double* values) {
  for (int i = 0; i < count; ++i) {
    T value;
    std::memcpy(&value, row + static_cast<std::size_t>(i) * step * sizeof(T), sizeof(T));
    values[i] = static_cast<double>(value);
  }
}

template <int bits>
void unpack_bits(const std::uint8_t* row, std::size_t step, int count, double* values) {
  for (int i = 0; i < count; ++i) {
    const std::size_t bit = static_cast<std::size_t>(i) * step * bits;
    values[i] = row[bit / 8] >> (8 - bits - static_cast<int>(bit % 8)) & ((1 << bits) - 1);
  }
}

}  // namespace

TiffTags read_tags(TIFF* tiff, const PictureSource& source) {
  std::uint32_t rows = 0, cols = 0;
  TIFFGetField(tiff, TIFFTAG_IMAGELENGTH, &rows);
  TIFFGetField(tiff, TIFFTAG_IMAGEWIDTH, &cols);
  check_size(source, rows, cols, 0);

  TiffTags tags;
  tags.rows = static_cast<int>(rows);
  tags.cols = static_cast<int>(cols);
  tags.samples = short_tag(tiff, TIFFTAG_SAMPLESPERPIXEL, 1);
  tags.bits = short_tag(tiff, TIFFTAG_BITSPERSAMPLE, 1);
  tags.format = short_tag(tiff, TIFFTAG_SAMPLEFORMAT, SAMPLEFORMAT_UINT);
  tags.photometric =
      short_tag(tiff, TIFFTAG_PHOTOMETRIC, tags.samples >= 3 ? PHOTOMETRIC_RGB : PHOTOMETRIC_MINISBLACK);
  tags.orientation = short_tag(tiff, TIFFTAG_ORIENTATION, ORIENTATION_TOPLEFT);
  tags.planes = short_tag(tiff, TIFFTAG_PLANARCONFIG, PLANARCONFIG_CONTIG);
  std::uint16_t extras = 0;
  const std::uint16_t* kinds = nullptr;
  if (TIFFGetField(tiff, TIFFTAG_EXTRASAMPLES, &extras, &kinds) == 1 && kinds != nullptr)
    tags.extra.assign(kinds, kinds + extras);
  if (tags.samples < 1 || tags.samples > 8)
    throw Error(source.path, "has " + std::to_string(tags.samples) + " channels", "1 to 8 are read");
  const int compression = short_tag(tiff, TIFFTAG_COMPRESSION, COMPRESSION_NONE);
  check_size(source, rows, cols, std::int64_t{rows} * cols * tags.bits / 8 / tightest_packing(compression));
  return tags;
}

Unpack choose_unpack(const TiffTags& tags, const PictureSource& source) {
  const bool is_unsigned = tags.format == SAMPLEFORMAT_UINT || tags.format == SAMPLEFORMAT_VOID;
  const bool is_signed = tags.format == SAMPLEFORMAT_INT, is_float = tags.format == SAMPLEFORMAT_IEEEFP;
  if (is_unsigned && tags.bits == 1) return unpack_bits<1>;
  if (is_unsigned && tags.bits == 2) return unpack_bits<2>;
  if (is_unsigned && tags.bits == 4) return unpack_bits<4>;
  if (is_unsigned && tags.bits == 8) return unpack<std::uint8_t>;
  if (is_unsigned && tags.bits == 16) return unpack<std::uint16_t>;
  if (is_unsigned && tags.bits == 32) return unpack<std::uint32_t>;
  if (is_unsigned && tags.bits == 64) return unpack<std::uint64_t>;
  if (is_signed && tags.bits == 8) return unpack<std::int8_t>;
  if (is_signed && tags.bits == 16) return unpack<std::int16_t>;
  if (is_signed && tags.bits == 32) return unpack<std::int32_t>;
  if (is_signed && tags.bits == 64) return unpack<std::int64_t>;
  if (is_float && tags.bits == 32) return unpack<float>;
  if (is_float && tags.bits == 64) return unpack<double>;
  throw Error(
      source.path,
      "has samples of " + std::to_string(tags.bits) + " bits in format " + std::to_string(tags.format),
      "integers of 1, 2, 4, 8, 16, 32, 64 bits and floats of 32, 64 bits are read",
      "save it as 8, 16 or 32 bit grey");
}

}  // namespace specimen
