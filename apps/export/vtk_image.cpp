#include "apps/export/vtk_image.hpp"

#include <fmt/format.h>

#include <array>
#include <cstdint>
#include <string_view>

#include "apps/export/text_stream.hpp"

namespace exchange {
namespace {

/// Codes of the characters of every name, each with a zero behind it, as VTK spells texts.
std::string spelled(const std::vector<std::string>& names) {
  std::string codes;
  for (const std::string& name : names) {
    for (const char c : name) codes += fmt::format("{} ", static_cast<unsigned char>(c));
    codes += "0\n";
  }
  return codes;
}

std::string header(const specimen::LabelledMask& mask) {
  const std::string extent = fmt::format("0 {} 0 {} 0 0", mask.labels.cols, mask.labels.rows);
  return fmt::format(
      R"(<?xml version="1.0"?>
<!-- Specimen of mesopix. Lengths are in metres. The origin is the bottom left corner, x points right, y points up. -->
<VTKFile type="ImageData" version="1.0" byte_order="LittleEndian" header_type="UInt64">
<ImageData WholeExtent="{0}" Origin="0 0 0" Spacing="{1} {1} {1}">
<FieldData>
<Array type="String" Name="phase_names" NumberOfTuples="{2}" format="ascii">
{3}</Array>
</FieldData>
<Piece Extent="{0}">
<CellData Scalars="phase">
<DataArray type="UInt8" Name="phase" format="appended" offset="0"/>
</CellData>
</Piece>
</ImageData>
<AppendedData encoding="raw">
_)",
      extent, length_text(mask.pixel_size), mask.phases.size(), spelled(mask.phases));
}

/// Number of bytes that follow, the lowest byte first.
std::string size_prefix(std::uint64_t size) {
  std::string bytes;
  for (int shift = 0; shift < 64; shift += 8) bytes += static_cast<char>(size >> shift & 0xFF);
  return bytes;
}

std::string_view row_of(const specimen::Raster<std::uint8_t>& labels, int row) {
  return {reinterpret_cast<const char*>(&labels(row, 0)), static_cast<std::size_t>(labels.cols)};
}

}  // namespace

void write_vtk_image(const std::string& path, const specimen::LabelledMask& mask) {
  write_text(path, [&](TextStream& file) {
    file << header(mask) << size_prefix(mask.labels.size());
    for (int row = mask.labels.rows - 1; row >= 0; --row) file << row_of(mask.labels, row);
    file << "\n</AppendedData>\n</VTKFile>\n";
  });
}

}  // namespace exchange
