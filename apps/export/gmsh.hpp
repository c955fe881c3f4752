/// Meshes for Gmsh, and for what reads its files (meshio, FEniCSx, MOOSE, ...).
#pragma once

#include <string>
#include <vector>

#include "apps/export/pixel_mesh.hpp"

namespace exchange {

/// Write the mesh in format 4.1, as text [m]: a physical surface a phase under group_names() with the label
/// of the phase as its tag, and physical curves BOTTOM, RIGHT, TOP and LEFT with tags 1 ... 4 (none where an
/// edge is void throughout) of lines of two nodes.
/// @throws specimen::Error (Fault::write).
void write_gmsh(const std::string& path, const PixelMesh& mesh);

/// Names of the physical surfaces, in the order of the phases of the mesh.
[[nodiscard]] std::vector<std::string> physical_surfaces(const PixelMesh& mesh);

}  // namespace exchange
