#include "specimen/picture/picture_tiff_write.hpp"

#include <algorithm>
#include <cstdarg>
#include <cstdio>
#include <exception>
#include <functional>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

#include "specimen/picture/picture_codecs.hpp"
#include "specimen/picture/picture_header.hpp"

namespace specimen {
namespace {

[[gnu::format(printf, 4, 0)]] int on_error(TIFF*, void* user_data, const char*, const char* format,
                                           va_list arguments) {
  auto* messages = static_cast<TiffMessages*>(user_data);
  if (messages->text[0] == '\0')
    (void)std::vsnprintf(messages->text.data(), messages->text.size(), format, arguments);
  return 1;  // told here, not on the terminal
}

int on_warning(TIFF*, void*, const char*, const char*, va_list) { return 1; }

}  // namespace

TiffOptions quiet_options(TiffMessages& messages) {
  TiffOptions options(TIFFOpenOptionsAlloc());
  TIFFOpenOptionsSetMaxSingleMemAlloc(options.get(), largest_allocation);
  TIFFOpenOptionsSetErrorHandlerExtR(options.get(), on_error, &messages);
  TIFFOpenOptionsSetWarningHandlerExtR(options.get(), on_warning, nullptr);
  return options;
}

}  // namespace specimen

// libtiff writes into memory, so that the file itself can be written whole or not at all.
namespace specimen {
namespace {

struct Memory {
  Bytes bytes;
  std::size_t at = 0;
};

tmsize_t memory_read(thandle_t handle, void* data, tmsize_t count) {
  auto* memory = static_cast<Memory*>(handle);
  const std::size_t left = memory->bytes.size() - std::min(memory->at, memory->bytes.size());
  const std::size_t taken = std::min(left, static_cast<std::size_t>(count));
  std::copy_n(memory->bytes.begin() + static_cast<std::ptrdiff_t>(memory->at), taken,
              static_cast<std::uint8_t*>(data));
  memory->at += taken;
  return static_cast<tmsize_t>(taken);
}

tmsize_t memory_write(thandle_t handle, void* data, tmsize_t count) {
  auto* memory = static_cast<Memory*>(handle);
  const std::size_t end = memory->at + static_cast<std::size_t>(count);
  try {
    if (end > memory->bytes.size()) memory->bytes.resize(end);
  } catch (const std::exception&) {  // must not fly through libtiff
    return 0;
  }
  std::copy_n(static_cast<const std::uint8_t*>(data), count,
              memory->bytes.begin() + static_cast<std::ptrdiff_t>(memory->at));
  memory->at = end;
  return count;
}

toff_t memory_seek(thandle_t handle, toff_t offset, int whence) {
  auto* memory = static_cast<Memory*>(handle);
  if (whence == SEEK_CUR) offset += memory->at;
  if (whence == SEEK_END) offset += memory->bytes.size();
  return memory->at = offset;
}

int memory_close(thandle_t) { return 0; }
toff_t memory_size(thandle_t handle) { return static_cast<Memory*>(handle)->bytes.size(); }

template <class T>
void set_tags(TIFF* tiff, const Raster<T>& values) {
  TIFFSetField(tiff, TIFFTAG_IMAGEWIDTH, values.cols);
  TIFFSetField(tiff, TIFFTAG_IMAGELENGTH, values.rows);
  TIFFSetField(tiff, TIFFTAG_BITSPERSAMPLE, 8 * static_cast<int>(sizeof(T)));
  TIFFSetField(tiff, TIFFTAG_SAMPLEFORMAT,
               std::is_floating_point_v<T> ? SAMPLEFORMAT_IEEEFP : SAMPLEFORMAT_UINT);
  TIFFSetField(tiff, TIFFTAG_SAMPLESPERPIXEL, 1);
  TIFFSetField(tiff, TIFFTAG_PHOTOMETRIC, PHOTOMETRIC_MINISBLACK);
  TIFFSetField(tiff, TIFFTAG_COMPRESSION, COMPRESSION_ADOBE_DEFLATE);
  TIFFSetField(tiff, TIFFTAG_PLANARCONFIG, PLANARCONFIG_CONTIG);
  TIFFSetField(tiff, TIFFTAG_ROWSPERSTRIP, TIFFDefaultStripSize(tiff, 0));
}

void set_resolution(TIFF* tiff, int unit, double pixels_per_unit) {
  TIFFSetField(tiff, TIFFTAG_RESOLUTIONUNIT, unit);
  TIFFSetField(tiff, TIFFTAG_XRESOLUTION, pixels_per_unit);
  TIFFSetField(tiff, TIFFTAG_YRESOLUTION, pixels_per_unit);
}

/// As ImageJ writes pictures that are measured in mm, in the shades from 0 to the largest value.
std::string imagej_description(const Raster<std::uint8_t>& values) {
  const int largest = values.empty() ? 0 : *std::max_element(values.data.begin(), values.data.end());
  return "ImageJ=1.53t\nunit=mm\nmin=0.0\nmax=" + std::to_string(std::max(largest, 1)) + ".0\n";
}

/// In shades that ImageJ chooses.
std::string imagej_description(const Raster<float>&) { return "ImageJ=1.53t\nunit=mm\n"; }

template <class T>
bool write_rows(TIFF* tiff, const Raster<T>& values) {
  std::vector<T> row(static_cast<std::size_t>(values.cols));
  for (int r = 0; r < values.rows; ++r) {
    std::copy_n(values.data.begin() + static_cast<std::ptrdiff_t>(r) * values.cols, values.cols, row.begin());
    if (TIFFWriteScanline(tiff, row.data(), static_cast<std::uint32_t>(r), 0) != 1) return false;
  }
  return TIFFFlush(tiff) == 1;
}

template <class T>
Bytes encode(const std::string& path, const Raster<T>& values, const std::function<void(TIFF*)>& set_scale) {
  Memory memory;
  TiffMessages messages;
  const TiffOptions options = quiet_options(messages);
  // l: the lowest byte first on every machine. Pillow 9.4 turns compressed numbers of 32 bits round
  // otherwise.
  TiffHandle tiff(TIFFClientOpenExt(path.c_str(), "wl", &memory, memory_read, memory_write, memory_seek,
                                    memory_close, memory_size, nullptr, nullptr, options.get()));
  bool written = tiff != nullptr;
  if (written) {
    set_tags(tiff.get(), values);
    set_scale(tiff.get());
    written = write_rows(tiff.get(), values);
  }
  tiff.reset();
  if (!written)
    throw Error(path, std::string("cannot be written as TIFF: ") + messages.text.data(), "", "",
                Fault::write);
  return std::move(memory.bytes);
}

template <class T>
Bytes encode_for_imagej(const std::string& path, const Raster<T>& values, double pixel_size,
                        const std::string& words = {}) {
  return encode(path, values, [&](TIFF* tiff) {
    std::string description = imagej_description(values);
    if (!words.empty()) description += std::string(own_keyword) + "=" + words + "\n";
    TIFFSetField(tiff, TIFFTAG_IMAGEDESCRIPTION, description.c_str());
    set_resolution(tiff, RESUNIT_NONE, 1e-3 / pixel_size);
  });
}

}  // namespace

Bytes encode_tiff(const std::string& path, const LabelledMask& mask) {
  return encode(path, mask.labels, [&](TIFF* tiff) {
    const std::string words = std::string(own_keyword) + " " + own_words(Origin::labels, mask.phases);
    TIFFSetField(tiff, TIFFTAG_IMAGEDESCRIPTION, words.c_str());
    if (mask.pixel_size > 0) set_resolution(tiff, RESUNIT_CENTIMETER, centimetre / mask.pixel_size);
  });
}

Bytes encode_imagej_tiff(const std::string& path, const Raster<std::uint8_t>& values, double pixel_size) {
  return encode_for_imagej(path, values, pixel_size);
}

Bytes encode_imagej_tiff(const std::string& path, const Raster<float>& values, double pixel_size) {
  return encode_for_imagej(path, values, pixel_size);
}

Bytes encode_imagej_tiff(const std::string& path, const LabelledMask& mask) {
  return encode_for_imagej(path, mask.labels, mask.pixel_size, own_words(Origin::labels, mask.phases));
}

}  // namespace specimen
