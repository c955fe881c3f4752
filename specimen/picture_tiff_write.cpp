#include <algorithm>
#include <cstdio>
#include <exception>
#include <string>
#include <utility>

#include "specimen/picture_codecs.hpp"
#include "specimen/picture_header.hpp"
#include "specimen/tiff_handle.hpp"

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

void set_tags(TIFF* tiff, const Raster<std::uint8_t>& labels, double pixel_size) {
  TIFFSetField(tiff, TIFFTAG_IMAGEWIDTH, labels.cols);
  TIFFSetField(tiff, TIFFTAG_IMAGELENGTH, labels.rows);
  TIFFSetField(tiff, TIFFTAG_BITSPERSAMPLE, 8);
  TIFFSetField(tiff, TIFFTAG_SAMPLESPERPIXEL, 1);
  TIFFSetField(tiff, TIFFTAG_PHOTOMETRIC, PHOTOMETRIC_MINISBLACK);
  TIFFSetField(tiff, TIFFTAG_COMPRESSION, COMPRESSION_LZW);
  TIFFSetField(tiff, TIFFTAG_PLANARCONFIG, PLANARCONFIG_CONTIG);
  TIFFSetField(tiff, TIFFTAG_ROWSPERSTRIP, TIFFDefaultStripSize(tiff, 0));
  if (pixel_size <= 0) return;
  TIFFSetField(tiff, TIFFTAG_RESOLUTIONUNIT, RESUNIT_CENTIMETER);
  TIFFSetField(tiff, TIFFTAG_XRESOLUTION, centimetre / pixel_size);
  TIFFSetField(tiff, TIFFTAG_YRESOLUTION, centimetre / pixel_size);
}

bool write_rows(TIFF* tiff, const Raster<std::uint8_t>& labels) {
  Bytes row(static_cast<std::size_t>(labels.cols));
  for (int r = 0; r < labels.rows; ++r) {
    std::copy_n(labels.data.begin() + static_cast<std::ptrdiff_t>(r) * labels.cols, labels.cols, row.begin());
    if (TIFFWriteScanline(tiff, row.data(), static_cast<std::uint32_t>(r), 0) != 1) return false;
  }
  return TIFFFlush(tiff) == 1;
}

}  // namespace

Bytes encode_tiff(const std::string& path, const Raster<std::uint8_t>& labels, double pixel_size) {
  Memory memory;
  TiffMessages messages;
  const TiffOptions options = quiet_options(messages);
  TiffHandle tiff(TIFFClientOpenExt(path.c_str(), "w", &memory, memory_read, memory_write, memory_seek,
                                    memory_close, memory_size, nullptr, nullptr, options.get()));
  bool written = tiff != nullptr;
  if (written) {
    set_tags(tiff.get(), labels, pixel_size);
    written = write_rows(tiff.get(), labels);
  }
  tiff.reset();
  if (!written)
    throw Error(path, std::string("cannot be written as TIFF: ") + messages.text.data(), "", "",
                Fault::write);
  return std::move(memory.bytes);
}

}  // namespace specimen
