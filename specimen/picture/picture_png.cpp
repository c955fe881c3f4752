#include <png.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <csetjmp>
#include <cstring>
#include <exception>
#include <new>
#include <string_view>
#include <utility>

#include "specimen/picture/picture_codecs.hpp"
#include "specimen/picture/picture_header.hpp"

// libpng reports a failure by longjmp. So every function that calls setjmp holds plain data alone: whatever
// has a destructor lives in its caller.
namespace specimen {
namespace {

struct PngFailure {
  std::array<char, 160> text{};
};

[[noreturn]] void on_error(png_structp png, png_const_charp text) {
  auto* failure = static_cast<PngFailure*>(png_get_error_ptr(png));
  std::strncpy(failure->text.data(), text, failure->text.size() - 1);
  longjmp(png_jmpbuf(png), 1);
}

void on_warning(png_structp, png_const_charp) {}

// ---- reading ----

struct PngReader {
  PngFailure failure;
  png_structp png = nullptr;
  png_infop info = nullptr;
  PngReader() : png(png_create_read_struct(PNG_LIBPNG_VER_STRING, &failure, on_error, on_warning)) {
    if (png != nullptr) info = png_create_info_struct(png);
    if (info == nullptr) {
      png_destroy_read_struct(&png, nullptr, nullptr);
      throw std::bad_alloc();
    }
  }
  PngReader(const PngReader&) = delete;
  PngReader& operator=(const PngReader&) = delete;
  ~PngReader() { png_destroy_read_struct(&png, &info, nullptr); }

  [[nodiscard]] int colour_type() const { return png_get_color_type(png, info); }
  [[nodiscard]] bool palette() const { return colour_type() == PNG_COLOR_TYPE_PALETTE; }
  [[nodiscard]] bool gray() const { return (colour_type() & PNG_COLOR_MASK_COLOR) == 0; }
};

constexpr const png_byte animation[] = "acTL";  ///< chunk that counts the pictures of an animation

bool read_header(PngReader& reader, std::FILE* file) {
  if (setjmp(png_jmpbuf(reader.png)) != 0) return false;
  png_set_user_limits(reader.png, PNG_UINT_31_MAX, PNG_UINT_31_MAX);  // check_size has the say
  png_set_keep_unknown_chunks(reader.png, PNG_HANDLE_CHUNK_ALWAYS, animation, 1);
  png_init_io(reader.png, file);
  png_read_info(reader.png, reader.info);
  return true;
}

bool is_animation(const PngReader& reader) {
  png_unknown_chunkp chunks = nullptr;
  const int count = png_get_unknown_chunks(reader.png, reader.info, &chunks);
  return std::any_of(chunks, chunks + count, [](const png_unknown_chunk& chunk) {
    return std::equal(chunk.name, chunk.name + 4, animation) && chunk.size >= 4 &&
           png_get_uint_32(chunk.data) > 1;
  });
}

/// Ask for bytes as they are needed: grey and colour as stored, a palette as indices.
bool choose_transforms(PngReader& reader) {
  if (setjmp(png_jmpbuf(reader.png)) != 0) return false;
  png_set_packing(reader.png);
  // One transparent colour of a picture without a palette: opacity of its own.
  if (!reader.palette() && png_get_valid(reader.png, reader.info, PNG_INFO_tRNS) != 0)
    png_set_tRNS_to_alpha(reader.png);
  png_set_interlace_handling(reader.png);
  png_read_update_info(reader.png, reader.info);
  return true;
}

bool read_pixels(PngReader& reader, png_bytepp rows) {
  if (setjmp(png_jmpbuf(reader.png)) != 0) return false;
  png_read_image(reader.png, rows);
  png_read_end(reader.png, nullptr);
  return true;
}

PixelShape pixel_shape(const PngReader& reader) {
  png_uint_32 x = 0, y = 0;
  int unit = PNG_RESOLUTION_UNKNOWN;
  if (png_get_pHYs(reader.png, reader.info, &x, &y, &unit) == 0) return {};
  PixelShape shape = pixel_shape_of(x, y);
  if (unit != PNG_RESOLUTION_METER) shape.width = 0;  // a ratio alone
  return shape;
}

/// What this program has written into it.
void read_words(const PngReader& reader, Picture& picture) {
  png_textp texts = nullptr;
  int count = 0;
  png_get_text(reader.png, reader.info, &texts, &count);
  for (int i = 0; i < count; ++i)
    if (std::string_view(texts[i].key) == own_keyword && texts[i].text != nullptr)
      set_origin(picture, texts[i].text);
}

int orientation(const PngReader& reader) {
  png_bytep block = nullptr;
  png_uint_32 size = 0;
  if (png_get_eXIf_1(reader.png, reader.info, &size, &block) == 0 || block == nullptr) return 1;
  return read_exif({block, size}).orientation;
}

std::uint16_t two_bytes_at(const std::uint8_t* p) { return static_cast<std::uint16_t>(p[0] * 256 + p[1]); }

/// Rows of grey values, with an opacity after each where there are two channels.
void set_gray(Picture& picture, const Bytes& bytes, int rows, int cols, std::size_t channels,
              bool two_bytes) {
  const std::size_t width = two_bytes ? 2 : 1;
  const auto fill = [&](auto raster, const auto& value_at) {
    for (std::size_t i = 0; i < raster.size(); ++i) raster.data[i] = value_at(&bytes[i * channels * width]);
    return raster;
  };
  if (two_bytes)
    picture.gray = fill(Raster<std::uint16_t>(rows, cols), two_bytes_at);
  else
    picture.gray = fill(Raster<std::uint8_t>(rows, cols), [](const std::uint8_t* p) { return *p; });
  if (channels < 2) return;
  picture.opacity = fill(Raster<std::uint8_t>(rows, cols), [&](const std::uint8_t* p) { return p[width]; });
  drop_if_opaque(picture);
}

void set_deep_colours(Picture& picture, const Bytes& bytes, int rows, int cols, std::size_t channels) {
  set_deep_colours(picture, rows, cols, [&](std::size_t i) {
    const std::uint8_t* p = &bytes[i * channels * 2];
    return DeepRgb{two_bytes_at(p), two_bytes_at(p + 2), two_bytes_at(p + 4)};
  });
  if (channels < 4) return;
  picture.opacity = Raster<std::uint8_t>(rows, cols);
  for (std::size_t i = 0; i < picture.opacity.size(); ++i)
    picture.opacity.data[i] = bytes[i * channels * 2 + 6];
  drop_if_opaque(picture);
}

void set_colours(Picture& picture, const Bytes& bytes, int rows, int cols, std::size_t channels) {
  picture.colour = Raster<Rgb>(rows, cols);
  if (channels == 4) picture.opacity = Raster<std::uint8_t>(rows, cols);
  for (std::size_t i = 0; i < picture.colour.size(); ++i) {
    const std::uint8_t* p = &bytes[i * channels];
    picture.colour.data[i] = {p[0], p[1], p[2]};
    if (channels == 4) picture.opacity.data[i] = p[3];
  }
  drop_if_opaque(picture);
}

Raster<std::uint8_t> indices_of(Bytes bytes, int rows, int cols) {
  Raster<std::uint8_t> indices;
  indices.rows = rows;
  indices.cols = cols;
  indices.data = std::move(bytes);
  return indices;
}

std::vector<Rgb> palette_of(const PngReader& reader) {
  png_colorp entries = nullptr;
  int count = 0;
  png_get_PLTE(reader.png, reader.info, &entries, &count);
  std::vector<Rgb> palette;
  for (int i = 0; i < count; ++i) palette.push_back({entries[i].red, entries[i].green, entries[i].blue});
  return palette;
}

std::vector<std::uint8_t> opacity_of_palette(const PngReader& reader) {
  png_bytep opacity = nullptr;
  int count = 0;
  png_get_tRNS(reader.png, reader.info, &opacity, &count, nullptr);
  if (opacity == nullptr || count <= 0) return {};
  return {opacity, opacity + count};
}

// ---- writing ----

struct PngWriter {
  PngFailure failure;
  png_structp png = nullptr;
  png_infop info = nullptr;
  PngWriter() : png(png_create_write_struct(PNG_LIBPNG_VER_STRING, &failure, on_error, on_warning)) {
    if (png != nullptr) info = png_create_info_struct(png);
    if (info == nullptr) {
      png_destroy_write_struct(&png, nullptr);
      throw std::bad_alloc();
    }
  }
  PngWriter(const PngWriter&) = delete;
  PngWriter& operator=(const PngWriter&) = delete;
  ~PngWriter() { png_destroy_write_struct(&png, &info); }
};

void append(png_structp png, png_bytep data, std::size_t count) {
  auto* bytes = static_cast<Bytes*>(png_get_io_ptr(png));
  bool stored = true;
  try {
    bytes->insert(bytes->end(), data, data + count);
  } catch (const std::exception&) {  // must not fly through libpng
    stored = false;
  }
  if (!stored) png_error(png, "out of memory");
}

struct PngPixels {
  int rows = 0, cols = 0, colour_type = 0;
  const std::uint8_t* data = nullptr;
  std::size_t stride = 0;       ///< [bytes]
  png_uint_32 per_metre = 0;    ///< 0 = no scale
  const char* words = nullptr;  ///< own_words(); null = none
  bool hasty = false;           ///< packed less tightly, in a fraction of the time
};

bool write_image(PngWriter& writer, const PngPixels& pixels, Bytes& bytes) {
  if (setjmp(png_jmpbuf(writer.png)) != 0) return false;
  png_set_write_fn(writer.png, &bytes, append, nullptr);
  png_set_user_limits(writer.png, PNG_UINT_31_MAX, PNG_UINT_31_MAX);
  png_set_IHDR(writer.png, writer.info, static_cast<png_uint_32>(pixels.cols),
               static_cast<png_uint_32>(pixels.rows), 8, pixels.colour_type, PNG_INTERLACE_NONE,
               PNG_COMPRESSION_TYPE_DEFAULT, PNG_FILTER_TYPE_DEFAULT);
  if (pixels.hasty) {
    png_set_compression_level(writer.png, 1);
    png_set_filter(writer.png, PNG_FILTER_TYPE_BASE, PNG_FILTER_UP);
  }
  if (pixels.per_metre > 0)
    png_set_pHYs(writer.png, writer.info, pixels.per_metre, pixels.per_metre, PNG_RESOLUTION_METER);
  if (pixels.words != nullptr) {
    png_text text{};
    text.compression = PNG_TEXT_COMPRESSION_NONE;
    text.key = const_cast<char*>(own_keyword);
    text.text = const_cast<char*>(pixels.words);
    png_set_text(writer.png, writer.info, &text, 1);
  }
  png_write_info(writer.png, writer.info);
  for (int row = 0; row < pixels.rows; ++row)
    png_write_row(writer.png, pixels.data + static_cast<std::size_t>(row) * pixels.stride);
  png_write_end(writer.png, writer.info);
  return true;
}

Bytes encode(const std::string& path, PngPixels pixels, double pixel_size) {
  if (pixel_size > 0)
    pixels.per_metre = static_cast<png_uint_32>(std::clamp(std::round(1 / pixel_size), 1.0, 2e9));
  Bytes bytes;
  PngWriter writer;
  if (!write_image(writer, pixels, bytes))
    throw Error(path, std::string("cannot be written as PNG: ") + writer.failure.text.data(), "", "",
                Fault::write);
  return bytes;
}

}  // namespace

Picture read_png(const PictureSource& source) {
  PngReader reader;
  const auto damaged = [&] {
    return bad_picture(source.path, std::string("is a damaged PNG: ") + reader.failure.text.data());
  };
  if (!read_header(reader, source.file.get())) throw damaged();
  const std::int64_t n_rows = png_get_image_height(reader.png, reader.info);
  const std::int64_t n_cols = png_get_image_width(reader.png, reader.info);
  const int bits = png_get_bit_depth(reader.png, reader.info);
  check_size(source, n_rows, n_cols, 0);
  // Deflate never packs tighter than 1032 to 1, so a short file cannot claim a huge picture.
  check_size(source, n_rows, n_cols, n_rows * n_cols * bits / 8 / 1032);
  if (is_animation(reader)) throw several_pictures(source.path, "is an animated PNG");
  if (!choose_transforms(reader)) throw damaged();

  const std::size_t stride = png_get_rowbytes(reader.png, reader.info);
  Bytes bytes(stride * static_cast<std::size_t>(n_rows));
  std::vector<png_bytep> row_starts(static_cast<std::size_t>(n_rows));
  for (std::size_t r = 0; r < row_starts.size(); ++r) row_starts[r] = bytes.data() + r * stride;
  if (!read_pixels(reader, row_starts.data())) throw damaged();

  Picture picture;
  picture.bits = bits;
  set_shape(picture, pixel_shape(reader));
  read_words(reader, picture);
  const int rows = static_cast<int>(n_rows), cols = static_cast<int>(n_cols);
  const std::size_t channels = png_get_channels(reader.png, reader.info);
  if (reader.palette())
    set_palette_pixels(picture, source, indices_of(std::move(bytes), rows, cols), palette_of(reader),
                       opacity_of_palette(reader));
  else if (reader.gray())
    set_gray(picture, bytes, rows, cols, channels, bits == 16);
  else if (bits == 16)
    set_deep_colours(picture, bytes, rows, cols, channels);
  else
    set_colours(picture, bytes, rows, cols, channels);
  return upright(std::move(picture), orientation(reader));
}

Bytes encode_png(const std::string& path, const Raster<Rgb>& picture, double pixel_size,
                 const std::string& words) {
  static_assert(sizeof(Rgb) == 3, "rows of Rgb are handed to libpng as they are");
  PngPixels pixels{picture.rows, picture.cols, PNG_COLOR_TYPE_RGB};
  pixels.data = reinterpret_cast<const std::uint8_t*>(picture.data.data());
  pixels.stride = static_cast<std::size_t>(picture.cols) * 3;
  if (!words.empty()) pixels.words = words.c_str();
  constexpr std::size_t large = 4'000'000;  // [px]: photographs, which hardly shrink whatever is tried
  pixels.hasty = picture.size() > large;
  return encode(path, pixels, pixel_size);
}

Bytes encode_png(const std::string& path, const LabelledMask& mask) {
  const Raster<std::uint8_t>& labels = mask.labels;
  const std::string words = own_words(Origin::labels, mask.phases);
  PngPixels pixels{labels.rows, labels.cols, PNG_COLOR_TYPE_GRAY};
  pixels.data = labels.data.data();
  pixels.stride = static_cast<std::size_t>(labels.cols);
  pixels.words = words.c_str();
  return encode(path, pixels, mask.pixel_size);
}

}  // namespace specimen
