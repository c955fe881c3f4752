#include "specimen/picture/picture.hpp"

#include <algorithm>
#include <array>
#include <cctype>
#include <span>

#include "specimen/picture/picture_codecs.hpp"
#include "specimen/picture/picture_header.hpp"
#include "specimen/body/replace_file.hpp"

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
  if (ending == ".png") return encode_png(path, mask.labels, mask.pixel_size);
  if (ending == ".tif" || ending == ".tiff") return encode_tiff(path, mask.labels, mask.pixel_size);
  if (ending == ".bmp") return encode_bmp(mask.labels, mask.pixel_size);
  if (ending == ".pgm") return encode_pgm(mask.labels);
  throw Error(path, ending.empty() ? "has no ending" : "has the ending " + ending,
              "labels are written as .png, .tif, .tiff, .bmp or .pgm", "choose one of these endings",
              Fault::write);
}

}  // namespace

Picture read_picture(const std::string& path, std::int64_t max_pixels) {
  const PictureSource source = open_picture(path, max_pixels);
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
    case PictureFormat::unknown:
      break;
  }
  throw Error(path, "is no picture that is known here", "PNG, TIFF, BMP, JPEG, PGM and PPM are read",
              "convert it to PNG");
}

void write_png(const std::string& path, const Raster<Rgb>& picture, double pixel_size) {
  const Bytes bytes = encode_png(path, picture, pixel_size);
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

void write_imagej_tiff(const std::string& path, const Raster<float>& values, double pixel_size) {
  const Bytes bytes = encode_imagej_tiff(path, values, pixel_size);
  replace_file(path, std::as_bytes(std::span(bytes)));
}

}  // namespace specimen
