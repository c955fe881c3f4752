#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>
#include <string>

#include "specimen/picture/picture_codecs.hpp"
#include "specimen/picture/picture_header.hpp"

namespace specimen {
namespace {

constexpr std::size_t file_header_size = 14, info_header_size = 40;
constexpr std::uint32_t uncompressed = 0, bit_fields = 3;
constexpr std::uint32_t own_mark = 0x7870736d;  ///< "mspx" in the four bytes that every program may use

std::uint32_t little_endian(const std::uint8_t* p, int width) {
  std::uint32_t value = 0;
  for (int i = width - 1; i >= 0; --i) value = value << 8 | p[i];
  return value;
}

struct BmpHeader {
  std::uint32_t pixels_at = 0;   ///< offset of the pixels [bytes]
  std::uint32_t palette_at = 0;  ///< offset of the palette [bytes]
  std::uint32_t palette_size = 0;
  int rows = 0, cols = 0, bits = 0;
  bool top_down = false;
  PixelShape shape{};
  bool ours = false;  ///< labels that this program wrote
  [[nodiscard]] std::int64_t stride() const {
    return (std::int64_t{cols} * bits + 31) / 32 * 4;
  }  ///< [bytes]
};

void check_compression(const PictureSource& source, const std::uint8_t* info, std::uint32_t info_size,
                       int bits) {
  const std::uint32_t compression = little_endian(info + 16, 4);
  if (compression == uncompressed) return;
  if (compression == bit_fields && bits == 32) {
    // The masks follow the 40 bytes of the plain header, or are its next fields in the longer ones.
    std::array<std::uint8_t, 12> masks{};
    if (info_size >= info_header_size + masks.size())
      std::copy_n(info + info_header_size, masks.size(), masks.begin());
    else
      read_exactly(source, masks.data(), masks.size());
    if (little_endian(&masks[0], 4) == 0xff0000 && little_endian(&masks[4], 4) == 0xff00 &&
        little_endian(&masks[8], 4) == 0xff)
      return;
  }
  throw bad_picture(source.path, "is a compressed BMP", "save it without compression, or as PNG");
}

BmpHeader read_header(const PictureSource& source) {
  std::array<std::uint8_t, file_header_size> file{};
  read_exactly(source, file.data(), file.size());
  std::array<std::uint8_t, 124> info{};  // the longest of the headers
  read_exactly(source, info.data(), 4);
  const std::uint32_t info_size = little_endian(info.data(), 4);
  if (info_size < info_header_size || info_size > info.size())
    throw bad_picture(source.path,
                      "is a BMP with an unknown header of " + std::to_string(info_size) + " bytes",
                      "save it as PNG");
  read_exactly(source, &info[4], info_size - 4);

  BmpHeader header;
  header.pixels_at = little_endian(&file[10], 4);
  header.palette_at = static_cast<std::uint32_t>(file_header_size) + info_size;
  const auto cols = static_cast<std::int32_t>(little_endian(&info[4], 4));
  const auto rows = static_cast<std::int32_t>(little_endian(&info[8], 4));
  header.bits = static_cast<int>(little_endian(&info[14], 2));
  if (header.bits != 1 && header.bits != 4 && header.bits != 8 && header.bits != 24 && header.bits != 32)
    throw Error(source.path, "is a BMP of " + std::to_string(header.bits) + " bits per pixel",
                "1, 4, 8, 24 and 32 are read", "save it as PNG");
  check_compression(source, info.data(), info_size, header.bits);
  header.top_down = rows < 0;
  check_size(source, std::abs(std::int64_t{rows}), cols, 0);
  header.rows = static_cast<int>(std::abs(std::int64_t{rows}));
  header.cols = cols;
  check_size(source, header.rows, header.cols, header.stride() * header.rows);
  header.ours = little_endian(&file[6], 4) == own_mark;
  header.shape = pixel_shape_of(static_cast<std::int32_t>(little_endian(&info[24], 4)),
                                static_cast<std::int32_t>(little_endian(&info[28], 4)));
  header.palette_size = little_endian(&info[32], 4);
  if (header.bits <= 8 && header.palette_size == 0) header.palette_size = 1U << header.bits;
  return header;
}

std::vector<Rgb> read_palette(const PictureSource& source, const BmpHeader& header) {
  if (header.palette_size > 256)
    throw Error(source.path, "has a palette of " + std::to_string(header.palette_size) + " colours",
                "at most 256 are allowed");
  if (std::fseek(source.file.get(), static_cast<long>(header.palette_at), SEEK_SET) != 0)
    throw bad_picture(source.path, "is a damaged BMP");
  Bytes bytes(std::size_t{header.palette_size} * 4);
  read_exactly(source, bytes.data(), bytes.size());
  std::vector<Rgb> palette;
  for (std::size_t i = 0; i < bytes.size(); i += 4) palette.push_back({bytes[i + 2], bytes[i + 1], bytes[i]});
  return palette;
}

/// Index of a pixel in a row of 1, 4 or 8 bits per pixel; the leftmost pixel is in the highest bits.
std::uint8_t index_at(const Bytes& row, int col, int bits) {
  const auto bit = static_cast<std::size_t>(col) * static_cast<std::size_t>(bits);
  const int shift = 8 - bits - static_cast<int>(bit % 8);
  return static_cast<std::uint8_t>(row[bit / 8] >> shift & ((1 << bits) - 1));
}

template <class Store>
void for_each_row(const PictureSource& source, const BmpHeader& header, Store store) {
  if (std::fseek(source.file.get(), static_cast<long>(header.pixels_at), SEEK_SET) != 0)
    throw bad_picture(source.path, "is a damaged BMP");
  Bytes bytes(static_cast<std::size_t>(header.stride()));
  for (int i = 0; i < header.rows; ++i) {
    read_exactly(source, bytes.data(), bytes.size());
    store(header.top_down ? i : header.rows - 1 - i, bytes);
  }
}

void put(Bytes& bytes, std::uint32_t value, int width) {
  for (int i = 0; i < width; ++i) bytes.push_back(static_cast<std::uint8_t>(value >> 8 * i));
}

}  // namespace

Picture read_bmp(const PictureSource& source) {
  const BmpHeader header = read_header(source);
  Picture picture;
  picture.bits = std::min(header.bits, 8);
  set_shape(picture, header.shape);
  if (header.ours) set_origin(picture, own_words(Origin::labels, standard_phases()));
  if (header.bits > 8) {
    picture.colour = Raster<Rgb>(header.rows, header.cols);
    const auto step = static_cast<std::size_t>(header.bits / 8);
    for_each_row(source, header, [&](int row, const Bytes& bytes) {
      for (int c = 0; c < header.cols; ++c) {
        const std::uint8_t* p = &bytes[static_cast<std::size_t>(c) * step];
        picture.colour(row, c) = {p[2], p[1], p[0]};
      }
    });
    return picture;
  }
  const std::vector<Rgb> palette = read_palette(source, header);
  Raster<std::uint8_t> indices(header.rows, header.cols);
  for_each_row(source, header, [&](int row, const Bytes& bytes) {
    for (int c = 0; c < header.cols; ++c) indices(row, c) = index_at(bytes, c, header.bits);
  });
  set_palette_pixels(picture, source, std::move(indices), palette);
  return picture;
}

Bytes encode_bmp(const LabelledMask& mask) {
  const Raster<std::uint8_t>& labels = mask.labels;
  const double pixel_size = mask.pixel_size;
  const auto cols = static_cast<std::uint32_t>(labels.cols), rows = static_cast<std::uint32_t>(labels.rows);
  const std::uint32_t stride = (cols + 3) / 4 * 4;
  constexpr std::uint32_t pixels_at = file_header_size + info_header_size + 256 * 4;
  const auto per_metre =
      pixel_size > 0 ? static_cast<std::uint32_t>(std::clamp(std::round(1 / pixel_size), 1.0, 2e9)) : 0U;
  Bytes bytes{'B', 'M'};
  put(bytes, pixels_at + stride * rows, 4);
  put(bytes, mask.phases == standard_phases() ? own_mark : 0, 4);
  put(bytes, pixels_at, 4);
  put(bytes, info_header_size, 4);
  put(bytes, cols, 4);
  put(bytes, rows, 4);
  put(bytes, 1, 2);
  put(bytes, 8, 2);
  put(bytes, uncompressed, 4);
  put(bytes, stride * rows, 4);
  put(bytes, per_metre, 4);
  put(bytes, per_metre, 4);
  put(bytes, 256, 4);
  put(bytes, 0, 4);
  for (std::uint32_t gray = 0; gray < 256; ++gray) put(bytes, gray << 16 | gray << 8 | gray, 4);
  for (int row = labels.rows - 1; row >= 0; --row) {
    const auto start = labels.data.begin() + static_cast<std::ptrdiff_t>(row) * labels.cols;
    bytes.insert(bytes.end(), start, start + labels.cols);
    bytes.resize(bytes.size() + (stride - cols));
  }
  return bytes;
}

}  // namespace specimen
