// Reader of TIFF by libtiff: rows, tiles, palettes; colours by libtiff itself.
#include <algorithm>
#include <array>
#include <cmath>
#include <cstring>
#include <map>
#include <string>
#include <string_view>
#include <utility>

#include "specimen/picture/picture_codecs.hpp"
#include "specimen/picture/picture_header.hpp"
#include "specimen/picture/picture_tiff_write.hpp"

namespace specimen {
namespace {

struct TiffTags {
  int rows = 0, cols = 0, samples = 1;  ///< samples a pixel, extra ones (opacity) included
  int bits = 1;                         ///< per sample
  int format = SAMPLEFORMAT_UINT, photometric = PHOTOMETRIC_MINISBLACK;
  int orientation = ORIENTATION_TOPLEFT, planes = PLANARCONFIG_CONTIG;
  [[nodiscard]] bool one_channel() const {
    return photometric == PHOTOMETRIC_MINISBLACK || photometric == PHOTOMETRIC_MINISWHITE ||
           photometric == PHOTOMETRIC_MASK || photometric == PHOTOMETRIC_PALETTE;
  }
  /// Samples from one pixel to the next in the rows that are read.
  [[nodiscard]] std::size_t step() const {
    return planes == PLANARCONFIG_CONTIG ? static_cast<std::size_t>(samples) : 1;
  }
};

int short_tag(TIFF* tiff, std::uint32_t tag, int otherwise) {
  std::uint16_t value = 0;
  return TIFFGetFieldDefaulted(tiff, tag, &value) == 1 ? value : otherwise;
}

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
  if (tags.samples < 1 || tags.samples > 8)
    throw Error(source.path, "has " + std::to_string(tags.samples) + " channels", "1 to 8 are read");
  const int compression = short_tag(tiff, TIFFTAG_COMPRESSION, COMPRESSION_NONE);
  check_size(source, rows, cols, std::int64_t{rows} * cols * tags.bits / 8 / tightest_packing(compression));
  return tags;
}

/// Unit of length in a description by ImageJ, which overrides the tag [m]; 0 = there is none that is known.
double imagej_unit(TIFF* tiff) {
  static const std::map<std::string_view, double> units{
      {"nm", 1e-9}, {"um", 1e-6},       {"\\u00B5m", 1e-6}, {"micron", 1e-6}, {"microns", 1e-6},
      {"mm", 1e-3}, {"cm", centimetre}, {"m", 1},           {"inch", inch}};
  const char* description = nullptr;
  if (TIFFGetField(tiff, TIFFTAG_IMAGEDESCRIPTION, &description) != 1 || description == nullptr) return 0;
  const std::string_view text(description);
  constexpr std::string_view key = "\nunit=";
  const std::size_t at = text.find(key);
  if (text.substr(0, 7) != "ImageJ=" || at == std::string_view::npos) return 0;
  const std::string_view rest = text.substr(at + key.size());
  const auto unit = units.find(rest.substr(0, rest.find('\n')));
  return unit == units.end() ? 0 : unit->second;
}

double unit_of_resolution(TIFF* tiff) {
  if (const double unit = imagej_unit(tiff); unit > 0) return unit;
  const int unit = short_tag(tiff, TIFFTAG_RESOLUTIONUNIT, RESUNIT_INCH);
  if (unit == RESUNIT_CENTIMETER) return centimetre;
  return unit == RESUNIT_INCH ? inch : 0;
}

double pixel_size(TIFF* tiff) {
  float x = 0, y = 0;
  if (TIFFGetField(tiff, TIFFTAG_XRESOLUTION, &x) != 1 || TIFFGetField(tiff, TIFFTAG_YRESOLUTION, &y) != 1)
    return 0;
  const double unit = unit_of_resolution(tiff);
  if (unit == 0) return 0;
  return pixel_size_of(static_cast<double>(x) / unit, static_cast<double>(y) / unit);
}

/// Values of one channel out of a row of interleaved samples.
using Unpack = void (*)(const std::uint8_t* row, std::size_t step, int count, double* values);

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

Unpack choose_unpack(const TiffTags& tags, const PictureSource& source) {
  const bool is_unsigned = tags.format == SAMPLEFORMAT_UINT || tags.format == SAMPLEFORMAT_VOID;
  const bool is_signed = tags.format == SAMPLEFORMAT_INT, is_float = tags.format == SAMPLEFORMAT_IEEEFP;
  if (is_unsigned && tags.bits == 1) return unpack_bits<1>;
  if (is_unsigned && tags.bits == 2) return unpack_bits<2>;
  if (is_unsigned && tags.bits == 4) return unpack_bits<4>;
  if (is_unsigned && tags.bits == 8) return unpack<std::uint8_t>;
  if (is_unsigned && tags.bits == 16) return unpack<std::uint16_t>;
  if (is_unsigned && tags.bits == 32) return unpack<std::uint32_t>;
  if (is_signed && tags.bits == 8) return unpack<std::int8_t>;
  if (is_signed && tags.bits == 16) return unpack<std::int16_t>;
  if (is_signed && tags.bits == 32) return unpack<std::int32_t>;
  if (is_float && tags.bits == 32) return unpack<float>;
  if (is_float && tags.bits == 64) return unpack<double>;
  throw Error(
      source.path,
      "has samples of " + std::to_string(tags.bits) + " bits in format " + std::to_string(tags.format),
      "integers of 1, 2, 4, 8, 16, 32 bits and floats of 32, 64 bits are read",
      "save it as 8 or 16 bit grey");
}

class TiffReader {
 public:
  explicit TiffReader(const PictureSource& source) : source_(source) {
    const TiffOptions options = quiet_options(messages_);
    // m: no memory map, whose pages a file that shrinks meanwhile would pull away.
    tiff_.reset(TIFFOpenExt(source.path.c_str(), "rm", options.get()));
    if (tiff_ == nullptr) throw damaged();
  }

  Picture read() {
    check_alone();
    const TiffTags tags = read_tags(tiff_.get(), source_);
    check_tiles(tags);
    Picture picture;
    picture.bits = tags.bits;
    picture.pixel_size = pixel_size(tiff_.get());
    if (!tags.one_channel())
      picture.colour = colours(tags);
    else if (tags.photometric == PHOTOMETRIC_PALETTE)
      read_palette_picture(tags, picture);
    else
      picture.gray = gray(tags);
    return upright(std::move(picture), tags.orientation);
  }

 private:
  [[nodiscard]] Error damaged() const {
    const std::string reason = messages_.text.data();
    return bad_picture(source_.path, reason.empty() ? "is a damaged TIFF" : "is a damaged TIFF: " + reason);
  }

  /// Previews, levels of a pyramid and masks of the first picture are none of their own.
  void check_alone() {
    constexpr int most_directories = 32;  // of a pyramid of any size
    for (int i = 0; TIFFReadDirectory(tiff_.get()) == 1; ++i) {
      std::uint32_t kind = 0;
      TIFFGetField(tiff_.get(), TIFFTAG_SUBFILETYPE, &kind);
      if ((kind & (FILETYPE_REDUCEDIMAGE | FILETYPE_MASK)) == 0 || i == most_directories)
        throw several_pictures(source_.path, "is a TIFF of several pages");
    }
    messages_ = {};  // what is wrong behind the first picture is no fault of it
    if (TIFFSetDirectory(tiff_.get(), 0) != 1) throw damaged();
  }

  /// libtiff unpacks a tile in one piece, and a few bytes can claim one of any size.
  void check_tiles(const TiffTags& tags) {
    if (TIFFIsTiled(tiff_.get()) == 0) return;
    std::uint32_t rows = 0, cols = 0;
    TIFFGetField(tiff_.get(), TIFFTAG_TILELENGTH, &rows);
    TIFFGetField(tiff_.get(), TIFFTAG_TILEWIDTH, &cols);
    constexpr double usual = 2048.0 * 2048.0;  // [px]
    if (double{1} * rows * cols > std::max(usual, 2.0 * tags.rows * tags.cols))
      throw Error(source_.path,
                  "has tiles of " + std::to_string(cols) + " x " + std::to_string(rows) + " pixels",
                  "must not be larger than the picture", "save it without tiles");
  }

  Raster<double> channel(const TiffTags& tags) {
    const Unpack unpack_row = choose_unpack(tags, source_);
    Raster<double> values(tags.rows, tags.cols);
    if (TIFFIsTiled(tiff_.get()) != 0)
      read_tiles(tags, unpack_row, values);
    else
      read_rows(tags, unpack_row, values);
    return values;
  }

  void read_rows(const TiffTags& tags, Unpack unpack_row, Raster<double>& values) {
    Bytes row(buffer_size(TIFFScanlineSize(tiff_.get())));
    for (int r = 0; r < tags.rows; ++r) {
      if (TIFFReadScanline(tiff_.get(), row.data(), static_cast<std::uint32_t>(r), 0) < 0) throw damaged();
      unpack_row(row.data(), tags.step(), tags.cols, &values(r, 0));
    }
  }

  void read_tiles(const TiffTags& tags, Unpack unpack_row, Raster<double>& values) {
    std::uint32_t tile_rows = 0, tile_cols = 0;
    TIFFGetField(tiff_.get(), TIFFTAG_TILELENGTH, &tile_rows);
    TIFFGetField(tiff_.get(), TIFFTAG_TILEWIDTH, &tile_cols);
    if (tile_rows == 0 || tile_cols == 0) throw damaged();
    Bytes tile(buffer_size(TIFFTileSize(tiff_.get())));
    const std::size_t stride = buffer_size(TIFFTileRowSize(tiff_.get()));
    const auto rows = static_cast<std::uint32_t>(tags.rows), cols = static_cast<std::uint32_t>(tags.cols);
    for (std::uint32_t top = 0; top < rows; top += std::min(tile_rows, rows - top))
      for (std::uint32_t left = 0; left < cols; left += std::min(tile_cols, cols - left)) {
        if (TIFFReadTile(tiff_.get(), tile.data(), left, top, 0, 0) < 0) throw damaged();
        for (std::uint32_t r = 0; r < std::min(tile_rows, rows - top); ++r)
          unpack_row(tile.data() + r * stride, tags.step(),
                     static_cast<int>(std::min(tile_cols, cols - left)),
                     &values(static_cast<int>(top + r), static_cast<int>(left)));
      }
  }

  /// A row or a tile must fit in memory, whatever the tags claim.
  [[nodiscard]] std::size_t buffer_size(tmsize_t size) const {
    if (size <= 0 || size > largest_allocation) throw damaged();
    return static_cast<std::size_t>(size);
  }

  Raster<double> gray(const TiffTags& tags) {
    Raster<double> values = channel(tags);
    const bool counts = tags.format == SAMPLEFORMAT_UINT || tags.format == SAMPLEFORMAT_VOID;
    if (tags.photometric == PHOTOMETRIC_MINISWHITE && counts) {
      const double white = std::ldexp(1.0, tags.bits) - 1;
      for (double& value : values.data) value = white - value;
    }
    check_finite(values);
    return values;
  }

  void check_finite(const Raster<double>& values) const {
    const auto is_bad = [](double value) { return !std::isfinite(value); };
    const auto bad = std::find_if(values.data.begin(), values.data.end(), is_bad);
    if (bad == values.data.end()) return;
    const std::int64_t at = bad - values.data.begin();
    throw bad_picture(source_.path,
                      "holds " + std::to_string(std::count_if(bad, values.data.end(), is_bad)) +
                          " pixels that are not finite (NaN or infinite), the first in row " +
                          std::to_string(at / values.cols) + ", column " + std::to_string(at % values.cols),
                      "replace them by a value, e.g. -1, first");
  }

  void read_palette_picture(const TiffTags& tags, Picture& picture) {
    if (tags.bits > 8 || tags.format != SAMPLEFORMAT_UINT)
      throw Error(source_.path, "has a palette of " + std::to_string(tags.bits) + " bits",
                  "at most 8 are read");
    std::uint16_t *red = nullptr, *green = nullptr, *blue = nullptr;
    if (TIFFGetField(tiff_.get(), TIFFTAG_COLORMAP, &red, &green, &blue) != 1) throw damaged();
    std::vector<Rgb> palette;
    for (int i = 0; i < 1 << tags.bits; ++i)
      palette.push_back({static_cast<std::uint8_t>(red[i] / 257), static_cast<std::uint8_t>(green[i] / 257),
                         static_cast<std::uint8_t>(blue[i] / 257)});
    const Raster<double> values = channel(tags);
    Raster<std::uint8_t> indices(tags.rows, tags.cols);
    std::transform(values.data.begin(), values.data.end(), indices.data.begin(),
                   [](double value) { return static_cast<std::uint8_t>(value); });
    set_palette_pixels(picture, source_, std::move(indices), palette);
  }

  /// Any kind of colour, by libtiff's own conversion to 8-bit RGB with premultiplied opacity.
  Raster<Rgb> colours(const TiffTags& tags) {
    std::array<char, 1024> reason{};
    if (TIFFRGBAImageOK(tiff_.get(), reason.data()) != 1)
      throw bad_picture(source_.path, std::string("is a TIFF that cannot be read: ") + reason.data(),
                        "save it as 8-bit RGB or grey");
    std::vector<std::uint32_t> packed(static_cast<std::size_t>(tags.rows) *
                                      static_cast<std::size_t>(tags.cols));
    // Asked for in its own orientation, it comes as it is stored; upright() turns it.
    if (TIFFReadRGBAImageOriented(tiff_.get(), static_cast<std::uint32_t>(tags.cols),
                                  static_cast<std::uint32_t>(tags.rows), packed.data(), tags.orientation,
                                  1) != 1)
      throw damaged();
    Raster<Rgb> colour(tags.rows, tags.cols);
    std::transform(packed.begin(), packed.end(), colour.data.begin(), [](std::uint32_t p) {
      const std::uint32_t under = 255 - TIFFGetA(p);
      const auto over_white = [&](std::uint32_t c) {
        return static_cast<std::uint8_t>(std::min(255U, c + under));
      };
      return Rgb{over_white(TIFFGetR(p)), over_white(TIFFGetG(p)), over_white(TIFFGetB(p))};
    });
    return colour;
  }

  const PictureSource& source_;
  TiffMessages messages_;
  TiffHandle tiff_;  // after messages_: closing may still report
};

}  // namespace

Picture read_tiff(const PictureSource& source) { return TiffReader(source).read(); }

}  // namespace specimen
