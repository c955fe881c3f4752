#include "specimen/picture/picture_codecs.hpp"

#include <algorithm>
#include <optional>
#include <string>
#include <string_view>
#include <utility>

#include "specimen/picture/picture_header.hpp"

namespace specimen {
namespace {

constexpr unsigned tag_orientation = 0x0112, tag_x = 0x011a, tag_y = 0x011b, tag_unit = 0x0128;

/// Numbers of either byte order; a read past the end gives nothing.
struct ExifBytes {
  std::span<const std::uint8_t> bytes;
  bool big_endian = false;

  [[nodiscard]] std::optional<std::uint32_t> number(std::size_t at, std::size_t width) const {
    if (at > bytes.size() || bytes.size() - at < width) return std::nullopt;
    std::uint32_t value = 0;
    for (std::size_t i = 0; i < width; ++i)
      value = value << 8 | bytes[big_endian ? at + i : at + width - 1 - i];
    return value;
  }
  [[nodiscard]] double ratio(std::size_t at) const {
    const auto top = number(at, 4), bottom = number(at + 4, 4);
    return top && bottom && *bottom != 0 ? static_cast<double>(*top) / *bottom : 0;
  }
};

}  // namespace

ExifTags read_exif(std::span<const std::uint8_t> block) {
  constexpr std::string_view start("Exif\0\0", 6);
  const bool has_start =
      block.size() >= start.size() && std::equal(start.begin(), start.end(), block.begin());
  ExifBytes tiff{has_start ? block.subspan(start.size()) : block};
  if (tiff.bytes.size() < 8 || (tiff.bytes[0] != 'M' && tiff.bytes[0] != 'I')) return {};
  tiff.big_endian = tiff.bytes[0] == 'M';

  ExifTags tags;
  const std::size_t directory = tiff.number(4, 4).value_or(0);
  const unsigned entries = tiff.number(directory, 2).value_or(0);
  double x = 0, y = 0;
  std::uint32_t unit = 2;  // EXIF: inch where nothing is said
  for (unsigned i = 0; i < entries; ++i) {
    const std::size_t entry = directory + 2 + 12 * static_cast<std::size_t>(i);
    const auto tag = tiff.number(entry, 2);
    if (!tag) break;
    const std::size_t value = entry + 8;
    if (*tag == tag_orientation) tags.orientation = static_cast<int>(tiff.number(value, 2).value_or(1));
    if (*tag == tag_unit) unit = tiff.number(value, 2).value_or(2);
    if (*tag == tag_x) x = tiff.ratio(tiff.number(value, 4).value_or(0));
    if (*tag == tag_y) y = tiff.ratio(tiff.number(value, 4).value_or(0));
  }
  if (tags.orientation < 1 || tags.orientation > 8) tags.orientation = 1;
  if (unit == 2) tags.shape = pixel_shape_of(x / inch, y / inch);
  if (unit == 3) tags.shape = pixel_shape_of(x / centimetre, y / centimetre);
  return tags;
}

std::string own_words(Origin origin, const std::vector<std::string>& phases) {
  if (origin == Origin::drawing) return "drawing";
  std::string words;
  for (const std::string& phase : phases) words += (words.empty() ? "" : ",") + phase;
  return (origin == Origin::preview ? "preview " : "labels ") + words;
}

void set_origin(Picture& picture, std::string_view words) {
  if (words == "drawing") picture.origin = Origin::drawing;
  for (const auto& [start, origin] : {std::pair(std::string_view("labels "), Origin::labels),
                                      {std::string_view("preview "), Origin::preview}}) {
    if (words.substr(0, start.size()) != start) continue;
    picture.origin = origin;
    for (std::string_view rest = words.substr(start.size()); !rest.empty();) {
      const std::size_t end = std::min(rest.find(','), rest.size());
      picture.phases.emplace_back(rest.substr(0, end));
      rest.remove_prefix(std::min(end + 1, rest.size()));
    }
    if (picture.phases.size() < 4 || picture.phases.size() > 256) picture.phases.clear();
  }
}

void drop_if_opaque(Picture& picture) {
  constexpr std::uint8_t opaque = 255;
  const auto& data = picture.opacity.data;
  if (std::all_of(data.begin(), data.end(), [](std::uint8_t a) { return a == opaque; })) picture.opacity = {};
}

void DeepToByte::look_at(std::uint16_t channel) {
  small_ = small_ && channel <= 255;
  upper_ = upper_ && channel % 256 == 0;
}

std::uint8_t DeepToByte::operator()(std::uint16_t channel) const {
  if (small_) return static_cast<std::uint8_t>(channel);
  if (upper_) return static_cast<std::uint8_t>(channel / 256);
  return static_cast<std::uint8_t>((channel + 128) / 257);
}

namespace {

void check_indices(const PictureSource& source, const Raster<std::uint8_t>& indices, std::size_t entries) {
  const auto bad = std::find_if(indices.data.begin(), indices.data.end(),
                                [&](std::uint8_t index) { return index >= entries; });
  if (bad == indices.data.end()) return;
  const std::int64_t at = bad - indices.data.begin();
  throw bad_picture(source.path, "pixel in row " + std::to_string(at / indices.cols) + ", column " +
                                     std::to_string(at % indices.cols) + " has colour " +
                                     std::to_string(*bad) + " of a palette with " + std::to_string(entries) +
                                     " colours");
}

bool all_gray(const std::vector<Rgb>& palette) {
  return std::all_of(palette.begin(), palette.end(), [](Rgb c) { return c.r == c.g && c.g == c.b; });
}

}  // namespace

void set_palette_pixels(Picture& picture, const PictureSource& source, Raster<std::uint8_t> indices,
                        const std::vector<Rgb>& palette, const std::vector<std::uint8_t>& opacity) {
  check_indices(source, indices, palette.size());
  if (all_gray(palette)) {
    Raster<std::uint8_t> gray(indices.rows, indices.cols);
    std::transform(indices.data.begin(), indices.data.end(), gray.data.begin(),
                   [&](std::uint8_t index) { return palette[index].r; });
    picture.gray = std::move(gray);
  } else {
    picture.colour = Raster<Rgb>(indices.rows, indices.cols);
    std::transform(indices.data.begin(), indices.data.end(), picture.colour.data.begin(),
                   [&](std::uint8_t index) { return palette[index]; });
  }
  if (!opacity.empty()) {
    picture.opacity = Raster<std::uint8_t>(indices.rows, indices.cols);
    std::transform(indices.data.begin(), indices.data.end(), picture.opacity.data.begin(),
                   [&](std::uint8_t index) { return index < opacity.size() ? opacity[index] : 255; });
    drop_if_opaque(picture);
  }
  picture.indices = std::move(indices);
}

}  // namespace specimen
