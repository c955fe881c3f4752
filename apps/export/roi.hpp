/// Regions of interest of ImageJ and Fiji.
#pragma once

#include <string>
#include <vector>

#include "specimen/body/inclusion.hpp"
#include "specimen/body/mask.hpp"

namespace exchange {

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

}  // namespace exchange
