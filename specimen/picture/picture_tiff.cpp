// Reader of TIFF by libtiff: rows, tiles, palettes; colours by libtiff itself.
#include <algorithm>
#include <array>
#include <cmath>
#include <string>
#include <string_view>
#include <utility>

#include "specimen/picture/picture_codecs.hpp"
#include "specimen/picture/picture_header.hpp"
#include "specimen/picture/picture_tiff_samples.hpp"
#include "specimen/picture/picture_tiff_tags.hpp"
#include "specimen/picture/picture_tiff_write.hpp"

namespace specimen {
namespace {

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
    check_slices();
    check_samples(tags);
    Picture picture;
    picture.bits = tags.bits;
    set_shape(picture, tiff_pixel_shape(tiff_.get()));
    read_tiff_words(tiff_.get(), picture);
    if (tags.photometric == PHOTOMETRIC_RGB && tags.format == SAMPLEFORMAT_UINT &&
        (tags.bits == 8 || tags.bits == 16))
      read_rgb(tags, picture);
    else if (!tags.one_channel())
      picture.colour = colours(tags);
    else if (tags.photometric == PHOTOMETRIC_PALETTE)
      read_palette_picture(tags, picture);
    else
      read_gray(tags, picture);
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

  /// ImageJ keeps the slices of a large stack behind each other in one directory; others say so by a depth.
  void check_slices() {
    const std::string_view description = description_of(tiff_.get());
    for (const char* key : {"images", "slices", "frames"}) {
      const std::string count(imagej_value(description, key));
      if (!count.empty() && count != "1")
        throw several_pictures(source_.path, "is an ImageJ stack of " + count + " " + key);
    }
    if (const std::string count(imagej_value(description, "channels")); !count.empty() && count != "1")
      throw several_pictures(source_.path, "is an ImageJ stack of " + count + " channels");
    std::uint32_t depth = 1;
    if (TIFFGetField(tiff_.get(), TIFFTAG_IMAGEDEPTH, &depth) == 1 && depth > 1)
      throw several_pictures(source_.path, "is a TIFF of " + std::to_string(depth) + " slices");
  }

  static bool is_alpha(int kind) { return kind == EXTRASAMPLE_ASSOCALPHA || kind == EXTRASAMPLE_UNASSALPHA; }

  /// Which of several values of a pixel is meant nobody can say, but for opacity.
  void check_samples(const TiffTags& tags) const {
    if (!tags.one_channel() || tags.samples == 1) return;
    if (tags.samples == 2 && tags.extra.size() == 1 && is_alpha(tags.extra[0])) return;
    throw Error(source_.path, "holds " + std::to_string(tags.samples) + " grey values a pixel",
                "must hold one, or red, green and blue", "save the channel that you mean as a separate file");
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

  /// Values of one sample of each pixel, as they are stored where that is as small as can be.
  GreyLevels channel(const TiffTags& tags, int sample = 0) {
    const bool counts = tags.format == SAMPLEFORMAT_UINT || tags.format == SAMPLEFORMAT_VOID;
    GreyLevels levels;
    if (counts && tags.bits <= 8)
      levels = channel_as<std::uint8_t>(tags, sample);
    else if (counts && tags.bits == 16)
      levels = channel_as<std::uint16_t>(tags, sample);
    else if (tags.bits <= 16 || (tags.format == SAMPLEFORMAT_IEEEFP && tags.bits == 32))
      levels = channel_as<float>(tags, sample);
    else
      levels = wide_channel(tags, sample);
    return levels;
  }

  template <class T>
  Raster<T> channel_as(const TiffTags& tags, int sample) {
    Raster<T> values(tags.rows, tags.cols);
    read_channel(tags, sample, [&](int row, int col, const std::vector<double>& part, int count) {
      std::transform(part.begin(), part.begin() + count, &values(row, col),
                     [](double value) { return static_cast<T>(value); });
    });
    return values;
  }

  /// In float where all numbers are exact in it, as those of labels are; else in double.
  GreyLevels wide_channel(const TiffTags& tags, int sample) {
    bool exact = true;
    Raster<float> narrow(tags.rows, tags.cols);
    read_channel(tags, sample, [&](int row, int col, const std::vector<double>& values, int count) {
      std::transform(values.begin(), values.begin() + count, &narrow(row, col), [&](double v) {
        const auto value = static_cast<float>(v);
        exact = exact && (static_cast<double>(value) == v || std::isnan(v));
        return value;
      });
    });
    if (exact) return narrow;
    narrow = {};
    return channel_as<double>(tags, sample);
  }

  /// @param store  takes row, column, values and their number, for each row of a strip or tile.
  template <class Store>
  void read_channel(const TiffTags& tags, int sample, const Store& store) {
    const Unpack unpack_row = choose_unpack(tags, source_);
    if (TIFFIsTiled(tiff_.get()) != 0)
      read_tiles(tags, unpack_row, sample, store);
    else
      read_rows(tags, unpack_row, sample, store);
  }

  /// Bytes before the first value of a sample in rows of all samples; samples of less than a byte are alone.
  static std::size_t start_of(const TiffTags& tags, int sample) {
    const bool together = tags.planes == PLANARCONFIG_CONTIG;
    return together ? static_cast<std::size_t>(sample) * static_cast<std::size_t>(tags.bits) / 8 : 0;
  }
  static std::uint16_t plane_of(const TiffTags& tags, int sample) {
    return tags.planes == PLANARCONFIG_CONTIG ? std::uint16_t{0} : static_cast<std::uint16_t>(sample);
  }

  template <class Store>
  void read_rows(const TiffTags& tags, Unpack unpack_row, int sample, const Store& store) {
    std::vector<double> values(static_cast<std::size_t>(tags.cols));
    Bytes row(buffer_size(TIFFScanlineSize(tiff_.get())));
    for (int r = 0; r < tags.rows; ++r) {
      if (TIFFReadScanline(tiff_.get(), row.data(), static_cast<std::uint32_t>(r), plane_of(tags, sample)) <
          0)
        throw damaged();
      unpack_row(row.data() + start_of(tags, sample), tags.step(), tags.cols, values.data());
      store(r, 0, values, tags.cols);
    }
  }

  template <class Store>
  void read_tiles(const TiffTags& tags, Unpack unpack_row, int sample, const Store& store) {
    std::uint32_t tile_rows = 0, tile_cols = 0;
    TIFFGetField(tiff_.get(), TIFFTAG_TILELENGTH, &tile_rows);
    TIFFGetField(tiff_.get(), TIFFTAG_TILEWIDTH, &tile_cols);
    if (tile_rows == 0 || tile_cols == 0) throw damaged();
    Bytes tile(buffer_size(TIFFTileSize(tiff_.get())));
    std::vector<double> values(std::min(tile_cols, static_cast<std::uint32_t>(tags.cols)));
    const std::size_t stride = buffer_size(TIFFTileRowSize(tiff_.get()));
    const auto rows = static_cast<std::uint32_t>(tags.rows), cols = static_cast<std::uint32_t>(tags.cols);
    for (std::uint32_t top = 0; top < rows; top += std::min(tile_rows, rows - top))
      for (std::uint32_t left = 0; left < cols; left += std::min(tile_cols, cols - left)) {
        if (TIFFReadTile(tiff_.get(), tile.data(), left, top, 0, plane_of(tags, sample)) < 0) throw damaged();
        const auto count = static_cast<int>(std::min(tile_cols, cols - left));
        for (std::uint32_t r = 0; r < std::min(tile_rows, rows - top); ++r) {
          unpack_row(tile.data() + r * stride + start_of(tags, sample), tags.step(), count, values.data());
          store(static_cast<int>(top + r), static_cast<int>(left), values, count);
        }
      }
  }

  /// A row or a tile must fit in memory, whatever the tags claim.
  [[nodiscard]] std::size_t buffer_size(tmsize_t size) const {
    if (size <= 0 || size > largest_allocation) throw damaged();
    return static_cast<std::size_t>(size);
  }

  void read_gray(const TiffTags& tags, Picture& picture) {
    const bool counts = tags.format == SAMPLEFORMAT_UINT || tags.format == SAMPLEFORMAT_VOID;
    if (tags.photometric == PHOTOMETRIC_MINISWHITE && counts) {
      picture.gray = tags.bits <= 16 ? channel(tags) : GreyLevels(channel_as<double>(tags, 0));
      picture.gray = turned_over(picture.gray, std::ldexp(1.0, tags.bits) - 1);
    } else {
      picture.gray = channel(tags);
    }
    check_values(tags, picture.gray);
    if (tags.samples == 2) read_opacity(tags, 1, picture);
  }

  /// Values counted from white, as counted from black.
  static GreyLevels turned_over(const GreyLevels& levels, double white) {
    return levels.with([&](auto raster) {
      using T = typename decltype(raster.data)::value_type;
      for (T& value : raster.data) value = static_cast<T>(white - static_cast<double>(value));
      return raster;
    });
  }

  void read_opacity(const TiffTags& tags, int sample, Picture& picture) {
    const double full = tags.format == SAMPLEFORMAT_UINT ? std::ldexp(1.0, tags.bits) - 1 : 1;
    picture.opacity = Raster<std::uint8_t>(tags.rows, tags.cols);
    read_channel(tags, sample, [&](int row, int col, const std::vector<double>& values, int count) {
      std::transform(values.begin(), values.begin() + count, &picture.opacity(row, col), [&](double v) {
        return static_cast<std::uint8_t>(std::lround(std::clamp(v / full, 0.0, 1.0) * 255));
      });
    });
    drop_if_opaque(picture);
  }

  template <class Colour>
  Raster<Colour> read_channels(const TiffTags& tags) {
    Raster<Colour> colour(tags.rows, tags.cols);
    using Channel = decltype(Colour::r);
    Channel Colour::*const members[] = {&Colour::r, &Colour::g, &Colour::b};
    for (int k = 0; k < 3; ++k)
      read_channel(tags, k, [&](int row, int col, const std::vector<double>& values, int count) {
        for (int i = 0; i < count; ++i)
          colour(row, col + i).*members[k] = static_cast<Channel>(values[static_cast<std::size_t>(i)]);
      });
    return colour;
  }

  /// Red, green and blue; further samples are opacity where the file says so, else of no use here.
  void read_rgb(const TiffTags& tags, Picture& picture) {
    if (tags.samples < 3)
      throw bad_picture(source_.path,
                        "is a TIFF of colours with " + std::to_string(tags.samples) + " channels");
    if (tags.bits == 16) {
      const Raster<DeepRgb> deep = read_channels<DeepRgb>(tags);
      set_deep_colours(picture, tags.rows, tags.cols, [&](std::size_t i) { return deep.data[i]; });
    } else {
      picture.colour = read_channels<Rgb>(tags);
    }
    const int beside = tags.samples - 3;
    const bool has_opacity = beside > 0 && !tags.extra.empty() && is_alpha(tags.extra[0]);
    if (has_opacity) read_opacity(tags, 3, picture);
    if (has_opacity && tags.extra[0] == EXTRASAMPLE_ASSOCALPHA) take_opacity_off(picture);
    if (const int unused = beside - (has_opacity ? 1 : 0); unused > 0)
      picture.notes.push_back(
          "left out " +
          std::string(unused == 1 ? "the channel" : "the " + std::to_string(unused) + " channels") +
          " beside red, green and blue, which the file does not call opacity");
  }

  /// Colours that were multiplied by their opacity, as they were before.
  static void take_opacity_off(Picture& picture) {
    for (std::size_t i = 0; i < picture.opacity.size(); ++i) {
      const int a = picture.opacity.data[i];
      if (!picture.gray.empty()) {
        const double v = picture.gray.data[i];
        picture.gray.data[i] = a == 0 ? 0 : std::min(65535.0, std::round(v * 255 / a));
        continue;
      }
      const auto full = [&](int c) {
        return static_cast<std::uint8_t>(a == 0 ? 0 : std::min(255, (c * 255 + a / 2) / a));
      };
      Rgb& c = picture.colour.data[i];
      c = {full(c.r), full(c.g), full(c.b)};
    }
  }

  /// Not-a-number is a pixel without a value; infinity, and whole numbers that a double cannot tell apart,
  /// are refused.
  void check_values(const TiffTags& tags, const GreyLevels& levels) const {
    const bool whole = tags.format != SAMPLEFORMAT_IEEEFP;
    if (whole && tags.bits < 64) return;
    constexpr double exact = 9'007'199'254'740'992.0;  // 2^53
    const auto is_bad = [&](double value) { return whole ? std::abs(value) > exact : std::isinf(value); };
    const auto place = [&](std::ptrdiff_t at) {
      return "the first in row " + std::to_string(at / levels.cols) + ", column " +
             std::to_string(at % levels.cols);
    };
    std::int64_t count = 0;
    std::ptrdiff_t first = 0;
    levels.data.visit([&](const auto& values) {
      for (std::size_t i = 0; i < values.size(); ++i)
        if (is_bad(static_cast<double>(values[i])) && count++ == 0) first = static_cast<std::ptrdiff_t>(i);
    });
    if (count == 0) return;
    if (whole)
      throw bad_picture(source_.path, "holds numbers above 2^53, " + place(first),
                        "number the grains 1, 2, 3, ... instead");
    throw bad_picture(source_.path, "holds " + std::to_string(count) + " infinite pixels, " + place(first),
                      "replace them by a value, e.g. -1, first");
  }

  void read_palette_picture(const TiffTags& tags, Picture& picture) {
    if (tags.bits > 8 || tags.format != SAMPLEFORMAT_UINT)
      throw Error(source_.path, "has a palette of " + std::to_string(tags.bits) + " bits",
                  "at most 8 are read");
    std::uint16_t *red = nullptr, *green = nullptr, *blue = nullptr;
    if (TIFFGetField(tiff_.get(), TIFFTAG_COLORMAP, &red, &green, &blue) != 1) throw damaged();
    DeepToByte byte;
    const int count = 1 << tags.bits;
    for (int i = 0; i < count; ++i)
      for (const std::uint16_t channel : {red[i], green[i], blue[i]}) byte.look_at(channel);
    std::vector<Rgb> palette;
    for (int i = 0; i < count; ++i) palette.push_back({byte(red[i]), byte(green[i]), byte(blue[i])});
    set_palette_pixels(picture, source_, channel_as<std::uint8_t>(tags, 0), palette);
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
