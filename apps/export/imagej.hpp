/// Inclusions as a table, and as regions of interest of ImageJ and Fiji in an archive.
#pragma once

#include <string>
#include <vector>

#include "specimen/body/ellipse.hpp"
#include "specimen/body/mask.hpp"

namespace exchange {

/// Comma-separated values, a line an inclusion, units in the names of the columns: number, centre from the
/// bottom left corner, semi-axes and angle of the ellipse (exact, or that of the same area and second
/// moments), area, perimeter and equivalent diameter, orientation of the long axis. Angles against x,
/// counter-clockwise.
[[nodiscard]] std::string inclusion_table(const std::vector<specimen::Inclusion>& inclusions);

/// A file of an archive or a folder.
struct NamedBytes {
  std::string name;
  std::string bytes;
};

/// One polygon in the file format of ImageJ (.roi), corners with fractions of a pixel.
/// @param corners  [m], in the specimen; ImageJ counts pixels from the top left corner of the picture, y
/// down. Source: ij.io.RoiEncoder of ImageJ 1.53t; numbers in it have their highest byte first.
[[nodiscard]] std::string polygon_roi(const std::vector<specimen::Point>& corners,
                                      const specimen::LabelledMask& mask);

/// The contour of every inclusion; exact ellipses become polygons that leave them by at most a twentieth of a
/// pixel. Named inclusion_0001.roi and so on, by the id.
[[nodiscard]] std::vector<NamedBytes> inclusion_rois(const std::vector<specimen::Inclusion>& inclusions,
                                                     const specimen::LabelledMask& mask);

/// Files as an archive, in their order, compressed, with no date of its own: the same files give the same
/// bytes.
/// @throws specimen::Error (Fault::write) naming `path`, under which it is to be kept.
[[nodiscard]] std::string zipped(const std::string& path, const std::vector<NamedBytes>& files);

}  // namespace exchange
