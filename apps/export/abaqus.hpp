/// Meshes for Abaqus and CalculiX.
#pragma once

#include <string>

#include "apps/export/pixel_mesh.hpp"

namespace exchange {

/// Which plane elements: CPS4 or CPE4.
enum class PlaneElement { stress, strain };

/// Write the mesh as an input file [m]: nodes, an element set a phase under set_names(), node sets BOTTOM,
/// RIGHT, TOP and LEFT (none where an edge is void throughout). Materials, sections and steps are left to the
/// user, and a comment says so.
/// @throws specimen::Error (Fault::write).
void write_abaqus(const std::string& path, const PixelMesh& mesh, PlaneElement plane);

/// Names of the element sets, in the order of the phases of the mesh.
[[nodiscard]] std::vector<std::string> element_sets(const PixelMesh& mesh);

}  // namespace exchange
