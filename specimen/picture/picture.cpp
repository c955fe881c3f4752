#include "specimen/picture/picture.hpp"

#include <algorithm>
#include <array>
#include <cctype>
#include <span>
#include <utility>

#include "specimen/body/files.hpp"
#include "specimen/picture/picture_codecs.hpp"
#include "specimen/picture/picture_header.hpp"

namespace specimen {
namespace {

PictureFormat sniff(const PictureSource& source) {
  std::array<std::uint8_t, 8> first{};
  const std::size_t count = std::fread(first.data(), 1, first.size(), source.file.get());
  std::rewind(source.file.get());
  return format_of(std::span(first).first(count));
}

std::string lower_case_ending(const std::string& path) {
  const std::size_t dot = path.find_last_of("./");
  if (dot == std::string::npos || path[dot] != '.') return {};
  std::string ending = path.substr(dot);
  std::transform(ending.begin(), ending.end(), ending.begin(),
                 [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  return ending;
}

Bytes encode_labels(const std::string& path, const LabelledMask& mask) {
  const std::string ending = lower_case_ending(path);
  if (ending == ".png") return encode_png(path, mask);
  if (ending == ".tif" || ending == ".tiff") return encode_tiff(path, mask);
  if (ending == ".bmp") return encode_bmp(mask);
  if (ending == ".pgm") return encode_pgm(mask);
  throw Error(path, ending.empty() ? "has no extension" : "has the extension " + ending,
              "labels are written as .png, .tif, .tiff, .bmp or .pgm", "choose one of these extensions",
              Fault::write);
}

}  // namespace

Picture read_picture(const std::string& path, std::int64_t max_pixels, SizeListener before_pixels) {
  PictureSource source = open_picture(path, max_pixels);
  source.before_pixels = std::move(before_pixels);
  switch (sniff(source)) {
    case PictureFormat::png:
      return read_png(source);
    case PictureFormat::jpeg:
      return read_jpeg(source);
    case PictureFormat::tiff:
      return read_tiff(source);
    case PictureFormat::bmp:
      return read_bmp(source);
    case PictureFormat::pnm:
      return read_pnm(source);
    case PictureFormat::hdf5:
      throw Error(path, "is an HDF5 file", "PNG, TIFF, BMP, JPEG, PGM and PPM are read",
                  "a specimen of mesopix needs no conversion: give it to the next command as it is; export "
                  "labels of another program, such as exported_data of ilastik, as PNG or TIFF");
    case PictureFormat::unknown:
      break;
  }
  throw Error(path, "is not in a known picture format", "PNG, TIFF, BMP, JPEG, PGM and PPM are read",
              "convert it to PNG");
}

void write_png(const std::string& path, const Raster<Rgb>& picture, double pixel_size, Origin origin) {
  const Bytes bytes =
      encode_png(path, picture, pixel_size, origin == Origin::unknown ? "" : own_words(origin, {}));
  replace_file(path, std::as_bytes(std::span(bytes)));
}

void write_preview(const std::string& path, const LabelledMask& mask) {
  const Bytes bytes =
      encode_png(path, preview(mask), mask.pixel_size, own_words(Origin::preview, mask.phases));
  replace_file(path, std::as_bytes(std::span(bytes)));
}

void write_labels(const std::string& path, const LabelledMask& mask) {
  const Bytes bytes = encode_labels(path, mask);
  replace_file(path, std::as_bytes(std::span(bytes)));
}

void write_imagej_tiff(const std::string& path, const Raster<std::uint8_t>& values, double pixel_size) {
  const Bytes bytes = encode_imagej_tiff(path, values, pixel_size);
  replace_file(path, std::as_bytes(std::span(bytes)));
}

void write_imagej_tiff(const std::string& path, const LabelledMask& mask) {
  const Bytes bytes = encode_imagej_tiff(path, mask);
  replace_file(path, std::as_bytes(std::span(bytes)));
}

void write_imagej_tiff(const std::string& path, const Raster<float>& values, double pixel_size) {
  const Bytes bytes = encode_imagej_tiff(path, values, pixel_size);
  replace_file(path, std::as_bytes(std::span(bytes)));
}

namespace {

constexpr std::array<Rgb, 4> standard = {{
    {255, 255, 255},  // void: white
    {112, 128, 150},  // aggregate: blue-grey
    {226, 205, 160},  // mortar: sand
    {196, 84, 0},     // ITZ: dark orange
}};

/// For the user's own phases. Source: Okabe and Ito (2008), less the two oranges, which are near the ITZ, and
/// black.
constexpr std::array<Rgb, 5> others = {{
    {0, 114, 178},
    {0, 158, 115},
    {204, 121, 167},
    {240, 228, 66},
    {86, 180, 233},
}};

std::uint8_t scaled(std::uint8_t channel, int sixteenths) {
  return static_cast<std::uint8_t>(channel * sixteenths / 16);
}

}  // namespace

Rgb phase_colour(std::uint8_t label) {
  if (label < standard.size()) return standard[label];
  const std::size_t index = label - standard.size();
  const Rgb base = others[index % others.size()];
  // Each further round is darker, so that more than five such phases still differ; after eight it starts
  // anew.
  const int brightness = 16 - 2 * static_cast<int>(index / others.size() % 8);
  return {scaled(base.r, brightness), scaled(base.g, brightness), scaled(base.b, brightness)};
}

Raster<Rgb> preview(const LabelledMask& mask) {
  Raster<Rgb> picture(mask.labels.rows, mask.labels.cols);
  std::array<Rgb, 256> colours;
  for (std::size_t label = 0; label < colours.size(); ++label)
    colours[label] = phase_colour(static_cast<std::uint8_t>(label));
  std::transform(mask.labels.data.begin(), mask.labels.data.end(), picture.data.begin(),
                 [&](std::uint8_t label) { return colours[label]; });
  return picture;
}

namespace {

constexpr int gutter = 12;  ///< between the photograph and what is laid over it [px]

Rgb mixed(Rgb a, Rgb b) {
  const auto half = [](int x, int y) { return static_cast<std::uint8_t>((x + y) / 2); };
  return {half(a.r, b.r), half(a.g, b.g), half(a.b, b.b)};
}

/// Stripes that stand out from photographs of any colour: black and yellow.
bool is_striped(int row, int col) { return (row + col) % 8 < 4; }
Rgb stripe(int row, int col) { return (row + col) % 8 == 0 ? Rgb{0, 0, 0} : Rgb{255, 230, 0}; }

}  // namespace

Raster<Rgb> overlay(const Raster<Rgb>& photograph, const LabelledMask& mask,
                    const Raster<std::uint8_t>& uncertain) {
  const int fine = photograph.cols / mask.labels.cols;
  const auto label_at = [&](int row, int col) {
    return mask.labels(std::min(row, photograph.rows - 1) / fine, std::min(col, photograph.cols - 1) / fine);
  };
  Raster<Rgb> both(photograph.rows, 2 * photograph.cols + gutter, Rgb{255, 255, 255});
  for (int row = 0; row < photograph.rows; ++row)
    for (int col = 0; col < photograph.cols; ++col) {
      const std::uint8_t label = label_at(row, col);
      const bool is_edge = label_at(row + 1, col) != label || label_at(row, col + 1) != label;
      both(row, col) = photograph(row, col);
      const bool is_hatched = !uncertain.empty() && uncertain(row, col) != 0 && is_striped(row, col);
      both(row, photograph.cols + gutter + col) = is_edge ? Rgb{0, 0, 0}
                                                  : is_hatched
                                                      ? stripe(row, col)
                                                      : mixed(photograph(row, col), phase_colour(label));
    }
  return both;
}

void write_overlay(const std::string& path, const Raster<Rgb>& photograph, const LabelledMask& mask,
                   const Raster<std::uint8_t>& uncertain) {
  write_png(path, overlay(photograph, mask, uncertain), 0, Origin::drawing);
}

}  // namespace specimen
