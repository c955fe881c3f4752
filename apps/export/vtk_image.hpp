/// Images for ParaView and other programs of VTK.
#pragma once

#include <string>

#include "specimen/body/mask.hpp"

namespace exchange {

/// Write the mask as VTK ImageData (.vti) [m]: a cell a pixel, void included, with the label in the cell data
/// `phase`, and the names of the phases by label in the field data `phase_names`. VTK counts rows from below.
/// @throws specimen::Error (Fault::write).
void write_vtk_image(const std::string& path, const specimen::LabelledMask& mask);

}  // namespace exchange
